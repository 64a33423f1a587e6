#include "finish/denoise.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "denoise.h"
#include "gpu/commands.hpp"
#include "gpu/context.hpp"
#include "gpu/programs.hpp"
#include "gpu/resources.hpp"

namespace vkbake {

namespace {

/// Of a map, its border with it.
struct DenoiseTile {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
};

DenoiseTile bordered(int left, int top, int side, const DenoiseFields& fields) {
    const int x = std::max(left - DENOISE_BORDER, 0);
    const int y = std::max(top - DENOISE_BORDER, 0);
    return {x, y, std::min(left + side + DENOISE_BORDER, fields.width) - x,
            std::min(top + side + DENOISE_BORDER, fields.height) - y};
}

gpu::ComputeProgram denoise_program(gpu::Context& context, std::string_view shader, std::size_t images) {
    return {context,
            {.shader = shader,
             .slots = std::vector(images, gpu::Slot::storage_image),
             .constant_bytes = sizeof(DenoiseConstants)}};
}

/// Kept by the context, for page after page.
struct DenoisePrograms {
    explicit DenoisePrograms(gpu::Context& context)
        : guide(denoise_program(context, "denoise_guide.comp", 4)),
          fit(denoise_program(context, "denoise_fit.comp", 6)),
          choose(denoise_program(context, "denoise_choose.comp", 6)) {}

    gpu::ComputeProgram guide;
    gpu::ComputeProgram fit;
    gpu::ComputeProgram choose;
};

/// The device's memory for one tile, used for all.
class DenoisePasses {
public:
    DenoisePasses(gpu::Context& context, int width, int height)
        : m_context(context), m_programs(context.kept<DenoisePrograms>()),
          m_colors(image(gpu::Format::rgba32ui, width, height)), m_places(image(gpu::Format::rgba32f, width, height)),
          m_facings(image(gpu::Format::rgba32f, width, height)), m_guides(image(gpu::Format::rgba32f, width, height)),
          m_fits(image(gpu::Format::rgba32f, width, height)), m_risks(image(gpu::Format::rgba32f, width, height)),
          m_chosen(image(gpu::Format::r32f, width, height)),
          m_upload(context, 3 * m_colors.size(), gpu::Memory::upload),
          m_fits_back(context, m_fits.size(), gpu::Memory::read_back),
          m_chosen_back(context, m_chosen.size(), gpu::Memory::read_back) {}

    void run(const DenoiseFields& fields, const DenoiseTile& tile) {
        const std::size_t texels = static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height);
        const std::size_t bytes = texels * sizeof(glm::vec4);
        write(fields, tile, fields.color, m_upload.as<glm::vec4>());
        write(fields, tile, fields.place, m_upload.as<glm::vec4>().subspan(texels));
        write(fields, tile, fields.facing, m_upload.as<glm::vec4>().subspan(2 * texels));
        const gpu::Region region{0, 0, tile.width, tile.height};
        const DenoiseConstants constants{static_cast<std::uint32_t>(tile.width),
                                         static_cast<std::uint32_t>(tile.height), fields.good};
        m_context.run([&](gpu::Commands& commands) {
            commands.copy(m_upload, 0, m_colors, region);
            commands.copy(m_upload, bytes, m_places, region);
            commands.copy(m_upload, 2 * bytes, m_facings, region);
            commands.barrier(gpu::Stage::copy, gpu::Stage::compute);
            dispatch(commands, m_programs.guide, constants, {&m_guides});
            commands.barrier(gpu::Stage::compute, gpu::Stage::compute);
            dispatch(commands, m_programs.fit, constants, {&m_guides, &m_fits, &m_risks});
            commands.barrier(gpu::Stage::compute, gpu::Stage::compute);
            dispatch(commands, m_programs.choose, constants, {&m_fits, &m_risks, &m_chosen});
            commands.barrier(gpu::Stage::compute, gpu::Stage::copy);
            commands.copy(m_fits, region, m_fits_back);
            commands.copy(m_chosen, region, m_chosen_back);
        });
    }

    /// Of the last tile, row by row.
    [[nodiscard]] DenoisedTexel texel(std::size_t index) const {
        const glm::vec4 fit = m_fits_back.as<glm::vec4>()[index];
        return {glm::vec3(fit), fit.w, m_chosen_back.as<float>()[index]};
    }

private:
    [[nodiscard]] gpu::Image image(gpu::Format format, int width, int height) {
        return {m_context, {.format = format, .width = width, .height = height, .storage = true}};
    }

    static void write(const DenoiseFields& fields, const DenoiseTile& tile, const std::vector<glm::vec4>& from,
                      std::span<glm::vec4> to) {
        for (int row = 0; row < tile.height; ++row) {
            const auto first = static_cast<std::size_t>(tile.top + row) * static_cast<std::size_t>(fields.width) +
                               static_cast<std::size_t>(tile.left);
            const auto width = static_cast<std::size_t>(tile.width);
            // As bytes: a chart's number is no float.
            std::memcpy(&to[static_cast<std::size_t>(row) * width], &from[first], width * sizeof(glm::vec4));
        }
    }

    void dispatch(gpu::Commands& commands, const gpu::ComputeProgram& program, const DenoiseConstants& constants,
                  std::initializer_list<const gpu::Image*> others) {
        std::vector<gpu::Resource> resources{gpu::storage(m_colors), gpu::storage(m_places), gpu::storage(m_facings)};
        for (const gpu::Image* image : others) {
            resources.push_back(gpu::storage(*image));
        }
        const auto groups = [](std::uint32_t texels) { return (texels + DENOISE_GROUP - 1) / DENOISE_GROUP; };
        commands.dispatch(program, {groups(constants.width), groups(constants.height)}, resources,
                          gpu::bytes_of(constants));
    }

    gpu::Context& m_context;
    DenoisePrograms& m_programs;
    gpu::Image m_colors;
    gpu::Image m_places;
    gpu::Image m_facings;
    gpu::Image m_guides; // mean variance, mean, its variance
    gpu::Image m_fits;
    gpu::Image m_risks;
    gpu::Image m_chosen;
    gpu::Buffer m_upload;
    gpu::Buffer m_fits_back;
    gpu::Buffer m_chosen_back;
};

bool takes_part(const glm::vec4& color) { return std::bit_cast<std::uint32_t>(color.a) != 0; }

} // namespace

std::uint64_t denoise(gpu::Context& context, LightMap& map, const DenoiseGuides& guides,
                      const DenoiseSettings& settings) {
    const DenoiseFields fields = make_denoise_fields(map, guides);
    if (std::none_of(fields.color.begin(), fields.color.end(), takes_part)) {
        return 0;
    }
    const int side = settings.tile;
    const int most = side + 2 * DENOISE_BORDER;
    DenoisePasses passes(context, std::min(most, fields.width), std::min(most, fields.height));
    DenoisedTexels denoised(fields.color.size());
    for (int top = 0; top < fields.height; top += side) {
        for (int left = 0; left < fields.width; left += side) {
            const DenoiseTile tile = bordered(left, top, side, fields);
            passes.run(fields, tile);
            for (int y = top; y < std::min(top + side, fields.height); ++y) {
                for (int x = left; x < std::min(left + side, fields.width); ++x) {
                    denoised[map.image.index(x, y)] = passes.texel(static_cast<std::size_t>(
                        static_cast<std::ptrdiff_t>(y - tile.top) * tile.width + (x - tile.left)));
                }
            }
        }
    }
    return take_denoised(fields, denoised, guides, map);
}

} // namespace vkbake
