// What rays meet, opaque or not: what tracers ask in place of an accelerator.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "bvh/accelerator.hpp"
#include "trace/surface_opacity.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// A surface that a ray sees, through whatever lies before it.
struct SeenSurface {
    Hit hit;
    glm::vec3 share{1.0F}; ///< of the light that it sends back along the ray, so much arrives
};

/// What one thread needs to ask, as BlockScratch; and the answers.
class VisibilityScratch {
public:
    /// Of the block that was asked last, where rays may be dimmed: those along which something, but not all, gets
    /// through. None are blocked.
    [[nodiscard]] const BlockedRays& dimmed() const { return m_dimmed; }
    /// Of a ray that is not blocked: what gets through.
    [[nodiscard]] glm::vec3 transmittance(std::size_t stratum, std::size_t lane) const {
        if ((m_dimmed[stratum] >> lane & 1U) == 0) {
            return glm::vec3(1.0F);
        }
        const auto& rows = m_transmittance[stratum];
        return {rows[0][lane], rows[1][lane], rows[2][lane]};
    }
    /// Rays so far that met a triangle that is not opaque.
    [[nodiscard]] std::uint64_t filtered_rays() const { return m_filtered_rays; }

private:
    friend class Visibility;
    friend class Passages;

    /// A triangle on the way that is not opaque, and what gets through.
    struct Entry {
        Hit hit;
        std::uint32_t rank = 0;
        Passage passage;
    };

    BlockScratch m_opaque;
    BlockScratch m_filtered;
    RayBlock m_rest;
    BlockedRays m_dimmed{};
    std::array<std::array<RayBlock::LaneRow, 3>, RayBlock::strata> m_transmittance{};
    std::vector<Entry> m_entries; ///< grows to what the ray with the most has
    std::vector<SeenSurface> m_seen;
    std::uint64_t m_filtered_rays = 0;
};

/// Two sets of triangles. Opaque ones come first and are asked in blocks; what gets by them is asked of the others in
/// blocks too, and only rays that meet one of these are followed by themselves, from look-up to look-up. Where all is
/// opaque there is no second set, and the first is all that is asked.
///
/// A ray that passes exactly through an edge is dimmed once where triangles lie side by side (Crossing::counts); a
/// point at which nothing gets through blocks even there. Products are formed in the order of distance, then of rank,
/// so that no answer depends on the accelerator.
class Visibility {
public:
    /// Both must outlive it. `opacity`: null where every triangle is taken for opaque. `falloff`: with how far along a
    /// ray a surface is, its end being Ray::max_distance, more gets through.
    Visibility(const Surface& surface, const AcceleratorSettings& settings, const SurfaceOpacity* opacity = nullptr,
               Falloff falloff = Falloff::none);

    [[nodiscard]] VisibilityScratch make_scratch() const;
    /// Whether rays may be dimmed: by triangles that are not opaque, or by distance.
    [[nodiscard]] bool dims() const { return m_filtered.has_value() || fades(); }
    /// Whether every surface lets something through, the more the farther it is.
    [[nodiscard]] bool fades() const { return m_falloff != Falloff::none; }

    /// The active rays along which nothing gets through. Sets scratch.dimmed().
    [[nodiscard]] BlockedRays blocked(const RayBlock& block, VisibilityScratch& scratch) const;
    /// The active rays that meet anything, opaque or not: those of which surfaces() is not empty.
    [[nodiscard]] BlockedRays met(const RayBlock& block, VisibilityScratch& scratch) const;

    /// What gets through along one ray: 1 where it meets nothing.
    [[nodiscard]] glm::vec3 transmittance(const Ray& ray, VisibilityScratch& scratch) const;
    /// Of a ray along which nothing gets through, where it ends.
    [[nodiscard]] std::optional<Hit> nearest(const Ray& ray, VisibilityScratch& scratch) const;
    /// All that is seen along a ray, the nearest first; of equal distances the last is an opaque triangle. Holds until
    /// the scratch is used again.
    [[nodiscard]] std::span<const SeenSurface> surfaces(const Ray& ray, VisibilityScratch& scratch) const;

private:
    /// What gets through the triangles that are not opaque.
    [[nodiscard]] glm::vec3 filtered(const Ray& ray, VisibilityScratch& scratch) const;
    void filter_block(const RayBlock& block, VisibilityScratch& scratch, BlockedRays& blocked) const;
    /// Of a ray that meets something: what gets through for how far that is.
    [[nodiscard]] glm::vec3 faded(const Ray& ray, VisibilityScratch& scratch) const;
    [[nodiscard]] BlockedRays fade_block(const RayBlock& block, VisibilityScratch& scratch) const;
    /// All that is not opaque before `last` (absent: before the ray's end) goes to scratch.m_entries, nearest first.
    void find_passages(const Ray& ray, const std::optional<Hit>& last, VisibilityScratch& scratch) const;
    /// Sorts a ray, of which so much gets through, among the dimmed, the blocked or neither.
    static void dim(std::size_t stratum, std::size_t lane, const glm::vec3& through, VisibilityScratch& scratch,
                    BlockedRays& blocked);

    TriangleAccelerator m_opaque;
    std::optional<TriangleAccelerator> m_filtered;
    const SurfaceOpacity* m_opacity;
    Falloff m_falloff;
};

} // namespace vkbake
