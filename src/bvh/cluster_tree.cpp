#include "bvh/cluster_tree.hpp"

#include "base/parallel.hpp"

namespace vkbake {
namespace {

// Below this many clusters another task costs more than it saves.
constexpr std::size_t clusters_a_task = 2048;

} // namespace

ClusterTree::ClusterTree(const ListedTriangles& triangles, int cluster_splits, std::size_t depth, int threads)
    : m_items(triangles.size()) {
    m_clusters = cluster_triangles(triangles, cluster_splits, threads,
                                   [&](std::uint32_t place, std::uint32_t rank, const Box& bounds) {
                                       m_items[place] = {bounds.low, bounds.high, rank, 1};
                                   });
    std::vector<BuildItem> clusters;
    clusters.reserve(m_clusters.size());
    for (const Cluster& cluster : m_clusters) {
        clusters.push_back({cluster.box.low, cluster.box.high, static_cast<std::uint32_t>(clusters.size()),
                            cluster.end - cluster.begin});
    }
    // Nodes are given by place, not by a counter: n clusters are under 2·n − 1 nodes, so each subtree knows its own.
    m_nodes.resize(2 * m_clusters.size() - 1);
    with_threads(threads, [&] { build(clusters, root(), depth); });
}

void ClusterTree::build(std::span<BuildItem> clusters, std::uint32_t index, std::size_t depth_left) {
    Node& node = m_nodes[index];
    if (clusters.size() == 1) {
        const Cluster& cluster = m_clusters[clusters.front().index];
        node = {.box = cluster.box, .begin = cluster.begin, .end = cluster.end};
        return;
    }
    const Halves halves = split(clusters, depth_left);
    const auto count = static_cast<std::uint32_t>(halves.first_count);
    node.first = index + 1;
    node.second = index + 2 * count;
    const auto build_first = [&] { build(clusters.first(count), node.first, depth_left - 1); };
    const auto build_second = [&] { build(clusters.subspan(count), node.second, depth_left - 1); };
    if (clusters.size() > clusters_a_task) {
        parallel_both(build_first, build_second);
    } else {
        build_first();
        build_second();
    }
    node.box = halves.first;
    node.box.add(halves.second);
    const Node& first = m_nodes[node.first];
    const Node& second = m_nodes[node.second];
    node.end = first.end - first.begin + second.end - second.begin;
}

} // namespace vkbake
