#include "bvh/clusters.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "unit/bvh/ray_scenes.hpp"

namespace vkbake {
namespace {

/// Keeps what ListedTriangles only points at: every triangle, as given.
class GivenTriangles {
public:
    explicit GivenTriangles(std::vector<glm::vec3> positions) : m_positions(std::move(positions)) {
        m_list.numbers.resize(m_positions.size() / 3);
        std::iota(m_list.numbers.begin(), m_list.numbers.end(), 0U);
        m_list.ranks = m_list.numbers;
    }

    [[nodiscard]] ListedTriangles listed() const { return {m_positions, m_list}; }

private:
    std::vector<glm::vec3> m_positions;
    TriangleList m_list;
};

struct Clustering {
    std::vector<Cluster> clusters;
    std::vector<std::uint32_t> ranks; ///< by place
};

Clustering cluster(const ListedTriangles& triangles, int splits, int threads) {
    Clustering clustering;
    clustering.ranks.resize(triangles.size(), no_triangle);
    clustering.clusters =
        cluster_triangles(triangles, splits, threads, [&](std::uint32_t place, std::uint32_t rank, const Box& bounds) {
            clustering.ranks.at(place) = rank;
            EXPECT_EQ(bounds.low, triangles[rank].bounds().low);
            EXPECT_EQ(bounds.high, triangles[rank].bounds().high);
        });
    return clustering;
}

// Four triangles in a row along x; their y and z are all 0 … 1 and 0.
// x, sorted: 0 0 1 | 3 3 6 | 6 8 10 | 11 12 13, so the quartiles cut at places 3, 6, 9: 3, 6 and 11.
// Centroids: A (0+0+1)/3 = ⅓ → part 0; B (3+3+6)/3 = 4 → 1; C (6+8+10)/3 = 8 → 2; D (11+12+13)/3 = 12 → 3.
std::vector<glm::vec3> row() {
    return {{0, 0, 0}, {0, 1, 0}, {1, 0, 0},  {3, 0, 0},  {3, 1, 0},  {6, 0, 0},
            {6, 0, 0}, {8, 1, 0}, {10, 0, 0}, {11, 0, 0}, {12, 1, 0}, {13, 0, 0}};
}

TEST(ClusterGrid, CutsStandAtTheQuartiles) {
    const GivenTriangles given(row());
    const ClusterGrid grid(given.listed(), 4, 1);
    EXPECT_EQ(grid.cuts(0), (std::vector<float>{3, 6, 11}));
    // y, sorted: eight zeros, four ones; places 3, 6, 9
    EXPECT_EQ(grid.cuts(1), (std::vector<float>{0, 0, 1}));
    EXPECT_EQ(grid.cuts(2), (std::vector<float>{0, 0, 0}));
    EXPECT_EQ(grid.cell_count(), 64U);
}

TEST(ClusterGrid, TrianglesGoToTheCellOfTheirCentroid) {
    const GivenTriangles given(row());
    const ListedTriangles triangles = given.listed();
    const ClusterGrid grid(triangles, 4, 1);
    // y = ⅓ lies in part 2 (above both zeros, below 1); z = 0 lies on all three cuts, so in the uppermost part, 3
    for (std::uint32_t i = 0; i < 4; ++i) {
        EXPECT_EQ(grid.cell_of(triangles[i]), i + 4U * (2U + 4U * 3U));
    }
}

TEST(ClusterGrid, CentroidOnACutBelongsToTheUpperCell) {
    const GivenTriangles given(row());
    const ListedTriangles triangles = given.listed();
    const ClusterGrid grid(triangles, 4, 1);
    const auto x_part = [&](float x0, float x1, float x2) {
        return grid.cell_of({{glm::vec3(x0, 0, 0), glm::vec3(x1, 1, 0), glm::vec3(x2, 0, 0)}}) % 4;
    };
    EXPECT_EQ(x_part(5, 6, 7), 2U); // the centroid is 6, the second cut
    EXPECT_EQ(x_part(5, 6, 6.999999F), 1U);
    EXPECT_EQ(x_part(-9, -9, -9), 0U); // beyond the outermost planes
    EXPECT_EQ(x_part(99, 99, 99), 3U);
}

TEST(Clusters, BoxesAreTightAndEmptyCellsLeftOut) {
    const GivenTriangles given(row());
    const ListedTriangles triangles = given.listed();
    const Clustering clustering = cluster(triangles, 4, 1);
    ASSERT_EQ(clustering.clusters.size(), 4U);
    EXPECT_EQ(clustering.ranks, (std::vector<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_EQ(clustering.clusters[1].box.low, glm::vec3(3, 0, 0));
    EXPECT_EQ(clustering.clusters[1].box.high, glm::vec3(6, 1, 0));
    EXPECT_EQ(clustering.clusters[1].begin, 1U);
    EXPECT_EQ(clustering.clusters[1].end, 2U);
}

TEST(Clusters, EveryTriangleIsInOneClusterAndInItsBox) {
    for (const int splits : {1, 2, 4, 7, 64}) {
        const GivenTriangles given(test::soup_positions(500, 0.1F, 3));
        const ListedTriangles triangles = given.listed();
        const Clustering clustering = cluster(triangles, splits, 2);
        std::vector<int> seen(triangles.size());
        std::uint32_t end = 0;
        for (const Cluster& cluster : clustering.clusters) {
            EXPECT_EQ(cluster.begin, end);
            EXPECT_LT(cluster.begin, cluster.end);
            end = cluster.end;
            for (std::uint32_t i = cluster.begin; i < cluster.end; ++i) {
                ++seen[clustering.ranks[i]];
                Box box = cluster.box;
                box.add(triangles[clustering.ranks[i]].bounds());
                EXPECT_EQ(box.low, cluster.box.low);
                EXPECT_EQ(box.high, cluster.box.high);
            }
        }
        EXPECT_EQ(end, triangles.size());
        EXPECT_EQ(seen, std::vector<int>(triangles.size(), 1));
    }
}

TEST(Clusters, NoTriangles) {
    const GivenTriangles none({});
    const Clustering clustering = cluster(none.listed(), 4, 1);
    EXPECT_TRUE(clustering.clusters.empty());
    EXPECT_TRUE(clustering.ranks.empty());
}

} // namespace
} // namespace vkbake
