// A closed surface of triangles, and models made of such.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "make_scenes/paint.hpp"

namespace vkbake::scenes {

/// Metres between things that touch. Faces in contact would coincide; this much air is too thin to be seen.
inline constexpr double contact_gap = 1.0 / 1024.0;

struct Triangle {
    std::array<std::uint32_t, 3> corners{}; ///< indices of points, counter-clockwise from outside
    Paint paint = Paint::white;
};

/// One connected surface. Points are shared by all the triangles that meet there, so edges pair up by construction.
struct Solid {
    std::vector<glm::dvec3> points; ///< metres
    std::vector<Triangle> triangles;
    double crease_cosine = 0.76;     ///< faces that meet at less than this angle (40°) share a normal
    glm::dvec3 grain{0.0, 1.0, 0.0}; ///< the direction of a wood texture's fibres
};

/// What becomes one mesh of a file: solids that neither cross nor touch each other.
struct Model {
    std::string name;
    std::vector<Solid> solids;

    void add(Solid solid) { solids.push_back(std::move(solid)); }
    /// Adds every solid of `other`, moved.
    void add(const Model& other, const glm::dmat4& placement);
    [[nodiscard]] std::size_t triangle_count() const;
};

/// Turns the triangles so that the enclosed volume is positive.
[[nodiscard]] Solid facing_outward(Solid solid);

/// Moved solid; a mirroring matrix turns the triangles, so the front stays outside.
[[nodiscard]] Solid moved(Solid solid, const glm::dmat4& placement);
[[nodiscard]] Solid moved(Solid solid, const glm::dvec3& offset);

/// The same solid in another paint, or with the fibres of the wood in another direction.
[[nodiscard]] Solid painted(Solid solid, Paint paint);
[[nodiscard]] Solid grained(Solid solid, const glm::dvec3& grain);

[[nodiscard]] inline glm::dvec3 unit(const glm::dvec3& v) { return v / glm::length(v); }

/// Rotation about an axis through the origin by an angle in turns, right-handed.
[[nodiscard]] glm::dmat4 about_x(double turns);
[[nodiscard]] glm::dmat4 about_y(double turns);
[[nodiscard]] glm::dmat4 about_z(double turns);
[[nodiscard]] glm::dmat4 shifted(const glm::dvec3& offset);

/// Splits the longest edge, again and again, until there are `count` triangles; the shape stays as it is. An edge
/// inside the surface makes two more triangles of two, one on an open rim makes one. Throws vkbake::Error if that
/// cannot be met.
void refine_to(Solid& solid, std::size_t count);

/// Refines one solid of a model so that the whole has `count` triangles.
void refine_model_to(Model& model, std::size_t solid_index, std::size_t count);

} // namespace vkbake::scenes
