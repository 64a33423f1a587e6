// The thesis's clusters (§3.3.1): a grid whose planes stand at the quantiles of the vertices.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "bvh/triangle_list.hpp"

namespace vkbake {

/// Cuts each axis into as many parts as `splits`, at the quantiles of the corners' sorted coordinates (every corner of
/// every triangle counts): cut j is the coordinate at place ⌊j · corners / splits⌋, counted from 0.
class ClusterGrid {
public:
    ClusterGrid(const ListedTriangles& triangles, int splits, int threads);

    /// The cell of the triangle's centroid, x fastest. A cell is closed below and open above: a centroid on a cut
    /// belongs to the upper cell, and of equal cuts to the uppermost. The outermost cells have no outer border.
    [[nodiscard]] std::uint32_t cell_of(const Triangle& triangle) const;
    [[nodiscard]] std::uint32_t cell_count() const;
    [[nodiscard]] const std::vector<float>& cuts(int axis) const { return m_cuts[static_cast<std::size_t>(axis)]; }

private:
    std::array<std::vector<float>, 3> m_cuts; // ascending, splits − 1 each
};

/// The triangles of one cell that is not empty: their places are [begin, end).
struct Cluster {
    Box box; ///< tight around its triangles
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
};

/// Is told a triangle's place; called by several threads, for each triangle once.
using PlaceTriangle = std::function<void(std::uint32_t place, std::uint32_t rank, const Box& bounds)>;

/// The clusters in the order of their cells. Triangles have places cluster by cluster, by ascending rank in each.
[[nodiscard]] std::vector<Cluster> cluster_triangles(const ListedTriangles& triangles, int splits, int threads,
                                                     const PlaceTriangle& place_triangle);

} // namespace vkbake
