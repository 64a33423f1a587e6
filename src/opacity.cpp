#include "opacity.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "imageio/decode.hpp"

namespace vkbake {

std::optional<SurfaceOpacity> make_opacity(const Scene& scene, const Surface& surface, const Settings& settings) {
    const bool all_opaque = std::ranges::none_of(scene.instances, [&](const Instance& instance) {
        return std::ranges::any_of(scene.meshes.at(instance.mesh).primitives,
                                   [&](const Primitive& primitive) { return lets_light_through(scene, primitive); });
    });
    if (settings.alpha == Alpha::opaque || all_opaque) {
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
