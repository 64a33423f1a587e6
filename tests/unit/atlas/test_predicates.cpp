#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "atlas/predicates.hpp"
#include "atlas/triangle_tree.hpp"

namespace vkbake {
namespace {

/// Area of the intersection, by clipping in double (Sutherland–Hodgman).
double clipped_area(const FlatTriangle& first, FlatTriangle second) {
    if (orientation(second) < 0) {
        std::swap(second[1], second[2]);
    }
    std::vector<glm::dvec2> polygon(first.begin(), first.end());
    for (unsigned e = 0; e < 3; ++e) {
        const glm::dvec2 from(second[e]);
        const glm::dvec2 to(second[(e + 1) % 3]);
        const auto side = [&](const glm::dvec2& p) {
            return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
        };
        std::vector<glm::dvec2> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const glm::dvec2 p = polygon[i];
            const glm::dvec2 q = polygon[(i + 1) % polygon.size()];
            if (side(p) >= 0.0) {
                kept.push_back(p);
            }
            if ((side(p) > 0.0 && side(q) < 0.0) || (side(p) < 0.0 && side(q) > 0.0)) {
                kept.push_back(p + (q - p) * (side(p) / (side(p) - side(q))));
            }
        }
        polygon = kept;
    }
    double doubled = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i];
        const glm::dvec2 q = polygon[(i + 1) % polygon.size()];
        doubled += p.x * q.y - p.y * q.x;
    }
    return std::abs(doubled) / 2.0;
}

int sign(std::int64_t value) { return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0); }

// Numerators over 2^24: floats in [½, 1] hold them, and the determinant fits 64 bits.
TEST(Orientation, agrees_with_integers_where_points_are_nearly_on_a_line) {
    std::mt19937 random(1);
    std::uniform_int_distribution<std::int64_t> coordinate(1 << 23, 1 << 24);
    std::uniform_int_distribution<std::int64_t> nudge(-1, 1);
    int on_line = 0;
    for (int i = 0; i < 200000; ++i) {
        const std::int64_t ax = coordinate(random);
        const std::int64_t ay = coordinate(random);
        const std::int64_t bx = coordinate(random);
        const std::int64_t by = coordinate(random);
        const std::int64_t cx = (ax + bx) / 2 + nudge(random);
        const std::int64_t cy = (ay + by) / 2 + nudge(random);
        const int expected = sign((ax - cx) * (by - cy) - (ay - cy) * (bx - cx));
        const auto point = [](std::int64_t x, std::int64_t y) {
            return glm::vec2(static_cast<float>(x) * 0x1p-24F, static_cast<float>(y) * 0x1p-24F);
        };
        ASSERT_EQ(orientation(point(ax, ay), point(bx, by), point(cx, cy)), expected);
        on_line += expected == 0 ? 1 : 0;
    }
    EXPECT_GT(on_line, 0);
}

TEST(Orientation, is_exact_where_double_differences_round) {
    // (1, 1), (2⁻¹⁴⁹, 0), and points about the line: differences of 1 and 2⁻¹⁴⁹ are not exact in double.
    const float tiny = std::numeric_limits<float>::denorm_min();
    // On the line through (0, 0) and (1, 1) but for one denormal.
    EXPECT_EQ(orientation({0.0F, 0.0F}, {1.0F, 1.0F}, {tiny, tiny}), 0);
    EXPECT_EQ(orientation({0.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, tiny}), 1);
    EXPECT_EQ(orientation({0.0F, 0.0F}, {1.0F, 1.0F}, {tiny, 0.0F}), -1);
    // The origin moved by a denormal: every difference with 1 rounds.
    EXPECT_EQ(orientation({tiny, 0.0F}, {1.0F, 1.0F}, {0.5F, 0.5F}), 1);
    EXPECT_EQ(orientation({0.0F, tiny}, {1.0F, 1.0F}, {0.5F, 0.5F}), -1);
}

TEST(Orientation, turns_with_the_order_of_its_points) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> coordinate(-1.0F, 1.0F);
    for (int i = 0; i < 10000; ++i) {
        const glm::vec2 a(coordinate(random), coordinate(random));
        const glm::vec2 b(coordinate(random), coordinate(random));
        const glm::vec2 c = (a + b) * 0.5F;
        ASSERT_EQ(orientation(a, b, c), orientation(b, c, a));
        ASSERT_EQ(orientation(a, b, c), -orientation(b, a, c));
    }
}

// With coordinates up to 6 every intersection's corners have denominators below 100, so an area that is not 0 is
// far above 1e-11, and double rounding far below.
TEST(Overlap, agrees_with_clipping_on_small_integers) {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> coordinate(0, 6);
    int overlaps = 0;
    int touches = 0;
    const auto triangle = [&] {
        FlatTriangle t{};
        for (glm::vec2& corner : t) {
            corner = glm::vec2(static_cast<float>(coordinate(random)), static_cast<float>(coordinate(random)));
        }
        return t;
    };
    for (int i = 0; i < 200000; ++i) {
        const FlatTriangle a = triangle();
        const FlatTriangle b = triangle();
        const bool expected = orientation(a) != 0 && orientation(b) != 0 && clipped_area(a, b) > 1e-11;
        ASSERT_EQ(triangles_overlap(a, b), expected);
        ASSERT_EQ(triangles_overlap(b, a), expected);
        overlaps += expected ? 1 : 0;
        touches += expected ? 0 : 1;
    }
    EXPECT_GT(overlaps, 1000);
    EXPECT_GT(touches, 1000);
}

TEST(Overlap, is_none_at_shared_corners_and_edges) {
    const FlatTriangle a{glm::vec2(0.1F, 0.1F), glm::vec2(0.7F, 0.3F), glm::vec2(0.2F, 0.9F)};
    EXPECT_FALSE(triangles_overlap(a, {a[0], a[1], glm::vec2(0.9F, 0.0F)}));
    EXPECT_FALSE(triangles_overlap(a, {a[0], glm::vec2(0.0F, 0.0F), glm::vec2(0.1F, 0.0F)}));
    EXPECT_TRUE(triangles_overlap(a, a));
    EXPECT_TRUE(triangles_overlap(a, {a[0], a[2], a[1]})); // mirrored, on itself
    EXPECT_FALSE(triangles_overlap(a, {a[0], a[1], a[1]}));
}

TEST(Overlap, is_found_where_a_corner_is_one_step_across_an_edge) {
    std::mt19937 random(4);
    std::uniform_int_distribution<std::int64_t> coordinate(1 << 23, (1 << 24) - 1);
    int across = 0;
    for (int i = 0; i < 50000; ++i) {
        const std::int64_t ax = coordinate(random);
        const std::int64_t ay = coordinate(random);
        const std::int64_t bx = coordinate(random);
        const std::int64_t by = coordinate(random);
        const std::int64_t mx = (ax + bx) / 2;
        const std::int64_t my = (ay + by) / 2;
        const auto point = [](std::int64_t x, std::int64_t y) {
            return glm::vec2(static_cast<float>(x) * 0x1p-24F, static_cast<float>(y) * 0x1p-24F);
        };
        // One triangle on the left of a → b; a sliver from its right that touches the line near the middle.
        const glm::vec2 a = point(ax, ay);
        const glm::vec2 b = point(bx, by);
        const glm::vec2 left = a + 0.25F * glm::vec2(-(b - a).y, (b - a).x) + 0.5F * (b - a);
        const glm::vec2 right = a - 0.25F * glm::vec2(-(b - a).y, (b - a).x) + 0.5F * (b - a);
        const glm::vec2 right2 = a - 0.25F * glm::vec2(-(b - a).y, (b - a).x) + 0.25F * (b - a);
        const bool expected = (bx - ax) * (my - ay) - (by - ay) * (mx - ax) > 0;
        ASSERT_EQ(triangles_overlap({a, b, left}, {point(mx, my), right, right2}), expected);
        across += expected ? 1 : 0;
    }
    EXPECT_GT(across, 1000);
}

TEST(TriangleTree, finds_what_trying_every_pair_finds) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> coordinate(0.0F, 1.0F);
    constexpr std::uint32_t count = 600;
    std::vector<glm::vec2> corners;
    for (std::uint32_t t = 0; t < count; ++t) {
        // Many small ones, a few huge, some slivers, some without area.
        const float size = t % 50 == 0 ? 1.0F : 0.03F;
        const glm::vec2 at(coordinate(random), coordinate(random));
        const glm::vec2 e = size * glm::vec2(coordinate(random) - 0.5F, coordinate(random) - 0.5F);
        const glm::vec2 f = size * glm::vec2(coordinate(random) - 0.5F, coordinate(random) - 0.5F);
        corners.push_back(at);
        corners.push_back(at + e);
        corners.push_back(t % 7 == 0 ? at + 20.0F * e + 0.01F * f : t % 11 == 0 ? at : at + f);
    }
    std::vector<std::uint32_t> all(count);
    for (std::uint32_t t = 0; t < count; ++t) {
        all[t] = t;
    }
    TriangleTree tree(corners, all);
    std::size_t pairs = 0;
    for (std::uint32_t t = 0; t < count; ++t) {
        std::vector<std::uint32_t> expected;
        for (std::uint32_t u = 0; u < count; ++u) {
            if (u != t && triangles_overlap(tree.corners_of(t), tree.corners_of(u))) {
                expected.push_back(u);
            }
        }
        std::vector<std::uint32_t> found;
        tree.visit_overlaps(t, [&](std::uint32_t other) {
            found.push_back(other);
            return true;
        });
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found, expected) << t;
        pairs += found.size();
    }
    EXPECT_GT(pairs, count);

    // Groups: only what is marked counts, and a later mark replaces an earlier one.
    for (std::uint32_t group = 0; group < 3; ++group) {
        std::vector<bool> marked(count, false);
        for (std::uint32_t t = group; t < count; t += 5) {
            tree.mark(t, group);
            marked[t] = true;
        }
        for (std::uint32_t t = 0; t < count; ++t) {
            bool expected = false;
            for (std::uint32_t u = 0; u < count; ++u) {
                expected =
                    expected || (u != t && marked[u] && triangles_overlap(tree.corners_of(t), tree.corners_of(u)));
            }
            ASSERT_EQ(tree.overlaps_group(t, group), expected) << t;
        }
    }
}

} // namespace
} // namespace vkbake
