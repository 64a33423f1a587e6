#include "opacity.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "imageio/decode.hpp"

namespace vkbake {

namespace {

bool all_opaque(const Scene& scene, const Settings& settings) {
    return settings.alpha == Alpha::opaque || std::ranges::none_of(scene.instances, [&](const Instance& instance) {
               return instance.mesh < scene.meshes.size() &&
                      std::ranges::any_of(scene.meshes[instance.mesh].primitives, [&](const Primitive& primitive) {
                          return lets_light_through(scene, primitive);
                      });
           });
}

} // namespace

std::uint64_t opacity_bytes(const Scene& scene, const Settings& settings) {
    if (all_opaque(scene, settings)) {
        return 0;
    }
    const std::vector<std::uint8_t> channels = opacity_channels(scene);
    std::uint64_t kept = 0;
    std::uint64_t decoding = 0;
    for (std::size_t image = 0; image < channels.size(); ++image) {
        const std::optional<ImageSize> size = channels[image] == 0 ? std::nullopt : size_of(scene.images[image]);
        if (!size) {
            continue;
        }
        const auto side = [](int texels) { return static_cast<std::uint64_t>(std::min(texels, most_opacity_texels)); };
        // A byte, and two for the range of each 2 × 2, 4 × 4 and so on.
        kept +=
            static_cast<std::uint64_t>(std::popcount(channels[image])) * side(size->width) * side(size->height) * 5 / 3;
        // As read, as RGBA, and a channel of it.
        decoding =
            std::max(decoding, 9 * static_cast<std::uint64_t>(size->width) * static_cast<std::uint64_t>(size->height));
    }
    return kept + decoding;
}

std::optional<SurfaceOpacity> make_opacity(const Scene& scene, const Surface& surface, const Settings& settings) {
    if (all_opaque(scene, settings)) {
        return std::nullopt;
    }
    const std::vector<std::uint8_t> channels = opacity_channels(scene);
    std::vector<OpacityImage> images(scene.images.size());
    for (std::size_t image = 0; image < images.size(); ++image) {
        if (channels[image] == 0) {
            continue;
        }
        const Rgba8Image decoded = decode_rgba8(scene.images[image]);
        for (std::size_t channel = 0; channel < images[image].size(); ++channel) {
            if ((channels[image] >> channel & 1U) != 0) {
                images[image][channel] = make_byte_texture(decoded.width, decoded.height, decoded.texels, channel);
            }
        }
    }
    return std::optional<SurfaceOpacity>(std::in_place, scene, surface, std::move(images));
}

} // namespace vkbake
