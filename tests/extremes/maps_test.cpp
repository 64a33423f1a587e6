// Light-map UVs and normals at their limits.
#include <limits>

#include <gtest/gtest.h>

#include "host_bake.hpp"

namespace vkbake::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Settings keeping(int size) {
    Settings settings = small_settings(size);
    settings.uv = UvSource::keep;
    return settings;
}

/// One triangle in the plane y = 0, facing up.
Primitive triangle_with(const std::array<glm::vec2, 3>& uvs) {
    Primitive primitive;
    for (const glm::vec3& corner : {glm::vec3(0, 0, 0), glm::vec3(0, 0, 1), glm::vec3(1, 0, 0)}) {
        primitive.indices.push_back(add_vertex(primitive, corner));
    }
    primitive.tex_coords[1].assign(uvs.begin(), uvs.end());
    return primitive;
}

struct UvCase {
    const char* name;
    std::array<glm::vec2, 3> uvs;
    std::uint64_t least; ///< covered texels of a map of 16²
    std::uint64_t most;
};

TEST(Maps, UvsAtTheirLimitsGiveLightWhereverATexelIsMet) {
    const float tiny = 0x1p-23F;
    const std::vector<UvCase> cases{
        {"corners of the page", {{{0, 0}, {0, 1}, {1, 0}}}, 136, 256}, // 16 · 17 / 2 closed squares at least
        {"clockwise", {{{0, 0}, {1, 0}, {0, 1}}}, 136, 256},
        {"at the far corner", {{{1, 1}, {1, 0.9F}, {0.9F, 1}}}, 2, 4},
        {"thinner than a texel", {{{0.1F, 0.53F}, {0.9F, 0.53F}, {0.5F, 0.531F}}}, 13, 28},
        {"smaller than a texel by 10^6", {{{0.52F, 0.52F}, {0.52F + tiny, 0.52F}, {0.52F, 0.52F + tiny}}}, 1, 1},
        {"where four texels meet", {{{0.5F, 0.5F}, {0.5F, 0.5F + tiny}, {0.5F + tiny, 0.5F}}}, 1, 4}};
    for (const UvCase& tried : cases) {
        SCOPED_TRACE(tried.name);
        const HostBake bake = bake_on_host(scene_of(triangle_with(tried.uvs)), {}, keeping(16));
        const LightMap& map = bake.maps.at(0);
        EXPECT_GE(map.statistics.covered_texels, tried.least);
        EXPECT_LE(map.statistics.covered_texels, tried.most);
        for (std::size_t texel = 0; texel < map.image.texels.size(); ++texel) {
            if (map.image.coverage[texel] > 0.5F) {
                ASSERT_EQ(map.image.texels[texel].x, 1.0F); // nothing hides it
            }
        }
    }
}

TEST(Maps, UvsThatWillNotDoAreRefusedOrMadeAnew) {
    const float over = std::nextafter(1.0F, 2.0F);
    const std::vector<UvCase> cases{{"just outside", {{{0, 0}, {0, over}, {1, 0}}}, 0, 0},
                                    {"below", {{{-1e-30F, 0}, {0, 1}, {1, 0}}}, 0, 0},
                                    {"far away", {{{1e38F, 0}, {0, 1}, {1, 0}}}, 0, 0},
                                    {"nan", {{{0, 0}, {0, nan}, {1, 0}}}, 0, 0},
                                    {"no area", {{{0, 0}, {0.5F, 0.5F}, {1, 1}}}, 0, 0},
                                    {"a point", {{{0.5F, 0.5F}, {0.5F, 0.5F}, {0.5F, 0.5F}}}, 0, 0}};
    for (const UvCase& tried : cases) {
        SCOPED_TRACE(tried.name);
        Settings settings = keeping(8);
        EXPECT_THROW((void)bake_on_host(scene_of(triangle_with(tried.uvs)), {}, settings), Error);
        settings.uv = UvSource::automatic;
        const HostBake bake = bake_on_host(scene_of(triangle_with(tried.uvs)), {}, settings);
        EXPECT_GT(bake.maps.at(0).statistics.covered_texels, 8U);
        EXPECT_FALSE(bake.atlas.notes.empty());
    }
}

/// Beside one that has both: a triangle with surface and no UV area, and one with UV area and no surface.
TEST(Maps, AreaInOneSpaceAloneDisturbsNobody) {
    Primitive all = triangle_with({{{0, 0}, {0, 0.4F}, {0.4F, 0}}});
    const HostBake alone = bake_on_host(scene_of(all), {}, keeping(16));
    const auto add = [&](const std::array<glm::vec3, 3>& corners, const std::array<glm::vec2, 3>& uvs) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            all.indices.push_back(add_vertex(all, corners[corner]));
            all.tex_coords[1].push_back(uvs[corner]);
        }
    };
    add({{{0, 0, -2}, {0, 0, -1.5F}, {0.5F, 0, -2}}}, {{{0.9F, 0.1F}, {0.9F, 0.3F}, {0.9F, 0.2F}}});
    add({{{0, 0, 0}, {0, 0, 0.5F}, {0, 0, 1}}}, {{{0.9F, 0.9F}, {0.6F, 0.9F}, {0.9F, 0.6F}}});
    const HostBake bake = bake_on_host(scene_of(all), {}, keeping(16));
    std::uint64_t more = 0;
    for (std::size_t texel = 0; texel < bake.maps[0].image.texels.size(); ++texel) {
        const glm::vec4 light = bake.maps[0].image.texels[texel];
        if (alone.maps[0].image.coverage[texel] > 0.5F) {
            ASSERT_EQ(light, glm::vec4(1.0F));
        } else if (bake.maps[0].image.coverage[texel] > 0.5F) {
            ++more;
            ASSERT_EQ(light, glm::vec4(1.0F));
        }
    }
    EXPECT_GE(more, 4U); // a line of 0.2 of 16 texels
    EXPECT_LE(more, 12U);
}

TEST(Maps, PagesOfOneTexel) {
    for (const UvSource source : {UvSource::keep, UvSource::make}) {
        Settings settings = keeping(1);
        settings.uv = source;
        const HostBake bake = bake_on_host(scene_of(triangle_with({{{0, 0}, {0, 1}, {1, 0}}})), {}, settings);
        ASSERT_EQ(bake.maps.at(0).image.texels.size(), 1U);
        EXPECT_EQ(bake.maps[0].image.texels[0], glm::vec4(1.0F));
    }
}

/// Normals of any length, none, and against the surface: light is that of the side the triangle faces.
TEST(Maps, NormalsOfAnyLengthNoneOrOpposed) {
    struct Case {
        const char* name;
        glm::vec3 normal;
    };
    for (const Case& tried : {Case{"long", {0, 1e30F, 0}}, Case{"short", {0, 1e-40F, 0}}, Case{"none", {0, 0, 0}},
                              Case{"opposed", {0, -1, 0}}, Case{"in the plane", {1, 0, 0}}}) {
        SCOPED_TRACE(tried.name);
        Primitive primitive = triangle_with({{{0, 0}, {0, 1}, {1, 0}}});
        primitive.normals.assign(3, tried.normal);
        Settings settings = keeping(8);
        settings.rays = 256;
        const HostBake bake = bake_on_host(scene_of(primitive), {}, settings);
        const LightMap& map = bake.maps.at(0);
        const bool in_plane = tried.normal.x > 0.0F;
        for (std::size_t texel = 0; texel < map.image.texels.size(); ++texel) {
            if (map.image.coverage[texel] > 0.5F) {
                // In the plane, half the hemisphere lies below the surface: not traced, and counted.
                ASSERT_NEAR(map.image.texels[texel].x, in_plane ? 0.5F : 1.0F, in_plane ? 0.1F : 0.0F);
            }
        }
        EXPECT_EQ(map.statistics.skipped_directions > 0, in_plane);
        EXPECT_EQ(map.statistics.occluded_rays, 0U);
    }
}

/// Interpolated normals that lean so far that half their hemisphere goes through the surface: a tent of one fold whose
/// vertices share a normal. What goes below is skipped and counted, nothing is stopped by the surface itself.
TEST(Maps, HemispheresThatGoThroughTheSurface) {
    Primitive tent;
    for (const glm::vec3& corner : {glm::vec3(-1, 0, 1), glm::vec3(0, 8, 1), glm::vec3(0, 8, -1), glm::vec3(-1, 0, -1),
                                    glm::vec3(1, 0, 1), glm::vec3(1, 0, -1)}) {
        add_vertex(tent, corner);
        tent.normals.emplace_back(0.0F, 1.0F, 0.0F);
    }
    tent.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
    const HostBake bake = bake_on_host(scene_of(tent), {}, small_settings(32, 64));
    const LightMapStatistics& statistics = bake.maps.at(0).statistics;
    EXPECT_EQ(statistics.occluded_rays, 0U);
    EXPECT_GT(statistics.skipped_directions, statistics.rays / 3);
}

} // namespace
} // namespace vkbake::test
