// The rules of the geometry image against brute force that shares nothing with it: whole numbers for what is covered
// and who holds the centre, long doubles and polygon clipping for what is nearest, the unrounded UVs for positions.
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "geometry_image/reference.hpp"
#include "geometry_image/texel_triangles.hpp"
#include "unit/geometry_image/surfaces.hpp"

namespace vkbake {
namespace {

using test::Kind;
using test::MappedSurface;

struct Point {
    long double x = 0;
    long double y = 0;
};
using Polygon = std::vector<Point>;

/// Sutherland & Hodgman 1974: the part of the polygon where a·x + b·y ≤ c.
Polygon clip(const Polygon& polygon, long double a, long double b, long double c) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& p = polygon[i];
        const Point& q = polygon[(i + 1) % polygon.size()];
        const long double at_p = a * p.x + b * p.y - c;
        const long double at_q = a * q.x + b * q.y - c;
        if (at_p <= 0) {
            kept.push_back(p);
        }
        if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
            const long double t = at_p / (at_p - at_q);
            kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        }
    }
    return kept;
}

Polygon clip_to_square(Polygon polygon, long double h) {
    polygon = clip(polygon, 1, 0, h);
    polygon = clip(polygon, -1, 0, h);
    polygon = clip(polygon, 0, 1, h);
    return clip(polygon, 0, -1, h);
}

/// Of the polygon's border, the point nearest the origin.
Point nearest_on_border(const Polygon& polygon) {
    Point best = polygon.front();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& p = polygon[i];
        const Point d{polygon[(i + 1) % polygon.size()].x - p.x, polygon[(i + 1) % polygon.size()].y - p.y};
        const long double square = d.x * d.x + d.y * d.y;
        const long double t = square > 0 ? std::clamp<long double>(-(p.x * d.x + p.y * d.y) / square, 0, 1) : 0;
        const Point near{p.x + t * d.x, p.y + t * d.y};
        if (std::hypot(near.x, near.y) < std::hypot(best.x, best.y)) {
            best = near;
        }
    }
    return best;
}

using Wide = std::int64_t; // a product of two differences is at most 2^52

/// A triangle relative to a texel's centre, in units.
struct WholeTriangle {
    std::array<std::int64_t, 3> x{};
    std::array<std::int64_t, 3> y{};

    WholeTriangle(const shared::TexelTriangle& triangle, int units, int i, int j) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            x[corner] = triangle.x[corner] - (std::int64_t{i} * units + units / 2);
            y[corner] = triangle.y[corner] - (std::int64_t{j} * units + units / 2);
        }
    }

    [[nodiscard]] Wide area(std::size_t a, std::size_t b, std::int64_t px, std::int64_t py) const {
        return Wide{x[b] - x[a]} * (py - y[a]) - Wide{y[b] - y[a]} * (px - x[a]);
    }

    /// Separating axes: both shapes are convex, so they are apart only along a normal of a side of either.
    [[nodiscard]] bool meets_square(std::int64_t h) const {
        const auto [x_low, x_high] = std::ranges::minmax(x);
        const auto [y_low, y_high] = std::ranges::minmax(y);
        if (x_low > h || x_high < -h || y_low > h || y_high < -h) {
            return false;
        }
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3;
            const std::size_t c = (a + 2) % 3;
            std::array corners{area(a, b, -h, -h), area(a, b, h, -h), area(a, b, h, h), area(a, b, -h, h)};
            const auto [low, high] = std::ranges::minmax(corners);
            const Wide third = area(a, b, x[c], y[c]);
            if (low > std::max<Wide>(third, 0) || high < std::min<Wide>(third, 0)) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] bool holds_centre() const {
        const std::array sides{area(0, 1, 0, 0), area(1, 2, 0, 0), area(2, 0, 0, 0)};
        const auto [low, high] = std::ranges::minmax(sides);
        return area(0, 1, x[2], y[2]) != 0 && (low >= 0 || high <= 0);
    }

    [[nodiscard]] long double distance(long double h) const {
        Polygon polygon;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            polygon.push_back({static_cast<long double>(x[corner]), static_cast<long double>(y[corner])});
        }
        polygon = clip_to_square(polygon, h * (1 + 1e-15L)); // what touches a corner only is kept
        const Point near = nearest_on_border(polygon);
        return std::hypot(near.x, near.y);
    }
};

class Rules : public testing::TestWithParam<Kind> {
protected:
    void SetUp() override {
        m_mapped = test::map_triangles(test::make_triangles(GetParam(), 60, 23), m_width, m_height);
        m_image = reference_geometry_image(m_mapped.surface, m_mapped.atlas, 0);
        for (std::uint32_t t = 0; t < m_mapped.surface.triangle_count(); ++t) {
            m_triangles.push_back(make_texel_triangle(m_mapped.surface, m_mapped.atlas, m_grid, t));
        }
    }

    template<class Visit>
    void for_each_texel(Visit&& visit) const {
        for (int j = 0; j < m_height; ++j) {
            for (int i = 0; i < m_width; ++i) {
                visit(i, j,
                      m_image.triangle[static_cast<std::size_t>(j) * static_cast<std::size_t>(m_width) +
                                       static_cast<std::size_t>(i)]);
            }
        }
    }

    [[nodiscard]] WholeTriangle at(std::uint32_t triangle, int i, int j) const {
        return {m_triangles[triangle], m_grid.units, i, j};
    }

    static constexpr int m_width = 53;
    static constexpr int m_height = 40;
    MappedSurface m_mapped;
    GeometryImage m_image;
    TexelGrid m_grid{AtlasPage{.name = "page", .width = m_width, .height = m_height}};
    std::vector<shared::TexelTriangle> m_triangles;
};

TEST_P(Rules, EveryClosedSquareThatATriangleMeetsIsCoveredAndNoOther) {
    for_each_texel([&](int i, int j, std::uint32_t winner) {
        bool met = false;
        for (std::uint32_t t = 0; t < m_triangles.size() && !met; ++t) {
            met = at(t, i, j).meets_square(m_grid.units / 2);
        }
        EXPECT_EQ(winner != GeometryImage::empty, met) << i << ", " << j;
    });
}

TEST_P(Rules, WhoHoldsTheCentreWinsThenTheNearestThenTheCanonicalOrder) {
    const auto half = m_grid.units / 2;
    const auto h = static_cast<long double>(half);
    for_each_texel([&](int i, int j, std::uint32_t winner) {
        if (winner == GeometryImage::empty) {
            return;
        }
        std::optional<std::uint32_t> first_holder;
        long double least = 2 * h;
        for (const std::uint32_t t : m_mapped.surface.canonical_order) {
            const WholeTriangle triangle = at(t, i, j);
            if (!first_holder && triangle.holds_centre()) {
                first_holder = t;
            }
            if (triangle.meets_square(m_grid.units / 2)) {
                least = std::min(least, triangle.distance(h));
            }
        }
        if (first_holder) {
            EXPECT_EQ(winner, *first_holder) << i << ", " << j;
        } else { // distances are compared as floats: 24 bits of their squares
            EXPECT_LE(at(winner, i, j).distance(h), least * (1 + 0x1p-24L) + h * 0x1p-40L) << i << ", " << j;
        }
    });
}

struct TruePosition {
    std::array<long double, 3> position{};
    bool holds_centre = false;
    long double height = 0;   ///< of the triangle, units
    long double gradient = 0; ///< the most that a coordinate changes while u and v go through the page
};

/// The triangle in texels from a texel's centre: with the UVs as they are, or rounded to units.
Polygon around_texel(const MappedSurface& mapped, std::uint32_t t, int i, int j, bool in_units) {
    const TexelGrid grid(mapped.atlas.pages[0]);
    Polygon polygon;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::vec2& uv = mapped.atlas.uvs[3 * std::size_t{t} + corner];
        const long double x = in_units ? static_cast<long double>(grid.x(uv.x)) / grid.units
                                       : static_cast<long double>(uv.x) * grid.width;
        const long double y = in_units ? static_cast<long double>(grid.y(uv.y)) / grid.units
                                       : static_cast<long double>(uv.y) * grid.height;
        polygon.push_back({x - i - 0.5L, y - j - 0.5L});
    }
    return polygon;
}

/// Nothing where the triangle does not meet the texel (with one sort of UVs it may, with the other not).
std::optional<TruePosition> true_position(const MappedSurface& mapped, std::uint32_t t, const Polygon& polygon) {
    const TexelGrid grid(mapped.atlas.pages[0]);
    const auto cross = [](const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; };
    const Point& a = polygon[0];
    const Point e1{polygon[1].x - a.x, polygon[1].y - a.y};
    const Point e2{polygon[2].x - a.x, polygon[2].y - a.y};
    const long double area = cross(e1, e2);
    const std::array weights{cross(polygon[1], polygon[2]), cross(polygon[2], polygon[0]),
                             cross(polygon[0], polygon[1])};
    const auto [low, high] = std::ranges::minmax(weights);
    TruePosition truth;
    truth.holds_centre = low >= 0 || high <= 0;
    truth.height = std::abs(area) /
                   std::max({std::hypot(e1.x, e1.y), std::hypot(e2.x, e2.y), std::hypot(e1.x - e2.x, e1.y - e2.y)}) *
                   grid.units;
    Point sample{};
    if (!truth.holds_centre) {
        const Polygon inside = clip_to_square(polygon, 0.5L);
        if (inside.empty()) {
            return std::nullopt;
        }
        sample = nearest_on_border(inside);
    }
    const Point q{sample.x - a.x, sample.y - a.y};
    const long double b1 = cross(q, e2) / area;
    const long double b2 = cross(e1, q) / area;
    for (int axis = 0; axis < 3; ++axis) {
        const auto p = [&](std::size_t corner) -> long double {
            return mapped.surface.positions[3 * std::size_t{t} + corner][axis];
        };
        const long double along_u = ((p(1) - p(0)) * e2.y - (p(2) - p(0)) * e1.y) / area * grid.width;
        const long double along_v = ((p(2) - p(0)) * e1.x - (p(1) - p(0)) * e2.x) / area * grid.height;
        truth.position[static_cast<std::size_t>(axis)] = p(0) + b1 * (p(1) - p(0)) + b2 * (p(2) - p(0));
        truth.gradient = std::max(truth.gradient, std::abs(along_u) + std::abs(along_v));
    }
    return truth;
}

/// How many texels' positions were compared: those for which `is_told` says that their bits tell the position.
template<class IsTold>
std::size_t check_positions(const MappedSurface& mapped, bool in_units, IsTold&& is_told) {
    const GeometryImage image = reference_geometry_image(mapped.surface, mapped.atlas, 0);
    std::size_t checked = 0;
    for (std::size_t texel = 0; texel < image.texel_count(); ++texel) {
        const std::uint32_t triangle = image.triangle[texel];
        if (triangle == GeometryImage::empty) {
            continue;
        }
        const int i = static_cast<int>(texel) % image.width;
        const int j = static_cast<int>(texel) / image.width;
        const auto truth = true_position(mapped, triangle, around_texel(mapped, triangle, i, j, in_units));
        if (!truth || !is_told(*truth)) {
            continue;
        }
        ++checked;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(static_cast<double>(image.position[texel][axis]),
                        static_cast<double>(truth->position[static_cast<std::size_t>(axis)]), 4 * 0x1p-24)
                << "texel " << texel << " axis " << axis;
        }
    }
    return checked;
}

TEST(Positions, WithUvsInUnitsAreWithinFourRoundingsOfTheFrame) {
    for (const Kind kind : {Kind::large, Kind::small, Kind::tiny, Kind::needles, Kind::aligned}) {
        const auto mapped = test::map_triangles(test::make_triangles(kind, 200, 23), 153, 140);
        const auto is_told = [](const TruePosition& truth) { return truth.height >= 1; };
        EXPECT_GT(check_positions(mapped, true, is_told), 100U) << static_cast<int>(kind);
    }
}

/// Rounding the UVs moves a corner by half a unit at most: where the surface changes by up to 8 frames over the page
/// that is less than a rounding. (Only centres are compared: on a border that is nearly parallel to the square's, the
/// nearest point itself slides far.)
TEST(Positions, WithUvsAsTheyAreAreWithinFourRoundingsOfTheFrame) {
    for (const Kind kind : {Kind::large, Kind::small, Kind::needles, Kind::aligned}) {
        auto triangles = test::make_triangles(kind, 400, 29);
        for (test::Triangle& triangle : triangles) {
            for (test::Corner& corner : triangle) {
                const glm::vec2 uv = corner.uv;
                corner.position = {2.0F * uv.x - 1.0F, 1.5F * uv.y - 0.7F, 0.3F * uv.x + 0.4F * uv.y};
            }
        }
        const auto is_told = [](const TruePosition& truth) { return truth.holds_centre && truth.gradient <= 8; };
        EXPECT_GT(check_positions(test::map_triangles(triangles, 153, 140), false, is_told), 10U)
            << static_cast<int>(kind);
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, Rules,
                         testing::Values(Kind::large, Kind::small, Kind::tiny, Kind::needles, Kind::aligned));

} // namespace
} // namespace vkbake
