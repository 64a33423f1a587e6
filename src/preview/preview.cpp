#include "preview/preview.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
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
#include "preview/resources.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

constexpr auto radiance_format = gpu::Format::rgba32f;

/// Pixels of the picture that are drawn at once.
struct Tile {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

gpu::GraphicsDescription surface_program(bool blend, bool relief) {
    using gpu::Slot;
    std::vector<Slot> slots{Slot::storage_buffer, Slot::storage_buffer, Slot::sampled_image, Slot::sampled_image,
                            Slot::sampled_image};
    if (relief) {
        slots.push_back(Slot::storage_buffer);
        slots.insert(slots.end(), 5, Slot::sampled_image);
    }
    return {.vertex_shader = relief ? "preview_relief.vert" : "preview.vert",
            .fragment_shader = relief ? "preview_relief.frag" : "preview.frag",
            .slots = slots,
            .constant_bytes = sizeof(PreviewConstants),
            .colors = {radiance_format},
            .depth_target = true,
            .depth_test = gpu::DepthTest::greater,
            .blend = blend};
}

/// What draws surfaces of one kind.
struct SurfacePrograms {
    SurfacePrograms(gpu::Context& context, bool relief)
        : opaque(context, surface_program(false, relief)), blended(context, surface_program(true, relief)) {}

    gpu::GraphicsProgram opaque;
    gpu::GraphicsProgram blended;
};

glm::vec4 quaternion(const glm::dmat3& orientation) {
    const glm::dquat turn = glm::quat_cast(orientation);
    return {turn.x, turn.y, turn.z, turn.w};
}

/// Programs and attachments, used for every tile.
class Pass {
public:
    Pass(gpu::Context& context, const Camera& camera, const PreviewSettings& settings, int width, int height)
        : m_context(context), m_camera(camera), m_settings(settings), m_exposure(settings.exposure),
          m_surfaces(context, false), m_sky(context, {.vertex_shader = "preview_sky.vert",
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
    void meter(const PreviewResources& resources) {
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

    void draw(const PreviewResources& resources, const PreviewSky& sky, const Tile& tile, Image& picture) {
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
    void record_surfaces(gpu::Commands& commands, const PreviewResources& resources, const Tile& tile,
                         const glm::dvec2& size, std::uint32_t show) {
        const PreviewGeometry& geometry = resources.geometry();
        const glm::dmat4 whole = projection(m_camera, aspect(), geometry.near, geometry.far);
        // The tile's part of the clip space becomes all of it.
        const glm::dvec2 part(tile.width, tile.height);
        const glm::dvec2 middle = (2.0 * glm::dvec2(tile.x, tile.y) + part) / size - 1.0;
        const glm::dvec2 zoom = size / part;
        const glm::vec4 orientation = quaternion(m_camera.orientation);
        // What is seen through a blended surface is what the light is measured on.
        const std::size_t count = show == PREVIEW_SHOW_METERED ? geometry.opaque_draws : geometry.draws.size();
        for (std::size_t i = 0; i < count; ++i) {
            const PreviewDraw& draw = geometry.draws[i];
            const bool relief = show != PREVIEW_SHOW_METERED && resources.has_relief(draw);
            if (relief && !m_reliefs) {
                m_reliefs.emplace(m_context, true);
            }
            PreviewConstants constants = resources.constants(draw, show);
            constants.orientation = orientation;
            constants.clip_scale = glm::vec2(zoom * glm::dvec2(whole[0][0], whole[1][1]));
            constants.clip_offset = glm::vec2(-zoom * middle);
            constants.depth = glm::vec4(glm::dvec4(whole[2][2], whole[3][2], whole[2][3], whole[3][3]));
            const SurfacePrograms& programs = relief ? *m_reliefs : m_surfaces;
            commands.draw(i < geometry.opaque_draws ? programs.opaque : programs.blended, draw.index_count,
                          resources.bindings(draw, relief), gpu::bytes_of(constants), draw.first_index);
        }
    }

    gpu::Context& m_context;
    const Camera& m_camera;
    const PreviewSettings& m_settings;
    double m_exposure;
    SurfacePrograms m_surfaces;
    std::optional<SurfacePrograms> m_reliefs; ///< made when the first one is drawn
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
    const PreviewResources resources(context, scene, images, make_geometry(scene, camera, images, chunk_bytes));
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
