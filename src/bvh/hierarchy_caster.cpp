#include "bvh/hierarchy_caster.hpp"

#include <bit>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bvh/hierarchy_caster.cpp"
// Vectors of a length that is not known when compiling cannot be members of a struct.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vkbake::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#include "bvh/edge_functions.inl"

using Lanes = hn::CappedTag<float, node_width>;
using Vector = hn::Vec<Lanes>;
static_assert(node_width == leaf_width && node_width <= 8, "a mask is one byte, and one width serves both");

/// A bit a lane, for all parts of a row.
template<class Part>
HWY_INLINE unsigned gather_bits(Part part) {
    const Lanes lanes;
    unsigned bits = 0;
    for (std::size_t first = 0; first < node_width; first += hn::Lanes(lanes)) {
        std::array<std::uint8_t, 8> bytes{};
        hn::StoreMaskBits(lanes, part(first), bytes.data());
        bits |= static_cast<unsigned>(bytes[0]) << first;
    }
    return bits;
}

/// The same arithmetic as pass(), for the children of a node.
class NodeTest {
public:
    HWY_INLINE explicit NodeTest(const PreparedRay& ray)
        : m_near_x(set(ray.near_origin.x)), m_near_y(set(ray.near_origin.y)), m_near_z(set(ray.near_origin.z)),
          m_far_x(set(ray.far_origin.x)), m_far_y(set(ray.far_origin.y)), m_far_z(set(ray.far_origin.z)),
          m_inverse_x(set(ray.inverse.x)), m_inverse_y(set(ray.inverse.y)),
          m_inverse_z(set(ray.inverse.z)), m_near{ray.negative[0] ? 3U : 0U, ray.negative[1] ? 4U : 1U,
                                                  ray.negative[2] ? 5U : 2U},
          m_far{ray.negative[0] ? 0U : 3U, ray.negative[1] ? 1U : 4U, ray.negative[2] ? 2U : 5U} {}

    /// The children that the ray passes before `end`; where it enters them goes to `entries`.
    HWY_INLINE unsigned operator()(const WideNode& node, float end, float* entries) const {
        const Lanes lanes;
        return gather_bits([&](std::size_t first) HWY_ATTR {
            const auto plane = [&](std::size_t row) HWY_ATTR { return hn::Load(lanes, &node.planes[row][first]); };
            const Vector near_x = (plane(m_near[0]) - m_near_x) * m_inverse_x;
            const Vector near_y = (plane(m_near[1]) - m_near_y) * m_inverse_y;
            const Vector near_z = (plane(m_near[2]) - m_near_z) * m_inverse_z;
            const Vector far_x = (plane(m_far[0]) - m_far_x) * m_inverse_x;
            const Vector far_y = (plane(m_far[1]) - m_far_y) * m_inverse_y;
            const Vector far_z = (plane(m_far[2]) - m_far_z) * m_inverse_z;
            const Vector entry = hn::Max(hn::Max(near_x, near_y), hn::Max(near_z, hn::Zero(lanes)));
            const Vector exit = hn::Min(hn::Min(far_x, far_y), hn::Min(far_z, set(end)));
            if (entries != nullptr) {
                hn::Store(entry, lanes, entries + first);
            }
            return hn::Le(entry, exit);
        });
    }

private:
    static HWY_INLINE Vector set(float value) { return hn::Set(Lanes(), value); }

    Vector m_near_x, m_near_y, m_near_z, m_far_x, m_far_y, m_far_z, m_inverse_x, m_inverse_y, m_inverse_z;
    std::array<std::size_t, 3> m_near, m_far;
};

/// The triangles of a leaf that test_watertight might hit: all but those that its float edge functions reject.
HWY_INLINE unsigned candidates(const PreparedRay& ray, const Leaf& leaf) {
    const Lanes lanes;
    const auto x = static_cast<std::size_t>(ray.x_axis);
    const auto y = static_cast<std::size_t>(ray.y_axis);
    const auto z = static_cast<std::size_t>(ray.z_axis);
    const Vector origin_x = hn::Set(lanes, ray.origin[ray.x_axis]);
    const Vector origin_y = hn::Set(lanes, ray.origin[ray.y_axis]);
    const Vector origin_z = hn::Set(lanes, ray.origin[ray.z_axis]);
    const Vector slope_x = hn::Set(lanes, ray.shear_x);
    const Vector slope_y = hn::Set(lanes, ray.shear_y);
    return gather_bits([&](std::size_t first) HWY_ATTR {
        const auto row = [&](std::size_t corner, std::size_t axis)
                             HWY_ATTR { return hn::Load(lanes, &leaf.corners[corner][axis][first]); };
        const Vector az = row(0, z) - origin_z;
        const Vector bz = row(1, z) - origin_z;
        const Vector cz = row(2, z) - origin_z;
        const EdgeFunctions<Vector> edge(
            {shear(row(0, x) - origin_x, slope_x, az), shear(row(0, y) - origin_y, slope_y, az),
             shear(row(1, x) - origin_x, slope_x, bz), shear(row(1, y) - origin_y, slope_y, bz),
             shear(row(2, x) - origin_x, slope_x, cz), shear(row(2, y) - origin_y, slope_y, cz)});
        const Vector least = hn::Min(edge.u, hn::Min(edge.v, edge.w));
        const Vector greatest = hn::Max(edge.u, hn::Max(edge.v, edge.w));
        return hn::Or(hn::Ge(least, hn::Zero(lanes)), hn::Le(greatest, hn::Zero(lanes)));
    });
}

HWY_INLINE Triangle triangle_in(const Leaf& leaf, std::size_t lane) {
    Triangle triangle;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const auto& rows = leaf.corners[corner];
        triangle.corners[corner] = {rows[0][lane], rows[1][lane], rows[2][lane]};
    }
    return triangle;
}

bool occluded(const Hierarchy& hierarchy, const PreparedRay& ray) {
    const NodeTest passes(ray);
    std::array<std::uint32_t, stack_size>
        stack; // NOLINT(cppcoreguidelines-pro-type-member-init): zeroing costs more than a ray
    stack[0] = 0;
    std::size_t size = 1;
    while (size > 0) {
        const std::uint32_t child = stack[--size];
        if ((child & leaf_bit) == 0) {
            const WideNode& node = hierarchy.nodes[child];
            for (unsigned bits = passes(node, ray.max_distance, nullptr); bits != 0; bits &= bits - 1) {
                stack[size++] = node.children[static_cast<std::size_t>(std::countr_zero(bits))];
            }
            continue;
        }
        const Leaf& leaf = hierarchy.leaves[child & ~leaf_bit];
        for (unsigned bits = candidates(ray, leaf); bits != 0; bits &= bits - 1) {
            if (test_watertight(ray, triangle_in(leaf, static_cast<std::size_t>(std::countr_zero(bits)))).hit) {
                return true;
            }
        }
    }
    return false;
}

struct Pending {
    std::uint32_t child;
    float entry;
};

/// Pushes the children so that the nearest one is on top.
HWY_INLINE std::size_t push(Pending* stack, std::size_t size, const WideNode& node, unsigned bits,
                            const float* entries) {
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
    NearestHit best(ray);
    std::array<Pending, stack_size> stack; // NOLINT(cppcoreguidelines-pro-type-member-init): as above
    stack[0] = {0, 0.0F};
    std::size_t size = 1;
    while (size > 0) {
        const Pending pending = stack[--size];
        if (pending.entry > best.distance) { // not where equal: a tie may be decided in there
            continue;
        }
        if ((pending.child & leaf_bit) == 0) {
            const WideNode& node = hierarchy.nodes[pending.child];
            alignas(64) std::array<float, node_width> entries;
            const unsigned bits = passes(node, best.distance, entries.data());
            size = push(stack.data(), size, node, bits, entries.data());
            continue;
        }
        const Leaf& leaf = hierarchy.leaves[pending.child & ~leaf_bit];
        for (unsigned bits = candidates(ray, leaf); bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            best.offer(test_watertight(ray, triangle_in(leaf, lane)), leaf.ranks[lane]);
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

HierarchyCaster::HierarchyCaster(Hierarchy hierarchy) : m_hierarchy(std::move(hierarchy)) {}

bool HierarchyCaster::occluded(const PreparedRay& ray) const {
    return HWY_DYNAMIC_DISPATCH(occluded)(m_hierarchy, ray);
}

NearestHit HierarchyCaster::nearest(const PreparedRay& ray) const {
    return HWY_DYNAMIC_DISPATCH(nearest)(m_hierarchy, ray);
}

AcceleratorStatistics HierarchyCaster::statistics() const {
    AcceleratorStatistics statistics;
    statistics.clusters = m_hierarchy.clusters;
    statistics.nodes = m_hierarchy.nodes.size();
    statistics.leaves = m_hierarchy.leaves.size();
    statistics.depth = m_hierarchy.depth;
    statistics.bytes = m_hierarchy.nodes.capacity() * sizeof(WideNode) + m_hierarchy.leaves.capacity() * sizeof(Leaf);
    return statistics;
}

} // namespace vkbake
#endif
