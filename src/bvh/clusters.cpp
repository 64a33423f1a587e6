#include "bvh/clusters.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace vkbake {
namespace {

constexpr std::size_t grain = 4096;

// The same cuts as a full sort gives, without sorting what lies between them.
std::vector<float> quantiles(std::span<const Triangle> triangles, int axis, std::size_t splits) {
    std::vector<float> sorted;
    sorted.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles) {
        for (const glm::vec3& corner : triangle.corners) {
            sorted.push_back(corner[axis]);
        }
    }
    std::vector<float> cuts;
    auto begin = sorted.begin();
    for (std::size_t cut = 1; cut < splits && !sorted.empty(); ++cut) {
        const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(cut * sorted.size() / splits);
        std::nth_element(begin, place, sorted.end());
        cuts.push_back(*place);
        begin = place;
    }
    return cuts;
}

} // namespace

ClusterGrid::ClusterGrid(std::span<const Triangle> triangles, int splits, int threads) {
    parallel_ranges(3, 1, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t axis = begin; axis < end; ++axis) {
            m_cuts[axis] = quantiles(triangles, static_cast<int>(axis), static_cast<std::size_t>(splits));
        }
    });
}

std::uint32_t ClusterGrid::cell_of(const Triangle& triangle) const {
    std::uint32_t cell = 0;
    for (int axis = 2; axis >= 0; --axis) {
        const auto& [a, b, c] = triangle.corners;
        const double centroid = (static_cast<double>(a[axis]) + b[axis] + c[axis]) / 3.0;
        const std::vector<float>& planes = cuts(axis);
        const auto part = std::upper_bound(planes.begin(), planes.end(), centroid) - planes.begin();
        cell = cell * static_cast<std::uint32_t>(planes.size() + 1) + static_cast<std::uint32_t>(part);
    }
    return cell;
}

std::uint32_t ClusterGrid::cell_count() const {
    std::size_t count = 1;
    for (const std::vector<float>& planes : m_cuts) {
        count *= planes.size() + 1;
    }
    return static_cast<std::uint32_t>(count);
}

Clustering cluster_triangles(std::span<const Triangle> triangles, int splits, int threads) {
    const ClusterGrid grid(triangles, splits, threads);
    std::vector<std::uint32_t> cells(triangles.size());
    parallel_ranges(triangles.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t rank = begin; rank < end; ++rank) {
            cells[rank] = grid.cell_of(triangles[rank]);
        }
    });

    std::vector<Cluster> by_cell(grid.cell_count());
    for (std::size_t rank = 0; rank < triangles.size(); ++rank) {
        Cluster& cluster = by_cell[cells[rank]];
        cluster.box.add(triangles[rank].bounds());
        ++cluster.end; // the count for now
    }
    std::uint32_t begin = 0;
    for (Cluster& cluster : by_cell) {
        cluster.begin = begin;
        begin += cluster.end;
        cluster.end = cluster.begin;
    }
    Clustering clustering;
    clustering.ranks.resize(triangles.size());
    for (std::uint32_t rank = 0; rank < triangles.size(); ++rank) {
        clustering.ranks[by_cell[cells[rank]].end++] = rank;
    }
    std::copy_if(by_cell.begin(), by_cell.end(), std::back_inserter(clustering.clusters),
                 [](const Cluster& cluster) { return cluster.begin < cluster.end; });
    return clustering;
}

} // namespace vkbake
