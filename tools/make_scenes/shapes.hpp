// Shapes to model with. Each is one closed surface, facing outward.
#pragma once

#include <functional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "make_scenes/solid.hpp"

namespace vkbake::scenes {

using Ring = std::vector<glm::dvec3>;
using Profile = std::vector<glm::dvec2>; ///< (radius, height), metres; radius 0 is a pole

enum class Ends { capped, joined };

/// A skin over rings of equally many points, or of one point (a pole, at an end). `capped` closes first and last ring
/// by rungs between points k and n − k, so a cap bends only about the direction of its rungs; `joined` closes in a
/// loop.
[[nodiscard]] Solid loft(const std::vector<Ring>& rings, Paint paint, Ends ends = Ends::capped);

/// A surface of revolution about +Y. A profile that neither starts nor ends at the axis is capped flat, or joined to a
/// ring.
[[nodiscard]] Solid lathe(const Profile& profile, int segments, Paint paint, Ends ends = Ends::capped);

/// An upright circular cylinder whose edges are cut by `bevel` (0: sharp), from y = 0 to `height`.
[[nodiscard]] Solid cylinder(double radius, double height, int segments, Paint paint, double bevel = 0.0);

[[nodiscard]] Solid box(const glm::dvec3& low, const glm::dvec3& high, Paint paint);

/// A box whose twelve edges are cut at 45° by `bevel` metres: 44 triangles.
[[nodiscard]] Solid bevelled_box(const glm::dvec3& low, const glm::dvec3& high, double bevel, Paint paint);

/// A box of which only the four edges around the +Z face are cut: 20 triangles.
[[nodiscard]] Solid front_bevelled_box(const glm::dvec3& low, const glm::dvec3& high, double bevel, Paint paint);

/// A simple polygon in the XY plane, drawn out from `low_z` to `high_z`; it may be concave, in either direction of
/// rotation.
[[nodiscard]] Solid extrude(const std::vector<glm::dvec2>& polygon, double low_z, double high_z, Paint paint);

/// A round bar along a path; `sideways` must not be parallel to any part of the path.
[[nodiscard]] Solid tube(const std::vector<glm::dvec3>& path, double radius, int sides, const glm::dvec3& sideways,
                         Paint paint);

/// A ring: a tube of radius `thickness` along the circle of `radius` around +Y.
[[nodiscard]] Solid torus(double radius, double thickness, int segments, int sides, Paint paint);

[[nodiscard]] Solid sphere(double radius, int segments, int rings, Paint paint);

/// A turned part along +X that sits on a cylinder of `body_radius` around +Z: its first ring follows that cylinder,
/// `gap` off it; the profile's (radius, x) gives the others. Its first x is ignored.
[[nodiscard]] Solid on_cylinder(double body_radius, double gap, const Profile& profile, int segments, Paint paint);

/// Where the planes of a grid of blocks lie along each axis, ascending, in metres.
struct Cuts {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;
};

/// The union of the grid's blocks that are `filled` (asked with the block's centre), as one surface without inner
/// faces. `paint` is asked for every face with its centre and outward normal.
[[nodiscard]] Solid blocks(const Cuts& cuts, const std::function<bool(const glm::dvec3&)>& filled,
                           const std::function<Paint(const glm::dvec3&, const glm::dvec3&)>& paint);

} // namespace vkbake::scenes
