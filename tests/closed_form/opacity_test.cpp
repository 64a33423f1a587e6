// What surfaces let through, where it is known.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "amount.hpp"
#include "base/luminance.hpp"
#include "configuration_factors.hpp"
#include "highway_targets.hpp"
#include "host_bake.hpp"
#include "imageio/encode.hpp"
#include "lit_on_host.hpp"

namespace vkbake {
namespace {

/// A PNG of these alphas, or of these colours.
std::uint32_t add_texture(Scene& scene, int width, int height, const std::function<glm::vec4(int, int)>& texel) {
    Image image{.width = width, .height = height, .texels = {}, .coverage = {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.texels.push_back(texel(x, y));
        }
    }
    const std::vector<std::uint8_t> bytes = encode_image(image, ImageFormat::png8).bytes;
    EncodedImage encoded{.name = "made", .mime_type = "image/png", .bytes = {}};
    std::ranges::transform(bytes, std::back_inserter(encoded.bytes), [](std::uint8_t byte) { return std::byte{byte}; });
    scene.images.push_back(std::move(encoded));
    return static_cast<std::uint32_t>(scene.images.size() - 1);
}

glm::vec4 white(float alpha) { return {1.0F, 1.0F, 1.0F, alpha}; }

/// A quarter of the texels of each 2 × 2 are opaque.
glm::vec4 quarter(int x, int y) { return white(x % 2 == 0 && y % 2 == 0 ? 1.0F : 0.0F); }

Primitive with_uvs(Primitive quads, float repeats) {
    for (std::size_t vertex = 0; vertex < quads.positions.size(); ++vertex) {
        quads.tex_coords[0].push_back(repeats * glm::vec2(vertex % 4 == 1 || vertex % 4 == 2, vertex % 4 >= 2));
    }
    return quads;
}

/// A floor in the middle of closed boxes, the first and smallest of the given material.
Scene floor_in_boxes(const std::vector<Material>& materials, float repeats = 1.0F) {
    Scene scene = test::scene_of(test::floor_of(0.5F));
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const float half = 1.0F + 0.25F * static_cast<float>(i);
        test::add_object(scene, "box", with_uvs(test::box_of(glm::vec3(-half), glm::vec3(half)), repeats));
        test::paint(scene, i + 1, materials[i]);
        scene.instances.back().density = 0.125; // its own light is no matter
    }
    return scene;
}

Settings settings_of(std::uint32_t rays = test::amount(64U, 16U)) {
    Settings settings;
    settings.layout = Layout::object;
    settings.density = 16.0;
    settings.size = 0;
    settings.rays = rays;
    return settings;
}

/// Of the first object's map.
std::vector<glm::dvec3> floor_light(const Image& map) {
    std::vector<glm::dvec3> light;
    for (std::size_t texel = 0; texel < map.texels.size(); ++texel) {
        if (map.coverage[texel] != 0.0F) {
            light.emplace_back(map.texels[texel]);
        }
    }
    EXPECT_GT(light.size(), 200U);
    return light;
}

std::vector<glm::dvec3> floor_light(const Scene& scene, const Settings& settings,
                                    const glm::vec3& sky = glm::vec3(1.0F)) {
    return floor_light(test::bake_on_host(scene, test::constant_sky(sky), settings).maps.at(0).image);
}

glm::dvec3 mean(const std::vector<glm::dvec3>& light) {
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& texel : light) {
        sum += texel;
    }
    return sum / static_cast<double>(light.size());
}

void expect_all(const std::vector<glm::dvec3>& light, const glm::dvec3& expected) {
    for (const glm::dvec3& texel : light) {
        ASSERT_LT(glm::length(texel - expected), 2e-7) << texel.x << " " << texel.y << " " << texel.z;
    }
}

Material blend(float alpha) { return {.base_color = white(alpha), .alpha_mode = AlphaMode::blend}; }

Material mask(float alpha, float cutoff) {
    return {.base_color = white(alpha), .alpha_mode = AlphaMode::mask, .alpha_cutoff = cutoff};
}

TEST(Opacity, BlendAroundTheFloorLetsThroughOneLessAlpha) {
    // Exactly, also along rays that pass through the edges of the boxes' triangles.
    expect_all(floor_light(floor_in_boxes({blend(0.25F)}), settings_of()), glm::dvec3(0.75));
    expect_all(floor_light(floor_in_boxes({blend(0.25F), blend(0.5F), blend(0.125F)}), settings_of()),
               glm::dvec3(0.75 * 0.5 * 0.875));
    expect_all(floor_light(floor_in_boxes({blend(0.0F)}), settings_of()), glm::dvec3(1.0));
    expect_all(floor_light(floor_in_boxes({blend(0.5F), blend(1.0F)}), settings_of()), glm::dvec3(0.0));
    expect_all(floor_light(floor_in_boxes(std::vector<Material>(8, blend(0.25F))), settings_of(), {1.0F, 2.0F, 4.0F}),
               std::pow(0.75, 8) * glm::dvec3(1.0, 2.0, 4.0));
}

TEST(Opacity, TheThesisSamplerIsDimmedToo) {
    Settings settings = settings_of();
    settings.sampler = Sampler::thesis;
    settings.accelerator = Accelerator::clusters;
    const std::vector<glm::dvec3> bare = floor_light(floor_in_boxes({mask(0.25F, 0.5F)}), settings);
    const std::vector<glm::dvec3> dimmed = floor_light(floor_in_boxes({blend(0.25F)}), settings);
    for (std::size_t texel = 0; texel < bare.size(); ++texel) {
        ASSERT_LT(glm::length(dimmed[texel] - 0.75 * bare[texel]), 2e-7);
    }
    settings.triangle_test = TriangleTest::moller_trumbore; // promises nothing at edges
    EXPECT_NEAR(mean(floor_light(floor_in_boxes({blend(0.25F)}), settings)).x, 0.75 * mean(bare).x, 1e-3);
}

TEST(Opacity, TransmissionIsColouredByTheBaseColour) {
    Material glass{.base_color = {0.25F, 0.5F, 1.0F, 1.0F}, .transmission = 0.5F};
    expect_all(floor_light(floor_in_boxes({glass}), settings_of()), {0.125, 0.25, 0.5});
    expect_all(floor_light(floor_in_boxes({glass, glass}), settings_of()), {0.015625, 0.0625, 0.25});
    glass.metallic = 0.5F; // what is metal lets nothing through
    expect_all(floor_light(floor_in_boxes({glass}), settings_of()), {0.0625, 0.125, 0.25});
    glass.alpha_mode = AlphaMode::blend; // and what is not there, everything
    glass.base_color.a = 0.5F;
    expect_all(floor_light(floor_in_boxes({glass}), settings_of()), {0.53125, 0.5625, 0.625});
    Settings settings = settings_of();
    settings.mode = Mode::ao; // one number: luminance
    expect_all(floor_light(floor_in_boxes({glass}), settings), glm::dvec3(luminance({0.53125, 0.5625, 0.625})));
    settings.ao_distance = 0.4; // the box is farther
    expect_all(floor_light(floor_in_boxes({glass}), settings), glm::dvec3(1.0));
    settings.alpha = Alpha::opaque;
    settings.ao_distance.reset();
    expect_all(floor_light(floor_in_boxes({glass}), settings), glm::dvec3(0.0));
}

TEST(Opacity, TransmissionTexturesAreLookedUpInTheirOwnChannels) {
    Scene scene = floor_in_boxes({{.base_color_texture = TextureUse{.image = 0},
                                   .metallic = 1.0F,
                                   .metallic_texture = TextureUse{.image = 1},
                                   .transmission = 0.5F,
                                   .transmission_texture = TextureUse{.image = 1}}});
    add_texture(scene, 2, 2, [](int, int) { return glm::vec4(1.0F, 188.0F / 255.0F, 0.0F, 1.0F); }); // sRGB
    add_texture(scene, 2, 2, [](int, int) { return glm::vec4(0.4F, 1.0F, 0.2F, 1.0F); });
    const double factor = 0.5 * 0.4 * (1.0 - 0.2);
    const double green = std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4);
    expect_all(floor_light(scene, settings_of()), {factor, factor * green, 0.0});
}

TEST(Opacity, MaskBlocksFromItsCutoffOn) {
    expect_all(floor_light(floor_in_boxes({mask(0.5F, 0.5F)}), settings_of()), glm::dvec3(0.0));
    expect_all(floor_light(floor_in_boxes({mask(0.5F, std::nextafter(0.5F, 1.0F))}), settings_of()), glm::dvec3(1.0));
    expect_all(floor_light(floor_in_boxes({mask(0.0F, 0.0F)}), settings_of()), glm::dvec3(0.0));
    expect_all(floor_light(floor_in_boxes({mask(1.0F, 1.5F)}), settings_of()),
               glm::dvec3(1.0)); // it hides the material
    // The same of a texture and of vertices' colours. 51 / 255 is 0.2, rounded as 0.2F is.
    for (const float cutoff : {0.2F, std::nextafter(0.2F, 1.0F)}) {
        Material material = mask(1.0F, cutoff);
        material.base_color_texture = TextureUse{};
        Scene scene = floor_in_boxes({material});
        add_texture(scene, 3, 2, [](int, int) { return white(0.2F); });
        expect_all(floor_light(scene, settings_of()), glm::dvec3(cutoff == 0.2F ? 0.0 : 1.0));
        scene = floor_in_boxes({mask(1.0F, cutoff)});
        scene.meshes[1].primitives[0].colors.assign(scene.meshes[1].primitives[0].positions.size(), white(0.2F));
        expect_all(floor_light(scene, settings_of()), glm::dvec3(cutoff == 0.2F ? 0.0 : 1.0));
    }
}

TEST(Opacity, AFinePatternLetsThroughItsShare) {
    for (const AlphaMode mode : {AlphaMode::mask, AlphaMode::blend}) {
        Scene scene =
            floor_in_boxes({{.base_color_texture = TextureUse{.filter = Filter::nearest}, .alpha_mode = mode}}, 32.0F);
        add_texture(scene, 8, 8, quarter);
        const std::vector<glm::dvec3> light = floor_light(scene, settings_of(256));
        // A ray is stopped with a probability of 1/4; the texels' rays are independent.
        const double deviation = std::sqrt(0.25 * 0.75 / (256.0 * static_cast<double>(light.size())));
        EXPECT_NEAR(mean(light).x, 0.75, 4.0 * deviation);
        EXPECT_LT(glm::length(mean(light) - glm::dvec3(mean(light).x)), 1e-9);
    }
}

TEST(Opacity, AHoleInAMaskIsAWindow) {
    // A lid one above the floor with a square hole, 1 × 1, in the middle of it; closed around.
    Scene scene = test::scene_of(test::floor_of(0.5F));
    test::add_object(scene, "lid", with_uvs(test::box_of(glm::vec3(-1.0F), glm::vec3(1.0F)), 1.0F));
    scene.instances.back().density = 0.125;
    Material material{.base_color_texture =
                          TextureUse{.wrap_u = Wrap::clamp, .wrap_v = Wrap::clamp, .filter = Filter::nearest},
                      .alpha_mode = AlphaMode::mask};
    test::paint(scene, 1, material);
    add_texture(scene, 8, 8, [](int x, int y) { return white(x >= 2 && x < 6 && y >= 2 && y < 6 ? 0.0F : 1.0F); });
    // Only the upper face has the hole: the others' UVs lie in the picture's opaque corner.
    Primitive& box = scene.meshes[1].primitives[0];
    for (std::size_t vertex = 0; vertex < box.positions.size(); ++vertex) {
        const std::size_t face = vertex / 4 * 4;
        const bool upper = box.positions[face].y + box.positions[face + 1].y + box.positions[face + 2].y > 2.5F;
        if (!upper) {
            box.tex_coords[0][vertex] *= 0.125F;
        }
    }
    const test::HostBake bake =
        test::bake_on_host(scene, test::constant_sky(glm::vec3(1.0F)), settings_of(test::amount(1024U, 256U)));
    double sum = 0.0;
    int count = 0;
    for (std::size_t texel = 0; texel < bake.geometry[0].texel_count(); ++texel) {
        const glm::dvec3 world = bake.surface.frame.to_world(bake.geometry[0].position[texel]);
        if (bake.geometry[0].triangle[texel] != GeometryImage::empty && std::abs(world.x) < 0.1 &&
            std::abs(world.z) < 0.1) {
            sum += bake.maps[0].image.texels[texel].r;
            ++count;
        }
    }
    ASSERT_GT(count, 4);
    const double expected = 4.0 * test::element_to_parallel_rectangle(0.5, 0.5, 1.0);
    EXPECT_NEAR(sum / count, expected, 0.01 * expected);
}

TEST(Opacity, AMaskThatIsOpaqueEverywhereHasTheBitsOfOpaque) {
    Scene scene = test::furnished_scene();
    Settings settings = test::small_settings(48, 32);
    settings.mode = Mode::irradiance;
    const Sky sky; // clear
    const test::HostBake expected = test::bake_on_host(scene, sky, settings);
    for (const AlphaMode mode : {AlphaMode::mask, AlphaMode::blend}) {
        Scene textured = scene;
        add_texture(textured, 4, 4, [](int, int) { return white(1.0F); });
        for (std::size_t mesh = 0; mesh < textured.meshes.size(); ++mesh) {
            test::paint(textured, mesh, {.base_color_texture = TextureUse{}, .alpha_mode = mode});
        }
        const test::HostBake found = test::bake_on_host(textured, sky, settings);
        EXPECT_TRUE(test::same_light(expected, found));
        EXPECT_EQ(found.maps[0].statistics.filtered_rays, 0U); // seen beforehand
        // Where it is not seen beforehand: a texel that no triangle shows is not opaque.
        textured.images.clear();
        add_texture(textured, 4, 4, [](int x, int y) { return white(x == 2 && y == 2 ? 0.0F : 1.0F); });
        for (Mesh& mesh : textured.meshes) {
            mesh.primitives[0].tex_coords[0].assign(mesh.primitives[0].positions.size(), glm::vec2(0.01F));
            mesh.primitives[0].tex_coords[0][0] = {0.2F, 0.2F};
        }
        const test::HostBake looked_up = test::bake_on_host(textured, sky, settings);
        EXPECT_TRUE(test::same_light(expected, looked_up));
        EXPECT_GT(looked_up.maps[0].statistics.filtered_rays, 1000U);
    }
}

/// Cards with holes, half-transparent and coloured ones, over the furnished floor.
Scene leafy_scene() {
    Scene scene = test::furnished_scene();
    add_texture(scene, 8, 8, quarter);
    add_texture(scene, 4, 4, [](int x, int y) {
        return glm::vec4(0.2F * static_cast<float>(x), 0.9F, 0.5F, 0.3F * static_cast<float>(y));
    });
    const std::vector<Material> materials{
        {.base_color_texture = TextureUse{}, .alpha_mode = AlphaMode::mask, .double_sided = true},
        {.base_color_texture = TextureUse{.image = 1, .wrap_u = Wrap::mirror, .rotation = 0.5F},
         .alpha_mode = AlphaMode::blend},
        {.base_color = {0.9F, 0.5F, 0.3F, 1.0F}, .transmission = 0.7F}};
    for (int card = 0; card < 12; ++card) {
        const double turn = 0.5 * card;
        const glm::dmat3 linear(std::cos(turn), 0.3, std::sin(turn), 0.2, 1.0, 0.1 * card, -std::sin(turn), 0.0,
                                std::cos(turn));
        test::add_object(scene, "card", with_uvs(test::floor_of(0.9F), 3.0F),
                         {0.4 * card - 2.4, 1.8 + 0.05 * card, 0.3 * (card % 5) - 0.6}, linear);
        test::paint(scene, scene.meshes.size() - 1, materials[static_cast<std::size_t>(card % 3)]);
    }
    return scene;
}

TEST(Opacity, AcceleratorsThreadsAndInstructionSetsGiveTheSameBits) {
    const Scene scene = leafy_scene();
    Settings settings = test::small_settings(test::amount(64, 32), 16);
    settings.mode = Mode::irradiance;
    settings.bounces = 1;
    settings.bounce_rays = 8;
    const Bake expected = test::bounced(scene, settings, Sky{});
    const LightMap& map = expected.light_maps[0];
    EXPECT_GT(map.statistics.filtered_rays, map.statistics.rays / 10);
    for (const Accelerator kind : {Accelerator::bvh, Accelerator::clusters, Accelerator::brute}) {
        settings.accelerator = kind;
        settings.threads = kind == Accelerator::bvh ? 1 : 2;
        const auto same = [&] {
            const Bake found = test::bounced(scene, settings, Sky{});
            EXPECT_TRUE(test::same_bits(map.image.texels, found.light_maps[0].image.texels));
            EXPECT_EQ(map.statistics.filtered_rays, found.light_maps[0].statistics.filtered_rays);
            EXPECT_EQ(map.statistics.back_side_hits, found.light_maps[0].statistics.back_side_hits);
        };
        if (kind == Accelerator::bvh) {
            test::for_every_target(same);
        } else {
            same();
        }
    }
}

TEST(Opacity, EstimatesOfErrorsSeeTheSameLight) {
    const Scene scene = leafy_scene();
    Settings settings = test::small_settings(48, 64);
    settings.mode = Mode::irradiance;
    const Image plain = test::bake_on_host(scene, {}, settings).maps.at(0).image;
    settings.estimate_error = true;
    const LightMap estimated = test::bake_on_host(scene, {}, settings).maps.at(0);
    for (std::size_t texel = 0; texel < plain.texels.size(); ++texel) {
        ASSERT_LT(glm::length(plain.texels[texel] - estimated.image.texels[texel]), 1e-6F);
    }
    // Under one sheet every sample is the same: there is no error but of what no ray may have met.
    settings = settings_of(64);
    settings.estimate_error = true;
    const LightMap veiled =
        test::bake_on_host(floor_in_boxes({blend(0.5F)}), test::constant_sky(glm::vec3(1.0F)), settings).maps.at(0);
    EXPECT_LT(veiled.error->relative_rmse, 1e-6);
    // And where samples differ, the parts add up to what the texel has: the error is that of a share of a half.
    Scene holes = floor_in_boxes(
        {{.base_color_texture = TextureUse{.filter = Filter::nearest}, .alpha_mode = AlphaMode::mask}}, 32.0F);
    add_texture(holes, 8, 8, quarter);
    const LightMap pierced = test::bake_on_host(holes, test::constant_sky(glm::vec3(1.0F)), settings).maps.at(0);
    EXPECT_NEAR(pierced.error->relative_rmse, std::sqrt(0.25 * 0.75 / 64.0) / 0.75, 0.01);
}

TEST(Opacity, ACardIsNotShadedByItself) {
    Scene scene = test::scene_of(with_uvs(test::floor_of(1.0F), 1.0F));
    test::paint(scene, 0, {.base_color_texture = TextureUse{}, .alpha_mode = AlphaMode::mask, .double_sided = true});
    add_texture(scene, 8, 8, quarter);
    expect_all(floor_light(scene, settings_of()), glm::dvec3(1.0));
}

TEST(Opacity, ProbesSeeWhatEndsARay) {
    // A closed box whose insides are backs, around one of which nothing can be said.
    const auto sides = [](const std::vector<Material>& materials) {
        return test::bake_on_host(floor_in_boxes(materials), {}, settings_of()).maps.at(0).statistics;
    };
    const LightMapStatistics inside = sides({blend(0.5F), mask(0.1F, 0.5F), blend(1.0F)});
    EXPECT_GT(inside.probed_hits, 200U);
    EXPECT_EQ(inside.back_side_hits, inside.probed_hits);
    EXPECT_EQ(inside.occluded_rays, inside.rays);
    EXPECT_EQ(sides({blend(0.5F)}).probed_hits, 0U);
}

/// A lamp over a floor, and between them a sheet: what the floor gets of it.
std::vector<glm::dvec3> lamp_light(const std::optional<Material>& sheet, const Material& lamp) {
    Scene scene = test::scene_of(test::floor_of(0.5F));
    test::paint(scene, 0, {.base_color = glm::vec4(0, 0, 0, 1)});
    Primitive downwards = test::floor_of(1.0F);
    std::ranges::reverse(downwards.indices);
    test::add_object(scene, "lamp", downwards, {0.0, 1.0, 0.0});
    scene.instances.back().density = 0.25;
    test::paint(scene, 1, lamp);
    if (sheet) {
        test::add_object(scene, "sheet", with_uvs(test::floor_of(2.0F), 1.0F), {0.0, 0.5, 0.0});
        scene.instances.back().density = 0.125;
        test::paint(scene, 2, *sheet);
    }
    add_texture(scene, 2, 2, [](int, int) { return white(0.25F); });
    Settings settings = settings_of(16);
    settings.bounces = 1;
    settings.bounce_rays = 64;
    return floor_light(test::bounced(scene, settings).light_maps.at(0).image);
}

TEST(Opacity, PunctualLampsAreDimmedAsTheSkyIs) {
    const auto floor_under = [](const Material& material, const Lamp& lamp) {
        Scene scene = floor_in_boxes({material});
        scene.lamps.push_back(lamp);
        Settings settings = settings_of();
        settings.estimate_error = lamp.is_soft();
        return floor_light(scene, settings, glm::vec3(0.0F));
    };
    const Material glass{.base_color = {1.0F, 0.5F, 0.25F, 1.0F}, .transmission = 0.5F};
    const glm::dvec3 aslant = glm::normalize(glm::dvec3(0.3, -1.0, 0.2));
    for (const Lamp& lamp : {Lamp{.kind = LampKind::directional, .intensity = 3.0, .direction = aslant},
                             Lamp{.kind = LampKind::directional, .direction = aslant, .angular_diameter = 10.0},
                             Lamp{.intensity = 5.0, .position = {0.3, 3.0, 0.1}},
                             Lamp{.intensity = 5.0, .position = {0.3, 3.0, 0.1}, .radius = 0.5}}) {
        const std::vector<glm::dvec3> bare = floor_under(mask(0.25F, 0.5F), lamp);
        EXPECT_GT(mean(bare).x, 0.1);
        const std::vector<glm::dvec3> dimmed = floor_under(glass, lamp);
        ASSERT_EQ(dimmed.size(), bare.size());
        for (std::size_t texel = 0; texel < bare.size(); ++texel) {
            ASSERT_LT(glm::length(dimmed[texel] - glm::dvec3(0.5, 0.25, 0.125) * bare[texel]), 1e-6);
        }
    }
}

TEST(Opacity, ASunInTheSkyIsDimmedAsTheRest) {
    Image noon{.width = 64, .height = 32, .texels = std::vector<glm::vec4>(64 * 32, glm::vec4(1.0F)), .coverage = {}};
    noon.texels[noon.index(20, 6)] = glm::vec4(5000.0F, 4000.0F, 3000.0F, 1.0F);
    const Sky sky{.source = EquirectangularSky{noon}, .name = "noon"};
    const auto floor_under = [&](const Material& material) {
        const test::HostBake bake = test::bake_on_host(floor_in_boxes({material}), sky, settings_of());
        EXPECT_GT(bake.maps[0].statistics.peak_rays, 0U); // it is sampled on its own
        return floor_light(bake.maps[0].image);
    };
    const std::vector<glm::dvec3> bare = floor_under(mask(0.25F, 0.5F));
    const std::vector<glm::dvec3> dimmed = floor_under({.base_color = {1.0F, 0.5F, 0.25F, 1.0F}, .transmission = 0.5F});
    ASSERT_EQ(dimmed.size(), bare.size());
    for (std::size_t texel = 0; texel < bare.size(); ++texel) {
        ASSERT_LT(glm::length(dimmed[texel] - glm::dvec3(0.5, 0.25, 0.125) * bare[texel]), 1e-5);
    }
}

TEST(Opacity, LampsShineThroughWhatLiesBeforeThem) {
    const Material lamp{.base_color = glm::vec4(0, 0, 0, 1), .emissive = {4.0F, 2.0F, 1.0F}};
    const std::vector<glm::dvec3> bare = lamp_light(std::nullopt, lamp);
    EXPECT_GT(mean(bare).x, 1.0);
    const auto expect_share = [&](const std::vector<glm::dvec3>& light, const glm::dvec3& share) {
        ASSERT_EQ(light.size(), bare.size()); // the floor's map is the same, and so are its rays
        for (std::size_t texel = 0; texel < bare.size(); ++texel) {
            ASSERT_LT(glm::length(light[texel] - share * bare[texel]), 1e-5);
        }
    };
    Material sheet = blend(0.25F);
    sheet.base_color = {0.0F, 0.0F, 0.0F, 0.25F};
    expect_share(lamp_light(sheet, lamp), glm::dvec3(0.75));
    expect_share(lamp_light(mask(0.25F, 0.5F), lamp), glm::dvec3(1.0));
    expect_share(lamp_light(Material{.base_color = {0.0F, 0.0F, 0.0F, 1.0F},
                                     .base_color_texture = TextureUse{},
                                     .alpha_mode = AlphaMode::mask,
                                     .alpha_cutoff = 0.25F},
                            lamp),
                 glm::dvec3(0.0));
    expect_share(lamp_light(Material{.base_color = {1.0F, 0.5F, 0.0F, 1.0F}, .transmission = 1.0F}, lamp),
                 {1.0, 0.5, 0.0});
    // A lamp that is half there sends half.
    Material half = lamp;
    half.base_color.a = 0.5F;
    half.alpha_mode = AlphaMode::blend;
    expect_share(lamp_light(std::nullopt, half), glm::dvec3(0.5));
}

} // namespace
} // namespace vkbake
