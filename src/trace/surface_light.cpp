#include "trace/surface_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/vec2.hpp>

#include "trace/hit_point.hpp"

namespace vkbake {

namespace {

int texel_of(double coordinate, int size) {
    return static_cast<int>(std::clamp(std::floor(coordinate * size), 0.0, static_cast<double>(size - 1)));
}

/// The texel itself; where rounding took the point just over the border of a chart, the first covered one around it.
glm::vec3 light_at(const LeavingLight& page, const std::vector<glm::vec3>& light, int x, int y) {
    constexpr std::array<std::array<int, 2>, 9> steps{
        {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
    for (const auto& [right, down] : steps) {
        const int column = x + right;
        const int row = y + down;
        if (column < 0 || row < 0 || column >= page.width || row >= page.height) {
            continue;
        }
        const auto texel =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(page.width) + static_cast<std::size_t>(column);
        if (page.covered[texel] != 0) {
            return light[texel];
        }
    }
    return glm::vec3(0.0F);
}

} // namespace

bool SurfaceLight::is_sought() const {
    return std::ranges::any_of(m_pages, [](const LeavingLight& page) { return !page.sought.empty(); });
}

glm::vec3 SurfaceLight::look_up(std::uint32_t triangle, const glm::dvec3& weights,
                                std::vector<glm::vec3> LeavingLight::*what) const {
    const std::size_t first = std::size_t{3} * triangle;
    glm::dvec2 uv(0.0);
    for (int corner = 0; corner < 3; ++corner) {
        uv += weights[corner] * glm::dvec2(m_atlas->uvs[first + static_cast<std::size_t>(corner)]);
    }
    const LeavingLight& page = m_pages[m_atlas->page[triangle]];
    return (page.*what).empty() ? glm::vec3(0.0F)
                                : light_at(page, page.*what, texel_of(uv.x, page.width), texel_of(uv.y, page.height));
}

glm::vec3 SurfaceLight::along(const Ray& ray, const Hit& hit) const {
    return shows(hit) ? look_up(hit.triangle, weights_at(*m_surface, ray, hit), &LeavingLight::radiance)
                      : glm::vec3(0.0F);
}

glm::vec3 SurfaceLight::sought_at(std::uint32_t triangle, const glm::dvec3& weights) const {
    return look_up(triangle, weights, &LeavingLight::sought);
}

glm::vec3 SurfaceLight::sought_along(const Ray& ray, const Hit& hit) const {
    return shows(hit) ? sought_at(hit.triangle, weights_at(*m_surface, ray, hit)) : glm::vec3(0.0F);
}

} // namespace vkbake
