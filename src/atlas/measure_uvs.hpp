// What light-map UVs are worth: figures that any UVs can be asked for, whoever made them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace vkbake {

/// UVs of a surface. Three entries a triangle; `page` one a triangle. They are not brought to texels beforehand: floats
/// would be rounded, and triangles that only meet would overlap.
struct MeasuredUvs {
    std::span<const glm::vec3> positions; ///< any unit
    std::span<const glm::vec2> uvs;
    std::span<const std::uint32_t> page;
    std::span<const glm::dvec2> page_sizes; ///< 1 a page: texels a unit of its UVs

    [[nodiscard]] glm::dvec2 texel(std::size_t corner) const {
        return glm::dvec2(uvs[corner]) * page_sizes[page[corner / 3]];
    }
};

struct UvFigures {
    std::size_t charts = 0;      ///< pieces whose triangles hang together by edges, in space and in the map
    std::size_t unmapped = 0;    ///< triangles with area in space and none in the map
    std::size_t mirrored = 0;    ///< triangles that turn against the greater part of their chart
    std::size_t overlapping = 0; ///< triangles whose interior meets another's; exact
    double uv_area = 0.0;        ///< texels² of all triangles
    double stretch = 0.0; ///< L2 stretch (Sander et al., "Texture mapping progressive meshes", 2001) over all that is
                          ///< mapped, times √(UV area / area): 1 where the map is isometric, greater elsewhere
};

/// Corners of equal position are one. Two triangles hang together in the map where both ends of an edge that they share
/// in space lie within 1/16 texel of each other there. The stretch of slivers is that of their exact map; where UVs
/// have no area the triangle is left out of it.
[[nodiscard]] UvFigures measure_uvs(const MeasuredUvs& uvs);

/// L2 stretch alone, of the triangles given (numbers of triangles; `flat` in any unit).
[[nodiscard]] double l2_stretch(std::span<const glm::vec3> positions, std::span<const glm::vec2> flat,
                                std::span<const std::uint32_t> triangles);

} // namespace vkbake
