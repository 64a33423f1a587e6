#include "finish/dilate.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "dilate.h"
#include "finish/dilate_reference.hpp"
#include "gpu/commands.hpp"
#include "gpu/context.hpp"
#include "gpu/programs.hpp"
#include "gpu/resources.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

/// Rounds that are submitted together: few waits for the device, yet no submission so long that a desktop's watchdog
/// ends it.
constexpr int rounds_a_run = 16;

struct Rectangle {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// The rectangle with `border` texels more on each side, as far as the image goes.
Rectangle with_border(const Rectangle& inner, int border, const Image& image) {
    const int left = std::max(inner.x - border, 0);
    const int top = std::max(inner.y - border, 0);
    return {left, top, std::min(inner.x + inner.width + border, image.width) - left,
            std::min(inner.y + inner.height + border, image.height) - top};
}

Rectangle intersection(const Rectangle& a, const Rectangle& b) {
    const int left = std::max(a.x, b.x);
    const int top = std::max(a.y, b.y);
    return {left, top, std::max(std::min(a.x + a.width, b.x + b.width) - left, 0),
            std::max(std::min(a.y + a.height, b.y + b.height) - top, 0)};
}

/// The least rectangle that holds those of the area's texels that are filled, or those that are not; 0 by 0 where none
/// are.
Rectangle box_of(const Image& image, const Rectangle& area, bool filled) {
    int left = area.x + area.width;
    int right = area.x;
    int top = area.y + area.height;
    int bottom = area.y;
    for (int y = area.y; y < area.y + area.height; ++y) {
        for (int x = area.x; x < area.x + area.width; ++x) {
            if (is_filled(image.texels[image.index(x, y)]) == filled) {
                left = std::min(left, x);
                right = std::max(right, x + 1);
                top = std::min(top, y);
                bottom = y + 1;
            }
        }
    }
    return left < right ? Rectangle{left, top, right - left, bottom - top} : Rectangle{};
}

/// Of a tile what the rounds may reach: its empty texels that are no farther from a filled one.
Rectangle within_reach(const Image& image, const Rectangle& tile, int border) {
    const Rectangle filled = box_of(image, with_border(tile, border, image), true);
    if (filled.width == 0) {
        return {};
    }
    return box_of(image, intersection(tile, with_border(filled, border, image)), false);
}

/// The device's memory for one tile, used for all.
class Pass {
public:
    Pass(gpu::Context& context, int width, int height, int rounds)
        : m_context(context), m_rounds(rounds),
          m_program(context, {.shader = "dilate.comp",
                              .slots = {gpu::Slot::storage_image, gpu::Slot::storage_image, gpu::Slot::storage_buffer},
                              .constant_bytes = sizeof(DilateConstants)}),
          m_images{gpu::Image(context, description(width, height)), gpu::Image(context, description(width, height))},
          m_upload(context, m_images[0].size(), gpu::Memory::upload),
          m_result(context, m_images[0].size(), gpu::Memory::read_back),
          m_progress(context, (static_cast<std::size_t>(rounds) + 1) * sizeof(std::uint32_t), gpu::Memory::device) {}

    /// Dilates the area as an image of its own, as it was before any of it was `made` by a tile before. The span stays
    /// valid until the next call: row by row, `area.width` texels each.
    std::span<const glm::vec4> run(const Image& image, const Rectangle& area, const std::vector<bool>& made) {
        const std::span<glm::vec4> texels = m_upload.as<glm::vec4>();
        std::size_t to = 0;
        for (int y = area.y; y < area.y + area.height; ++y) {
            const std::size_t row = image.index(area.x, y);
            for (std::size_t from = row; from < row + static_cast<std::size_t>(area.width); ++from) {
                texels[to++] = made[from] ? glm::vec4(0.0F) : image.texels[from];
            }
        }
        std::vector<std::uint32_t> filled(static_cast<std::size_t>(m_rounds) + 1, 0);
        filled[0] = 1;
        m_progress.upload(std::as_bytes(std::span(filled)));
        const gpu::Region region{0, 0, area.width, area.height};
        for (int round = 0; round < m_rounds && filled[static_cast<std::size_t>(round)] != 0; round += rounds_a_run) {
            const int last = std::min(round + rounds_a_run, m_rounds);
            m_context.run([&](gpu::Commands& commands) {
                if (round == 0) {
                    commands.copy(m_upload, 0, m_images[0], region);
                    commands.barrier(gpu::Stage::copy, gpu::Stage::compute);
                }
                for (int i = round; i < last; ++i) {
                    record(commands, area, i);
                }
                commands.barrier(gpu::Stage::compute, gpu::Stage::copy);
                commands.copy(m_images[static_cast<std::size_t>(last % 2)], region, m_result);
            });
            m_progress.download(std::as_writable_bytes(std::span(filled)));
        }
        return m_result.as<glm::vec4>();
    }

private:
    static gpu::ImageDescription description(int width, int height) {
        return {.format = gpu::Format::rgba32ui, .width = width, .height = height, .storage = true};
    }

    void record(gpu::Commands& commands, const Rectangle& area, int round) {
        const DilateConstants constants{static_cast<std::uint32_t>(area.width), static_cast<std::uint32_t>(area.height),
                                        static_cast<std::uint32_t>(round)};
        const auto source = static_cast<std::size_t>(round % 2);
        const auto groups = [](std::uint32_t texels) { return (texels + DILATE_GROUP - 1) / DILATE_GROUP; };
        commands.dispatch(
            m_program, {groups(constants.width), groups(constants.height)},
            std::vector{gpu::storage(m_images[source]), gpu::storage(m_images[1 - source]), gpu::storage(m_progress)},
            gpu::bytes_of(constants));
        commands.barrier(gpu::Stage::compute, gpu::Stage::compute);
    }

    gpu::Context& m_context;
    int m_rounds;
    gpu::ComputeProgram m_program;
    std::array<gpu::Image, 2> m_images;
    gpu::Buffer m_upload;
    gpu::Buffer m_result;
    gpu::Buffer m_progress;
};

/// Takes over what the pass filled, and nothing else: so no texel that was filled before can change.
std::uint64_t take_filled(std::span<const glm::vec4> result, const Rectangle& area, const Rectangle& inner,
                          Image& image, std::vector<bool>& made) {
    std::uint64_t count = 0;
    for (int y = inner.y; y < inner.y + inner.height; ++y) {
        const auto row = static_cast<std::size_t>(y - area.y) * static_cast<std::size_t>(area.width);
        for (int x = inner.x; x < inner.x + inner.width; ++x) {
            const glm::vec4& texel = result[row + static_cast<std::size_t>(x - area.x)];
            const std::size_t index = image.index(x, y);
            if (is_filled(texel) && !is_filled(image.texels[index])) {
                image.texels[index] = texel;
                made[index] = true;
                ++count;
            }
        }
    }
    return count;
}

} // namespace

std::uint64_t dilate(gpu::Context& context, Image& image, const DilateSettings& settings) {
    if (settings.rounds < 0 || settings.tile < 1) {
        throw Error(ErrorKind::usage,
                    "padding: must not be negative, and a tile has at least one texel; change the setting");
    }
    // A value travels one texel a round: so far reaches a tile's border, and more rounds than the image is long do
    // nothing.
    const int border = std::min(settings.rounds, std::max(image.width, image.height));
    std::vector<Rectangle> tiles;
    Rectangle largest;
    for (int y = 0; y < image.height; y += settings.tile) {
        for (int x = 0; x < image.width; x += settings.tile) {
            const Rectangle tile{x, y, std::min(settings.tile, image.width - x),
                                 std::min(settings.tile, image.height - y)};
            const Rectangle inner = border > 0 ? within_reach(image, tile, border) : Rectangle{};
            if (inner.width > 0) {
                const Rectangle area = with_border(inner, border, image);
                tiles.push_back(inner);
                largest.width = std::max(largest.width, area.width);
                largest.height = std::max(largest.height, area.height);
            }
        }
    }
    if (tiles.empty()) {
        return 0;
    }
    Pass pass(context, largest.width, largest.height, border);
    std::vector<bool> made(image.texels.size(), false);
    std::uint64_t filled = 0;
    for (const Rectangle& inner : tiles) {
        const Rectangle area = with_border(inner, border, image);
        filled += take_filled(pass.run(image, area, made), area, inner, image, made);
    }
    return filled;
}

} // namespace vkbake
