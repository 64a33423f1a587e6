#include "bvh/hierarchy_part.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "bvh/leaf_builder.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

/// A part and what comes before it.
struct Placed {
    HierarchyPart* part;
    std::size_t first_node;
    std::size_t first_leaf;
};

/// A child that is the root of another part.
struct Link {
    std::size_t node;
    std::uint32_t lane;
    std::size_t part;
};

struct PartLayout {
    std::vector<Placed> parts;
    std::vector<Link> links;
    std::size_t nodes = 0;
    std::size_t leaves = 0;

    // As deep as tasks are nested: no deeper than the tree.
    void add(HierarchyPart& part) {
        const std::size_t first_node = nodes;
        parts.push_back({&part, nodes, leaves});
        nodes += part.nodes.size();
        leaves += part.leaves.size();
        for (const HierarchyPart::Below& below : part.below) {
            links.push_back({first_node + below.node, below.lane, parts.size()});
            add(*below.part);
        }
    }
};

class Joint {
public:
    Joint(const ListedTriangles& triangles, std::span<const std::uint16_t> corners, Hierarchy& hierarchy)
        : m_triangles(triangles), m_corners(corners), m_hierarchy(hierarchy) {}

    void copy(const Placed& placed) {
        for (std::size_t index = 0; index < placed.part->nodes.size(); ++index) {
            WideNode& node = m_hierarchy.nodes[placed.first_node + index];
            node = placed.part->nodes[index];
            fetch_leaves(node, placed);
            for (std::uint32_t& child : node.children) {
                if ((child & leaf_bit) != 0) {
                    const std::uint32_t place = placed.part->leaves[leaf_index(child)];
                    child += static_cast<std::uint32_t>(placed.first_leaf); // no more than 2²⁷: no carry
                    write_leaf(m_hierarchy.leaves[leaf_index(child)], m_triangles, ranks_of(place, child),
                               &m_corners[place], place);
                } else if (child != 0) {
                    child += static_cast<std::uint32_t>(placed.first_node);
                }
            }
        }
        placed.part->nodes.clear();
    }

private:
    [[nodiscard]] std::span<const std::uint32_t> ranks_of(std::uint32_t place, std::uint32_t child) const {
        return std::span(m_hierarchy.ranks).subspan(place, triangles_of(child));
    }

    void fetch_leaves(const WideNode& node, const Placed& placed) const {
        for (const std::uint32_t child : node.children) {
            if ((child & leaf_bit) != 0) {
                for (const std::uint32_t rank : ranks_of(placed.part->leaves[leaf_index(child)], child)) {
                    m_triangles.prefetch(rank);
                }
            }
        }
    }

    const ListedTriangles& m_triangles;
    std::span<const std::uint16_t> m_corners;
    Hierarchy& m_hierarchy;
};

} // namespace

void join(HierarchyPart& root, const ListedTriangles& triangles, std::span<const std::uint16_t> corners,
          Hierarchy& hierarchy, int threads) {
    PartLayout layout;
    layout.add(root);
    if (layout.leaves > greatest_leaf_count) {
        throw Error(ErrorKind::bad_input, "accelerator: more than 2^27 leaves; split the scene");
    }
    hierarchy.leaves.resize(layout.leaves);
    hierarchy.nodes.resize(layout.nodes);
    Joint joint(triangles, corners, hierarchy);
    parallel_ranges(layout.parts.size(), 1, threads,
                    [&](std::size_t part, std::size_t /*end*/) { joint.copy(layout.parts[part]); });
    for (const Link& link : layout.links) {
        hierarchy.nodes[link.node].children[link.lane] = static_cast<std::uint32_t>(layout.parts[link.part].first_node);
    }
    hierarchy.depth = root.depth;
}

} // namespace vkbake
