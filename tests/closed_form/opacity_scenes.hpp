// Surfaces that let light through, round and over a floor.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "amount.hpp"
#include "host_bake.hpp"
#include "imageio/encode.hpp"

namespace vkbake::test::opacity {

/// A PNG of these alphas, or of these colours.
inline std::uint32_t add_texture(Scene& scene, int width, int height, const std::function<glm::vec4(int, int)>& texel) {
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

inline glm::vec4 white(float alpha) { return {1.0F, 1.0F, 1.0F, alpha}; }

/// A quarter of the texels of each 2 × 2 are opaque.
inline glm::vec4 quarter(int x, int y) { return white(x % 2 == 0 && y % 2 == 0 ? 1.0F : 0.0F); }

inline Primitive with_uvs(Primitive quads, float repeats) {
    for (std::size_t vertex = 0; vertex < quads.positions.size(); ++vertex) {
        quads.tex_coords[0].push_back(repeats * glm::vec2(vertex % 4 == 1 || vertex % 4 == 2, vertex % 4 >= 2));
    }
    return quads;
}

/// A floor in the middle of closed boxes, the first and smallest of the given material.
inline Scene floor_in_boxes(const std::vector<Material>& materials, float repeats = 1.0F) {
    Scene scene = test::scene_of(test::floor_of(0.5F));
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const float half = 1.0F + 0.25F * static_cast<float>(i);
        test::add_object(scene, "box", with_uvs(test::box_of(glm::vec3(-half), glm::vec3(half)), repeats));
        test::paint(scene, i + 1, materials[i]);
        scene.instances.back().density = 0.125; // its own light is no matter
    }
    return scene;
}

inline Settings settings_of(std::uint32_t rays = test::amount(64U, 16U)) {
    Settings settings;
    settings.layout = Layout::object;
    settings.density = 16.0;
    settings.size = 0;
    settings.rays = rays;
    return settings;
}

/// Of the first object's map.
inline std::vector<glm::dvec3> floor_light(const Image& map) {
    std::vector<glm::dvec3> light;
    for (std::size_t texel = 0; texel < map.texels.size(); ++texel) {
        if (map.coverage[texel] != 0.0F) {
            light.emplace_back(map.texels[texel]);
        }
    }
    EXPECT_GT(light.size(), 200U);
    return light;
}

inline std::vector<glm::dvec3> floor_light(const Scene& scene, const Settings& settings,
                                           const glm::vec3& sky = glm::vec3(1.0F)) {
    return floor_light(test::bake_on_host(scene, test::constant_sky(sky), settings).maps.at(0).image);
}

inline glm::dvec3 mean(const std::vector<glm::dvec3>& light) {
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& texel : light) {
        sum += texel;
    }
    return sum / static_cast<double>(light.size());
}

inline void expect_all(const std::vector<glm::dvec3>& light, const glm::dvec3& expected) {
    for (const glm::dvec3& texel : light) {
        ASSERT_LT(glm::length(texel - expected), 2e-7) << texel.x << " " << texel.y << " " << texel.z;
    }
}

inline Material blend(float alpha) { return {.base_color = white(alpha), .alpha_mode = AlphaMode::blend}; }

inline Material mask(float alpha, float cutoff) {
    return {.base_color = white(alpha), .alpha_mode = AlphaMode::mask, .alpha_cutoff = cutoff};
}

} // namespace vkbake::test::opacity
