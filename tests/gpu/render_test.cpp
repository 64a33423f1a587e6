// The public `render`: what a baked scene refers to is found, decoded and exposed.
#include "vkbake/render.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "device.hpp"
#include "imageio/encode.hpp"
#include "panorama.hpp"
#include "vkbake/vkbake.hpp"

namespace {

using vkbake::Image;
using vkbake::Scene;
using vkbake::test::device;

Image map_of(const glm::vec3& value) {
    return {.width = 1, .height = 1, .texels = {glm::vec4(value, 1.0F)}, .coverage = {}};
}

vkbake::EncodedImage png(const Image& image) {
    const std::vector<std::uint8_t> bytes = vkbake::encode_image(image, vkbake::ImageFormat::png8).bytes;
    const auto* const data = reinterpret_cast<const std::byte*>(bytes.data());
    return {.name = "map", .mime_type = "image/png", .bytes = {data, data + bytes.size()}};
}

/// A white square that more than fills the view of its camera "front", 90° high.
Scene wall() {
    Scene scene;
    scene.name = "wall";
    vkbake::Primitive primitive;
    primitive.positions = {{-3.0F, 3.0F, -2.0F}, {3.0F, 3.0F, -2.0F}, {3.0F, -3.0F, -2.0F}, {-3.0F, -3.0F, -2.0F}};
    primitive.tex_coords[1] = {{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}};
    primitive.indices = {0, 3, 1, 1, 3, 2};
    primitive.material = 0;
    scene.meshes.emplace_back();
    scene.meshes[0].primitives.push_back(primitive);
    scene.instances.emplace_back();
    scene.materials.emplace_back();
    scene.cameras.emplace_back();
    scene.cameras[0].name = "front";
    scene.cameras[0].vertical_field_of_view = std::acos(0.0);
    return scene;
}

vkbake::RenderSettings small(double stops = 0.0) {
    vkbake::RenderSettings settings;
    settings.width = settings.height = 8;
    settings.exposure = stops;
    return settings;
}

glm::vec4 middle_of(const Scene& scene, const vkbake::RenderSettings& settings = small()) {
    const Image picture = vkbake::render(scene, {}, settings, device());
    EXPECT_EQ(picture.width, settings.width);
    EXPECT_EQ(picture.height, settings.height);
    return picture.texels.at(picture.index(picture.width / 2, picture.height / 2));
}

/// Grey radiance from 0.08 to 0.7 as the display shows it: less the 0.04 that the tone mapping takes off, sRGB-encoded.
double shown(double radiance) { return 1.055 * std::pow(radiance - 0.04, 1.0 / 2.4) - 0.055; }

TEST(Render, ExposesEmbeddedAndLinearLightMapsAlike) {
    Scene scene = wall();
    scene.images.push_back(png(map_of(glm::vec3(1.0F))));
    scene.materials[0].light_map =
        vkbake::LightMapUse{.texture = {.image = 0, .tex_coord = 1}, .intensity = 50.0F, .linear_file = {}};
    EXPECT_NEAR(middle_of(scene).g, shown(0.4), 1e-3);
    EXPECT_NEAR(middle_of(scene, small(-1.0)).g, shown(0.2), 1e-3);

    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "vkbake-render";
    std::filesystem::create_directories(folder);
    vkbake::write_image(folder / "map.exr", map_of({0.01F, 0.02F, 0.0F}));
    scene.directory = folder.string();
    scene.materials[0].light_map->linear_file = "map.exr";
    const glm::vec4 green = middle_of(scene);
    EXPECT_GT(green.g, green.r) << "the EXR's values, not the white image's";
    EXPECT_GT(green.r, green.b);
    std::filesystem::remove_all(folder);
    EXPECT_NEAR(middle_of(scene).r, shown(0.4), 1e-3) << "without the EXR the embedded image serves";
}

/// A wall that fills the left half of the view of wall()'s camera (1) or the right half (2), or all of it behind them
/// (3), by the embedded light map at π or 2π times its values.
Scene two_walls(std::initializer_list<int> parts) {
    Scene scene = wall();
    scene.images.push_back(png(map_of(glm::vec3(1.0F))));
    const auto use = [](double intensity) {
        return vkbake::LightMapUse{
            .texture = {.image = 0, .tex_coord = 1}, .intensity = static_cast<float>(intensity), .linear_file = {}};
    };
    scene.materials[0].light_map = use(std::numbers::pi);
    scene.materials.emplace_back();
    scene.materials[1].light_map = use(2.0 * std::numbers::pi);
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes[1].primitives[0].material = 1;
    scene.instances.clear();
    for (const int part : parts) {
        scene.instances.emplace_back();
        scene.instances.back().mesh = part == 1 ? 0 : 1;
        scene.instances.back().translation = {part == 1 ? -3.0 : part == 2 ? 3.0 : 0.0, 0.0, part == 3 ? -1.0 : 0.0};
    }
    return scene;
}

TEST(Render, EmbeddedLightMapIsIrradianceAndThePictureIsMetered) {
    // Light 1 on the left half and 2 on the right: their geometric mean is √2.
    const Image picture = vkbake::render(two_walls({1, 2}), {}, small(), device());
    EXPECT_NEAR(picture.texels[picture.index(1, 4)].g, shown(0.4 / std::numbers::sqrt2), 1e-3);
    EXPECT_NEAR(picture.texels[picture.index(6, 4)].g, shown(0.4 * std::numbers::sqrt2), 1e-3);
}

TEST(Render, LightThatThePictureDoesNotShowDoesNotExposeIt) {
    EXPECT_NEAR(middle_of(two_walls({3})).g, shown(0.4), 1e-3) << "nothing else there";
    Scene hidden = two_walls({3, 1, 1});
    hidden.instances[1].translation.x = 0.0; // before the brighter wall
    hidden.instances[2].translation.x = 50.0;
    EXPECT_NEAR(middle_of(hidden).g, shown(0.4), 1e-3);
    // The sky beside a wall does not count either, however bright.
    vkbake::Sky sky;
    sky.source = vkbake::ConstantSky{glm::vec3(100.0F)};
    const Image beside = vkbake::render(two_walls({1}), sky, small(), device());
    EXPECT_NEAR(beside.texels[beside.index(1, 4)].g, shown(0.4), 1e-3);
}

TEST(Render, GlassIsMeteredThrough) {
    Scene scene = two_walls({1, 3});
    scene.instances[0].translation = {0.0, 0.0, 0.0};
    scene.materials[0].alpha_mode = vkbake::AlphaMode::blend;
    scene.materials[0].base_color = {0.0F, 0.0F, 0.0F, 0.25F};
    EXPECT_NEAR(middle_of(scene).g, shown(0.75 * 0.4), 1e-3);
}

TEST(Render, OcclusionTexturesServeWhereThereIsNoLightMap) {
    Scene scene = wall();
    scene.images.push_back(png(map_of({0.5F, 1.0F, 1.0F}))); // occlusion is the red channel
    scene.materials[0].occlusion_texture = vkbake::TextureUse{.image = 0, .tex_coord = 1};
    const glm::vec4 pixel = middle_of(scene);
    EXPECT_NEAR(pixel.r, shown(0.4), 1e-3);
    EXPECT_EQ(pixel.r, pixel.g);
    EXPECT_EQ(pixel.g, pixel.b);
}

/// A folder that goes away.
class Folder {
public:
    Folder() : m_path(std::filesystem::path(testing::TempDir()) / "vkbake-render-maps") {
        std::filesystem::create_directories(m_path);
    }
    ~Folder() { std::filesystem::remove_all(m_path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
};

TEST(Render, BentNormalsTakeTheLightOfTheSkyWhereTheyPoint) {
    // Radiance 1 + d·(1, 0, 0) over a panorama whose middle is +X. On a surface that looks along n it makes
    // E / π = 1 + 2/3 n·(1, 0, 0): Lambert's cosine halves the mean and takes two thirds of what is linear.
    vkbake::Sky sky =
        vkbake::test::panorama_of(64, [](const glm::dvec3& towards) { return glm::dvec3(1.0 + towards.x); });
    sky.intensity = 3.0; // shows in nothing: the picture is exposed by its light
    const Folder folder;
    Image bent{.width = 2, .height = 1, .texels = {}, .coverage = {}};
    bent.texels = {{-0.3F, 0.4F, 0.0F, 1.0F}, {0.24F, 0.0F, 0.07F, 1.0F}}; // half open; a quarter
    vkbake::write_image(folder.path() / "bent.exr", bent);
    Scene scene = wall();
    scene.directory = folder.path().string();
    scene.images.push_back(png(map_of(glm::vec3(1.0F))));
    scene.materials[0].occlusion_texture = vkbake::TextureUse{.image = 0, .tex_coord = 1};
    scene.materials[0].bent_normal_file = "bent.exr";
    const Image picture = vkbake::render(scene, sky, small(), device());
    const double left = 0.5 * (1.0 - 2.0 / 3.0 * 0.6);
    const double right = 0.25 * (1.0 + 2.0 / 3.0 * 0.96);
    // Between two texels' centres light is mixed: the view shows the middle two thirds of the wall.
    const auto light_at = [&](int column) {
        const double u = 0.5 + ((column + 0.5) / 8.0 - 0.5) * 2.0 / 3.0;
        const double share = std::clamp(2.0 * u - 0.5, 0.0, 1.0);
        return left + share * (right - left);
    };
    const auto value = [&](int column) { return picture.texels[picture.index(column, 4)].g; };
    double logarithms = 0.0;
    for (int column = 0; column < 8; ++column) {
        logarithms += std::log(light_at(column)) / 8.0;
    }
    for (const int column : {0, 3, 7}) {
        EXPECT_NEAR(value(column), shown(0.4 * light_at(column) / std::exp(logarithms)), 3e-3) << column;
    }
    scene.materials[0].bent_normal_file = "lost.exr";
    EXPECT_NEAR(middle_of(scene).g, shown(0.4), 1e-3) << "without the EXR the embedded lengths serve";
}

TEST(Render, DirectionalMapsAreDrawnUnlessOneIsMissingOrSwitchedOff) {
    const Folder folder;
    Scene scene = wall();
    scene.directory = folder.path().string();
    scene.meshes[0].primitives[0].tex_coords[0] = scene.meshes[0].primitives[0].tex_coords[1];
    scene.images.push_back(png(map_of(glm::vec3(1.0F))));
    scene.images.push_back(png(map_of({0.9F, 0.5F, 0.7F}))); // leans to the right
    scene.materials[0].normal_map = vkbake::NormalMapUse{.texture = {.image = 1}};
    scene.materials[0].light_map = vkbake::LightMapUse{.texture = {.image = 0, .tex_coord = 1},
                                                       .intensity = 50.0F,
                                                       .linear_file = {},
                                                       .directional_files = {"0.exr", "1.exr", "2.exr", "3.exr"}};
    for (std::size_t i = 0; i < 4; ++i) { // light from the right, and from the wall's front
        const std::array<float, 4> coefficients{1.0F, 0.0F, 0.5F, 1.0F};
        vkbake::write_image(folder.path() / (std::to_string(i) + ".exr"), map_of(glm::vec3(coefficients[i])));
    }
    EXPECT_GT(middle_of(scene).g, shown(0.4) + 0.05);
    vkbake::RenderSettings off = small();
    off.directional = vkbake::Switch::off;
    EXPECT_NEAR(middle_of(scene, off).g, shown(0.4), 1e-3);
    std::filesystem::remove(folder.path() / "2.exr");
    EXPECT_NEAR(middle_of(scene).g, shown(0.4), 1e-3);
}

TEST(Render, SkyIsShownBehindUnlessItIsLeftOut) {
    Scene scene = wall();
    scene.images.push_back(png(map_of(glm::vec3(1.0F))));
    scene.materials[0].light_map =
        vkbake::LightMapUse{.texture = {.image = 0, .tex_coord = 1}, .intensity = 3.14159265F, .linear_file = {}};
    scene.instances[0].translation = {100.0, 0.0, 0.0};
    vkbake::Sky sky;
    sky.source = vkbake::ConstantSky{{0.5F, 0.25F, 0.5F}};
    sky.intensity = 2.0;
    const Image picture = vkbake::render(scene, sky, small(), device());
    EXPECT_NEAR(picture.texels[0].r, shown(0.4), 1e-3);
    EXPECT_NEAR(picture.texels[0].g, shown(0.2), 1e-3);
    vkbake::RenderSettings without_sky = small();
    without_sky.show_sky = false;
    const Image black = vkbake::render(scene, sky, without_sky, device());
    EXPECT_EQ(black.texels[0], glm::vec4(0.0F, 0.0F, 0.0F, 1.0F));
}

void expect_refused(const Scene& scene, const vkbake::RenderSettings& settings, const std::vector<std::string>& words) {
    try {
        (void)vkbake::render(scene, {}, settings, device());
        FAIL() << "drew it";
    } catch (const vkbake::Error& error) {
        EXPECT_EQ(error.kind(), vkbake::ErrorKind::bad_input);
        for (const std::string& word : words) {
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
    }
}

TEST(Render, RefusesScenesWithoutLightMapsAndUnknownCameras) {
    Scene scene = wall();
    expect_refused(scene, {}, {"wall", "light map"});
    scene.materials[0].light_map =
        vkbake::LightMapUse{.texture = {.image = 3, .tex_coord = 1}, .intensity = 1.0F, .linear_file = {}};
    expect_refused(scene, {}, {"wall", "image 3"});
    scene.materials[0].light_map->texture.image = 0;
    scene.images.push_back(png(map_of(glm::vec3(1.0F))));
    vkbake::RenderSettings settings = small();
    settings.camera = "roof";
    expect_refused(scene, settings, {"wall", "roof", "front"});
}

TEST(Render, ShowsLightProbesAsBallsInTheirLight) {
    Scene scene = wall();
    scene.images.push_back(png(map_of(glm::vec3(1.0F))));
    scene.materials[0].light_map = vkbake::LightMapUse{.texture = {.tex_coord = 1}};
    scene.directory = testing::TempDir();
    const auto with_probe = [&](const std::string& light) {
        std::ofstream file(std::filesystem::path(scene.directory) / "probes.json");
        file << R"({"probes": [{"position": [0, 0, -0.2], "coefficients": [)" << light;
        for (int i = 1; i < 9; ++i) {
            file << ", [0, 0, 0]";
        }
        file << "]}]}";
        file.close();
        vkbake::RenderSettings settings = small();
        settings.probes = true;
        return middle_of(scene, settings);
    };
    EXPECT_GT(middle_of(scene).g, 0.3F);
    EXPECT_EQ(glm::vec3(with_probe("[0, 0, 0]")), glm::vec3(0.0F));
    const glm::vec4 red = with_probe("[1, 0, 0]"); // so E / π is 0.28, 0, 0
    EXPECT_GT(red.r, 0.2F);
    EXPECT_LT(red.g, 0.1F);
}

} // namespace
