// A whole bake against an integrator that shares nothing with it: positions from TEXCOORD_1 at texel centres, uniform
// directions, Möller–Trumbore over all triangles, everything in double. Compared by statistics: the mean of each block
// of 8 × 8 texels must lie within 4 standard errors.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "vkbake/vkbake.hpp"

namespace vkbake {
namespace {

constexpr int size = 64;
constexpr int block = 8;
constexpr int reference_rays = 512;

/// Bright red towards +X, green upwards, blue towards +Z: no symmetry that a turned or mirrored map could hide behind.
/// 128 × 64 texels, smooth enough that bilinear and nearest look-ups differ by less than the noise.
Sky coloured_sky() {
    Image image{.width = 128, .height = 64};
    image.texels.resize(128 * 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 128; ++x) {
            const double phi = ((x + 0.5) / 128.0 - 0.5) * 2.0 * std::numbers::pi;
            const double theta = (y + 0.5) / 64.0 * std::numbers::pi;
            const glm::dvec3 direction(std::sin(theta) * std::cos(phi), std::cos(theta),
                                       std::sin(theta) * std::sin(phi));
            image.texels[image.index(x, y)] = glm::vec4(glm::vec3(1.5 * (direction + 1.0)), 1.0F);
        }
    }
    return {.source = EquirectangularSky{image}, .name = "coloured"};
}

glm::dvec3 radiance(const glm::dvec3& direction) { return 1.5 * (direction + 1.0); }

/// A floor of 4 m × 4 m and, off its middle, a wall 1.5 m high: its front and back are mapped too.
Scene floor_and_wall() {
    Primitive primitive;
    const auto quad = [&](const std::array<glm::vec3, 4>& corners, glm::vec2 low, glm::vec2 high) {
        const auto first = static_cast<std::uint32_t>(primitive.positions.size());
        primitive.positions.insert(primitive.positions.end(), corners.begin(), corners.end());
        auto& uvs = primitive.tex_coords[1];
        uvs.insert(uvs.end(), {{low.x, low.y}, {high.x, low.y}, {high.x, high.y}, {low.x, high.y}});
        for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) {
            primitive.indices.push_back(first + corner);
        }
    };
    // Borders between texel centres, so that no centre lies on one.
    quad({{{-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2}}}, {1 / 64.0F, 1 / 64.0F}, {47 / 64.0F, 47 / 64.0F});
    quad({{{0.5F, 0, 1}, {0.5F, 0, -1.5F}, {0.5F, 1.5F, -1.5F}, {0.5F, 1.5F, 1}}}, {50 / 64.0F, 1 / 64.0F},
         {63 / 64.0F, 30 / 64.0F});
    quad({{{0.4F, 0, -1.5F}, {0.4F, 0, 1}, {0.4F, 1.5F, 1}, {0.4F, 1.5F, -1.5F}}}, {2 / 64.0F, 50 / 64.0F},
         {40 / 64.0F, 63 / 64.0F});
    Scene scene;
    scene.name = "floor and wall";
    scene.meshes.push_back({"mesh", {primitive}, 0});
    Instance instance;
    instance.name = "mesh";
    scene.instances.push_back(instance);
    return scene;
}

struct Triangle {
    std::array<glm::dvec3, 3> corners;
    std::array<glm::dvec2, 3> uvs;
};

std::vector<Triangle> triangles_of(const Primitive& primitive) {
    std::vector<Triangle> triangles(primitive.indices.size() / 3);
    for (std::size_t corner = 0; corner < primitive.indices.size(); ++corner) {
        const std::uint32_t vertex = primitive.indices[corner];
        triangles[corner / 3].corners[corner % 3] = glm::dvec3(primitive.positions[vertex]);
        triangles[corner / 3].uvs[corner % 3] = glm::dvec2(primitive.tex_coords[1][vertex]);
    }
    return triangles;
}

double cross2(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

struct Point {
    glm::dvec3 position;
    glm::dvec3 normal;
    std::size_t triangle = 0;
};

std::optional<Point> point_at(const std::vector<Triangle>& triangles, const glm::dvec2& uv) {
    for (std::size_t index = 0; index < triangles.size(); ++index) {
        const auto& [corners, uvs] = triangles[index];
        const double area = cross2(uvs[1] - uvs[0], uvs[2] - uvs[0]);
        const double b1 = cross2(uv - uvs[0], uvs[2] - uvs[0]) / area;
        const double b2 = cross2(uvs[1] - uvs[0], uv - uvs[0]) / area;
        if (b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0) {
            const glm::dvec3 edge1 = corners[1] - corners[0];
            const glm::dvec3 edge2 = corners[2] - corners[0];
            return Point{corners[0] + b1 * edge1 + b2 * edge2, glm::normalize(glm::cross(edge1, edge2)), index};
        }
    }
    return std::nullopt;
}

bool occluded(const std::vector<Triangle>& triangles, const Point& point, const glm::dvec3& direction) {
    for (std::size_t index = 0; index < triangles.size(); ++index) {
        const auto& corners = triangles[index].corners;
        const glm::dvec3 edge1 = corners[1] - corners[0];
        const glm::dvec3 edge2 = corners[2] - corners[0];
        const glm::dvec3 p = glm::cross(direction, edge2);
        const double determinant = glm::dot(edge1, p);
        if (index == point.triangle || determinant == 0.0) {
            continue;
        }
        const glm::dvec3 t = point.position - corners[0];
        const double u = glm::dot(t, p) / determinant;
        const glm::dvec3 q = glm::cross(t, edge1);
        const double v = glm::dot(direction, q) / determinant;
        if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && glm::dot(edge2, q) / determinant > 1e-9) {
            return true;
        }
    }
    return false;
}

struct Estimate {
    glm::dvec3 mean{0.0};
    glm::dvec3 variance{0.0}; ///< of the mean
};

/// E/π = 2 · mean of L cos θ over uniform directions.
Estimate estimate(const std::vector<Triangle>& triangles, const Point& point, std::mt19937& generator) {
    std::normal_distribution<double> normal;
    glm::dvec3 sum(0.0);
    glm::dvec3 squares(0.0);
    for (int ray = 0; ray < reference_rays; ++ray) {
        glm::dvec3 direction = glm::normalize(glm::dvec3(normal(generator), normal(generator), normal(generator)));
        double cosine = glm::dot(direction, point.normal);
        direction = cosine < 0.0 ? -direction : direction;
        cosine = std::abs(cosine);
        const glm::dvec3 value =
            occluded(triangles, point, direction) ? glm::dvec3(0.0) : 2.0 * cosine * radiance(direction);
        sum += value;
        squares += value * value;
    }
    const double count = reference_rays;
    const glm::dvec3 mean = sum / count;
    return {mean, (squares / count - mean * mean) / (count - 1.0)};
}

std::size_t texel_at(int x, int y) { return static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x); }

/// An estimate for each texel whose centre lies in a triangle.
std::vector<std::optional<Estimate>> reference_map(const Scene& scene) {
    const std::vector<Triangle> triangles = triangles_of(scene.meshes[0].primitives[0]);
    std::mt19937 generator(20260101);
    std::vector<std::optional<Estimate>> map(size * size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            if (const auto point = point_at(triangles, {(x + 0.5) / size, (y + 0.5) / size})) {
                map[texel_at(x, y)] = estimate(triangles, *point, generator);
            }
        }
    }
    return map;
}

/// How many blocks differ by more than 4 standard errors, or lack a texel that the reference has. The bake's own
/// variance is no larger than the reference's: it has as many rays, better spread.
int wrong_blocks(const std::vector<std::optional<Estimate>>& reference, const Image& image) {
    int wrong = 0;
    for (int top = 0; top < size; top += block) {
        for (int left = 0; left < size; left += block) {
            glm::dvec3 difference(0.0);
            glm::dvec3 variance(0.0);
            bool missing = false;
            for (int y = top; y < top + block; ++y) {
                for (int x = left; x < left + block; ++x) {
                    if (const auto& expected = reference[texel_at(x, y)]) {
                        missing = missing || image.coverage[image.index(x, y)] < 0.5F;
                        difference += glm::dvec3(image.texels[image.index(x, y)]) - expected->mean;
                        variance += 2.0 * expected->variance;
                    }
                }
            }
            bool outside = missing;
            for (int channel = 0; channel < 3; ++channel) {
                outside = outside || std::abs(difference[channel]) > 4.0 * std::sqrt(variance[channel]);
            }
            wrong += outside ? 1 : 0;
        }
    }
    return wrong;
}

template<typename From>
Image rearranged(const Image& image, From from) {
    Image result = image;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const auto [source_x, source_y] = from(x, y);
            result.texels[result.index(x, y)] = image.texels[image.index(source_x, source_y)];
            result.coverage[result.index(x, y)] = image.coverage[image.index(source_x, source_y)];
        }
    }
    return result;
}

TEST(BlockStatistics, ABakeAgreesWithAnIndependentIntegrator) {
    const Scene scene = floor_and_wall();
    Settings settings;
    settings.size = size;
    settings.rays = reference_rays;
    settings.layout = Layout::object;
    settings.uv = UvSource::keep;
    settings.padding = 0;
    const Bake result = bake(scene, coloured_sky(), settings, open_device());
    ASSERT_EQ(result.light_maps.size(), 1U);
    const Image& image = result.light_maps[0].image;
    const auto reference = reference_map(scene);
    EXPECT_EQ(wrong_blocks(reference, image), 0);

    // The test can fail: it sees a map that is turned over, mirrored or moved by one texel.
    using Place = std::pair<int, int>;
    EXPECT_GT(wrong_blocks(reference, rearranged(image, [](int x, int y) { return Place(x, size - 1 - y); })), 8);
    EXPECT_GT(wrong_blocks(reference, rearranged(image, [](int x, int y) { return Place(size - 1 - x, y); })), 8);
    EXPECT_GT(wrong_blocks(reference, rearranged(image, [](int x, int y) { return Place(std::max(x - 1, 0), y); })), 2);
    EXPECT_GT(wrong_blocks(reference, rearranged(image, [](int x, int y) { return Place(x, std::max(y - 1, 0)); })), 2);
    // With the charts' places kept, too: only the values inside the floor's chart move.
    const auto inside = [](int x, int y) { return x >= 2 && x < 46 && y >= 2 && y < 46; };
    EXPECT_GT(
        wrong_blocks(reference,
                     rearranged(image, [&](int x, int y) { return inside(x, y) ? Place(x - 1, y) : Place(x, y); })),
        2);
}

} // namespace
} // namespace vkbake
