// A connected piece of surface that lies flat in the map.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace vkbake {

/// Flat coordinates: two floats a corner, 3·t … 3·t + 2 for triangle t of the surface; for a chart that was made its
/// bake-frame position without the coordinate that it was projected along, for kept UVs the UVs themselves.
struct Chart {
    std::vector<std::uint32_t> triangles; ///< in canonical order, at least one
    glm::dvec2 lower{0.0};                ///< the box of the flat coordinates
    glm::dvec2 upper{0.0};
    double scale = 1.0; ///< bake-frame units a flat unit, ≥ 0
};

/// A chart of these triangles (at least one) with its box.
[[nodiscard]] Chart bounded_chart(std::vector<std::uint32_t> triangles, std::span<const glm::vec2> flat);

} // namespace vkbake
