#include "finish/denoise_fields.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "base/luminance.hpp"
#include "base/percentile.hpp"

namespace vkbake {

namespace {

bool is_baked(const LightMap& map, std::size_t texel) { return map.image.coverage[texel] > 0.0F; }

/// Sums over the covered texels whose light is finite.
struct LightSums {
    double count = 0.0;
    double light = 0.0; ///< luminance
    double variance = 0.0;
};

LightSums sums_of(const LightMap& map, std::span<const float> variance) {
    LightSums sums;
    for (std::size_t texel = 0; texel < map.image.texels.size(); ++texel) {
        const double light = luminance(glm::dvec3(map.image.texels[texel]));
        if (is_baked(map, texel) && std::isfinite(light)) {
            sums.count += 1.0;
            sums.light += light;
            sums.variance += static_cast<double>(variance[texel]);
        }
    }
    return sums;
}

} // namespace

DenoiseFields make_denoise_fields(const LightMap& map, const DenoiseGuides& guides) {
    const std::size_t count = map.image.texels.size();
    DenoiseFields fields{.width = map.image.width, .height = map.image.height};
    fields.color.resize(count, glm::vec4(0.0F));
    fields.place.resize(count, glm::vec4(0.0F));
    fields.facing.resize(count, glm::vec4(0.0F));
    const LightSums sums = sums_of(map, guides.variance);
    if (!(sums.light > 0.0) || !(sums.variance > 0.0)) {
        return fields;
    }
    fields.exponent = -std::ilogb(sums.light / sums.count);
    const double scale = std::ldexp(1.0, fields.exponent);
    const auto scaled = [](double value, double factor) { // a NaN stays one
        constexpr double tiny = 0x1p-60;
        return value * factor < tiny ? 0.0F : static_cast<float>(value * factor);
    };
    fields.good = DENOISE_GOOD_SHARE * scaled(sums.variance / sums.count, scale * scale);
    constexpr float most = 0x1p30F;
    for (std::size_t texel = 0; texel < count; ++texel) {
        const glm::vec3 light(map.image.texels[texel]);
        const glm::vec3 color(scaled(light.r, scale), scaled(light.g, scale), scaled(light.b, scale));
        const float variance = scaled(guides.variance[texel], scale * scale);
        const bool in_range = color.r <= most && color.g <= most && color.b <= most && variance <= most;
        if (!is_baked(map, texel) || !in_range) {
            continue;
        }
        const std::uint32_t chart = guides.chart[guides.geometry.triangle[texel]];
        fields.color[texel] = {color, std::bit_cast<float>(chart + 1)};
        fields.place[texel] = {guides.geometry.position[texel], variance};
        fields.facing[texel] = {guides.geometry.shading_normal[texel],
                                (DENOISE_RED * color.r + DENOISE_GREEN * color.g) + DENOISE_BLUE * color.b};
    }
    return fields;
}

std::uint64_t take_denoised(const DenoiseFields& fields, std::span<const DenoisedTexel> denoised,
                            const DenoiseGuides& guides, LightMap& map) {
    std::uint64_t changed = 0;
    double squares = 0.0;
    double noise = 0.0;
    const double scale = std::ldexp(1.0, -fields.exponent);
    for (std::size_t texel = 0; texel < denoised.size(); ++texel) {
        const DenoisedTexel& filtered = denoised[texel];
        const auto variance = static_cast<double>(guides.variance[texel]);
        if (filtered.risk >= DENOISE_ALONE) {
            squares += variance;
            noise += variance;
            continue;
        }
        const double risk = scale * scale * static_cast<double>(filtered.risk);
        const double left = scale * scale * static_cast<double>(filtered.variance);
        squares += risk;
        noise += left;
        // What no ray has met is less likely to be there where none of the neighbours' met it either.
        const double unseen = std::max(std::pow(static_cast<double>(map.standard_error[texel]), 2.0) - variance, 0.0) *
                              (variance > 0.0 ? std::min(left / variance, 1.0) : 1.0);
        map.standard_error[texel] = static_cast<float>(std::sqrt(std::max(risk, left) + unseen));
        map.image.texels[texel] = glm::vec4(glm::vec3(scale * glm::dvec3(filtered.color)), map.image.texels[texel].a);
        ++changed;
    }
    if (map.error && changed > 0) {
        const LightSums sums = sums_of(map, guides.variance);
        const double mean = sums.light / sums.count;
        map.error->noise_rmse = map.error->relative_rmse;
        map.error->relative_rmse = std::sqrt(std::max(squares, noise) / sums.count) / mean;
        map.error->percentile_99 = covered_percentile_99(map.standard_error, map.image.coverage) / mean;
    }
    return changed;
}

} // namespace vkbake
