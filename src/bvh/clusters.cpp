#include "bvh/clusters.hpp"

#include <algorithm>
#include <iterator>

#include "base/parallel.hpp"
#include "bvh/quantiles.hpp"

namespace vkbake {
namespace {

constexpr std::size_t triangles_a_count = 8192;
constexpr std::size_t lookahead = 16; // triangles that are fetched ahead
constexpr std::size_t most_counters = std::size_t{1} << 20U;

/// Counts (then places) by block of ranks and by cell. Blocks are few where cells are many.
class Counters {
public:
    Counters(std::size_t triangles, std::size_t cells)
        : m_cells(cells),
          m_block(std::max(triangles_a_count, triangles / std::max<std::size_t>(most_counters / cells, 1) + 1)),
          m_blocks(std::max<std::size_t>((triangles + m_block - 1) / m_block, 1)), m_clusters(m_blocks * cells) {}

    [[nodiscard]] std::size_t block_size() const { return m_block; }
    [[nodiscard]] Cluster* of_block(std::size_t first_rank) { return &m_clusters[first_rank / m_block * m_cells]; }

    /// From counts in `end` to the place of each block's first triangle.
    void to_places() {
        std::uint32_t place = 0;
        for (std::size_t cell = 0; cell < m_cells; ++cell) {
            for (std::size_t block = 0; block < m_blocks; ++block) {
                Cluster& part = m_clusters[block * m_cells + cell];
                const std::uint32_t count = part.end;
                part.begin = part.end = place;
                place += count;
            }
        }
    }
    /// Of all blocks together, where `end` is each block's last place and one. Those that are not empty.
    [[nodiscard]] std::vector<Cluster> clusters() const {
        std::vector<Cluster> clusters;
        for (std::size_t cell = 0; cell < m_cells; ++cell) {
            Cluster cluster = m_clusters[cell];
            for (std::size_t block = 1; block < m_blocks; ++block) {
                const Cluster& part = m_clusters[block * m_cells + cell];
                cluster.box.add(part.box);
                cluster.end = part.end;
            }
            if (cluster.begin < cluster.end) {
                clusters.push_back(cluster);
            }
        }
        return clusters;
    }

private:
    std::size_t m_cells;
    std::size_t m_block;
    std::size_t m_blocks;
    std::vector<Cluster> m_clusters;
};

} // namespace

ClusterGrid::ClusterGrid(const ListedTriangles& triangles, int splits, int threads)
    : m_cuts(quantiles(triangles, static_cast<std::size_t>(splits), threads)) {}

std::uint32_t ClusterGrid::cell_of(const Triangle& triangle) const {
    std::uint32_t cell = 0;
    for (int axis = 2; axis >= 0; --axis) {
        const auto& [a, b, c] = triangle.corners;
        const double centroid = (static_cast<double>(a[axis]) + b[axis] + c[axis]) / 3.0;
        const std::vector<float>& planes = cuts(axis);
        std::uint32_t part = 0; // counted, not sought: they are few, and which is next cannot be foretold
        for (const float plane : planes) {
            part += static_cast<std::uint32_t>(static_cast<double>(plane) <= centroid);
        }
        cell = cell * static_cast<std::uint32_t>(planes.size() + 1) + part;
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

std::vector<Cluster> cluster_triangles(const ListedTriangles& triangles, int splits, int threads,
                                       const PlaceTriangle& place_triangle) {
    const ClusterGrid grid(triangles, splits, threads);
    std::vector<std::uint32_t> cells(triangles.size()); // by rank
    parallel_ranges(triangles.end_number(), triangles_a_count, threads, [&](std::size_t begin, std::size_t end) {
        triangles.each_by_number(
            begin, end, [&](const Triangle& triangle, std::uint32_t rank) { cells[rank] = grid.cell_of(triangle); });
    });
    Counters counters(triangles.size(), grid.cell_count());
    // blocks, not workers, own the counters
    const auto each_block = [&](const auto& body) {
        const std::size_t size = counters.block_size();
        parallel_ranges((triangles.size() + size - 1) / size, 1, threads, [&](std::size_t block, std::size_t /*end*/) {
            const std::size_t begin = block * size;
            body(counters.of_block(begin), begin, std::min(begin + size, triangles.size()));
        });
    };
    each_block([&](Cluster* by_cell, std::size_t begin, std::size_t end) {
        for (std::size_t rank = begin; rank < end; ++rank) {
            ++by_cell[cells[rank]].end;
        }
    });
    counters.to_places();
    each_block([&](Cluster* by_cell, std::size_t begin, std::size_t end) {
        for (std::size_t rank = begin; rank < end; ++rank) {
            if (rank + lookahead < end) {
                triangles.prefetch(rank + lookahead);
            }
            Cluster& cluster = by_cell[cells[rank]];
            const Box box = triangles[rank].bounds();
            cluster.box.add(box);
            place_triangle(cluster.end++, static_cast<std::uint32_t>(rank), box);
        }
    });
    return counters.clusters();
}

} // namespace vkbake
