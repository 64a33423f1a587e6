#include "write/display_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/srgb.hpp"

namespace vkbake {
namespace {

template<class Visit>
void each_texel(const Image& image, const Poll& poll, const Visit& visit) {
    constexpr std::size_t between_polls = 1U << 16U;
    for (std::size_t texel = 0; texel < image.texels.size(); ++texel) {
        if (poll && texel % between_polls == 0) {
            poll();
        }
        visit(image.texels[texel]);
    }
}

float greatest_value(const Image& image, const Poll& poll) {
    float greatest = 0.0F;
    each_texel(image, poll, [&](const glm::vec4& texel) {
        for (int channel = 0; channel < 3 && texel.w > 0.0F; ++channel) {
            greatest = std::isfinite(texel[channel]) ? std::max(greatest, texel[channel]) : greatest;
        }
    });
    return greatest > 0.0F ? greatest : 1.0F;
}

/// In [0,1]; NaN gives 0.
double share_of(float value, double greatest) {
    return value > 0.0F ? std::min(static_cast<double>(value) / greatest, 1.0) : 0.0;
}

/// The linear values half way between two neighbouring codes (in encoded values): 8-bit sRGB by a search in 255 numbers
/// instead of a power for each of up to 2²⁸ texels.
std::array<double, 255> srgb_borders() {
    std::array<double, 255> borders{};
    for (std::size_t code = 0; code < borders.size(); ++code) {
        borders.at(code) = srgb_to_linear((static_cast<double>(code) + 0.5) / 255.0);
    }
    return borders;
}

} // namespace

DisplayMap make_display_map(const std::string& name, const Image& image, Mode mode, const Poll& poll) {
    DisplayMap map{.name = name};
    std::vector<std::uint8_t> texels;
    if (mode != Mode::irradiance) {
        texels.reserve(image.texels.size());
        each_texel(image, poll, [&](const glm::vec4& texel) {
            const float open = mode == Mode::ao ? texel.x : glm::length(glm::vec3(texel));
            const double visibility = texel.w > 0.0F ? share_of(open, 1.0) : 0.0;
            texels.push_back(static_cast<std::uint8_t>(std::lround(visibility * 255.0)));
        });
        map.png = encode_grey_png(image.width, image.height, texels, {}, poll);
        return map;
    }
    const double greatest = static_cast<double>(greatest_value(image, poll));
    const std::array<double, 255> borders = srgb_borders();
    texels.reserve(3 * image.texels.size());
    each_texel(image, poll, [&](const glm::vec4& texel) {
        if (!(texel.w > 0.0F)) {
            texels.insert(texels.end(), 3, std::uint8_t{0});
            return;
        }
        for (int channel = 0; channel < 3; ++channel) {
            const double share = share_of(texel[channel], greatest);
            const auto* const border = std::upper_bound(borders.begin(), borders.end(), share);
            texels.push_back(static_cast<std::uint8_t>(border - borders.begin()));
        }
    });
    map.png = encode_srgb_png(image.width, image.height, texels, {}, poll);
    map.intensity = std::numbers::pi * greatest;
    return map;
}

} // namespace vkbake
