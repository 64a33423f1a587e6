#include "atlas/place_charts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "atlas/outline_proof.hpp"
#include "atlas/predicates.hpp"
#include "atlas/triangle_tree.hpp"

namespace vkbake {

namespace {

constexpr double grid = 0x1p23; ///< steps of UVs in [0,1]

FlatTriangle corners_of(std::span<const glm::vec2> corners, std::uint32_t triangle) {
    const auto own = corners.subspan(3 * std::size_t{triangle}, 3);
    return {own[0], own[1], own[2]};
}

void set_corners(std::span<glm::vec2> corners, std::uint32_t triangle, const FlatTriangle& to) {
    std::copy(to.begin(), to.end(), corners.begin() + 3 * static_cast<std::ptrdiff_t>(triangle));
}

glm::vec2 to_grid(const glm::dvec2& uv) {
    return {static_cast<float>(std::nearbyint(uv.x * grid) / grid),
            static_cast<float>(std::nearbyint(uv.y * grid) / grid)};
}

/// Twice the area. Only compared; ties are broken by canonical order.
double rough_area(const FlatTriangle& t) {
    const glm::dvec2 a(t[0]);
    const glm::dvec2 b(t[1]);
    const glm::dvec2 c(t[2]);
    return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// Puts the corner that is nearest to another one onto it: what is left lies within the triangle and has no area.
FlatTriangle folded(FlatTriangle triangle) {
    const auto length = [&](unsigned edge) {
        const glm::dvec2 along = glm::dvec2(triangle[edge]) - glm::dvec2(triangle[(edge + 1) % 3]);
        return along.x * along.x + along.y * along.y;
    };
    unsigned shortest = 0;
    for (unsigned edge = 1; edge < 3; ++edge) {
        shortest = length(edge) < length(shortest) ? edge : shortest;
    }
    triangle[shortest] = triangle[(shortest + 1) % 3];
    return triangle;
}

/// Corners moved by `steps` grid steps towards the middle; nothing where the result is not a triangle within the old
/// one.
std::optional<FlatTriangle> drawn_in(const FlatTriangle& triangle, double steps) {
    const int turn = orientation(triangle);
    const glm::dvec2 middle =
        (glm::dvec2(triangle[0]) + glm::dvec2(triangle[1]) + glm::dvec2(triangle[2])) * (1.0 / 3.0);
    FlatTriangle result{};
    for (unsigned c = 0; c < 3; ++c) {
        const glm::dvec2 way = middle - glm::dvec2(triangle[c]);
        const double length = std::max(std::abs(way.x), std::abs(way.y));
        if (length * grid <= steps) {
            return std::nullopt;
        }
        result[c] = to_grid(glm::dvec2(triangle[c]) + way * (steps / (grid * length)));
        for (unsigned edge = 0; edge < 3; ++edge) {
            if (turn * orientation(triangle[edge], triangle[(edge + 1) % 3], result[c]) < 0) {
                return std::nullopt;
            }
        }
    }
    return orientation(result) == turn ? std::optional(result) : std::nullopt;
}

/// `moved` drawn in, or folded, until it does not overlap `fixed`.
FlatTriangle taken_back(const FlatTriangle& moved, const FlatTriangle& fixed) {
    for (double steps = 1.0; steps <= 4096.0; steps *= 2.0) {
        const auto candidate = drawn_in(moved, steps);
        if (candidate && !triangles_overlap(*candidate, fixed)) {
            return *candidate;
        }
    }
    return folded(moved);
}

} // namespace

void place_chart(const Chart& chart, const ChartLayout& layout, const Placement& placement, const glm::ivec2& page,
                 std::span<const glm::vec2> flat, std::span<glm::vec2> uvs) {
    for (const std::uint32_t triangle : chart.triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t corner = 3 * std::size_t{triangle} + c;
            glm::dvec2 local = glm::dvec2(flat[corner]) * layout.scale + layout.offset;
            glm::ivec2 size(layout.size.width, layout.size.height);
            for (int turn = 0; turn < placement.turns; ++turn) { // quarter turns, not reflections
                local = {local.y, size.x - local.x};
                size = {size.y, size.x};
            }
            uvs[corner] = to_grid((glm::dvec2(placement.x, placement.y) + local) / glm::dvec2(page));
        }
    }
}

void repair_rounding(const Chart& chart, std::span<const glm::vec2> flat, std::span<glm::vec2> uvs) {
    int flat_turn = 0;
    for (const std::uint32_t triangle : chart.triangles) {
        const FlatTriangle placed = corners_of(uvs, triangle);
        flat_turn = orientation(corners_of(flat, triangle));
        if (orientation(placed) != flat_turn) {
            set_corners(uvs, triangle, folded(placed));
        }
    }
    if (outline_proves_no_overlap(uvs, chart.triangles)) {
        return;
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs; // places in chart.triangles
    {
        std::vector<glm::vec2> local;
        local.reserve(3 * chart.triangles.size());
        std::vector<std::uint32_t> places;
        for (const std::uint32_t triangle : chart.triangles) {
            const FlatTriangle placed = corners_of(uvs, triangle);
            local.insert(local.end(), placed.begin(), placed.end());
            places.push_back(static_cast<std::uint32_t>(places.size()));
        }
        const TriangleTree tree(local, places);
        for (const std::uint32_t place : places) {
            tree.visit_overlaps(place, [&](std::uint32_t other) {
                if (place < other) {
                    pairs.emplace_back(place, other);
                }
                return true;
            });
        }
    }
    // A triangle that is drawn in lies within its old place, so no new overlap can arise. The order is by geometry.
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [first_place, second_place] : pairs) {
        const std::uint32_t first = chart.triangles[first_place];
        const std::uint32_t second = chart.triangles[second_place];
        const FlatTriangle a = corners_of(uvs, first);
        const FlatTriangle b = corners_of(uvs, second);
        if (!triangles_overlap(a, b)) {
            continue;
        }
        if (rough_area(a) < rough_area(b)) {
            set_corners(uvs, first, taken_back(a, b));
        } else {
            set_corners(uvs, second, taken_back(b, a));
        }
    }
}

} // namespace vkbake
