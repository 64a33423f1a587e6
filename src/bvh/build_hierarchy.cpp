#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>

#include "base/float_state.hpp"
#include "base/parallel.hpp"
#include "bvh/clusters.hpp"
#include "bvh/hierarchy.hpp"
#include "bvh/leaf_builder.hpp"
#include "bvh/split.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

constexpr std::size_t greatest_triangle_count = std::size_t{1} << 30U;
// 64³ clusters at most need 18 levels, 2³⁰ triangles 30: the rest is room for uneven cuts.
constexpr std::size_t top_depth = 24;
constexpr std::size_t cluster_depth = greatest_depth - top_depth;
// Below this many triangles another task costs more than it saves.
constexpr std::size_t task_size = 2048;
constexpr std::size_t grain = 8192;

struct BinaryNode {
    Box box;
    std::uint32_t left = 0; ///< slots; a leaf has neither
    std::uint32_t right = 0;
    std::uint32_t begin = 0; ///< of a leaf: its items
    std::uint32_t end = 0;

    [[nodiscard]] bool leaf() const { return begin < end; }
};

/// Slots are given by place, not by a counter: n items use 2·n − 1 slots at most, so each subtree knows its own, and
/// threads neither meet nor change the result.
class BinaryTree {
public:
    BinaryTree(const std::vector<Triangle>& triangles, int cluster_splits, int threads) : m_triangles(triangles) {
        Clustering clustering = cluster_triangles(triangles, cluster_splits, threads);
        m_items.resize(triangles.size());
        parallel_ranges(triangles.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                m_items[i] = {triangles[clustering.ranks[i]].bounds(), clustering.ranks[i], 1};
            }
        });
        m_clusters = std::move(clustering.clusters);
        m_nodes.resize(2 * (m_items.size() + m_clusters.size()));
        std::vector<BuildItem> tops;
        for (const Cluster& cluster : m_clusters) {
            tops.push_back({cluster.box, static_cast<std::uint32_t>(tops.size()), cluster.end - cluster.begin});
        }
        with_threads(threads, [&] { m_root = build_top(tops, 2 * m_items.size(), top_depth); });
    }

    [[nodiscard]] const BinaryNode& node(std::uint32_t slot) const { return m_nodes[slot]; }
    [[nodiscard]] std::uint32_t root() const { return m_root; }
    [[nodiscard]] std::size_t cluster_count() const { return m_clusters.size(); }
    [[nodiscard]] std::span<const BuildItem> items(const BinaryNode& leaf) const {
        return std::span(m_items).subspan(leaf.begin, leaf.end - leaf.begin);
    }

private:
    // Returns the slot of the subtree's root: for one cluster that of the cluster's own tree.
    std::uint32_t build_top(std::span<BuildItem> tops, std::size_t slot, std::size_t depth_left) {
        if (tops.size() == 1) {
            const Cluster& cluster = m_clusters[tops.front().index];
            const std::size_t own_slot = 2 * static_cast<std::size_t>(cluster.begin);
            build_below(cluster.begin, cluster.end, own_slot, cluster_depth);
            return static_cast<std::uint32_t>(own_slot);
        }
        const std::size_t count = split(tops, depth_left);
        BinaryNode& node = m_nodes[slot];
        parallel_both([&] { node.left = build_top(tops.first(count), slot + 1, depth_left - 1); },
                      [&] { node.right = build_top(tops.subspan(count), slot + 2 * count, depth_left - 1); });
        node.box = m_nodes[node.left].box;
        node.box.add(m_nodes[node.right].box);
        return static_cast<std::uint32_t>(slot);
    }

    [[nodiscard]] bool fit_a_leaf(std::size_t begin, std::size_t end) const {
        LeafBuilder leaf;
        for (std::size_t i = begin; i < end; ++i) {
            if (end - begin > leaf_width || !leaf.add(m_triangles[m_items[i].index])) {
                return false;
            }
        }
        return true;
    }

    void build_below(std::size_t begin, std::size_t end, std::size_t slot, std::size_t depth_left) {
        BinaryNode& node = m_nodes[slot];
        if (fit_a_leaf(begin, end)) {
            node.begin = static_cast<std::uint32_t>(begin);
            node.end = static_cast<std::uint32_t>(end);
            for (const BuildItem& item : items(node)) {
                node.box.add(item.box);
            }
            return;
        }
        const std::size_t count = split(std::span(m_items).subspan(begin, end - begin), depth_left);
        const std::size_t left = slot + 1;
        const std::size_t right = slot + 2 * count;
        const auto build_left = [&] { build_below(begin, begin + count, left, depth_left - 1); };
        const auto build_right = [&] { build_below(begin + count, end, right, depth_left - 1); };
        if (end - begin > task_size) {
            parallel_both(build_left, build_right);
        } else {
            build_left();
            build_right();
        }
        node.left = static_cast<std::uint32_t>(left);
        node.right = static_cast<std::uint32_t>(right);
        node.box = m_nodes[left].box;
        node.box.add(m_nodes[right].box);
    }

    const std::vector<Triangle>& m_triangles;
    std::vector<Cluster> m_clusters;
    std::vector<BuildItem> m_items;
    std::vector<BinaryNode> m_nodes;
    std::uint32_t m_root = 0;
};

/// Draws levels of the binary tree together into wide nodes.
class WideTree {
public:
    WideTree(const BinaryTree& tree, const std::vector<Triangle>& triangles) : m_tree(tree), m_triangles(triangles) {}

    Hierarchy take() && {
        m_hierarchy.clusters = m_tree.cluster_count();
        m_hierarchy.ranks.reserve(m_triangles.size());
        m_hierarchy.places.resize(m_triangles.size());
        add_node(m_tree.root(), 1);
        m_hierarchy.nodes.shrink_to_fit();
        m_hierarchy.leaves.shrink_to_fit();
        return std::move(m_hierarchy);
    }

private:
    // Opens the child of the largest box until the node is full: it is the one that most rays would open anyway (Wald,
    // Benthin, Boulos, "Getting Rid of Packets", 2008). A root that is a leaf becomes an only child.
    [[nodiscard]] std::vector<std::uint32_t> children_of(std::uint32_t slot) const {
        std::vector<std::uint32_t> children{slot};
        while (children.size() < node_width) {
            auto widest = children.end();
            double area = -1.0;
            for (auto child = children.begin(); child != children.end(); ++child) {
                const BinaryNode& node = m_tree.node(*child);
                if (!node.leaf() && node.box.half_area() > area) {
                    widest = child;
                    area = node.box.half_area();
                }
            }
            if (widest == children.end()) {
                break;
            }
            const BinaryNode& node = m_tree.node(*widest);
            *widest = node.left;
            children.insert(widest + 1, node.right);
        }
        return children;
    }

    std::uint32_t add_node(std::uint32_t slot, std::size_t depth) {
        const auto index = static_cast<std::uint32_t>(m_hierarchy.nodes.size());
        m_hierarchy.depth = std::max(m_hierarchy.depth, depth);
        WideNode wide{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            wide.planes[axis].fill(empty_low);
            wide.planes[axis + 3].fill(empty_high);
        }
        m_hierarchy.nodes.push_back(wide);
        std::size_t lane = 0;
        for (const std::uint32_t child : children_of(slot)) {
            const BinaryNode& node = m_tree.node(child);
            for (int axis = 0; axis < 3; ++axis) {
                wide.planes[static_cast<std::size_t>(axis)][lane] = node.box.low[axis];
                wide.planes[static_cast<std::size_t>(axis) + 3][lane] = node.box.high[axis];
            }
            wide.children[lane++] = node.leaf() ? add_leaf(m_tree.items(node)) : add_node(child, depth + 1);
        }
        m_hierarchy.nodes[index] = wide;
        return index;
    }

    std::uint32_t add_leaf(std::span<const BuildItem> items) {
        LeafBuilder leaf;
        for (const BuildItem& item : items) {
            leaf.add(m_triangles[item.index]);
        }
        m_hierarchy.leaves.push_back(leaf.take(static_cast<std::uint32_t>(m_hierarchy.ranks.size())));
        for (const BuildItem& item : items) {
            m_hierarchy.places[item.index] = static_cast<std::uint32_t>(m_hierarchy.ranks.size());
            m_hierarchy.ranks.push_back(item.index);
        }
        if (m_hierarchy.leaves.size() > greatest_leaf_count) {
            throw Error(ErrorKind::bad_input, "accelerator: more than 2^27 leaves; split the scene");
        }
        return leaf_child(m_hierarchy.leaves.size() - 1, items.size());
    }

    const BinaryTree& m_tree;
    const std::vector<Triangle>& m_triangles;
    Hierarchy m_hierarchy;
};

} // namespace

Hierarchy build_hierarchy(const std::vector<Triangle>& triangles, int cluster_splits, int threads) {
    if (triangles.size() > greatest_triangle_count) {
        throw Error(ErrorKind::bad_input, "accelerator: more than 2^30 triangles; split the scene");
    }
    if (triangles.empty()) {
        return {};
    }
    return WideTree(BinaryTree(triangles, cluster_splits, threads), triangles).take();
}

} // namespace vkbake
