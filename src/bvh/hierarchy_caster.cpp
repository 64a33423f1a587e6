#include "bvh/hierarchy_caster.hpp"

#include <array>
#include <bit>
#include <cstring>
#include <type_traits>
#include <utility>

#include "base/simd_targets.hpp"
#include "bvh/block_caster.hpp"
#include "bvh/lane_sets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bvh/hierarchy_caster.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vkbake::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#include "bvh/row.inl"
// after row.inl
#include "bvh/leaf_test.inl"

/// The same arithmetic as pass(), for the children of a node.
class NodeTest {
public:
    HWY_INLINE explicit NodeTest(const PreparedRay& ray) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<int>(axis);
            m_near_origin[axis] = fill(ray.near_origin[a]);
            m_far_origin[axis] = fill(ray.far_origin[a]);
            m_inverse[axis] = fill(ray.inverse[a]);
            m_near[axis] = ray.negative[axis] ? axis + 3 : axis;
            m_far[axis] = ray.negative[axis] ? axis : axis + 3;
        }
    }

    /// The children that the ray passes before `end`; where it enters them goes to `entries`.
    HWY_INLINE unsigned operator()(const WideNode& node, float end, std::array<float, node_width>& entries) const {
        Row entry = fill(0.0F);
        Row exit = fill(end);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            entry = max(entry, (load(node.planes[m_near[axis]]) - m_near_origin[axis]) * m_inverse[axis]);
            exit = min(exit, (load(node.planes[m_far[axis]]) - m_far_origin[axis]) * m_inverse[axis]);
        }
        store(entry, entries);
        return (entry <= exit).bits();
    }

private:
    Row m_near_origin[3], m_far_origin[3], m_inverse[3]; // NOLINT(modernize-avoid-c-arrays): see row.inl
    std::array<std::size_t, 3> m_near{}, m_far{};
};

struct Candidates {
    unsigned bits; ///< the triangles that may be met
    bool met;      ///< one of them for certain
};

/// One ray against leaves.
class LeafTest {
public:
    HWY_INLINE explicit LeafTest(const Hierarchy& hierarchy, const PreparedRay& ray)
        : m_ignored(place_of(hierarchy, ray.ignored_rank)), m_axes{static_cast<std::uint32_t>(ray.x_axis),
                                                                   static_cast<std::uint32_t>(ray.y_axis),
                                                                   static_cast<std::uint32_t>(ray.z_axis)},
          m_limits(ray.max_distance < std::numeric_limits<float>::infinity(), sure_sum_of(ray.extent)) {
        const float sign = ray.direction[ray.z_axis] < 0.0F ? -1.0F : 1.0F;
        const float depth = ray.max_distance * sign * ray.direction[ray.z_axis];
        m_rays = {fill<1>(ray.origin[ray.x_axis]),
                  fill<1>(ray.origin[ray.y_axis]),
                  fill<1>(sign),
                  fill<1>(sign * ray.origin[ray.z_axis]),
                  fill<1>(sign * ray.shear_x),
                  fill<1>(sign * ray.shear_y),
                  fill<1>(depth * nearly_one),
                  fill<1>(depth * just_over_one)};
    }

    HWY_INLINE Candidates operator()(const Leaf& leaf, std::uint32_t child) const {
        const LeafBits met = test_leaf(m_rays, m_limits, m_axes, leaf, triangles_of(child));
        const unsigned others = triangles_but(leaf, child, m_ignored);
        return {met.doubt & others, (met.hit & others) != 0};
    }

private:
    std::uint32_t m_ignored; ///< a place
    LeafAxes m_axes;
    LeafLimits<1> m_limits;
    LeafRays<1> m_rays;
};

/// Calls visit(leaf, child) for the leaves whose boxes the ray passes until it returns true; returns whether it did.
template<class Visit>
HWY_INLINE bool any_leaf(const Hierarchy& hierarchy, const PreparedRay& ray, const Visit& visit) {
    const NodeTest passes(ray);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): zeroing costs more than a ray
    std::array<std::uint32_t, stack_size> stack;
    alignas(64) std::array<float, node_width> entries{};
    stack[0] = 0;
    std::size_t size = 1;
    while (size > 0) {
        const std::uint32_t child = stack[--size];
        if ((child & leaf_bit) == 0) {
            const WideNode& node = hierarchy.nodes[child];
            for (unsigned bits = passes(node, ray.max_distance, entries); bits != 0; bits &= bits - 1) {
                stack[size++] = node.children[static_cast<std::size_t>(std::countr_zero(bits))];
            }
        } else if (visit(hierarchy.leaves[leaf_index(child)], child)) {
            return true;
        }
    }
    return false;
}

bool occluded(const Hierarchy& hierarchy, const PreparedRay& ray) {
    const LeafTest test(hierarchy, ray);
    return any_leaf(hierarchy, ray, [&](const Leaf& leaf, std::uint32_t child) HWY_ATTR {
        const Candidates candidates = test(leaf, child);
        for (unsigned bits = candidates.bits; bits != 0 && !candidates.met; bits &= bits - 1) {
            if (test_watertight(ray, triangle_in(leaf, static_cast<std::size_t>(std::countr_zero(bits)))).hit) {
                return true;
            }
        }
        return candidates.met;
    });
}

bool filter(const Hierarchy& hierarchy, const PreparedRay& ray, const RankedFilter& crossings) {
    const LeafTest test(hierarchy, ray);
    return any_leaf(hierarchy, ray, [&](const Leaf& leaf, std::uint32_t child) HWY_ATTR {
        for (unsigned bits = test(leaf, child).bits; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            if (filter_triangle(TriangleTest::watertight, ray, triangle_in(leaf, lane),
                                hierarchy.ranks[leaf.first_place + lane], crossings)) {
                return true;
            }
        }
        return false;
    });
}

struct Pending {
    std::uint32_t child;
    float entry;
};

/// Pushes the children so that the nearest one is on top.
HWY_INLINE std::size_t push(Pending* stack, std::size_t size, const WideNode& node, unsigned bits,
                            const std::array<float, node_width>& entries) {
    const std::size_t base = size;
    for (; bits != 0; bits &= bits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
        std::size_t place = size++;
        for (; place > base && stack[place - 1].entry < entries[lane]; --place) {
            stack[place] = stack[place - 1];
        }
        stack[place] = {node.children[lane], entries[lane]};
    }
    return size;
}

NearestHit nearest(const Hierarchy& hierarchy, const PreparedRay& ray) {
    const NodeTest passes(ray);
    const LeafTest test(hierarchy, ray);
    NearestHit best(ray);
    std::array<Pending, stack_size> stack; // NOLINT(cppcoreguidelines-pro-type-member-init): as above
    alignas(64) std::array<float, node_width> entries{};
    stack[0] = {0, 0.0F};
    std::size_t size = 1;
    while (size > 0) {
        const Pending pending = stack[--size];
        if (pending.entry > best.distance) { // not where equal: a tie may be decided in there
            continue;
        }
        if ((pending.child & leaf_bit) == 0) {
            const WideNode& node = hierarchy.nodes[pending.child];
            const unsigned bits = passes(node, best.distance, entries);
            size = push(stack.data(), size, node, bits, entries);
            continue;
        }
        const Leaf& leaf = hierarchy.leaves[leaf_index(pending.child)];
        for (unsigned bits = test(leaf, pending.child).bits; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            best.offer(test_watertight(ray, triangle_in(leaf, lane)), hierarchy.ranks[leaf.first_place + lane]);
        }
    }
    return best;
}

} // namespace vkbake::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vkbake {

HWY_EXPORT(occluded);
HWY_EXPORT(nearest);
HWY_EXPORT(filter);

HierarchyCaster::HierarchyCaster(Hierarchy hierarchy) : m_hierarchy(std::move(hierarchy)) {}

bool HierarchyCaster::occluded(const PreparedRay& ray) const {
    return HWY_DYNAMIC_DISPATCH(occluded)(m_hierarchy, ray);
}

NearestHit HierarchyCaster::nearest(const PreparedRay& ray) const {
    return HWY_DYNAMIC_DISPATCH(nearest)(m_hierarchy, ray);
}

bool HierarchyCaster::filter(const PreparedRay& ray, const RankedFilter& filter) const {
    return HWY_DYNAMIC_DISPATCH(filter)(m_hierarchy, ray, filter);
}

BlockedRays HierarchyCaster::blocked(const RayBlock& block, const IgnoredRanks& ignored, const Box& bounds,
                                     BlockScratch& scratch) const {
    IgnoredPlaces places{};
    for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
        places[lane] = place_of(m_hierarchy, ignored[lane]);
    }
    return blocked_rays(m_hierarchy, block, places, bounds, scratch);
}

BlockScratch HierarchyCaster::make_scratch() const { return BlockScratch(queue_capacity(m_hierarchy)); }

AcceleratorStatistics HierarchyCaster::statistics() const {
    AcceleratorStatistics statistics;
    statistics.clusters = m_hierarchy.clusters;
    statistics.nodes = m_hierarchy.nodes.size();
    statistics.leaves = m_hierarchy.leaves.size();
    statistics.depth = m_hierarchy.depth;
    statistics.bytes = m_hierarchy.nodes.capacity() * sizeof(WideNode) + m_hierarchy.leaves.capacity() * sizeof(Leaf) +
                       (m_hierarchy.ranks.capacity() + m_hierarchy.places.capacity()) * sizeof(std::uint32_t);
    return statistics;
}

} // namespace vkbake
#endif
