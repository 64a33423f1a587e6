// Triangles as the pass wants them: whole texel coordinates, and all that would need a division.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry_image.h"
#include "vkbake/atlas.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// A page's texel coordinates as whole numbers of units; see shaders/glsl/shared/geometry_image.h.
struct TexelGrid {
    int width = 0; ///< texels
    int height = 0;
    int units = 0; ///< a texel: 2^26 / the longer side's next power of two

    explicit TexelGrid(const AtlasPage& page);
    [[nodiscard]] int
    x(float u) const; ///< the nearest unit; exact for the pages' usual sizes, powers of two, where u ≥ ¼
    [[nodiscard]] int y(float v) const;
};

/// `triangle` is an index in the surface. Only add, multiply and divide of the host's IEEE doubles: the same on every
/// host.
[[nodiscard]] shared::TexelTriangle make_texel_triangle(const Surface& surface, const Atlas& atlas,
                                                        const TexelGrid& grid, std::uint32_t triangle);

/// Texels, half open: those whose closed squares the triangle's box meets.
struct TexelBox {
    int x_begin = 0;
    int x_end = 0;
    int y_begin = 0;
    int y_end = 0;
};
[[nodiscard]] TexelBox texel_box(const Atlas& atlas, const TexelGrid& grid, std::uint32_t triangle);

/// The page's triangles that have area in space, in canonical order. Throws Error{bad_input} for UVs outside [0,1].
[[nodiscard]] std::vector<std::uint32_t> drawn_triangles(const Surface& surface, const Atlas& atlas,
                                                         std::uint32_t page);

/// Unit length, on the geometric normal's side; the geometric normal itself where the interpolated one is 0.
[[nodiscard]] glm::vec3 unit_shading_normal(const glm::vec3& interpolated, const glm::vec3& geometric);

} // namespace vkbake
