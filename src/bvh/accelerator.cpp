#include "bvh/accelerator.hpp"

#include <utility>
#include <vector>

#include "base/float_state.hpp"
#include "bvh/brute_force.hpp"
#include "bvh/cluster_list.hpp"
#include "bvh/hierarchy_caster.hpp"
#include "bvh/triangle_list.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

struct TriangleAccelerator::State {
    std::vector<std::uint32_t> numbers; // by rank
    Box bounds;
    std::unique_ptr<RayCaster> caster;
};

namespace {

void check(const AcceleratorSettings& settings) {
    if (settings.cluster_splits < 1 || settings.cluster_splits > 64) {
        throw Error(ErrorKind::usage, "accelerator: cluster splits must be 1 to 64; choose one of these");
    }
    if (settings.kind == Accelerator::bvh && settings.test == TriangleTest::moller_trumbore) {
        throw Error(ErrorKind::usage,
                    "accelerator: the Möller–Trumbore test goes with the accelerators clusters and brute "
                    "only; choose one of these, or the watertight test");
    }
}

std::unique_ptr<RayCaster> make_caster(std::vector<Triangle> triangles, const AcceleratorSettings& settings) {
    switch (settings.kind) {
    case Accelerator::brute:
        return std::make_unique<BruteForce>(std::move(triangles), settings.test);
    case Accelerator::clusters:
        return std::make_unique<ClusterList>(triangles, settings.cluster_splits, settings.threads, settings.test);
    case Accelerator::bvh:
        break;
    }
    return std::make_unique<HierarchyCaster>(build_hierarchy(triangles, settings.cluster_splits, settings.threads));
}

} // namespace

TriangleAccelerator::TriangleAccelerator(std::span<const glm::vec3> positions,
                                         std::span<const std::uint32_t> canonical_order,
                                         const AcceleratorSettings& settings) {
    check(settings);
    const DefaultFloatState state; // what is built must not depend on the caller's either
    TriangleList list = list_triangles(positions, canonical_order);
    auto caster = make_caster(std::move(list.triangles), settings);
    m_state = std::make_unique<State>(State{std::move(list.numbers), list.bounds, std::move(caster)});
}

TriangleAccelerator::~TriangleAccelerator() = default;
TriangleAccelerator::TriangleAccelerator(TriangleAccelerator&&) noexcept = default;
TriangleAccelerator& TriangleAccelerator::operator=(TriangleAccelerator&&) noexcept = default;

bool TriangleAccelerator::occluded(const Ray& ray) const {
    const PreparedRay prepared(ray, m_state->bounds);
    return prepared.valid && m_state->caster->occluded(prepared);
}

std::optional<Hit> TriangleAccelerator::nearest(const Ray& ray) const {
    const PreparedRay prepared(ray, m_state->bounds);
    if (!prepared.valid) {
        return std::nullopt;
    }
    const NearestHit hit = m_state->caster->nearest(prepared);
    if (!hit.found) {
        return std::nullopt;
    }
    return Hit{m_state->numbers[hit.rank], hit.distance, hit.back_side};
}

BlockedRays TriangleAccelerator::blocked(const RayBlock& block, BlockScratch& scratch) const {
    return m_state->caster->blocked(block, m_state->bounds, scratch);
}

BlockScratch TriangleAccelerator::make_scratch() const { return m_state->caster->make_scratch(); }

AcceleratorStatistics TriangleAccelerator::statistics() const {
    AcceleratorStatistics statistics = m_state->caster->statistics();
    statistics.triangles = m_state->numbers.size();
    statistics.bytes += m_state->numbers.capacity() * sizeof(std::uint32_t) + sizeof(State);
    return statistics;
}

} // namespace vkbake
