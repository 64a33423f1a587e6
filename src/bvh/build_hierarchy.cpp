#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "bvh/cluster_tree.hpp"
#include "bvh/hierarchy.hpp"
#include "bvh/hierarchy_part.hpp"
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
constexpr std::size_t triangles_a_task = 4096;
constexpr std::size_t items_a_range = 16384;

// What a ray that passes a leaf's box pays, and for a further child the one that passes its node; in tests of eight
// triangles. Chosen by speed and memory together, by the measurements in docs/tracing.md: at about half of each, and
// with the smallest leaves halved too, a twentieth to a fifth fewer leaves are visited, for a fifth to two fifths more
// memory.
constexpr double leaf_visit_cost = 2.0;
constexpr double child_cost = 0.5;
[[nodiscard]] constexpr double leaf_cost(std::size_t triangles) {
    return leaf_visit_cost + static_cast<double>(triangles) / 8.0;
}
/// Fewer triangles are left together: a smaller leaf takes as many bytes, and trying costs time.
constexpr std::size_t least_to_halve = 8;
/// Of the area of a leaf's box, that its triangles' boxes have in the mean. At 0.15 the bunny is traced 8 % slower;
/// trying whatever it is takes a tenth more of the build's time, and traces none of three scenes faster.
constexpr double greatest_filled_share = 0.2;
/// Cuts that leave at least one triangle of a leaf's on either side, and more than enough of them.
constexpr std::size_t levels_in_leaf = 5;

/// A subtree to be: a node of the tree over the clusters, or triangles of one cluster.
struct Subtree {
    Box box;
    double half_area = 0.0; ///< −1 where it is not opened any more
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t cluster_node = 0; ///< none but where `of_clusters`
    bool of_clusters = false;
    std::size_t depth_left = 0; ///< levels of cuts
    bool leaf = false;          ///< its triangles find room in one

    [[nodiscard]] bool closed() const { return half_area < 0.0; }
    [[nodiscard]] std::size_t size() const { return end - begin; }
};

/// The children of a node: open() them until the node is full.
class Children {
public:
    explicit Children(const Subtree& only) { m_children[0] = only; }

    [[nodiscard]] std::span<Subtree> all() { return {m_children.data(), m_count}; }
    [[nodiscard]] bool full() const { return m_count == node_width; }
    /// The child of the largest box: it is the one that most rays would open anyway (Wald, Benthin, Boulos, "Getting
    /// Rid of Packets", 2008). One that is closed only where there is nothing else.
    [[nodiscard]] std::size_t widest() const {
        std::size_t widest = 0;
        for (std::size_t child = 1; child < m_count; ++child) {
            widest = m_children[child].half_area > m_children[widest].half_area ? child : widest;
        }
        return widest;
    }
    void replace(std::size_t child, const Subtree& first, const Subtree& second) {
        const auto place = m_children.begin() + static_cast<std::ptrdiff_t>(child);
        const auto end = m_children.begin() + static_cast<std::ptrdiff_t>(m_count++);
        std::copy_backward(place + 1, end, end + 1);
        *place = first;
        *(place + 1) = second;
    }

private:
    std::array<Subtree, node_width> m_children;
    std::size_t m_count = 1;
};

void run_all(std::span<const std::function<void()>> tasks) {
    if (tasks.size() == 1) {
        tasks.front()();
    } else if (!tasks.empty()) {
        const std::size_t half = tasks.size() / 2;
        parallel_both([&] { run_all(tasks.first(half)); }, [&] { run_all(tasks.subspan(half)); });
    }
}

/// Builds wide nodes from the top, without the levels of the binary tree between them.
class Build {
public:
    Build(const ListedTriangles& triangles, ClusterTree& clusters)
        : m_triangles(triangles), m_clusters(clusters), m_items(clusters.items()) {}

    void run(HierarchyPart& part) {
        Subtree root = subtree_of(ClusterTree::root());
        try_leaf(root); // a root that is a leaf becomes an only child
        add_node(root, 1, part);
    }

private:
    [[nodiscard]] std::span<BuildItem> items_of(const Subtree& subtree) const {
        return m_items.subspan(subtree.begin, subtree.size());
    }
    [[nodiscard]] Subtree subtree_of(std::uint32_t cluster_node) const {
        const ClusterTree::Node& node = m_clusters.node(cluster_node);
        Subtree subtree{.box = node.box, .half_area = node.box.half_area(), .begin = node.begin, .end = node.end};
        subtree.cluster_node = cluster_node;
        subtree.of_clusters = !node.cluster();
        subtree.depth_left = cluster_depth;
        return subtree;
    }

    // Where they make a leaf, which vertices are whose goes with the items, in place of their weight of 1.
    void try_leaf(Subtree& subtree) const {
        if (subtree.size() > leaf_width || subtree.of_clusters) {
            return;
        }
        const std::span<BuildItem> items = items_of(subtree);
        for (const BuildItem& item : items) {
            m_triangles.prefetch(item.index);
        }
        LeafBuilder leaf;
        for (const BuildItem& item : items) {
            if (!leaf.add(m_triangles[item.index])) {
                return;
            }
        }
        for (std::size_t lane = 0; lane < items.size(); ++lane) {
            items[lane].weight = leaf.corners(lane);
        }
        subtree.leaf = true;
    }

    void open(Children& children, std::size_t place) const {
        Subtree& subtree = children.all()[place];
        if (subtree.of_clusters) {
            const ClusterTree::Node& node = m_clusters.node(subtree.cluster_node);
            replace(children, place, subtree_of(node.first), subtree_of(node.second));
        } else if (!subtree.leaf) {
            const auto [first, second] = halves_of(subtree, split(items_of(subtree), subtree.depth_left));
            replace(children, place, first, second);
        } else if (const std::optional<Halves> halves = worthwhile_halves(subtree)) {
            const auto [first, second] = halves_of(subtree, *halves);
            replace(children, place, first, second);
        } else {
            subtree.half_area = -1.0;
        }
    }

    /// Whether the items' own boxes are so large beside the one around all that cutting is not worth trying.
    [[nodiscard]] static bool well_filled(std::span<const BuildItem> items, double half_area) {
        double filled = 0.0;
        for (const BuildItem& item : items) {
            filled += item.box().half_area();
        }
        return filled > greatest_filled_share * half_area * static_cast<double>(items.size());
    }

    /// Of a leaf that is better two, whose items it puts in the order of these; otherwise nothing is changed.
    [[nodiscard]] std::optional<Halves> worthwhile_halves(const Subtree& subtree) const {
        const std::size_t count = subtree.size();
        const std::span<BuildItem> items = items_of(subtree);
        if (count < least_to_halve || subtree.depth_left <= levels_in_leaf || well_filled(items, subtree.half_area)) {
            return std::nullopt;
        }
        std::array<BuildItem, leaf_width> copies; // NOLINT(cppcoreguidelines-pro-type-member-init): written below
        std::copy(items.begin(), items.end(), copies.begin());
        for (BuildItem& copy : copies) {
            copy.weight = 1;
        }
        const Halves halves = split(std::span(copies).first(count), subtree.depth_left);
        const double apart = halves.first.half_area() * leaf_cost(halves.first_count) +
                             halves.second.half_area() * leaf_cost(count - halves.first_count) +
                             subtree.half_area * child_cost;
        if (apart >= subtree.half_area * leaf_cost(count)) {
            return std::nullopt;
        }
        std::copy_n(copies.begin(), count, items.begin());
        return halves;
    }

    static std::pair<Subtree, Subtree> halves_of(const Subtree& subtree, const Halves& halves) {
        const std::uint32_t middle = subtree.begin + static_cast<std::uint32_t>(halves.first_count);
        const auto half = [&](const Box& box, std::uint32_t begin, std::uint32_t end) {
            Subtree child{.box = box, .half_area = box.half_area(), .begin = begin, .end = end};
            child.depth_left = subtree.depth_left - 1;
            return child;
        };
        return {half(halves.first, subtree.begin, middle), half(halves.second, middle, subtree.end)};
    }

    void replace(Children& children, std::size_t place, Subtree first, Subtree second) const {
        try_leaf(first);
        try_leaf(second);
        children.replace(place, first, second);
    }

    std::uint32_t add_node(const Subtree& subtree, std::size_t depth, HierarchyPart& part) {
        const auto index = static_cast<std::uint32_t>(part.nodes.size());
        WideNode& node = part.nodes.push_back(); // stays where it is
        part.depth = std::max(part.depth, depth);
        Children children(subtree);
        for (std::size_t widest = 0; !children.full() && !children.all()[widest].closed(); widest = children.widest()) {
            open(children, widest);
        }
        write(node, children.all());
        std::vector<std::function<void()>> tasks;
        const std::size_t first_below = part.below.size();
        for (std::uint32_t lane = 0; lane < children.all().size(); ++lane) {
            const Subtree& child = children.all()[lane];
            if (child.leaf) {
                node.children[lane] = leaf_child(part.leaves.size(), child.size());
                part.leaves.push_back(child.begin);
            } else if (child.size() <= triangles_a_task) {
                node.children[lane] = add_node(child, depth + 1, part);
            } else {
                part.below.push_back({index, lane, std::make_unique<HierarchyPart>()});
                HierarchyPart& below = *part.below.back().part;
                tasks.emplace_back([this, &child, depth, &below] { add_node(child, depth + 1, below); });
            }
        }
        run_all(tasks);
        for (std::size_t below = first_below; below < part.below.size(); ++below) {
            part.depth = std::max(part.depth, part.below[below].part->depth);
        }
        return index;
    }

    static void write(WideNode& node, std::span<const Subtree> children) {
        node.children.fill(0);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            node.planes[axis].fill(empty_low);
            node.planes[axis + 3].fill(empty_high);
            for (std::size_t lane = 0; lane < children.size(); ++lane) {
                node.planes[axis][lane] = children[lane].box.low[static_cast<int>(axis)];
                node.planes[axis + 3][lane] = children[lane].box.high[static_cast<int>(axis)];
            }
        }
    }

    const ListedTriangles& m_triangles;
    const ClusterTree& m_clusters;
    std::span<BuildItem> m_items;
};

} // namespace

Hierarchy build_hierarchy(const ListedTriangles& triangles, int cluster_splits, int threads) {
    if (triangles.size() > greatest_triangle_count) {
        throw Error(ErrorKind::bad_input, "accelerator: more than 2^30 triangles; split the scene");
    }
    Hierarchy hierarchy;
    if (triangles.size() == 0) {
        return hierarchy;
    }
    HierarchyPart root;
    UninitialisedVector<std::uint16_t> corners(triangles.size());
    hierarchy.ranks.resize(triangles.size());
    {
        ClusterTree clusters(triangles, cluster_splits, top_depth, threads);
        with_threads(threads, [&] { Build(triangles, clusters).run(root); });
        hierarchy.clusters = clusters.cluster_count();
        const std::span<const BuildItem> items = clusters.items();
        parallel_ranges(items.size(), items_a_range, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t place = begin; place < end; ++place) {
                hierarchy.ranks[place] = items[place].index;
                corners[place] = static_cast<std::uint16_t>(items[place].weight);
            }
        });
    }
    join(root, triangles, corners, hierarchy, threads);
    hierarchy.places.resize(triangles.size());
    parallel_ranges(triangles.size(), items_a_range, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t place = begin; place < end; ++place) {
            hierarchy.places[hierarchy.ranks[place]] = static_cast<std::uint32_t>(place);
        }
    });
    return hierarchy;
}

} // namespace vkbake
