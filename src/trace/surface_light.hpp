// The light that leaves surfaces, as the rays that meet them see it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "bvh/accelerator.hpp"
#include "vkbake/atlas.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Radiance that leaves the fronts of what a page holds, the same in all directions (Lambert).
struct LeavingLight {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> radiance;   ///< row-major
    std::vector<glm::vec3> sought;     ///< what of `radiance` rays may go and seek; empty where nothing is
    std::vector<std::uint8_t> covered; ///< 1 where the texel was baked
};

/// Looks it up where a ray ends. A hit takes the texel that its point lies in, without filtering: every texel that a
/// triangle meets is covered, so none is without a value, and nothing comes from beyond a chart's border.
///
/// A back side that a material shows (double-sided) leaves what its front leaves, since a map has no more to tell; one
/// that it does not show is black.
class SurfaceLight {
public:
    /// All must outlive it. `pages`: one a page of the atlas. `two_sided`: one a part of the surface.
    SurfaceLight(const Surface& surface, const Atlas& atlas, std::span<const LeavingLight> pages,
                 std::span<const std::uint8_t> two_sided)
        : m_surface(&surface), m_atlas(&atlas), m_pages(pages), m_two_sided(two_sided) {}

    /// What arrives along a ray from where it ends.
    [[nodiscard]] glm::vec3 along(const Ray& ray, const Hit& hit) const;
    /// Whether the side that was met is to be seen: a front, or a back that its material shows.
    [[nodiscard]] bool shows(const Hit& hit) const { return !hit.back_side || shows_back(hit.triangle); }
    [[nodiscard]] bool shows_back(std::uint32_t triangle) const {
        return m_two_sided[m_surface->parts_of[triangle]] != 0;
    }

    [[nodiscard]] bool is_sought() const;
    /// LeavingLight::sought at a point of a triangle, on sides that show; `weights`: barycentric.
    [[nodiscard]] glm::vec3 sought_at(std::uint32_t triangle, const glm::dvec3& weights) const;
    /// What of along() is that.
    [[nodiscard]] glm::vec3 sought_along(const Ray& ray, const Hit& hit) const;

private:
    [[nodiscard]] glm::vec3 look_up(std::uint32_t triangle, const glm::dvec3& weights,
                                    std::vector<glm::vec3> LeavingLight::*what) const;

    const Surface* m_surface; ///< never null
    const Atlas* m_atlas;     ///< never null
    std::span<const LeavingLight> m_pages;
    std::span<const std::uint8_t> m_two_sided;
};

} // namespace vkbake
