#include "trace/visibility.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

#include "bvh/each_ray.hpp"

namespace vkbake {

namespace {

std::span<const std::uint32_t> opaque_triangles(const Surface& surface, const SurfaceOpacity* opacity) {
    return opacity != nullptr ? opacity->opaque() : std::span<const std::uint32_t>(surface.canonical_order);
}

} // namespace

/// Collects what a ray meets of triangles that are not opaque.
class Passages final : public CrossingFilter {
public:
    /// `to_the_end`: past points that let nothing through, for there may be others before them.
    Passages(const SurfaceOpacity& opacity, const Ray& ray, bool to_the_end,
             std::vector<VisibilityScratch::Entry>& entries)
        : m_opacity(&opacity), m_ray(&ray), m_to_the_end(to_the_end), m_entries(&entries) {
        entries.clear();
    }

    [[nodiscard]] bool ends(const Crossing& crossing) override {
        const Passage passage = m_opacity->passage(*m_ray, crossing.hit);
        const bool blocks = passage.transmittance == glm::vec3(0.0F);
        if (blocks || (crossing.counts && passage.transmittance != glm::vec3(1.0F))) {
            m_entries->push_back({crossing.hit, crossing.rank, passage});
        }
        return blocks && !m_to_the_end;
    }

private:
    const SurfaceOpacity* m_opacity; ///< never null
    const Ray* m_ray;                ///< never null
    bool m_to_the_end;
    std::vector<VisibilityScratch::Entry>* m_entries; ///< never null
};

namespace {

/// Of what a surface hides so much is let through, at a share of the ray's length.
float let_through(Falloff falloff, float share) { return falloff == Falloff::square ? share * (2.0F - share) : share; }

template<typename Entries>
void sort_by_distance(Entries& entries) {
    std::ranges::sort(entries, {}, [](const auto& entry) { return std::tuple(entry.hit.distance, entry.rank); });
}

} // namespace

Visibility::Visibility(const Surface& surface, const AcceleratorSettings& settings, const SurfaceOpacity* opacity,
                       Falloff falloff)
    : m_opaque(surface.positions, opaque_triangles(surface, opacity), settings), m_opacity(opacity),
      m_falloff(falloff) {
    if (opacity != nullptr && !opacity->filtered().empty()) {
        m_filtered.emplace(surface.positions, opacity->filtered(), settings);
    }
}

VisibilityScratch Visibility::make_scratch() const {
    VisibilityScratch scratch;
    scratch.m_opaque = m_opaque.make_scratch();
    if (m_filtered) {
        scratch.m_filtered = m_filtered->make_scratch();
    }
    return scratch;
}

BlockedRays Visibility::blocked(const RayBlock& block, VisibilityScratch& scratch) const {
    if (fades()) {
        return fade_block(block, scratch);
    }
    BlockedRays blocked = m_opaque.blocked(block, scratch.m_opaque);
    if (m_filtered) {
        filter_block(block, scratch, blocked);
    }
    return blocked;
}

void Visibility::filter_block(const RayBlock& block, VisibilityScratch& scratch, BlockedRays& blocked) const {
    RayBlock& rest = scratch.m_rest;
    rest = block;
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        rest.active[stratum] = static_cast<RayBlock::LaneBits>(rest.active[stratum] & ~blocked[stratum]);
    }
    const BlockedRays met = m_filtered->blocked(rest, scratch.m_filtered);
    scratch.m_dimmed = {};
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        for (unsigned left = met[stratum]; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            dim(stratum, lane, filtered(ray_of(block, stratum, lane), scratch), scratch, blocked);
            ++scratch.m_filtered_rays;
        }
    }
}

void Visibility::dim(std::size_t stratum, std::size_t lane, const glm::vec3& through, VisibilityScratch& scratch,
                     BlockedRays& blocked) {
    const auto bit = static_cast<RayBlock::LaneBits>(1U << lane);
    if (through == glm::vec3(0.0F)) {
        blocked[stratum] |= bit;
    } else if (through != glm::vec3(1.0F)) {
        scratch.m_dimmed[stratum] |= bit;
        for (int channel = 0; channel < 3; ++channel) {
            scratch.m_transmittance[stratum][static_cast<std::size_t>(channel)][lane] = through[channel];
        }
    }
}

BlockedRays Visibility::fade_block(const RayBlock& block, VisibilityScratch& scratch) const {
    const BlockedRays found = met(block, scratch);
    BlockedRays blocked{};
    scratch.m_dimmed = {};
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        for (unsigned left = found[stratum]; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            dim(stratum, lane, faded(ray_of(block, stratum, lane), scratch), scratch, blocked);
        }
    }
    return blocked;
}

// What stands behind a point at which nothing would get through is hidden by it, however far that is.
glm::vec3 Visibility::faded(const Ray& ray, VisibilityScratch& scratch) const {
    const auto kept = [&](const Hit& hit) { return let_through(m_falloff, hit.distance / ray.max_distance); };
    const std::optional<Hit> last = m_opaque.nearest(ray);
    glm::vec3 through(1.0F);
    if (m_filtered) {
        find_passages(ray, last, scratch);
        for (const auto& entry : scratch.m_entries) {
            const glm::vec3& own = entry.passage.transmittance;
            through *= own + (1.0F - own) * kept(entry.hit);
            if (own == glm::vec3(0.0F)) {
                return through;
            }
        }
    }
    return last ? through * kept(*last) : through;
}

BlockedRays Visibility::met(const RayBlock& block, VisibilityScratch& scratch) const {
    BlockedRays met = m_opaque.blocked(block, scratch.m_opaque);
    if (m_filtered) {
        const BlockedRays others = m_filtered->blocked(block, scratch.m_filtered);
        for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
            met[stratum] |= others[stratum];
        }
    }
    return met;
}

glm::vec3 Visibility::filtered(const Ray& ray, VisibilityScratch& scratch) const {
    Passages passages(*m_opacity, ray, false, scratch.m_entries);
    if (m_filtered->filter(ray, passages)) {
        return glm::vec3(0.0F);
    }
    sort_by_distance(scratch.m_entries);
    glm::vec3 through(1.0F);
    for (const auto& entry : scratch.m_entries) {
        through *= entry.passage.transmittance;
    }
    return through;
}

glm::vec3 Visibility::transmittance(const Ray& ray, VisibilityScratch& scratch) const {
    if (m_opaque.occluded(ray)) {
        return glm::vec3(0.0F);
    }
    return m_filtered ? filtered(ray, scratch) : glm::vec3(1.0F);
}

std::optional<Hit> Visibility::nearest(const Ray& ray, VisibilityScratch& scratch) const {
    const std::span<const SeenSurface> seen = surfaces(ray, scratch);
    return seen.empty() ? std::nullopt : std::optional(seen.back().hit);
}

void Visibility::find_passages(const Ray& ray, const std::optional<Hit>& last, VisibilityScratch& scratch) const {
    Ray before = ray;
    before.max_distance = last ? last->distance : ray.max_distance;
    Passages passages(*m_opacity, before, true, scratch.m_entries);
    m_filtered->filter(before, passages);
    sort_by_distance(scratch.m_entries);
}

std::span<const SeenSurface> Visibility::surfaces(const Ray& ray, VisibilityScratch& scratch) const {
    scratch.m_seen.clear();
    const std::optional<Hit> last = m_opaque.nearest(ray);
    glm::vec3 through(1.0F);
    if (m_filtered) {
        find_passages(ray, last, scratch);
        for (const auto& entry : scratch.m_entries) {
            scratch.m_seen.push_back({entry.hit, through * entry.passage.coverage});
            through *= entry.passage.transmittance;
            if (through == glm::vec3(0.0F)) {
                return scratch.m_seen;
            }
        }
    }
    if (last) {
        scratch.m_seen.push_back({*last, through});
    }
    return scratch.m_seen;
}

} // namespace vkbake
