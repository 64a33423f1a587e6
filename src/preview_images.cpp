#include "preview_images.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "bent_light.hpp"
#include "imageio/decode.hpp"
#include "vkbake/error.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake {

namespace {

const EncodedImage& image_at(const Scene& scene, std::uint32_t index) {
    if (index >= scene.images.size()) {
        throw Error(ErrorKind::bad_input, scene.name + ": a material refers to image " + std::to_string(index) +
                                              ", which is not there; repair the scene");
    }
    return scene.images[index];
}

/// A file beside the scene, where it is there.
std::optional<std::filesystem::path> file_beside(const Scene& scene, const std::string& name) {
    const std::filesystem::path file = std::filesystem::path(scene.directory) / name;
    return !name.empty() && std::filesystem::is_regular_file(file) ? std::optional(file) : std::nullopt;
}

/// Light map files and images, each decoded once.
class LightMaps {
public:
    LightMaps(const Scene& scene, const Sky& sky, PreviewImages& images)
        : m_scene(scene), m_sky(sky), m_images(images) {}

    std::uint32_t of(const LightMapUse& use) {
        if (const auto linear = file_beside(m_scene, use.linear_file)) {
            return once(m_light_maps, linear->string(), m_images.light_maps, [&] { return read_image(*linear); });
        }
        const std::uint32_t index = use.texture.image;
        const std::string key = "image " + std::to_string(index) + " x " + std::to_string(use.intensity);
        return once(m_light_maps, key, m_images.light_maps, [&] {
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
        return once(m_light_maps, "image " + std::to_string(occlusion.image), m_images.light_maps, [&] {
            const Rgba8Image encoded = decode_rgba8(image_at(m_scene, occlusion.image));
            Image image{.width = encoded.width, .height = encoded.height, .texels = {}, .coverage = {}};
            for (std::size_t i = 0; i + 3 < encoded.texels.size(); i += 4) {
                const float visibility = static_cast<float>(encoded.texels[i]) / 255.0F;
                image.texels.emplace_back(visibility, visibility, visibility, 1.0F);
            }
            return image;
        });
    }

    std::uint32_t of_bent_normals(const std::filesystem::path& file) {
        return once(m_light_maps, file.string(), m_images.light_maps, [&] {
            Image image = read_image(file);
            if (!m_sky_coefficients) {
                m_sky_coefficients = sky_coefficients(m_sky);
            }
            light_bent_normals(image, *m_sky_coefficients);
            return image;
        });
    }

    /// None where one of the files is missing.
    std::uint32_t of_directional(const std::array<std::string, 4>& names) {
        std::array<std::filesystem::path, 4> files;
        for (std::size_t i = 0; i < files.size(); ++i) {
            const auto file = file_beside(m_scene, names[i]);
            if (!file) {
                return PreviewImages::none;
            }
            files[i] = *file;
        }
        return once(m_directional_maps, files[0].string(), m_images.directional_maps, [&] {
            std::array<Image, 4> maps;
            std::ranges::transform(files, maps.begin(),
                                   [](const std::filesystem::path& file) { return read_image(file); });
            return maps;
        });
    }

private:
    using Known = std::map<std::string, std::uint32_t>;

    template<class Maps, class Make>
    std::uint32_t once(Known& known, const std::string& key, Maps& maps, const Make& make) {
        const auto [place, is_new] = known.try_emplace(key, static_cast<std::uint32_t>(maps.size()));
        if (is_new) {
            maps.push_back(make());
        }
        return place->second;
    }

    const Scene& m_scene;
    const Sky& m_sky;
    PreviewImages& m_images;
    Known m_light_maps;
    Known m_directional_maps;
    std::optional<std::array<glm::vec3, 9>> m_sky_coefficients;
};

void decode_texture(const Scene& scene, const TextureUse& use, std::vector<PreviewTexture>& textures) {
    if (!textures.at(use.image).texels.empty()) {
        return;
    }
    Rgba8Image decoded = decode_rgba8(image_at(scene, use.image));
    textures[use.image] = {decoded.width, decoded.height, std::move(decoded.texels)};
}

std::uint32_t light_map_of(const Scene& scene, const Material& material, bool occlusion, LightMaps& light_maps) {
    if (!occlusion) {
        return material.light_map ? light_maps.of(*material.light_map) : PreviewImages::none;
    }
    if (!material.occlusion_texture) {
        return PreviewImages::none;
    }
    const auto bent_normals = file_beside(scene, material.bent_normal_file);
    return bent_normals ? light_maps.of_bent_normals(*bent_normals) : light_maps.of(*material.occlusion_texture);
}

} // namespace

PreviewImages decode_images(const Scene& scene, const Sky& sky, const RenderSettings& settings) {
    const auto has_light_map = [](const Material& material) { return material.light_map.has_value(); };
    const auto has_occlusion = [](const Material& material) { return material.occlusion_texture.has_value(); };
    PreviewImages images;
    images.occlusion = std::ranges::none_of(scene.materials, has_light_map);
    if (images.occlusion && std::ranges::none_of(scene.materials, has_occlusion)) {
        throw Error(ErrorKind::bad_input, scene.name + ": no material refers to a light map; bake the scene first");
    }
    const bool light_only = settings.light_only || settings.checker;
    images.textures.resize(scene.images.size());
    LightMaps light_maps(scene, sky, images);
    for (const Material& material : scene.materials) {
        images.light_map_of.push_back(light_map_of(scene, material, images.occlusion, light_maps));
        if (material.base_color_texture && (!light_only || material.alpha_mode != AlphaMode::opaque)) {
            decode_texture(scene, *material.base_color_texture, images.textures);
        }
        if (material.emissive_texture && !light_only) {
            decode_texture(scene, *material.emissive_texture, images.textures);
        }
        std::uint32_t directional = PreviewImages::none;
        if (settings.directional == Switch::on && !settings.checker && material.light_map && material.normal_map) {
            directional = light_maps.of_directional(material.light_map->directional_files);
        }
        images.directional_map_of.push_back(directional);
        if (directional != PreviewImages::none) {
            images.normal_maps.resize(scene.images.size());
            decode_texture(scene, material.normal_map->texture, images.normal_maps);
        }
    }
    return images;
}

} // namespace vkbake
