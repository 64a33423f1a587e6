#include "imageio/channels.hpp"

#include <algorithm>
#include <string_view>

#include "base/srgb.hpp"

namespace vkbake {
namespace {

std::optional<std::size_t> find(const std::vector<std::string>& names, const std::string& layer,
                                std::string_view last) {
    const auto place = std::find(names.begin(), names.end(), layer + std::string(last));
    return place == names.end() ? std::nullopt
                                : std::optional<std::size_t>(static_cast<std::size_t>(place - names.begin()));
}

/// "" first, then every layer ("Combined.") in the file's order.
std::vector<std::string> layers_of(const std::vector<std::string>& names) {
    std::vector<std::string> layers{""};
    for (const std::string& name : names) {
        const std::size_t point = name.rfind('.');
        if (point != std::string::npos) {
            layers.push_back(name.substr(0, point + 1));
        }
    }
    return layers;
}

} // namespace

ChannelPlaces find_channels(const std::vector<std::string>& names) {
    ChannelPlaces places;
    for (const std::string& layer : layers_of(names)) {
        const auto red = find(names, layer, "R");
        const auto green = find(names, layer, "G");
        const auto blue = find(names, layer, "B");
        const auto grey = find(names, layer, "Y");
        if ((red && green && blue) || grey) {
            places.color = red && green && blue ? std::array{*red, *green, *blue} : std::array{*grey, *grey, *grey};
            places.alpha = find(names, layer, "A");
            places.coverage = find(names, layer, "coverage");
            return places;
        }
    }
    if (names.size() >= 3) {
        places.color = {0, 1, 2};
    }
    if (names.size() == 2 || names.size() >= 4) {
        places.alpha = std::min<std::size_t>(names.size() - 1, 3);
    }
    return places;
}

Image to_image(const Samples<float>& samples, Transfer transfer) {
    const ChannelPlaces places = find_channels(samples.channels);
    const std::size_t stride = samples.channels.size();
    const std::size_t count = samples.values.size() / stride;
    Image image{samples.width, samples.height, std::vector<glm::vec4>(count), {}};
    image.coverage.resize(places.coverage ? count : 0);
    for (std::size_t texel = 0; texel < count; ++texel) {
        const float* values = samples.values.data() + texel * stride;
        glm::vec4& result = image.texels[texel];
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const float value = values[places.color[channel]];
            result[static_cast<int>(channel)] =
                transfer == Transfer::srgb ? static_cast<float>(srgb_to_linear(static_cast<double>(value))) : value;
        }
        result.w = places.alpha ? values[*places.alpha] : 1.0F;
        if (places.coverage) {
            image.coverage[texel] = values[*places.coverage];
        }
    }
    return image;
}

} // namespace vkbake
