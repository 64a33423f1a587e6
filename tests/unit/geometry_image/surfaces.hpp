// Hand-made surfaces with light-map UVs, for tests of the geometry image.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "vkbake/atlas.hpp"
#include "vkbake/surface.hpp"

namespace vkbake::test {

struct Corner {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 uv;
};
using Triangle = std::array<Corner, 3>;

struct MappedSurface {
    Surface surface;
    Atlas atlas;
};

inline std::array<float, 9> position_key(const Surface& surface, std::uint32_t triangle) {
    std::array<float, 9> key{};
    for (std::size_t i = 0; i < 9; ++i) {
        key[i] = surface.positions[3 * std::size_t{triangle} + i / 3][static_cast<int>(i % 3)];
    }
    return key;
}

/// One page of width × height texels that holds all triangles.
inline MappedSurface map_triangles(const std::vector<Triangle>& triangles, int width, int height) {
    MappedSurface made;
    for (const Triangle& triangle : triangles) {
        for (const Corner& corner : triangle) {
            made.surface.positions.push_back(corner.position);
            made.surface.normals.push_back(corner.normal);
            made.surface.vertices.push_back(static_cast<std::uint32_t>(made.surface.vertices.size()));
            made.atlas.uvs.push_back(corner.uv);
        }
        const glm::dvec3 a = triangle[0].position;
        const glm::dvec3 n = glm::cross(glm::dvec3(triangle[1].position) - a, glm::dvec3(triangle[2].position) - a);
        const double length = glm::length(n);
        made.surface.geometric_normals.push_back(length > 0.0 ? glm::vec3(n / length) : glm::vec3(0.0F));
    }
    const std::size_t count = triangles.size();
    made.surface.parts_of.assign(count, 0);
    made.surface.canonical_order.resize(count);
    std::iota(made.surface.canonical_order.begin(), made.surface.canonical_order.end(), 0U);
    std::ranges::sort(made.surface.canonical_order, {},
                      [&](std::uint32_t triangle) { return position_key(made.surface, triangle); });
    made.atlas.pages = {{.name = "page", .width = width, .height = height}};
    made.atlas.page.assign(count, 0);
    made.atlas.chart.assign(count, 0);
    return made;
}

class Generator {
public:
    explicit Generator(std::uint32_t seed) : m_engine(seed) {}

    float uniform(float low, float high) {
        // The engine's bits are the same everywhere; a distribution's are not.
        return low + (high - low) * static_cast<float>(m_engine() >> 8U) * 0x1p-24F;
    }
    glm::vec3 position() { return {uniform(-1.0F, 1.0F), uniform(-1.0F, 1.0F), uniform(-1.0F, 1.0F)}; }
    glm::vec3 normal() { return glm::normalize(position() + glm::vec3(0.001F)); }
    Triangle triangle(const std::array<glm::vec2, 3>& uvs) {
        return {Corner{position(), normal(), uvs[0]}, Corner{position(), normal(), uvs[1]},
                Corner{position(), normal(), uvs[2]}};
    }

    /// Corners anywhere within `reach` of a random point, clamped to the page.
    Triangle random(float reach) {
        const glm::vec2 centre(uniform(0.0F, 1.0F), uniform(0.0F, 1.0F));
        std::array<glm::vec2, 3> uvs{};
        for (glm::vec2& uv : uvs) {
            uv.x = std::clamp(centre.x + uniform(-reach, reach), 0.0F, 1.0F);
            uv.y = std::clamp(centre.y + uniform(-reach, reach), 0.0F, 1.0F);
        }
        return triangle(uvs);
    }

    /// Long and as thin as floats allow, every third without any area at all.
    Triangle needle() {
        const glm::vec2 a(uniform(0.0F, 1.0F), uniform(0.0F, 1.0F));
        const glm::vec2 b(uniform(0.0F, 1.0F), uniform(0.0F, 1.0F));
        const float width = m_engine() % 3U == 0 ? 0.0F : uniform(0.0F, 0.0001F);
        const glm::vec2 c = glm::clamp(a + uniform(0.0F, 1.0F) * (b - a) + width, 0.0F, 1.0F);
        return triangle({a, b, c});
    }

    /// Corners on a lattice of `cells` a side: edges through texels' corners, centres and along their borders.
    Triangle aligned(int cells) {
        std::array<glm::vec2, 3> uvs{};
        for (glm::vec2& uv : uvs) {
            for (int axis = 0; axis < 2; ++axis) {
                uv[axis] =
                    static_cast<float>(m_engine() % static_cast<std::uint32_t>(cells + 1)) / static_cast<float>(cells);
            }
        }
        return triangle(uvs);
    }

    std::uint32_t next() { return static_cast<std::uint32_t>(m_engine()); }

private:
    std::mt19937 m_engine;
};

enum class Kind : std::uint8_t { large, small, tiny, needles, aligned, mixed };

inline std::vector<Triangle> make_triangles(Kind kind, std::size_t count, std::uint32_t seed) {
    Generator generator(seed);
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < count; ++i) {
        switch (kind == Kind::mixed ? static_cast<Kind>(i % 5) : kind) {
        case Kind::large:
            triangles.push_back(generator.random(0.5F));
            break;
        case Kind::small:
            triangles.push_back(generator.random(0.05F));
            break;
        case Kind::tiny: // far smaller than a texel
            triangles.push_back(generator.random(0.0005F));
            break;
        case Kind::needles:
            triangles.push_back(generator.needle());
            break;
        default:
            triangles.push_back(generator.aligned(16));
            break;
        }
    }
    return triangles;
}

} // namespace vkbake::test
