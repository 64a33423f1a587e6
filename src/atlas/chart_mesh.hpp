// One object's triangles with welded corners, and what lies across each of their sides.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "vkbake/surface.hpp"

namespace vkbake {

/// Triangles are numbered by their place in the list given, sides as corners: side 3·t + c runs from corner c of
/// triangle t to the next.
struct ChartMesh {
    static constexpr std::uint32_t none = 0xFFFFFFFFU;

    std::vector<std::uint32_t> vertices; ///< 3 a triangle: corners of equal position are one vertex
    std::vector<glm::vec3> points;       ///< 1 a vertex, bake frame
    std::vector<glm::dvec3> normals;     ///< 1 a triangle, unit; 0 where it has no area
    std::vector<std::uint32_t> across;   ///< 3 a triangle: the side of the triangle that goes on beyond, or `none`
    std::vector<std::uint8_t> creases;   ///< 1 a side, not 0 where light may change abruptly there, see make_chart_mesh

    [[nodiscard]] bool is_crease(std::uint32_t side) const { return creases[side] != 0; }
    [[nodiscard]] std::size_t triangle_count() const { return normals.size(); }
    [[nodiscard]] glm::dvec3 corner(std::uint32_t place) const { return glm::dvec3(points[vertices[place]]); }
};

[[nodiscard]] constexpr std::uint32_t next_corner(std::uint32_t place) {
    return place % 3 == 2 ? place - 2 : place + 1;
}
[[nodiscard]] constexpr std::uint32_t last_corner(std::uint32_t place) { return next_corner(next_corner(place)); }

/// Normals whose cosine is less are apart: about 26°.
constexpr double crease_cosine = 0.9;

/// Sides lie across from each other where they join the same vertices in opposite senses. Where more than two triangles
/// meet at an edge the flattest pairs go together; a triangle without area lies across from nothing.
/// A side is a crease where parts meet (materials change there), or where both the triangles and, at one of its ends,
/// their shading normals are apart: what is shaded smoothly gets light that changes smoothly.
[[nodiscard]] ChartMesh make_chart_mesh(const Surface& surface, std::span<const std::uint32_t> triangles);

/// A triangle laid down in the plane, counter-clockwise: its first corner at the origin, the second at (x1, 0), the
/// third at (x2, y2).
struct LaidTriangle {
    double x1 = 0.0;
    double x2 = 0.0;
    double y2 = 0.0;
};

/// Side `side` of the mesh on the x axis.
[[nodiscard]] LaidTriangle lay_down(const ChartMesh& mesh, std::uint32_t side);

/// How a map stretches a triangle. With singular values σ₁ ≥ σ₂ from space to the map:
struct Distortion {
    double squares = 0.0; ///< σ₁² + σ₂²
    double product = 0.0; ///< σ₁ σ₂, negative where the triangle is mirrored
    /// (σ₁² + σ₂² + σ₁⁻² + σ₂⁻²) / 4 − 1: 0 where isometric (the symmetric Dirichlet energy).
    [[nodiscard]] double energy() const { return 0.25 * (squares + squares / (product * product)) - 1.0; }
};

[[nodiscard]] Distortion distortion(const LaidTriangle& triangle, const glm::dvec2& a, const glm::dvec2& b,
                                    const glm::dvec2& c);

} // namespace vkbake
