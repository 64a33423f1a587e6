// Texels on a crease inside a chart: a roof of two faces that meet along a line aslant through the texels.
#include "finish/crease_texels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "finish/blend_creases.hpp"
#include "finish/covered_area.hpp"
#include "roof.hpp"

namespace {

using vkbake::CreaseTexel;

using vkbake::test::first_share;
using vkbake::test::roof;
using vkbake::test::under_sloping_sky;

constexpr int side = vkbake::test::roof_side;

struct Roof {
    vkbake::Surface surface;
    vkbake::Atlas atlas;
    vkbake::GeometryImage geometry;

    explicit Roof(const vkbake::Primitive& primitive = roof())
        : surface(vkbake::make_surface(vkbake::test::scene_of(primitive))) {
        atlas.pages = {{"map", side, side}};
        atlas.page.assign(surface.triangle_count(), 0);
        atlas.chart.assign(surface.triangle_count(), 0);
        for (const std::uint32_t vertex : surface.vertices) {
            atlas.uvs.emplace_back(primitive.positions[vertex].x, primitive.positions[vertex].z);
        }
        geometry = vkbake::reference_geometry_image(surface, atlas, 0);
    }

    [[nodiscard]] std::vector<CreaseTexel> creases() const {
        return vkbake::find_crease_texels(surface, atlas, geometry, 0);
    }
};

vkbake::Image lit(const Roof& roof) {
    vkbake::Image image{.width = side, .height = side, .texels = {}, .coverage = {}};
    for (std::size_t texel = 0; texel < roof.geometry.texel_count(); ++texel) {
        const double light = under_sloping_sky(glm::dvec3(roof.geometry.geometric_normal[texel]));
        image.texels.emplace_back(glm::vec3(static_cast<float>(light)), 1.0F);
    }
    return image;
}

TEST(CreaseTexels, HoldTheAreaWeightedMeanOfBothSidesUnderALinearSky) {
    const Roof roof;
    vkbake::Image image = lit(roof);
    const std::vector<CreaseTexel> creases = roof.creases();
    vkbake::blend_creases(creases, image);
    const double first = under_sloping_sky(vkbake::test::first_normal());
    const double second = under_sloping_sky(vkbake::test::second_normal());
    ASSERT_GT(std::abs(first - second), 0.3);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double share = first_share(x, y);
            // A share is off by less than a part for each of the two texels that it may be taken from, and by floats.
            const double tolerance = 2.0 / CreaseTexel::whole * std::abs(first - second) + 1e-6;
            ASSERT_NEAR(image.texels[image.index(x, y)].g, share * first + (1.0 - share) * second, tolerance)
                << x << ", " << y;
        }
    }
    EXPECT_EQ(creases.size(), std::size_t{side}); // the crease is in one column of each row
}

TEST(CreaseTexels, KeepTheBitsOfEvenLight) {
    vkbake::Image image{.width = side, .height = side, .texels = {}, .coverage = {}};
    image.texels.assign(std::size_t{side} * side, glm::vec4(0.1F, 1e30F, 3e-39F, 1.0F));
    const vkbake::Image before = image;
    vkbake::blend_creases(Roof().creases(), image);
    EXPECT_TRUE(vkbake::test::same_bits(image.texels, before.texels));
}

TEST(CreaseTexels, AreNoneWhereShadingIsSmooth) {
    vkbake::Primitive smooth = roof();
    smooth.normals.assign(smooth.positions.size(), glm::vec3(0, 1, 0));
    smooth.normals[2] = smooth.normals[5] = glm::normalize(glm::vec3(1, 1, 0)); // it turns within the second face
    EXPECT_TRUE(Roof(smooth).creases().empty());
}

TEST(CreaseTexels, AreNoneBetweenCharts) {
    Roof roof;
    for (std::uint32_t triangle = 0; triangle < roof.surface.triangle_count(); ++triangle) {
        roof.atlas.chart[triangle] = roof.surface.geometric_normals[triangle].x > 0.1F ? 1 : 0;
    }
    EXPECT_TRUE(roof.creases().empty());
}

TEST(CreaseTexels, DoNotDependOnTheOrderOfTriangles) {
    vkbake::Primitive turned = roof();
    std::ranges::reverse(turned.indices);
    for (std::size_t first = 0; first < turned.indices.size(); first += 3) {
        std::swap(turned.indices[first], turned.indices[first + 1]);
    }
    const std::vector<CreaseTexel> one = Roof().creases();
    const std::vector<CreaseTexel> other = Roof(turned).creases();
    EXPECT_TRUE(std::ranges::equal(one, other, [](const CreaseTexel& a, const CreaseTexel& b) {
        return a.texel == b.texel && a.shares == b.shares;
    }));
}

TEST(CreaseTexels, MixStandardErrorsAtMostAsTheyMixLight) {
    const Roof roof;
    const std::vector<CreaseTexel> creases = roof.creases();
    std::vector<float> errors(std::size_t{side} * side, 0.25F);
    vkbake::blend_creases(creases, side, errors);
    EXPECT_EQ(errors, std::vector<float>(errors.size(), 0.25F));
    errors[creases[3].texel] = 0.0F; // sure of itself, but not of what it takes from the other side
    vkbake::blend_creases(std::span(creases).subspan(3, 1), side, errors);
    const double others = 1.0 - static_cast<double>(creases[3].shares[4]) / CreaseTexel::whole;
    EXPECT_NEAR(errors[creases[3].texel], 0.25 * others, 1e-7);
}

TEST(CoveredArea, IsThatOfWhatIsInTheSquare) {
    EXPECT_EQ(vkbake::covered_area({glm::dvec2(0, 0), {1, 0}, {0, 1}}), 0.5);
    EXPECT_EQ(vkbake::covered_area({glm::dvec2(-4, -4), {9, -4}, {-4, 9}}), 1.0);      // all of it
    EXPECT_EQ(vkbake::covered_area({glm::dvec2(0.5, 0.5), {2, 0.5}, {0.5, 2}}), 0.25); // a quarter
    EXPECT_EQ(vkbake::covered_area({glm::dvec2(0.5, 2), {2, 0.5}, {0.5, 0.5}}), 0.25); // turned the other way
    EXPECT_EQ(vkbake::covered_area({glm::dvec2(2, 0), {3, 0}, {2, 1}}), 0.0);
    // Seven corners: the square without three corners, of legs ¼ and ¼, and twice ⅜ and ¾.
    EXPECT_NEAR(vkbake::covered_area({glm::dvec2(-0.25, 0.5), {0.5, -0.25}, {1.25, 1.25}}),
                1.0 - 0.5 * 0.25 * 0.25 - 0.375 * 0.75, 1e-12);
}

} // namespace
