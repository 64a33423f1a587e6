// A uniform grid.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "bench/accelerators/ray_asker.hpp"

namespace vkbake::bench {

/// Cubes, some `cells_a_triangle` times as many as triangles: along an axis of length s there are s · ∛(d · N / V) of
/// them (Cleary, Wyvill, Birtwistle, Vatti, "Multiprocessor Ray Tracing", 1986; Cleary, Wyvill, "Analysis of an
/// Algorithm for Fast Ray Tracing Using Uniform Space Subdivision", 1988). A ray goes from cell to cell as Amanatides
/// and Woo have it ("A Fast Voxel Traversal Algorithm for Ray Tracing", 1987).
class UniformGrid final : public RayAsker {
public:
    /// As Wald and others 2006 ("Ray Tracing Animated Scenes Using Coherent Grid Traversal") have chosen.
    static constexpr double cells_a_triangle = 5.0;

    UniformGrid(const std::vector<Triangle>& triangles, const Box& bounds);

    [[nodiscard]] bool occluded(const PreparedRay& ray) const override;
    [[nodiscard]] std::size_t bytes() const override;

private:
    [[nodiscard]] std::size_t index(const glm::ivec3& cell) const;
    [[nodiscard]] glm::ivec3 cell_of(const glm::dvec3& point) const; ///< the nearest one
    [[nodiscard]] Box box_of(const glm::ivec3& cell) const;
    template<typename Visit>
    void for_each_cell(const Triangle& triangle, const Visit& visit) const;

    Box m_bounds;
    glm::ivec3 m_resolution{1};
    glm::dvec3 m_cell{0.0};             ///< lengths of a cell's sides
    std::vector<std::uint32_t> m_first; ///< by cell, and one more: where its triangles begin
    std::vector<std::uint32_t> m_indices;
    std::vector<Triangle> m_triangles;
};

} // namespace vkbake::bench
