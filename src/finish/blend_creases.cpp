#include "finish/blend_creases.hpp"

#include <cstddef>

#include <glm/vec3.hpp>

namespace vkbake {

namespace {

/// Calls take(texel, share) for the texels that one is mixed from; shares are parts of 1.
template<typename Take>
void for_each_share(const CreaseTexel& crease, int width, const Take& take) {
    for (int place = 0; place < 9; ++place) {
        const std::uint16_t share = crease.shares[static_cast<std::size_t>(place)];
        if (share > 0) {
            const std::ptrdiff_t step = static_cast<std::ptrdiff_t>(place / 3 - 1) * width + (place % 3 - 1);
            take(static_cast<std::size_t>(static_cast<std::ptrdiff_t>(crease.texel) + step),
                 static_cast<double>(share) / CreaseTexel::whole);
        }
    }
}

} // namespace

void blend_creases(std::span<const CreaseTexel> creases, Image& image) {
    std::vector<glm::vec3> mixed; // all from what was there before
    mixed.reserve(creases.size());
    for (const CreaseTexel& crease : creases) {
        glm::dvec3 light(0.0);
        for_each_share(crease, image.width,
                       [&](std::size_t texel, double share) { light += share * glm::dvec3(image.texels[texel]); });
        mixed.emplace_back(light);
    }
    for (std::size_t i = 0; i < creases.size(); ++i) {
        glm::vec4& texel = image.texels[creases[i].texel];
        texel = glm::vec4(mixed[i], texel.a);
    }
}

void blend_creases(std::span<const CreaseTexel> creases, int width, std::vector<float>& standard_errors) {
    std::vector<float> mixed;
    mixed.reserve(creases.size());
    for (const CreaseTexel& crease : creases) {
        double error = 0.0;
        for_each_share(crease, width, [&](std::size_t texel, double share) {
            error += share * static_cast<double>(standard_errors[texel]);
        });
        mixed.push_back(static_cast<float>(error));
    }
    for (std::size_t i = 0; i < creases.size(); ++i) {
        standard_errors[creases[i].texel] = mixed[i];
    }
}

void blend_creases(std::span<const CreaseTexel> creases, LightMap& map) {
    blend_creases(creases, map.image);
    for (Image& image : map.directional) {
        blend_creases(creases, image);
    }
    if (!map.standard_error.empty()) {
        blend_creases(creases, map.image.width, map.standard_error);
    }
    map.statistics.blended_texels = creases.size();
}

} // namespace vkbake
