#include "geometry_image/draw.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include <glm/vec4.hpp>

#include "base/float_state.hpp"
#include "base/parallel.hpp"
#include "geometry_image/texel_triangles.hpp"
#include "gpu/commands.hpp"
#include "gpu/context.hpp"

namespace vkbake {

namespace {

using shared::TexelTriangle;
using shared::TileConstants;

/// Triangles drawn at once: 25 MB of them, far below any device's storage-buffer range. More go in further draws, in
/// order.
constexpr std::size_t batch_triangles = 131072;
constexpr std::uint32_t vertices_of_a_box = 6;

/// What every page needs, kept with the context.
struct Pass {
    explicit Pass(gpu::Context& context)
        : program(context, {.vertex_shader = "geometry_image.vert",
                            .fragment_shader = "geometry_image.frag",
                            .slots = {gpu::Slot::storage_buffer},
                            .constant_bytes = sizeof(TileConstants),
                            .colors = {gpu::Format::rgba32f, gpu::Format::rgba32f, gpu::Format::r32ui},
                            .depth_target = true,
                            .depth_test = gpu::DepthTest::less}),
          triangles(context, batch_triangles * sizeof(TexelTriangle), gpu::Memory::upload) {}

    gpu::GraphicsProgram program;
    gpu::Buffer triangles;
};

/// One tile's attachments and what they are read back into, used for tile after tile.
struct TileTargets {
    TileTargets(gpu::Context& context, int width, int height)
        : position(context, {.format = gpu::Format::rgba32f, .width = width, .height = height, .target = true}),
          normal(context, {.format = gpu::Format::rgba32f, .width = width, .height = height, .target = true}),
          number(context, {.format = gpu::Format::r32ui, .width = width, .height = height, .target = true}),
          depth(context, {.format = gpu::Format::d32, .width = width, .height = height, .target = true}),
          read_position(context, position.size(), gpu::Memory::read_back),
          read_normal(context, normal.size(), gpu::Memory::read_back),
          read_number(context, number.size(), gpu::Memory::read_back) {}

    [[nodiscard]] gpu::Targets cleared() const {
        constexpr std::uint32_t none = GeometryImage::empty;
        return {.colors = {{.image = &position}, {.image = &normal}, {&number, std::array{none, none, none, none}}},
                .depth = gpu::DepthTarget{&depth, 1.0F}};
    }

    [[nodiscard]] gpu::Targets continued() const {
        return {.colors = {{&position, gpu::Load{}}, {&normal, gpu::Load{}}, {&number, gpu::Load{}}},
                .depth = gpu::DepthTarget{&depth, std::nullopt}};
    }

    gpu::Image position;
    gpu::Image normal;
    gpu::Image number;
    gpu::Image depth;
    gpu::Buffer read_position;
    gpu::Buffer read_normal;
    gpu::Buffer read_number;
};

/// The side of a tile: what was asked for, as far as the page needs it and a quarter of the device's memory holds it.
int tile_side(const gpu::Limits& limits, const TexelGrid& grid, const DrawSettings& settings) {
    constexpr std::uint64_t bytes_of_a_texel = 16 + 16 + 4 + 4 + 16 + 16 + 4;
    int side = std::min({settings.tile, limits.image_side, std::max(grid.width, grid.height)});
    const auto bytes = [&] {
        return bytes_of_a_texel * static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side);
    };
    while (side > 64 && bytes() > limits.heap_size / 4) {
        side /= 2;
    }
    return std::max(side, 1);
}

/// A page cut into tiles, with the triangles whose boxes meet each, in canonical order.
struct Tiles {
    Tiles(const Atlas& atlas, const TexelGrid& grid, int tile, const std::vector<std::uint32_t>& drawn)
        : side(tile), columns((grid.width + tile - 1) / tile), rows((grid.height + tile - 1) / tile),
          triangles(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {
        for (const std::uint32_t triangle : drawn) {
            const TexelBox box = texel_box(atlas, grid, triangle);
            for (int row = box.y_begin / side; row * side < box.y_end; ++row) {
                for (int column = box.x_begin / side; column * side < box.x_end; ++column) {
                    triangles[index(row, column)].push_back(triangle);
                }
            }
        }
    }

    [[nodiscard]] std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }

    int side;
    int columns;
    int rows;
    std::vector<std::vector<std::uint32_t>> triangles;
};

class PageDrawing {
public:
    PageDrawing(gpu::Context& context, const Surface& surface, const Atlas& atlas, const TexelGrid& grid,
                int tile_width, int tile_height)
        : m_context(context), m_surface(surface), m_atlas(atlas), m_grid(grid), m_pass(context.kept<Pass>()),
          m_targets(context, tile_width, tile_height) {}

    void draw(const gpu::Region& tile, std::span<const std::uint32_t> triangles, GeometryImage& image) {
        gpu::Targets targets = m_targets.cleared();
        for (std::size_t done = 0; done < triangles.size(); done += batch_triangles) {
            const auto batch = triangles.subspan(done, std::min(batch_triangles, triangles.size() - done));
            draw_batch(tile, batch, targets, done + batch.size() == triangles.size());
            targets = m_targets.continued();
        }
        read(tile, image);
    }

private:
    void draw_batch(const gpu::Region& tile, std::span<const std::uint32_t> batch, const gpu::Targets& targets,
                    bool last) {
        const std::span<TexelTriangle> records = m_pass.triangles.as<TexelTriangle>();
        parallel_ranges(batch.size(), 1024, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                records[i] = make_texel_triangle(m_surface, m_atlas, m_grid, batch[i]);
            }
        });
        const TileConstants constants = constants_of(tile);
        const std::array resources{gpu::storage(m_pass.triangles)};
        const gpu::Region region{0, 0, tile.width, tile.height};
        m_context.run([&](gpu::Commands& commands) {
            const auto vertices = static_cast<std::uint32_t>(batch.size()) * vertices_of_a_box;
            commands.render(
                targets, [&] { commands.draw(m_pass.program, vertices, resources, gpu::bytes_of(constants)); }, region);
            if (last) {
                commands.barrier(gpu::Stage::draw, gpu::Stage::copy);
                commands.copy(m_targets.position, region, m_targets.read_position);
                commands.copy(m_targets.normal, region, m_targets.read_normal);
                commands.copy(m_targets.number, region, m_targets.read_number);
            }
        });
    }

    [[nodiscard]] TileConstants constants_of(const gpu::Region& tile) const {
        // A rasteriser snaps vertices to its grid, twice over where it clips; the rest is for the vertex shader's
        // rounding.
        const float slack = 2.0F / static_cast<float>(1U << m_context.limits().sub_pixel_precision_bits) + 1.0F / 32.0F;
        const auto units = static_cast<double>(m_grid.units);
        return {.origin_x = tile.x,
                .origin_y = tile.y,
                .width = tile.width,
                .height = tile.height,
                .units = m_grid.units,
                .slack = slack,
                .depth_scale = 1.0 / (units * units)};
    }

    void read(const gpu::Region& tile, GeometryImage& image) const {
        const auto positions = m_targets.read_position.as<glm::vec4>();
        const auto normals = m_targets.read_normal.as<glm::vec4>();
        const auto numbers = m_targets.read_number.as<std::uint32_t>();
        const auto width = static_cast<std::size_t>(tile.width);
        parallel_ranges(static_cast<std::size_t>(tile.height), 16, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row) {
                const std::size_t to =
                    (static_cast<std::size_t>(tile.y) + row) * static_cast<std::size_t>(image.width) +
                    static_cast<std::size_t>(tile.x);
                for (std::size_t column = 0; column < width; ++column) {
                    const std::size_t from = row * width + column;
                    const std::uint32_t number = numbers[from];
                    if (number == GeometryImage::empty) {
                        continue;
                    }
                    const glm::vec3& geometric = m_surface.geometric_normals[number];
                    image.triangle[to + column] = number;
                    image.position[to + column] = positions[from];
                    image.shading_normal[to + column] = unit_shading_normal(normals[from], geometric);
                    image.geometric_normal[to + column] = geometric;
                }
            }
        });
    }

    gpu::Context& m_context;
    const Surface& m_surface;
    const Atlas& m_atlas;
    const TexelGrid& m_grid;
    Pass& m_pass;
    TileTargets m_targets;
};

GeometryImage empty_image(const TexelGrid& grid) {
    GeometryImage image;
    image.width = grid.width;
    image.height = grid.height;
    const std::size_t texels = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    image.triangle.assign(texels, GeometryImage::empty);
    image.position = ZeroedArray<glm::vec3>(texels);
    image.shading_normal = ZeroedArray<glm::vec3>(texels);
    image.geometric_normal = ZeroedArray<glm::vec3>(texels);
    return image;
}

} // namespace

GeometryImage draw_geometry_image(gpu::Context& context, const Surface& surface, const Atlas& atlas, std::uint32_t page,
                                  const DrawSettings& settings) {
    const DefaultFloatState float_state;
    const TexelGrid grid(atlas.pages.at(page));
    GeometryImage image = empty_image(grid);
    const std::vector<std::uint32_t> drawn = drawn_triangles(surface, atlas, page);
    if (drawn.empty()) {
        return image;
    }
    const Tiles tiles(atlas, grid, tile_side(context.limits(), grid, settings), drawn);
    const int side = tiles.side;
    PageDrawing drawing(context, surface, atlas, grid, std::min(side, grid.width), std::min(side, grid.height));
    for (int row = 0; row < tiles.rows; ++row) {
        for (int column = 0; column < tiles.columns; ++column) {
            const auto& triangles = tiles.triangles[tiles.index(row, column)];
            const gpu::Region tile{column * side, row * side, std::min(side, grid.width - column * side),
                                   std::min(side, grid.height - row * side)};
            if (!triangles.empty()) {
                drawing.draw(tile, triangles, image);
            }
        }
    }
    return image;
}

} // namespace vkbake
