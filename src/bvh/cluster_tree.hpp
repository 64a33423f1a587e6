// The top of the hierarchy: a binary tree over the clusters, and the items of each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bvh/clusters.hpp"
#include "bvh/split.hpp"
#include "bvh/uninitialised.hpp"

namespace vkbake {

class ClusterTree {
public:
    struct Node {
        Box box;
        std::uint32_t first = 0; ///< the nodes of both halves; a cluster has none
        std::uint32_t second = 0;
        std::uint32_t begin = 0; ///< of a cluster: its items. Otherwise end − begin are as many as all clusters have
        std::uint32_t end = 0;

        [[nodiscard]] bool cluster() const { return first == second; }
    };

    /// Surface-area heuristic over the clusters (see clusters.hpp), at most `depth` levels of it; 64³ clusters need 18.
    /// At least one triangle; the items carry ranks.
    ClusterTree(const ListedTriangles& triangles, int cluster_splits, std::size_t depth, int threads);

    [[nodiscard]] const Node& node(std::uint32_t index) const { return m_nodes[index]; }
    [[nodiscard]] static constexpr std::uint32_t root() { return 0; }
    [[nodiscard]] std::size_t cluster_count() const { return m_clusters.size(); }
    [[nodiscard]] std::span<BuildItem> items() { return m_items; }

private:
    void build(std::span<BuildItem> clusters, std::uint32_t index, std::size_t depth_left);

    UninitialisedVector<BuildItem> m_items;
    std::vector<Cluster> m_clusters;
    std::vector<Node> m_nodes;
};

} // namespace vkbake
