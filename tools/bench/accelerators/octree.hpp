// An octree.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bench/accelerators/ray_asker.hpp"

namespace vkbake::bench {

/// Cubes that are cut into eight where they hold more than a few triangles (Glassner, "Space Subdivision for Fast Ray
/// Tracing", 1984). A triangle is in every leaf that it touches.
class Octree final : public RayAsker {
public:
    static constexpr std::size_t leaf_triangles = 16;
    static constexpr int greatest_depth = 12;

    Octree(const std::vector<Triangle>& triangles, const Box& bounds);

    [[nodiscard]] bool occluded(const PreparedRay& ray) const override;
    [[nodiscard]] std::size_t bytes() const override;

private:
    struct Node {
        Box box;
        std::uint32_t children = 0; ///< the first of eight in a row; 0: a leaf
        std::uint32_t begin = 0;    ///< of a leaf's triangles in m_indices
        std::uint32_t end = 0;
    };
    void divide(std::uint32_t node, const std::vector<std::uint32_t>& held, int depth);
    [[nodiscard]] bool occluded_below(std::uint32_t node, const PreparedRay& ray, std::uint32_t nearest_child) const;

    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_indices;
    std::vector<Triangle> m_triangles;
};

} // namespace vkbake::bench
