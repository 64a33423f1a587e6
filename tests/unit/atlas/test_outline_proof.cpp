#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "amount.hpp"
#include "atlas/outline_proof.hpp"
#include "atlas/predicates.hpp"

namespace vkbake {
namespace {

using test::amount;

struct Layout {
    std::vector<glm::vec2> corners;

    void add(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) { corners.insert(corners.end(), {a, b, c}); }

    [[nodiscard]] bool proven() const {
        std::vector<std::uint32_t> triangles(corners.size() / 3);
        std::iota(triangles.begin(), triangles.end(), 0U);
        return outline_proves_no_overlap(corners, triangles);
    }

    /// Tries every pair.
    [[nodiscard]] bool overlaps() const {
        for (std::size_t a = 0; a < corners.size(); a += 3) {
            for (std::size_t b = 0; b < a; b += 3) {
                if (triangles_overlap({corners[a], corners[a + 1], corners[a + 2]},
                                      {corners[b], corners[b + 1], corners[b + 2]})) {
                    return true;
                }
            }
        }
        return false;
    }
};

/// A strip of quads of that many around the origin, `begin` to `begin` + `turns` turns, getting wider by `pitch` a
/// turn.
Layout spiral(int quads, double turns, double pitch) {
    Layout layout;
    const auto at = [&](int k, double radius) {
        const double turn = turns * k / quads;
        // A closed ring closes to the bit.
        const double angle = pitch == 0.0 && k == quads ? 0.0 : 2.0 * std::numbers::pi * turn;
        return glm::vec2(glm::dvec2(std::cos(angle), std::sin(angle)) * (radius + pitch * turn));
    };
    for (int k = 0; k < quads; ++k) {
        layout.add(at(k, 1.0), at(k, 2.0), at(k + 1, 2.0));
        layout.add(at(k, 1.0), at(k + 1, 2.0), at(k + 1, 1.0));
    }
    return layout;
}

TEST(OutlineProof, is_found_for_discs_rings_and_spirals) {
    EXPECT_TRUE(spiral(1, 0.1, 0.0).proven());
    EXPECT_TRUE(spiral(24, 0.9, 0.0).proven()); // open
    EXPECT_TRUE(spiral(24, 1.0, 0.0).proven()); // with a hole
    EXPECT_TRUE(spiral(96, 4.0, 1.5).proven());
    Layout mirrored = spiral(24, 1.0, 0.0);
    for (glm::vec2& corner : mirrored.corners) {
        corner.x = -corner.x;
    }
    EXPECT_TRUE(mirrored.proven()) << "which way all turn does not matter";
    mirrored.add({0.0F, 0.0F}, {0.5F, 0.0F}, {0.25F, 0.0F});
    EXPECT_TRUE(mirrored.proven()) << "without area";
}

TEST(OutlineProof, is_not_found_for_what_overlaps) {
    EXPECT_FALSE(spiral(96, 4.0, 0.75).proven());
    EXPECT_FALSE(spiral(24, 1.1, 0.0).proven());
    // A fan that goes twice around its middle, closed and not: its outline is no more than a pentagram's five corners.
    for (const int count : {9, 10}) {
        Layout fan;
        const auto at = [](int k) {
            const double angle = 0.3 + 0.4 * (k % 10) * 2.0 * std::numbers::pi / 2.0;
            const double radius = k % 10 < 5 ? 1.0 : 3.0;
            return glm::vec2(glm::dvec2(std::cos(angle), std::sin(angle)) * radius);
        };
        for (int k = 0; k < count; ++k) {
            fan.add({0.0F, 0.0F}, at(k), at(k + 1));
        }
        ASSERT_TRUE(fan.overlaps());
        EXPECT_FALSE(fan.proven());
    }
    // One within another, their outlines far apart.
    Layout nested;
    nested.add({0.0F, 0.0F}, {9.0F, 0.0F}, {0.0F, 9.0F});
    nested.add({1.0F, 1.0F}, {2.0F, 1.0F}, {1.0F, 2.0F});
    EXPECT_FALSE(nested.proven());
    // The same twice, and folded over.
    Layout twice = nested;
    twice.corners = {{0, 0}, {9, 0}, {0, 9}, {9, 0}, {0, 9}, {0, 0}};
    EXPECT_FALSE(twice.proven());
    Layout folded;
    folded.corners = {{0, 0}, {9, 0}, {0, 9}, {0, 9}, {9, 0}, {1, 1}};
    EXPECT_FALSE(folded.proven());
}

// Two squares, one above the other, that are slit from l to r and go over into each other there, along m and along n:
// the outline is one square well within the other, and only l and r, which the surface goes around twice, betray it.
TEST(OutlineProof, is_not_found_where_the_surface_goes_around_a_corner_twice) {
    const glm::vec2 l(-1.0F, 0.0F);
    const glm::vec2 r(1.0F, 0.0F);
    const glm::vec2 m(0.0F, 0.25F);
    const glm::vec2 n(0.0F, -0.25F);
    Layout layout;
    const auto add_half = [&](float side, const glm::vec2& middle) { // above the slit, or below where `side` < 0
        const glm::vec2 first = side > 0.0F ? l : r;
        const glm::vec2 last = side > 0.0F ? r : l;
        layout.add(last, {side, 0.0F}, {0.0F, side});
        layout.add(middle, last, {0.0F, side});
        layout.add(first, middle, {0.0F, side});
        layout.add({-side, 0.0F}, first, {0.0F, side});
    };
    add_half(3.0F, m);
    add_half(-3.0F, n);
    ASSERT_FALSE(layout.overlaps()); // one square, with a gap in its middle
    add_half(4.0F, n);
    add_half(-4.0F, m);
    ASSERT_TRUE(layout.overlaps());
    EXPECT_FALSE(layout.proven());
}

// Strips of random triangles on few coordinates, so that they touch, fold and cross in every way.
TEST(OutlineProof, is_never_found_for_what_overlaps) {
    std::mt19937 random(11);
    std::uniform_int_distribution<int> coordinate(0, 5);
    int proven = 0;
    int overlapping = 0;
    for (int i = 0; i < amount(60000, 3000); ++i) {
        Layout layout;
        const auto corner = [&] {
            return glm::vec2(static_cast<float>(coordinate(random)), static_cast<float>(coordinate(random)));
        };
        layout.add(corner(), corner(), corner());
        const int count = 2 + static_cast<int>(random() % 6);
        while (static_cast<int>(layout.corners.size()) < 3 * count) {
            const std::size_t hinge = random() % layout.corners.size();
            const std::size_t next = hinge % 3 == 2 ? hinge - 2 : hinge + 1;
            layout.add(layout.corners[next], layout.corners[hinge], corner());
        }
        overlapping += layout.overlaps() ? 1 : 0;
        if (layout.proven()) {
            ++proven;
            ASSERT_FALSE(layout.overlaps());
        }
    }
    EXPECT_GT(proven, amount(1000, 50));
    EXPECT_GT(overlapping, amount(1000, 50));
}

} // namespace
} // namespace vkbake
