// Decodes what a baked scene refers to and has the preview draw it.
#include "vkbake/render.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "base/boundary.hpp"
#include "imageio/decode.hpp"
#include "preview/camera.hpp"
#include "preview/preview.hpp"
#include "probe_balls.hpp"
#include "trace/sky_lookup.hpp"
#include "trace/sky_sum.hpp"
#include "vkbake/error.hpp"
#include "vkbake/vkbake.hpp"
#include "write/manifest.hpp"

namespace vkbake {

namespace {

const EncodedImage& image_at(const Scene& scene, std::uint32_t index) {
    if (index >= scene.images.size()) {
        throw Error(ErrorKind::bad_input, scene.name + ": a material refers to image " + std::to_string(index) +
                                              ", which is not there; repair the scene");
    }
    return scene.images[index];
}

/// Light map files and images, each decoded once.
class LightMaps {
public:
    LightMaps(const Scene& scene, PreviewImages& images) : m_scene(scene), m_images(images) {}

    std::uint32_t of(const LightMapUse& use) {
        const std::filesystem::path linear = std::filesystem::path(m_scene.directory) / use.linear_file;
        if (!use.linear_file.empty() && std::filesystem::is_regular_file(linear)) {
            return once(linear.string(), [&] { return read_image(linear); });
        }
        const std::uint32_t index = use.texture.image;
        return once("image " + std::to_string(index) + " x " + std::to_string(use.intensity), [&] {
            Image image = decode_image(image_at(m_scene, index));
            const float factor = use.intensity / std::numbers::pi_v<float>; // E to E/π
            for (glm::vec4& texel : image.texels) {
                texel = glm::vec4(factor * glm::vec3(texel), texel.a);
            }
            return image;
        });
    }

    /// glTF: occlusion is the red channel, linear.
    std::uint32_t of(const TextureUse& occlusion) {
        return once("image " + std::to_string(occlusion.image), [&] {
            const Rgba8Image encoded = decode_rgba8(image_at(m_scene, occlusion.image));
            Image image{.width = encoded.width, .height = encoded.height, .texels = {}, .coverage = {}};
            for (std::size_t i = 0; i + 3 < encoded.texels.size(); i += 4) {
                const float visibility = static_cast<float>(encoded.texels[i]) / 255.0F;
                image.texels.emplace_back(visibility, visibility, visibility, 1.0F);
            }
            return image;
        });
    }

private:
    template<class Make>
    std::uint32_t once(const std::string& key, const Make& make) {
        const auto [place, is_new] = m_known.try_emplace(key, static_cast<std::uint32_t>(m_images.light_maps.size()));
        if (is_new) {
            m_images.light_maps.push_back(make());
        }
        return place->second;
    }

    const Scene& m_scene;
    PreviewImages& m_images;
    std::map<std::string, std::uint32_t> m_known;
};

void decode_texture(const Scene& scene, const std::optional<TextureUse>& use, PreviewImages& images) {
    if (!use || !images.textures.at(use->image).texels.empty()) {
        return;
    }
    Rgba8Image decoded = decode_rgba8(image_at(scene, use->image));
    images.textures[use->image] = {decoded.width, decoded.height, std::move(decoded.texels)};
}

PreviewImages decode(const Scene& scene, bool light_only) {
    const auto has_light_map = [](const Material& material) { return material.light_map.has_value(); };
    const auto has_occlusion = [](const Material& material) { return material.occlusion_texture.has_value(); };
    PreviewImages images;
    images.occlusion = std::ranges::none_of(scene.materials, has_light_map);
    if (images.occlusion && std::ranges::none_of(scene.materials, has_occlusion)) {
        throw Error(ErrorKind::bad_input, scene.name + ": no material refers to a light map; bake the scene first");
    }
    images.textures.resize(scene.images.size());
    LightMaps light_maps(scene, images);
    for (const Material& material : scene.materials) {
        std::uint32_t light_map = PreviewImages::none;
        if (images.occlusion && material.occlusion_texture) {
            light_map = light_maps.of(*material.occlusion_texture);
        } else if (!images.occlusion && material.light_map) {
            light_map = light_maps.of(*material.light_map);
        }
        images.light_map_of.push_back(light_map);
        if (!light_only || material.alpha_mode != AlphaMode::opaque) {
            decode_texture(scene, material.base_color_texture, images);
        }
        if (!light_only) {
            decode_texture(scene, material.emissive_texture, images);
        }
    }
    return images;
}

/// Squares of 4 × 4 texels; what was baked or filled is no matter.
void draw_checker(Image& light_map) {
    for (int y = 0; y < light_map.height; ++y) {
        for (int x = 0; x < light_map.width; ++x) {
            const float light = (x / 4 + y / 4) % 2 == 0 ? 1.0F : 0.25F;
            light_map.texels[light_map.index(x, y)] = glm::vec4(light, light, light, 1.0F);
        }
    }
}

Image draw(const Scene& scene, const Sky& sky, const RenderSettings& settings, const Device& device) {
    const bool light_only = settings.light_only || settings.checker;
    PreviewImages images = decode(scene, light_only);
    if (settings.checker) {
        std::ranges::for_each(images.light_maps, draw_checker);
    }
    Scene with_probes;
    if (settings.probes) {
        with_probes = scene;
        add_probe_balls(read_probes(std::filesystem::path(scene.directory) / "probes.json"), with_probes, images);
    }
    const Scene& baked = settings.probes ? with_probes : scene;
    const double aspect = static_cast<double>(std::max(settings.width, 1)) / std::max(settings.height, 1);
    const Camera camera = settings.view ? *settings.view : choose_camera(baked, settings.camera, aspect);
    PreviewSky radiance;
    if (settings.show_sky) {
        radiance = [lookup = make_sky_lookup(sky), intensity = static_cast<float>(sky.intensity)](
                       const glm::vec3& direction) { return intensity * vkbake::radiance(lookup, direction); };
    }
    const PreviewSettings preview{.width = settings.width,
                                  .height = settings.height,
                                  .light_only = light_only,
                                  .exposure = std::exp2(settings.exposure),
                                  .metered = true};
    return draw_preview(device.context(), baked, images, camera, radiance, preview);
}

} // namespace

Image render(const Scene& baked, const Sky& sky, const RenderSettings& settings, const Device& device) {
    return at_boundary([&] {
        if (baked.source) {
            check_bake_of(baked.directory, baked.name + ".glb");
        }
        return draw(baked, sky, settings, device);
    });
}

} // namespace vkbake
