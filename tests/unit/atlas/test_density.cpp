#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "amount.hpp"
#include "atlas/make_atlas.hpp"
#include "support.hpp"
#include "surface/make_surface.hpp"

namespace vkbake {
namespace {

using namespace test; // NOLINT(google-build-using-namespace): the helpers of these tests

glm::vec3 turned(const glm::vec3& p, float angle) {
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

/// A wall of quads of random widths and heights, turned.
void add_wall(Primitive& primitive, std::mt19937& random, const glm::vec3& at) {
    std::uniform_real_distribution<float> length(0.05F, 1.5F);
    const float angle = 6.0F * length(random);
    const int columns = 1 + static_cast<int>(random() % 4);
    const int rows = 1 + static_cast<int>(random() % 4);
    std::vector<float> heights{0.0F};
    for (int j = 0; j < rows; ++j) {
        heights.push_back(heights.back() + length(random));
    }
    float left = 0.0F;
    for (int i = 0; i < columns; ++i) {
        const float right = left + length(random);
        for (int j = 0; j + (i == 0 ? 0 : 1) < rows; ++j) { // one step at the top
            const auto corner = [&](float x, int row) {
                return at + turned({x, heights[static_cast<std::size_t>(row)], 0.0F}, angle);
            };
            add_quad(primitive, corner(left, j), corner(right, j), corner(right, j + 1), corner(left, j + 1));
        }
        left = right;
    }
}

/// Of flat sides, which are unrolled or stay apart.
void add_prism(Primitive& primitive, int sides, float radius, float height, const glm::vec3& at) {
    const auto corner = [&](int k, float y) {
        const float angle =
            2.0F * std::numbers::pi_v<float> * static_cast<float>(k % sides) / static_cast<float>(sides);
        return at + glm::vec3(radius * std::cos(angle), y, -radius * std::sin(angle));
    };
    for (int k = 0; k < sides; ++k) {
        add_quad(primitive, corner(k, 0.0F), corner(k + 1, 0.0F), corner(k + 1, height), corner(k, height));
    }
}

struct Box {
    glm::dvec2 low{std::numeric_limits<double>::infinity()};
    glm::dvec2 high{-std::numeric_limits<double>::infinity()};
};

// Walls, boxes, triangles and prisms can be laid out without any stretch, so that their sides have the texels asked for
// but for what a border's snapping to texel centres takes: half a texel a chart's extent.
TEST(Density, of_grown_flat_charts_is_what_was_asked) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> length(0.03F, 2.0F);
    Scene scene = empty_scene();
    Primitive& primitive = scene.meshes[0].primitives[0];
    for (int i = 0; i < amount(20, 4); ++i) {
        const glm::vec3 at(20.0F * static_cast<float>(i), 0.0F, 0.0F);
        add_wall(primitive, random, at);
        add_box(primitive, at + glm::vec3(0, 0, 5), at + glm::vec3(length(random), length(random), 5 + length(random)));
        add_prism(primitive, 3 + static_cast<int>(random() % 12), length(random), length(random),
                  at + glm::vec3(0, 0, 10));
        const glm::vec3 corner = at + glm::vec3(0, 0, 15);
        add_triangle(primitive, corner, corner + turned({length(random), 0, 0}, 3.0F * length(random)),
                     corner + glm::vec3(0, 0, length(random)));
    }
    const Surface surface = make_surface(scene);
    for (const double asked : {3.0, 17.3, 150.0}) {
        Settings settings = made_by(ChartMaker::grown, 0);
        settings.density = asked;
        const Atlas atlas = make_atlas(scene, surface, settings);
        const glm::dvec2 page(atlas.pages[0].width, atlas.pages[0].height);
        std::vector<Box> boxes(atlas.chart_count);
        for (std::size_t corner = 0; corner < atlas.uvs.size(); ++corner) {
            const glm::dvec2 texel = glm::dvec2(atlas.uvs[corner]) * page;
            Box& box = boxes[atlas.chart[corner / 3]];
            box.low = glm::min(box.low, texel);
            box.high = glm::max(box.high, texel);
        }
        for (std::size_t corner = 0; corner < atlas.uvs.size(); ++corner) {
            const std::size_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
            const double metres =
                glm::length(glm::dvec3(surface.positions[next]) - glm::dvec3(surface.positions[corner])) /
                surface.frame.scale();
            const double texels = glm::length((glm::dvec2(atlas.uvs[next]) - glm::dvec2(atlas.uvs[corner])) * page);
            const Box& box = boxes[atlas.chart[corner / 3]];
            const double extent = std::min(box.high.x - box.low.x, box.high.y - box.low.y);
            const double rounding = 1e-5 + page.x * 0x1p-22 / texels; // of floats, and of UVs to their grid
            ASSERT_NEAR(asked * metres / texels, 1.0, std::max(0.01, 0.5 / extent) + rounding)
                << "a side of " << metres << " m at " << asked << " texels a metre, its chart " << extent << " texels";
        }
    }
}

} // namespace
} // namespace vkbake
