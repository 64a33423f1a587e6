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
    TriangleList list;
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

std::unique_ptr<RayCaster> make_caster(const ListedTriangles& triangles, const AcceleratorSettings& settings) {
    switch (settings.kind) {
    case Accelerator::brute:
        return std::make_unique<BruteForce>(triangles.copy(), settings.test);
    case Accelerator::clusters:
        return std::make_unique<ClusterList>(triangles, settings.cluster_splits, settings.threads, settings.test);
    case Accelerator::bvh:
        break;
    }
    return std::make_unique<HierarchyCaster>(build_hierarchy(triangles, settings.cluster_splits, settings.threads));
}

std::uint32_t rank_of(std::uint32_t number, const std::vector<std::uint32_t>& ranks) {
    return number < ranks.size() ? ranks[number] : no_triangle;
}

} // namespace

TriangleAccelerator::TriangleAccelerator(std::span<const glm::vec3> positions,
                                         std::span<const std::uint32_t> canonical_order,
                                         const AcceleratorSettings& settings) {
    check(settings);
    const DefaultFloatState state; // what is built must not depend on the caller's either
    TriangleList list = list_triangles(positions, canonical_order, settings.threads);
    auto caster = make_caster(ListedTriangles(positions, list), settings);
    m_state = std::make_unique<State>(State{std::move(list), std::move(caster)});
}

TriangleAccelerator::~TriangleAccelerator() = default;
TriangleAccelerator::TriangleAccelerator(TriangleAccelerator&&) noexcept = default;
TriangleAccelerator& TriangleAccelerator::operator=(TriangleAccelerator&&) noexcept = default;

bool TriangleAccelerator::occluded(const Ray& ray) const {
    PreparedRay prepared(ray, m_state->list.bounds);
    prepared.ignored_rank = rank_of(ray.ignored_triangle, m_state->list.ranks);
    return prepared.valid && m_state->caster->occluded(prepared);
}

std::optional<Hit> TriangleAccelerator::nearest(const Ray& ray) const {
    PreparedRay prepared(ray, m_state->list.bounds);
    prepared.ignored_rank = rank_of(ray.ignored_triangle, m_state->list.ranks);
    if (!prepared.valid) {
        return std::nullopt;
    }
    const NearestHit hit = m_state->caster->nearest(prepared);
    if (!hit.found) {
        return std::nullopt;
    }
    return Hit{m_state->list.numbers[hit.rank], hit.distance, hit.back_side};
}

bool TriangleAccelerator::filter(const Ray& ray, CrossingFilter& filter) const {
    PreparedRay prepared(ray, m_state->list.bounds);
    prepared.ignored_rank = rank_of(ray.ignored_triangle, m_state->list.ranks);
    return prepared.valid && m_state->caster->filter(prepared, {m_state->list.numbers, filter});
}

BlockedRays TriangleAccelerator::blocked(const RayBlock& block, BlockScratch& scratch) const {
    std::array<std::uint32_t, RayBlock::lanes> ignored_ranks{};
    for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
        ignored_ranks[lane] = rank_of(block.ignored_triangle[lane], m_state->list.ranks);
    }
    return m_state->caster->blocked(block, ignored_ranks, m_state->list.bounds, scratch);
}

BlockScratch TriangleAccelerator::make_scratch() const { return m_state->caster->make_scratch(); }

AcceleratorStatistics TriangleAccelerator::statistics() const {
    AcceleratorStatistics statistics = m_state->caster->statistics();
    statistics.triangles = m_state->list.numbers.size();
    statistics.bytes +=
        (m_state->list.numbers.capacity() + m_state->list.ranks.capacity()) * sizeof(std::uint32_t) + sizeof(State);
    return statistics;
}

} // namespace vkbake
