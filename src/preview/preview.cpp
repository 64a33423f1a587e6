#include "preview/preview.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <glm/mat4x4.hpp>

#include "base/parallel.hpp"
#include "gpu/commands.hpp"
#include "gpu/context.hpp"
#include "gpu/programs.hpp"
#include "gpu/resources.hpp"
#include "preview.h"
#include "preview/camera.hpp"
#include "preview/exposure.hpp"
#include "preview/geometry.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

static_assert(sizeof(PreviewVertex) == PREVIEW_VERTEX_FLOATS * sizeof(float));
static_assert(sizeof(PreviewConstants) <= 128, "what every device takes as push constants");

/// What a clay model is taken for.
constexpr float grey = 0.5F;

constexpr auto radiance_format = gpu::Format::rgba32f;

/// Pixels of the picture that are drawn at once.
struct Tile {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

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
                               .mip_maps = format == gpu::Format::rgba8_srgb});
    image.upload(texels);
    return image;
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

/// The scene in the device's memory.
class Resources {
public:
    Resources(gpu::Context& context, const Scene& scene, const PreviewImages& images, PreviewGeometry geometry)
        : m_scene(scene), m_images(images), m_geometry(std::move(geometry)),
          m_white(sampled_image(context, gpu::Format::rgba8_srgb, 1, 1, std::as_bytes(std::span(white_texel)))),
          m_black(sampled_image(context, gpu::Format::rgba32f, 1, 1, std::as_bytes(std::span(black_texel)))) {
        for (const PreviewChunk& chunk : m_geometry.chunks) {
            m_vertices.push_back(storage_buffer(context, std::as_bytes(std::span(chunk.vertices))));
            m_indices.push_back(storage_buffer(context, std::as_bytes(std::span(chunk.indices))));
        }
        m_textures.resize(images.textures.size());
        for (std::size_t i = 0; i < m_textures.size(); ++i) {
            const PreviewTexture& texture = images.textures[i];
            if (!texture.texels.empty()) {
                m_textures[i] = sampled_image(context, gpu::Format::rgba8_srgb, texture.width, texture.height,
                                              std::as_bytes(std::span(texture.texels)));
            }
        }
        for (const Image& map : images.light_maps) {
            m_light_maps.push_back(sampled_image(context, gpu::Format::rgba32f, map.width, map.height,
                                                 std::as_bytes(std::span(map.texels))));
        }
        m_mean = mean_light(images.light_maps);
    }

    [[nodiscard]] const PreviewGeometry& geometry() const { return m_geometry; }
    [[nodiscard]] const glm::dvec3& mean() const { return m_mean; }

    /// In the order of the shaders' bindings.
    [[nodiscard]] std::array<gpu::Resource, 5> bindings(const PreviewDraw& draw) const {
        const Material* const material = material_of(draw);
        const std::uint32_t map = light_map_of(draw);
        return {
            gpu::storage(m_vertices[draw.chunk]), gpu::storage(m_indices[draw.chunk]),
            texture(material != nullptr ? material->base_color_texture : std::nullopt),
            texture(material != nullptr ? material->emissive_texture : std::nullopt),
            gpu::sampled(map == PreviewImages::none ? m_black : m_light_maps[map], {.filter = gpu::Filter::nearest})};
    }

    /// All but what is the same for every draw.
    [[nodiscard]] PreviewConstants constants(const PreviewDraw& draw, std::uint32_t show) const {
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
        return constants;
    }

private:
    static constexpr std::array<std::uint8_t, 4> white_texel{255, 255, 255, 255};
    static constexpr std::array<float, 4> black_texel{};

    [[nodiscard]] const Material* material_of(const PreviewDraw& draw) const {
        return draw.material < m_scene.materials.size() ? &m_scene.materials[draw.material] : nullptr;
    }

    [[nodiscard]] std::uint32_t light_map_of(const PreviewDraw& draw) const {
        return draw.material < m_images.light_map_of.size() ? m_images.light_map_of[draw.material]
                                                            : PreviewImages::none;
    }

    [[nodiscard]] gpu::Resource texture(const std::optional<TextureUse>& use) const {
        if (!use || use->image >= m_textures.size() || !m_textures[use->image]) {
            return gpu::sampled(m_white);
        }
        return gpu::sampled(*m_textures[use->image], {.u = wrap(use->wrap_u), .v = wrap(use->wrap_v)});
    }

    const Scene& m_scene;
    const PreviewImages& m_images;
    PreviewGeometry m_geometry;
    gpu::Image m_white;
    gpu::Image m_black;
    std::vector<gpu::Buffer> m_vertices; ///< one a chunk
    std::vector<gpu::Buffer> m_indices;
    std::vector<std::optional<gpu::Image>> m_textures; ///< one an image of the scene
    std::vector<gpu::Image> m_light_maps;
    glm::dvec3 m_mean{0.0}; ///< mean_light
};

gpu::GraphicsDescription surface_program(bool blend) {
    using gpu::Slot;
    return {.vertex_shader = "preview.vert",
            .fragment_shader = "preview.frag",
            .slots = {Slot::storage_buffer, Slot::storage_buffer, Slot::sampled_image, Slot::sampled_image,
                      Slot::sampled_image},
            .constant_bytes = sizeof(PreviewConstants),
            .colors = {radiance_format},
            .depth_target = true,
            .depth_test = gpu::DepthTest::greater,
            .blend = blend};
}

/// Programs and attachments, used for every tile.
class Pass {
public:
    Pass(gpu::Context& context, const Camera& camera, const PreviewSettings& settings, int width, int height)
        : m_context(context), m_camera(camera), m_settings(settings), m_exposure(settings.exposure),
          m_opaque(context, surface_program(false)), m_blended(context, surface_program(true)),
          m_sky(context, {.vertex_shader = "preview_sky.vert",
                          .fragment_shader = "preview_sky.frag",
                          .slots = {gpu::Slot::sampled_image},
                          .constant_bytes = sizeof(ResolveConstants),
                          .colors = {radiance_format},
                          .depth_target = true}),
          m_resolve(context, {.shader = "preview_resolve.comp",
                              .slots = {gpu::Slot::storage_image, gpu::Slot::storage_image},
                              .constant_bytes = sizeof(ResolveConstants)}),
          m_radiance(context, {.format = radiance_format,
                               .width = width * settings.samples,
                               .height = height * settings.samples,
                               .target = true,
                               .storage = true}),
          m_depth(context, {.format = gpu::Format::d32,
                            .width = width * settings.samples,
                            .height = height * settings.samples,
                            .target = true}),
          m_background(context, {.format = radiance_format, .width = width, .height = height, .sampled = true}),
          m_picture(context, {.format = radiance_format, .width = width, .height = height, .storage = true}),
          m_upload(context, m_background.size(), gpu::Memory::upload),
          m_result(context, m_picture.size(), gpu::Memory::read_back) {}

    /// Sets the exposure by the light on the opaque surfaces, seen in a small picture with one sample a pixel.
    void meter(const Resources& resources) {
        constexpr int largest = 256;
        const double scale =
            std::min(1.0, static_cast<double>(largest) / std::max(m_settings.width, m_settings.height));
        const auto scaled = [&](int side) { return std::max(static_cast<int>(scale * side), 1); };
        const Tile all{0, 0, scaled(m_settings.width), scaled(m_settings.height)};
        const gpu::Image light(m_context,
                               {.format = radiance_format, .width = all.width, .height = all.height, .target = true});
        const gpu::Image depth(m_context,
                               {.format = gpu::Format::d32, .width = all.width, .height = all.height, .target = true});
        const gpu::Buffer result(m_context, light.size(), gpu::Memory::read_back);
        m_context.run([&](gpu::Commands& commands) {
            commands.render(
                {.colors = {{.image = &light}}, .depth = gpu::DepthTarget{.image = &depth, .clear = 0.0F}}, [&] {
                    record_surfaces(commands, resources, all, {all.width, all.height}, PREVIEW_SHOW_METERED);
                });
            commands.barrier(gpu::Stage::draw, gpu::Stage::copy);
            commands.copy(light, {0, 0, all.width, all.height}, result);
        });
        const std::array<glm::vec4, 1> mean{glm::vec4(resources.mean(), 1.0F)};
        m_exposure *= metered_exposure(result.as<glm::vec4>()).value_or(metered_exposure(mean).value_or(1.0));
    }

    void draw(const Resources& resources, const PreviewSky& sky, const Tile& tile, Image& picture) {
        look_up_sky(sky, tile);
        const gpu::Region pixels{0, 0, tile.width, tile.height};
        const gpu::Region samples{0, 0, tile.width * m_settings.samples, tile.height * m_settings.samples};
        const ResolveConstants constants{
            static_cast<std::uint32_t>(tile.width), static_cast<std::uint32_t>(tile.height),
            static_cast<std::uint32_t>(m_settings.samples), static_cast<float>(m_exposure)};
        m_context.run([&](gpu::Commands& commands) {
            commands.copy(m_upload, 0, m_background, pixels);
            commands.barrier(gpu::Stage::copy, gpu::Stage::draw);
            const gpu::Targets targets{.colors = {{.image = &m_radiance}},
                                       .depth = gpu::DepthTarget{.image = &m_depth, .clear = 0.0F}};
            commands.render(
                targets,
                [&] {
                    commands.draw(m_sky, 3, std::array{gpu::sampled(m_background, {.filter = gpu::Filter::nearest})},
                                  gpu::bytes_of(constants));
                    record_surfaces(commands, resources, tile, {m_settings.width, m_settings.height},
                                    m_settings.light_only ? PREVIEW_SHOW_LIGHT_ONLY : PREVIEW_SHOW_ALL);
                },
                samples);
            commands.barrier(gpu::Stage::draw, gpu::Stage::compute);
            const auto groups = [](std::uint32_t count) { return (count + PREVIEW_GROUP - 1) / PREVIEW_GROUP; };
            commands.dispatch(m_resolve, {groups(constants.width), groups(constants.height)},
                              std::array{gpu::storage(m_radiance), gpu::storage(m_picture)}, gpu::bytes_of(constants));
            commands.barrier(gpu::Stage::compute, gpu::Stage::copy);
            commands.copy(m_picture, pixels, m_result);
        });
        const std::span<const glm::vec4> result = m_result.as<glm::vec4>();
        for (int row = 0; row < tile.height; ++row) {
            std::copy_n(result.begin() + static_cast<std::ptrdiff_t>(row) * tile.width, tile.width,
                        picture.texels.begin() + static_cast<std::ptrdiff_t>(picture.index(tile.x, tile.y + row)));
        }
    }

private:
    [[nodiscard]] double aspect() const { return static_cast<double>(m_settings.width) / m_settings.height; }

    void look_up_sky(const PreviewSky& sky, const Tile& tile) {
        const std::span<glm::vec4> texels = m_upload.as<glm::vec4>();
        const auto row_length = static_cast<std::size_t>(tile.width);
        parallel_ranges(
            row_length * static_cast<std::size_t>(tile.height), row_length, 0, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    const glm::ivec2 place(static_cast<int>(i % row_length), static_cast<int>(i / row_length));
                    const glm::dvec2 pixel = glm::dvec2(tile.x, tile.y) + glm::dvec2(place) + 0.5;
                    const glm::dvec2 point = pixel / glm::dvec2(m_settings.width, m_settings.height);
                    texels[i] = sky ? glm::vec4(sky(glm::vec3(direction_through(m_camera, aspect(), point))), 1.0F)
                                    : glm::vec4(0.0F);
                }
            });
    }

    /// `tile` of a picture of `size`.
    void record_surfaces(gpu::Commands& commands, const Resources& resources, const Tile& tile, const glm::dvec2& size,
                         std::uint32_t show) {
        const PreviewGeometry& geometry = resources.geometry();
        const glm::dmat4 whole = projection(m_camera, aspect(), geometry.near, geometry.far);
        // The tile's part of the clip space becomes all of it.
        const glm::dvec2 part(tile.width, tile.height);
        const glm::dvec2 middle = (2.0 * glm::dvec2(tile.x, tile.y) + part) / size - 1.0;
        const glm::dvec2 zoom = size / part;
        // What is seen through a blended surface is what the light is measured on.
        const std::size_t count = show == PREVIEW_SHOW_METERED ? geometry.opaque_draws : geometry.draws.size();
        for (std::size_t i = 0; i < count; ++i) {
            const PreviewDraw& draw = geometry.draws[i];
            PreviewConstants constants = resources.constants(draw, show);
            constants.clip_scale = glm::vec2(zoom * glm::dvec2(whole[0][0], whole[1][1]));
            constants.clip_offset = glm::vec2(-zoom * middle);
            constants.depth = glm::vec4(glm::dvec4(whole[2][2], whole[3][2], whole[2][3], whole[3][3]));
            commands.draw(i < geometry.opaque_draws ? m_opaque : m_blended, draw.index_count, resources.bindings(draw),
                          gpu::bytes_of(constants), draw.first_index);
        }
    }

    gpu::Context& m_context;
    const Camera& m_camera;
    const PreviewSettings& m_settings;
    double m_exposure;
    gpu::GraphicsProgram m_opaque;
    gpu::GraphicsProgram m_blended;
    gpu::GraphicsProgram m_sky;
    gpu::ComputeProgram m_resolve;
    gpu::Image m_radiance;
    gpu::Image m_depth;
    gpu::Image m_background;
    gpu::Image m_picture;
    gpu::Buffer m_upload;
    gpu::Buffer m_result;
};

void check(const PreviewSettings& settings) {
    constexpr int largest = 16384;
    if (std::min(settings.width, settings.height) < 1 || std::max(settings.width, settings.height) > largest) {
        throw Error(ErrorKind::usage, "picture: " + std::to_string(settings.width) + " x " +
                                          std::to_string(settings.height) + " pixels is out of range; give 1 to " +
                                          std::to_string(largest) + " in each direction");
    }
    if (!std::isfinite(settings.exposure)) {
        throw Error(ErrorKind::usage, "exposure: is not finite; give stops around 0");
    }
}

} // namespace

Image draw_preview(gpu::Context& context, const Scene& scene, const PreviewImages& images, const Camera& camera,
                   const PreviewSky& sky, const PreviewSettings& settings) {
    check(settings);
    constexpr std::size_t chunk_bytes = std::size_t{64} << 20U; // half of what every device's storage buffers hold
    const Resources resources(context, scene, images, make_geometry(scene, camera, images.occlusion, chunk_bytes));
    const int side = std::max(settings.tile / settings.samples, 1);
    Pass pass(context, camera, settings, std::min(side, settings.width), std::min(side, settings.height));
    if (settings.metered) {
        pass.meter(resources);
    }
    Image picture{.width = settings.width, .height = settings.height, .texels = {}, .coverage = {}};
    picture.texels.resize(static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height));
    for (int y = 0; y < settings.height; y += side) {
        for (int x = 0; x < settings.width; x += side) {
            const Tile tile{x, y, std::min(side, settings.width - x), std::min(side, settings.height - y)};
            pass.draw(resources, sky, tile, picture);
        }
    }
    return picture;
}

} // namespace vkbake
