#include "imageio/decode.hpp"

#include <cstddef>
#include <string>

#include "imageio/channels.hpp"
#include "imageio/load_codec.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

constexpr SampleLimits texture_limits{16384, 2ULL << 30U};

std::string message_name(const EncodedImage& image) {
    return image.name.empty() ? "(without a name)" : '"' + image.name + '"';
}

} // namespace

std::optional<ImageSize> size_of(const EncodedImage& image) {
    try {
        const auto [width, height] = codec().read_size(image.bytes, message_name(image), texture_limits);
        return ImageSize{width, height};
    } catch (const Error&) {
        return std::nullopt;
    }
}

Rgba8Image decode_rgba8(const EncodedImage& image) {
    const auto samples = codec().read_bytes(image.bytes, message_name(image), texture_limits);
    const ChannelPlaces places = find_channels(samples.channels);
    const std::size_t stride = samples.channels.size();
    Rgba8Image result{samples.width, samples.height, {}};
    result.texels.resize(samples.values.size() / stride * 4);
    for (std::size_t texel = 0; texel < result.texels.size() / 4; ++texel) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            result.texels[4 * texel + channel] = samples.values[texel * stride + places.color.at(channel)];
        }
        result.texels[4 * texel + 3] =
            places.alpha ? samples.values[texel * stride + *places.alpha] : std::uint8_t{255};
    }
    return result;
}

Image decode_image(const EncodedImage& image) {
    const auto samples = codec().read_floats(image.bytes, message_name(image), texture_limits);
    return to_image(samples, samples.integer ? Transfer::srgb : Transfer::linear);
}

} // namespace vkbake
