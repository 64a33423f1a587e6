#include "support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "atlas/predicates.hpp"
#include "base/random.hpp"

namespace vkbake::test {

namespace {

FlatTriangle triangle_of(const Atlas& atlas, std::size_t triangle) {
    return {atlas.uvs[3 * triangle], atlas.uvs[3 * triangle + 1], atlas.uvs[3 * triangle + 2]};
}

/// Closed triangle (of any area, none too) against the closed square [i, i+1] × [j, j+1], by separating axes in double.
bool meets_square(const std::array<glm::dvec2, 3>& t, int i, int j) {
    const std::array<glm::dvec2, 4> square{glm::dvec2(i, j), glm::dvec2(i + 1, j), glm::dvec2(i + 1, j + 1),
                                           glm::dvec2(i, j + 1)};
    const auto apart_along = [&](const glm::dvec2& axis) {
        double t_low = 1e300;
        double t_high = -1e300;
        double s_low = 1e300;
        double s_high = -1e300;
        for (const glm::dvec2& p : t) {
            t_low = std::min(t_low, p.x * axis.x + p.y * axis.y);
            t_high = std::max(t_high, p.x * axis.x + p.y * axis.y);
        }
        for (const glm::dvec2& p : square) {
            s_low = std::min(s_low, p.x * axis.x + p.y * axis.y);
            s_high = std::max(s_high, p.x * axis.x + p.y * axis.y);
        }
        return t_high < s_low || s_high < t_low;
    };
    if (apart_along({1.0, 0.0}) || apart_along({0.0, 1.0})) {
        return false;
    }
    for (unsigned e = 0; e < 3; ++e) {
        const glm::dvec2 along = t[(e + 1) % 3] - t[e];
        if (apart_along({-along.y, along.x})) {
            return false;
        }
    }
    return true;
}

/// Which chart covers each texel of a page; fails where two do.
std::vector<std::int64_t> rasterise(const Atlas& atlas, std::uint32_t page) {
    const int width = atlas.pages[page].width;
    const int height = atlas.pages[page].height;
    std::vector<std::int64_t> owner(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1);
    for (std::size_t triangle = 0; triangle < atlas.page.size(); ++triangle) {
        if (atlas.page[triangle] != page) {
            continue;
        }
        std::array<glm::dvec2, 3> t{};
        glm::dvec2 low(1e300);
        glm::dvec2 high(-1e300);
        for (std::size_t c = 0; c < 3; ++c) {
            t[c] = glm::dvec2(atlas.uvs[3 * triangle + c]) * glm::dvec2(width, height);
            low = {std::min(low.x, t[c].x), std::min(low.y, t[c].y)};
            high = {std::max(high.x, t[c].x), std::max(high.y, t[c].y)};
        }
        for (int j = std::max(0, static_cast<int>(low.y) - 1); j <= std::min(height - 1, static_cast<int>(high.y));
             ++j) {
            for (int i = std::max(0, static_cast<int>(low.x) - 1); i <= std::min(width - 1, static_cast<int>(high.x));
                 ++i) {
                if (!meets_square(t, i, j)) {
                    continue;
                }
                auto& texel =
                    owner[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)];
                if (texel >= 0 && texel != atlas.chart[triangle]) {
                    ADD_FAILURE() << "charts " << texel << " and " << atlas.chart[triangle] << " both touch texel " << i
                                  << ", " << j;
                    return owner;
                }
                texel = atlas.chart[triangle];
            }
        }
    }
    return owner;
}

} // namespace

Settings made_by(ChartMaker charts, int size) {
    Settings settings;
    settings.size = size;
    settings.uv = UvSource::make;
    settings.charts = charts;
    return settings;
}

Scene empty_scene() {
    Scene scene;
    scene.name = "test";
    scene.meshes.emplace_back();
    scene.meshes[0].name = "thing";
    scene.meshes[0].primitives.emplace_back();
    add_instance(scene, glm::dvec3(0.0));
    return scene;
}

void add_triangle(Primitive& primitive, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    for (const glm::vec3& corner : {a, b, c}) {
        primitive.indices.push_back(static_cast<std::uint32_t>(primitive.positions.size()));
        primitive.positions.push_back(corner);
    }
}

void add_quad(Primitive& primitive, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    add_triangle(primitive, a, b, c);
    add_triangle(primitive, a, c, d);
}

void add_box(Primitive& primitive, const glm::vec3& l, const glm::vec3& h) {
    add_quad(primitive, {h.x, l.y, h.z}, {h.x, l.y, l.z}, {h.x, h.y, l.z}, {h.x, h.y, h.z}); // +X
    add_quad(primitive, {l.x, l.y, l.z}, {l.x, l.y, h.z}, {l.x, h.y, h.z}, {l.x, h.y, l.z}); // −X
    add_quad(primitive, {l.x, h.y, h.z}, {h.x, h.y, h.z}, {h.x, h.y, l.z}, {l.x, h.y, l.z}); // +Y
    add_quad(primitive, {l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, l.y, h.z}, {l.x, l.y, h.z}); // −Y
    add_quad(primitive, {l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, h.y, h.z}, {l.x, h.y, h.z}); // +Z
    add_quad(primitive, {h.x, l.y, l.z}, {l.x, l.y, l.z}, {l.x, h.y, l.z}, {h.x, h.y, l.z}); // −Z
}

void set_light_map_uvs(Primitive& primitive, const std::vector<glm::vec2>& uvs) {
    ASSERT_EQ(uvs.size(), primitive.positions.size());
    primitive.tex_coords[1] = uvs;
}

void add_instance(Scene& scene, const glm::dvec3& translation) {
    Instance instance;
    instance.name = "node " + std::to_string(scene.instances.size());
    instance.translation = translation;
    scene.instances.push_back(instance);
}

void add_rough_ground(Primitive& primitive, int n, float height) {
    const auto corner = [&](int i, int j) {
        const std::uint64_t bits = mix64(static_cast<std::uint64_t>(i) * 1000 + static_cast<std::uint64_t>(j));
        return glm::vec3(static_cast<float>(i), height * static_cast<float>(bits % 1024) / 1024.0F,
                         static_cast<float>(j));
    };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            add_quad(primitive, corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j));
        }
    }
}

void shuffle_triangles(Primitive& primitive, std::uint32_t seed) {
    const std::size_t count = primitive.indices.size() / 3;
    for (std::size_t i = count; i > 1; --i) {
        const std::size_t j = mix64(seed * 1000003ULL + i) % i;
        for (std::size_t c = 0; c < 3 && j + 1 < i; ++c) {
            std::swap(primitive.indices[3 * (i - 1) + c], primitive.indices[3 * j + (c + 1) % 3]);
        }
        std::rotate(primitive.indices.begin() + static_cast<std::ptrdiff_t>(3 * j),
                    primitive.indices.begin() + static_cast<std::ptrdiff_t>(3 * j + 1),
                    primitive.indices.begin() + static_cast<std::ptrdiff_t>(3 * j + 3));
    }
}

double doubled_texel_area(const Atlas& atlas, std::size_t triangle) {
    const FlatTriangle t = triangle_of(atlas, triangle);
    const AtlasPage& page = atlas.pages[atlas.page[triangle]];
    const glm::dvec2 e = glm::dvec2(t[1]) - glm::dvec2(t[0]);
    const glm::dvec2 f = glm::dvec2(t[2]) - glm::dvec2(t[0]);
    return (e.x * f.y - e.y * f.x) * page.width * page.height;
}

double doubled_projected_area(const Surface& surface, std::size_t triangle) {
    const glm::dvec3 a(surface.positions[3 * triangle]);
    const glm::dvec3 e = glm::dvec3(surface.positions[3 * triangle + 1]) - a;
    const glm::dvec3 f = glm::dvec3(surface.positions[3 * triangle + 2]) - a;
    const double metres = 1.0 / surface.frame.scale();
    return std::max(
               {std::abs(e.y * f.z - e.z * f.y), std::abs(e.z * f.x - e.x * f.z), std::abs(e.x * f.y - e.y * f.x)}) *
           metres * metres;
}

void expect_sound(const Surface& surface, const Atlas& atlas) {
    const std::size_t count = surface.triangle_count();
    ASSERT_EQ(atlas.uvs.size(), 3 * count);
    ASSERT_EQ(atlas.page.size(), count);
    ASSERT_EQ(atlas.chart.size(), count);
    for (const glm::vec2& uv : atlas.uvs) {
        ASSERT_TRUE(uv.x >= 0.0F && uv.x <= 1.0F && uv.y >= 0.0F && uv.y <= 1.0F) << uv.x << ", " << uv.y;
    }
    std::vector<bool> chart_seen(atlas.chart_count, false);
    std::vector<bool> page_seen(atlas.pages.size(), false);
    for (std::size_t t = 0; t < count; ++t) {
        ASSERT_LT(atlas.chart[t], atlas.chart_count);
        ASSERT_LT(atlas.page[t], atlas.pages.size());
        chart_seen[atlas.chart[t]] = true;
        page_seen[atlas.page[t]] = true;
    }
    EXPECT_EQ(std::count(chart_seen.begin(), chart_seen.end(), false), 0);
    EXPECT_EQ(std::count(page_seen.begin(), page_seen.end(), false), 0);
    for (std::size_t a = 0; a < count; ++a) {
        for (std::size_t b = a + 1; b < count; ++b) {
            if (atlas.page[a] == atlas.page[b]) {
                ASSERT_FALSE(triangles_overlap(triangle_of(atlas, a), triangle_of(atlas, b)))
                    << "triangles " << a << " and " << b;
            }
        }
    }
}

void expect_gutter(const Atlas& atlas, int gutter) {
    for (std::uint32_t page = 0; page < atlas.pages.size(); ++page) {
        const int width = atlas.pages[page].width;
        const int height = atlas.pages[page].height;
        const auto owner = rasterise(atlas, page);
        const auto at = [&](int i, int j) {
            return owner[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)];
        };
        for (int j = 0; j < height; ++j) {
            for (int i = 0; i < width; ++i) {
                if (at(i, j) < 0) {
                    continue;
                }
                for (int y = j; y <= std::min(height - 1, j + gutter); ++y) {
                    for (int x = std::max(0, i - gutter); x <= std::min(width - 1, i + gutter); ++x) {
                        if (at(x, y) >= 0) {
                            ASSERT_EQ(at(x, y), at(i, j)) << "texels " << i << ", " << j << " and " << x << ", " << y;
                        }
                    }
                }
            }
        }
    }
}

void expect_one_density(const Surface& surface, const Atlas& atlas) {
    for (std::size_t t = 0; t < surface.triangle_count(); ++t) {
        const double expected = doubled_projected_area(surface, t) * atlas.density * atlas.density;
        // A corner moves by half a grid step, 2⁻²⁴ of the page, when it is rounded to the grid, and by as much at most
        // when its chart is laid out in single precision. To first order the doubled area changes by the move across
        // the opposite edge, which is at most the move's larger coordinate times that edge's length in the L1 norm.
        const double size = atlas.pages[atlas.page[t]].width;
        const double move = 2.0 * size * 0x1p-24;
        const FlatTriangle corners = triangle_of(atlas, t);
        double around = 0.0;
        for (unsigned c = 0; c < 3; ++c) {
            const glm::dvec2 edge = glm::dvec2(corners[(c + 1) % 3]) - glm::dvec2(corners[c]);
            around += (std::abs(edge.x) + std::abs(edge.y)) * size;
        }
        const double tolerance = move * (around + 8.0 * move);
        ASSERT_NEAR(-doubled_texel_area(atlas, t), expected, tolerance) << "triangle " << t;
    }
}

} // namespace vkbake::test
