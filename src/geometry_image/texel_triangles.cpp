#include "geometry_image/texel_triangles.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "vkbake/error.hpp"

namespace vkbake {

namespace {

constexpr int grid_side = 1 << 26; // units a page's side

int to_units(float coordinate, int texels, int units) {
    // The product is exact: 24 bits by at most 26. Halves go up, for a mirrored map too.
    return static_cast<int>(std::floor(static_cast<double>(coordinate) * texels * units + 0.5));
}

double inverse(double value) { return value == 0.0 ? 0.0 : 1.0 / value; }

/// Some devices take denormals for 0; so nobody sees one.
float without_denormal(float value) { return std::abs(value) < std::numeric_limits<float>::min() ? 0.0F : value; }

void set_corners(shared::TexelTriangle& made, const Surface& surface, std::uint32_t triangle) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::vec3& position = surface.positions[3 * std::size_t{triangle} + corner];
        const glm::vec3& normal = surface.normals[3 * std::size_t{triangle} + corner];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            made.position[3 * corner + axis] = without_denormal(position[static_cast<int>(axis)]);
            made.normal[3 * corner + axis] = without_denormal(normal[static_cast<int>(axis)]);
        }
    }
}

void set_inverses(shared::TexelTriangle& made) {
    const auto x = [&](std::size_t corner) { return static_cast<double>(made.x[corner % 3]); };
    const auto y = [&](std::size_t corner) { return static_cast<double>(made.y[corner % 3]); };
    made.inverse_area = inverse((x(1) - x(0)) * (y(2) - y(0)) - (y(1) - y(0)) * (x(2) - x(0)));
    for (std::size_t edge = 0; edge < 3; ++edge) {
        double dx = x(edge + 1) - x(edge);
        double dy = y(edge + 1) - y(edge);
        if (dx < 0.0 || (dx == 0.0 && dy < 0.0)) {
            made.turned |= 1U << edge;
            dx = 0.0 - dx;
            dy = 0.0 - dy;
        }
        made.inverse_x[edge] = inverse(dx);
        made.inverse_y[edge] = inverse(dy);
        made.inverse_square[edge] = inverse(dx * dx + dy * dy);
    }
}

[[noreturn]] void refuse_uv(std::uint32_t triangle, const glm::vec2& uv) {
    throw Error(ErrorKind::bad_input, "geometry image: triangle " + std::to_string(triangle) + " has light-map UV (" +
                                          std::to_string(uv.x) + ", " + std::to_string(uv.y) +
                                          ") outside [0,1]; make the UVs anew (--uv make)");
}

} // namespace

TexelGrid::TexelGrid(const AtlasPage& page) : width(page.width), height(page.height) {
    const int side = std::max(width, height);
    if (std::min(width, height) < 1 || side > grid_side / 2) {
        throw Error(ErrorKind::usage, "geometry image: page " + page.name + " has " + std::to_string(width) + " x " +
                                          std::to_string(height) + " texels; choose a size from 1 to " +
                                          std::to_string(grid_side / 2));
    }
    units = grid_side / static_cast<int>(std::bit_ceil(static_cast<unsigned>(side)));
}

int TexelGrid::x(float u) const { return to_units(u, width, units); }

int TexelGrid::y(float v) const { return to_units(v, height, units); }

shared::TexelTriangle make_texel_triangle(const Surface& surface, const Atlas& atlas, const TexelGrid& grid,
                                          std::uint32_t triangle) {
    shared::TexelTriangle made{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::vec2& uv = atlas.uvs[3 * std::size_t{triangle} + corner];
        made.x[corner] = grid.x(uv.x);
        made.y[corner] = grid.y(uv.y);
    }
    made.number = triangle;
    set_corners(made, surface, triangle);
    set_inverses(made);
    return made;
}

TexelBox texel_box(const Atlas& atlas, const TexelGrid& grid, std::uint32_t triangle) {
    const glm::vec2* uv = &atlas.uvs[3 * std::size_t{triangle}];
    const auto [x_low, x_high] = std::minmax({grid.x(uv[0].x), grid.x(uv[1].x), grid.x(uv[2].x)});
    const auto [y_low, y_high] = std::minmax({grid.y(uv[0].y), grid.y(uv[1].y), grid.y(uv[2].y)});
    // A coordinate on the border of two texels belongs to both.
    const auto first = [&](int low) { return std::max((low + grid.units - 1) / grid.units - 1, 0); };
    const auto end = [&](int high, int side) { return std::min(high / grid.units + 1, side); };
    return {first(x_low), end(x_high, grid.width), first(y_low), end(y_high, grid.height)};
}

std::vector<std::uint32_t> drawn_triangles(const Surface& surface, const Atlas& atlas, std::uint32_t page) {
    std::vector<std::uint32_t> drawn;
    for (const std::uint32_t triangle : surface.canonical_order) {
        if (atlas.page[triangle] != page || surface.geometric_normals[triangle] == glm::vec3(0.0F)) {
            continue;
        }
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const glm::vec2& uv = atlas.uvs[3 * std::size_t{triangle} + corner];
            if (!(uv.x >= 0.0F && uv.x <= 1.0F && uv.y >= 0.0F && uv.y <= 1.0F)) {
                refuse_uv(triangle, uv);
            }
        }
        drawn.push_back(triangle);
    }
    return drawn;
}

glm::vec3 unit_shading_normal(const glm::vec3& interpolated, const glm::vec3& geometric) {
    // By hand: the bits of glm's dot and normalize depend on how it was built.
    const double x = interpolated.x;
    const double y = interpolated.y;
    const double z = interpolated.z;
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length == 0.0) {
        return geometric;
    }
    const double side = x * geometric.x + y * geometric.y + z * geometric.z;
    const double divisor = side < 0.0 ? -length : length;
    return {static_cast<float>(x / divisor), static_cast<float>(y / divisor), static_cast<float>(z / divisor)};
}

} // namespace vkbake
