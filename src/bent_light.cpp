#include "bent_light.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "trace/lane_harmonics.hpp"
#include "trace/resample_sky.hpp"
#include "trace/sky_lookup.hpp"
#include "trace/sky_sum.hpp"
#include "vkbake_light.h"

namespace vkbake {

std::array<glm::vec3, 9> sky_coefficients(const Sky& sky) {
    constexpr int side_of_formulas = 256; // of the octahedron's square, even
    SkyLookup lookup = make_sky_lookup(sky);
    resample(lookup, 0); // its texels are means, so that no sun falls between the points below
    const auto* const picture = std::get_if<MapLookup>(&lookup);
    const int side = picture != nullptr ? picture->map.side() : side_of_formulas;
    std::array<glm::dvec3, 9> sums{};
    double sphere = 0.0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const glm::dvec3 point = SkyMap::octahedron_point(side, x + 0.5, y + 0.5);
            const double distance = glm::length(point);
            const double solid_angle = 4.0 / (distance * distance * distance * side * side);
            const glm::vec3 direction(point / distance);
            const glm::dvec3 light = solid_angle * glm::dvec3(radiance(lookup, direction));
            const std::array<float, 9> basis = harmonics(direction);
            for (std::size_t i = 0; i < sums.size(); ++i) {
                sums[i] += light * static_cast<double>(basis[i]);
            }
            sphere += solid_angle;
        }
    }
    std::array<glm::vec3, 9> coefficients{};
    const double scale = sky.intensity * 4.0 * std::acos(-1.0) / sphere;
    std::ranges::transform(sums, coefficients.begin(), [&](const glm::dvec3& sum) { return glm::vec3(scale * sum); });
    return coefficients;
}

void light_bent_normals(Image& bent_normals, const std::array<glm::vec3, 9>& sky_coefficients) {
    parallel_ranges(bent_normals.texels.size(), 4096, 0, [&](std::size_t begin, std::size_t end) {
        std::array<glm::vec3, 9> coefficients = sky_coefficients; // GLSL's parameters are not const
        for (std::size_t i = begin; i < end; ++i) {
            const glm::vec3 bent(bent_normals.texels[i]);
            const float visibility = glm::length(bent);
            glm::vec3 light(0.0F);
            if (visibility > 0.0F) {
                light = visibility * shared::vkbake_probe_light(coefficients.data(), bent / visibility);
            }
            bent_normals.texels[i] = glm::vec4(light, bent_normals.texels[i].a);
        }
    });
}

} // namespace vkbake
