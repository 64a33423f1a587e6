#include "preview/resources.hpp"

#include <cstddef>
#include <span>
#include <utility>

#include "preview/exposure.hpp"

namespace vkbake {

namespace {

static_assert(sizeof(PreviewVertex) == PREVIEW_VERTEX_FLOATS * sizeof(float));
static_assert(sizeof(PreviewRelief) == PREVIEW_RELIEF_FLOATS * sizeof(float));
static_assert(sizeof(PreviewConstants) <= 128, "what every device takes as push constants");

/// What a clay model is taken for.
constexpr float grey = 0.5F;

constexpr std::array<std::uint8_t, 4> white_texel{255, 255, 255, 255};
constexpr std::array<float, 4> black_texel{};

gpu::Buffer storage_buffer(gpu::Context& context, std::span<const std::byte> data) {
    gpu::Buffer buffer(context, data.size(), gpu::Memory::device);
    buffer.upload(data);
    return buffer;
}

gpu::Image sampled_image(gpu::Context& context, gpu::Format format, int width, int height,
                         std::span<const std::byte> texels) {
    gpu::Image image(context, {.format = format,
                               .width = width,
                               .height = height,
                               .sampled = true,
                               .mip_maps = format != gpu::Format::rgba32f});
    image.upload(texels);
    return image;
}

gpu::Image sampled_map(gpu::Context& context, const Image& map) {
    return sampled_image(context, gpu::Format::rgba32f, map.width, map.height, std::as_bytes(std::span(map.texels)));
}

std::vector<std::optional<gpu::Image>> sampled_textures(gpu::Context& context, gpu::Format format,
                                                        const std::vector<PreviewTexture>& textures) {
    std::vector<std::optional<gpu::Image>> sampled(textures.size());
    for (std::size_t i = 0; i < textures.size(); ++i) {
        const PreviewTexture& texture = textures[i];
        if (!texture.texels.empty()) {
            sampled[i] =
                sampled_image(context, format, texture.width, texture.height, std::as_bytes(std::span(texture.texels)));
        }
    }
    return sampled;
}

gpu::Wrap wrap(Wrap mode) {
    switch (mode) {
    case Wrap::clamp:
        return gpu::Wrap::clamp;
    case Wrap::mirror:
        return gpu::Wrap::mirror;
    case Wrap::repeat:
        break;
    }
    return gpu::Wrap::repeat;
}

gpu::Resource unfiltered(const gpu::Image& map) { return gpu::sampled(map, {.filter = gpu::Filter::nearest}); }

} // namespace

PreviewResources::PreviewResources(gpu::Context& context, const Scene& scene, const PreviewImages& images,
                                   PreviewGeometry geometry)
    : m_scene(scene), m_images(images), m_geometry(std::move(geometry)),
      m_white(sampled_image(context, gpu::Format::rgba8_srgb, 1, 1, std::as_bytes(std::span(white_texel)))),
      m_black(sampled_image(context, gpu::Format::rgba32f, 1, 1, std::as_bytes(std::span(black_texel)))),
      m_textures(sampled_textures(context, gpu::Format::rgba8_srgb, images.textures)),
      m_normal_maps(sampled_textures(context, gpu::Format::rgba8, images.normal_maps)),
      m_mean(mean_light(images.light_maps)) {
    for (const PreviewChunk& chunk : m_geometry.chunks) {
        m_vertices.push_back(storage_buffer(context, std::as_bytes(std::span(chunk.vertices))));
        m_indices.push_back(storage_buffer(context, std::as_bytes(std::span(chunk.indices))));
        m_reliefs.emplace_back();
        if (!chunk.reliefs.empty()) {
            m_reliefs.back() = storage_buffer(context, std::as_bytes(std::span(chunk.reliefs)));
        }
    }
    for (const Image& map : images.light_maps) {
        m_light_maps.push_back(sampled_map(context, map));
    }
    for (const std::array<Image, 4>& maps : images.directional_maps) {
        m_directional_maps.emplace_back();
        for (const Image& map : maps) {
            m_directional_maps.back().push_back(sampled_map(context, map));
        }
    }
}

std::vector<gpu::Resource> PreviewResources::bindings(const PreviewDraw& draw, bool relief) const {
    const Material* const material = material_of(draw);
    const std::uint32_t map = light_map_of(draw);
    std::vector<gpu::Resource> bindings{
        gpu::storage(m_vertices[draw.chunk]), gpu::storage(m_indices[draw.chunk]),
        texture(m_textures, material != nullptr ? material->base_color_texture : std::nullopt),
        texture(m_textures, material != nullptr ? material->emissive_texture : std::nullopt),
        unfiltered(map == PreviewImages::none ? m_black : m_light_maps[map])};
    if (relief) {
        bindings.push_back(gpu::storage(m_reliefs[draw.chunk].value()));
        for (const gpu::Image& harmonic : m_directional_maps[m_images.relief_of(draw.material)]) {
            bindings.push_back(unfiltered(harmonic));
        }
        bindings.push_back(texture(m_normal_maps, material->normal_map->texture));
    }
    return bindings;
}

PreviewConstants PreviewResources::constants(const PreviewDraw& draw, std::uint32_t show) const {
    const Material fallback;
    const Material* const known = material_of(draw);
    const Material& material = known != nullptr ? *known : fallback;
    PreviewConstants constants{};
    constants.base_color =
        show == PREVIEW_SHOW_LIGHT_ONLY ? glm::vec4(grey, grey, grey, material.base_color.a) : material.base_color;
    constants.emissive =
        glm::vec4(material.emissive, material.alpha_mode == AlphaMode::mask ? material.alpha_cutoff : -1.0F);
    constants.ambient = glm::vec4(m_mean, light_map_of(draw) == PreviewImages::none ? 0.0F : 1.0F);
    constants.show = show;
    constants.normal_scale = material.normal_map ? material.normal_map->scale : 1.0F;
    return constants;
}

const Material* PreviewResources::material_of(const PreviewDraw& draw) const {
    return draw.material < m_scene.materials.size() ? &m_scene.materials[draw.material] : nullptr;
}

std::uint32_t PreviewResources::light_map_of(const PreviewDraw& draw) const {
    return draw.material < m_images.light_map_of.size() ? m_images.light_map_of[draw.material] : PreviewImages::none;
}

gpu::Resource PreviewResources::texture(const std::vector<std::optional<gpu::Image>>& textures,
                                        const std::optional<TextureUse>& use) const {
    if (!use || use->image >= textures.size() || !textures[use->image]) {
        return gpu::sampled(m_white);
    }
    return gpu::sampled(*textures[use->image], {.u = wrap(use->wrap_u), .v = wrap(use->wrap_v)});
}

} // namespace vkbake
