#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "atlas/pack.hpp"

namespace vkbake {
namespace {

std::vector<ChartShape> shapes_of(const std::vector<TexelSize>& sizes) {
    std::vector<ChartShape> shapes(sizes.size());
    std::transform(sizes.begin(), sizes.end(), shapes.begin(), rectangle);
    return shapes;
}

std::optional<std::vector<Placement>> pack(const std::vector<TexelSize>& sizes, const PageSettings& settings) {
    return vkbake::pack(shapes_of(sizes), settings);
}

/// Counts each page's texels one by one.
void expect_apart(const std::vector<TexelSize>& rectangles, const std::vector<Placement>& placements,
                  const PageSettings& settings) {
    ASSERT_EQ(placements.size(), rectangles.size());
    const auto side = static_cast<std::size_t>(settings.width);
    std::vector<std::vector<int>> pages;
    for (std::size_t r = 0; r < rectangles.size(); ++r) {
        const Placement& place = placements[r];
        const int width = place.turns % 2 == 1 ? rectangles[r].height : rectangles[r].width;
        const int height = place.turns % 2 == 1 ? rectangles[r].width : rectangles[r].height;
        ASSERT_GE(place.x, 0);
        ASSERT_GE(place.y, 0);
        ASSERT_LE(place.x + width, settings.width);
        ASSERT_LE(place.y + height, settings.width);
        ASSERT_LT(place.page, static_cast<std::uint32_t>(settings.max_pages));
        if (place.page >= pages.size()) {
            pages.resize(place.page + 1, std::vector<int>(side * side, -1));
        }
        // The rectangle and its gutter may hold nothing that came before; what comes later tests the same of itself.
        for (int y = std::max(0, place.y - settings.gutter);
             y < std::min(settings.width, place.y + height + settings.gutter); ++y) {
            for (int x = std::max(0, place.x - settings.gutter);
                 x < std::min(settings.width, place.x + width + settings.gutter); ++x) {
                int& owner = pages[place.page][static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)];
                ASSERT_EQ(owner, -1) << "rectangles " << owner << " and " << r;
            }
        }
        for (int y = place.y; y < place.y + height; ++y) {
            for (int x = place.x; x < place.x + width; ++x) {
                pages[place.page][static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)] =
                    static_cast<int>(r);
            }
        }
    }
}

TEST(Pack, keeps_rectangles_apart) {
    std::mt19937 random(7);
    for (const int gutter : {0, 1, 3}) {
        for (const int longest : {1, 4, 30, 90}) {
            std::uniform_int_distribution<int> length(1, longest);
            std::vector<TexelSize> rectangles(400);
            for (TexelSize& rectangle : rectangles) {
                rectangle = {length(random), length(random)};
            }
            const PageSettings settings{100, 100, gutter, 400};
            const auto placements = pack(rectangles, settings);
            ASSERT_TRUE(placements);
            expect_apart(rectangles, *placements, settings);
        }
    }
}

TEST(Pack, fills_a_page_that_equal_rectangles_fill_exactly) {
    for (const int gutter : {0, 2}) {
        const int side = 10 * (8 + gutter) - gutter;
        const PageSettings settings{side, side, gutter, 1};
        EXPECT_TRUE(pack(std::vector<TexelSize>(100, {8, 8}), settings));
        EXPECT_FALSE(pack(std::vector<TexelSize>(101, {8, 8}), settings));
        // Standing and lying ones are the same.
        std::vector<TexelSize> mixed(64, {5, 20});
        std::fill(mixed.begin() + 32, mixed.end(), TexelSize{20, 5});
        const int mixed_side = 4 * 20 + 3 * gutter + (gutter > 0 ? 24 : 0);
        EXPECT_TRUE(pack(mixed, {mixed_side, mixed_side, gutter, 1}));
    }
}

// Two L-shaped pieces of three quarters of a square fill a rectangle of 3 : 2 with two squares left for small ones.
TEST(Pack, fills_the_holes_between_outlines) {
    ChartShape corner{.width = 40, .height = 40};
    for (int y = 0; y < 40; ++y) {
        corner.first.push_back(static_cast<std::uint32_t>(y));
        corner.runs.push_back({0, y < 20 ? 20 : 40});
    }
    corner.first.push_back(40);
    EXPECT_EQ(corner.texel_count(), 1200.0);
    const std::vector<ChartShape> pieces{corner, rectangle({20, 20})};
    const auto placements = vkbake::pack(pieces, {40, 40, 0, 1});
    ASSERT_TRUE(placements);
    EXPECT_EQ((*placements)[1].x, 20);
    EXPECT_EQ((*placements)[1].y, 0);
    EXPECT_FALSE(vkbake::pack(pieces, {40, 40, 1, 1}));
}

TEST(Pack, turns_what_stands_too_high) {
    const std::vector<TexelSize> rectangles{{3, 10}, {10, 3}, {3, 10}, {1, 10}};
    const PageSettings settings{10, 10, 0, 1};
    const auto placements = pack(rectangles, settings);
    ASSERT_TRUE(placements);
    expect_apart(rectangles, *placements, settings);
}

TEST(Pack, refuses_what_no_page_holds) {
    EXPECT_FALSE(pack(std::vector<TexelSize>{{11, 1}}, {10, 10, 0, 5}));
    EXPECT_TRUE(pack(std::vector<TexelSize>{{10, 10}, {10, 10}}, {10, 10, 64, 2}));
    EXPECT_FALSE(pack(std::vector<TexelSize>{{10, 10}, {10, 10}}, {10, 10, 64, 1}));
    EXPECT_TRUE(pack(std::vector<TexelSize>{}, {10, 10, 0, 1}));
}

// Best fit leaves a few per cent of a page empty with this many rectangles; 85 % is far from what a broken packer
// reaches.
TEST(Pack, wastes_little) {
    std::mt19937 random(8);
    std::uniform_int_distribution<int> length(2, 40);
    std::vector<TexelSize> rectangles;
    double area = 0.0;
    while (area < 0.85 * 512.0 * 512.0) {
        rectangles.push_back({length(random), length(random)});
        area += static_cast<double>(rectangles.back().width) * rectangles.back().height;
    }
    EXPECT_TRUE(pack(rectangles, {512, 512, 0, 1}));
}

} // namespace
} // namespace vkbake
