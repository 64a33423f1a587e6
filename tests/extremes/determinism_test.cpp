// One scene and one seed: one set of bytes, however they are computed and wherever the work stops.
#include <gtest/gtest.h>

#include "amount.hpp"
#include "closed_form/hand_made.hpp"
#include "highway_targets.hpp"
#include "host_bake.hpp"
#include "unit/write/small_scene.hpp"
#include "unit/write/test_folder.hpp"
#include "vkbake/vkbake.hpp"
#include "write/manifest.hpp"

namespace vkbake::test {
namespace {

Sky striped_sky() {
    Image image{32, 16, {}, {}};
    for (int texel = 0; texel < 32 * 16; ++texel) {
        image.texels.emplace_back(texel % 7 == 0 ? 1e9F : 1e-30F, static_cast<float>(texel), 0.1F, 1.0F);
    }
    return {.source = EquirectangularSky{std::move(image)}, .rotation_degrees = 33.0};
}

TEST(Determinism, ThreadsInstructionSetsAndAcceleratorsGiveOneSetOfBytes) {
    const Scene scene = furnished_scene();
    for (const Sky& sky : {Sky{}, striped_sky()}) {
        Settings settings = small_settings(amount(32, 16), amount(32, 16));
        settings.mode = Mode::irradiance;
        const HostBake expected = bake_on_host(scene, sky, settings);
        ASSERT_GT(expected.maps.at(0).statistics.occluded_rays, 100U);
        for (const Accelerator kind : {Accelerator::bvh, Accelerator::clusters, Accelerator::brute}) {
            settings.accelerator = kind;
            for (const int threads : {1, 2, 16}) {
                settings.threads = threads;
                EXPECT_TRUE(same_light(expected, bake_on_host(scene, sky, settings))) << threads;
            }
            settings.threads = 1;
            for_every_target([&] { EXPECT_TRUE(same_light(expected, bake_on_host(scene, sky, settings))); });
        }
    }
}

/// Those that are there to be measured too.
TEST(Determinism, EverySamplerGivesOneSetOfBytes) {
    const Scene scene = furnished_scene();
    for (const Sampler sampler : {Sampler::thesis, Sampler::uniform, Sampler::stratified}) {
        Settings settings = small_settings(16, amount(64, 16));
        settings.mode = Mode::irradiance;
        settings.sampler = sampler;
        settings.threads = 1;
        const HostBake expected = bake_on_host(scene, striped_sky(), settings);
        for_every_target([&] { EXPECT_TRUE(same_light(expected, bake_on_host(scene, striped_sky(), settings))); });
    }
}

TEST(Determinism, TheTestScenesGiveOneSetOfBytesEach) {
    for (const auto& entry : std::filesystem::directory_iterator(VKBAKE_SOURCE_DIR "/scenes/test")) {
        SCOPED_TRACE(entry.path());
        const Scene scene = load_scene(entry.path());
        Settings settings = small_settings(amount(16, 8));
        settings.threads = 1;
        const HostBake expected = bake_on_host(scene, {}, settings);
        for_every_target([&] { EXPECT_TRUE(same_light(expected, bake_on_host(scene, {}, settings))); });
        for (const int threads : {2, 16}) {
            settings.threads = threads;
            EXPECT_TRUE(same_light(expected, bake_on_host(scene, {}, settings))) << threads;
        }
    }
}

std::vector<std::filesystem::path> larger_scenes() {
    std::vector<std::filesystem::path> files;
    for (const char* const folder : {"/scenes", "/scenes/objects"}) {
        for (const auto& entry : std::filesystem::directory_iterator(std::string(VKBAKE_SOURCE_DIR) + folder)) {
            if (entry.path().extension() == ".glb" && (!few_samples || entry.path().stem() == "pergola")) {
                files.push_back(entry.path());
            }
        }
    }
    return files;
}

/// These are too large to be laid out: the light at the middle of every few triangles, with the lamps, leaves and panes
/// that the scenes have.
TEST(Determinism, TheLargerScenesGiveOneSetOfBytesEach) {
    for (const std::filesystem::path& file : larger_scenes()) {
        SCOPED_TRACE(file);
        const Scene scene = load_scene(file);
        const Surface surface = make_surface(scene);
        std::vector<SamplePoint> points;
        const auto triangles = static_cast<std::uint32_t>(surface.triangle_count());
        for (std::uint32_t triangle = 0; triangle < triangles; triangle += triangles / amount(256U, 32U) + 1) {
            points.push_back(point_on(surface, triangle, glm::dvec3(1.0 / 3.0)));
        }
        const GeometryImage texels = geometry_image(points, 64);
        Settings settings;
        settings.rays = 16;
        const std::optional<SurfaceOpacity> opacity = make_opacity(scene, surface, settings);
        const auto tracer = [&](int threads) {
            settings.threads = threads;
            return Tracer(surface, striped_sky(), settings, scene.lamps, opacity ? &*opacity : nullptr);
        };
        const Tracer one = tracer(1);
        const std::vector<glm::vec4> expected = one.trace(texels).image.texels;
        EXPECT_TRUE(std::ranges::any_of(expected, [](const glm::vec4& texel) { return texel.x > 0.0F; }));
        for_every_target([&] { EXPECT_TRUE(same_bits(expected, one.trace(texels).image.texels)); });
        for (const int threads : {2, 16}) {
            EXPECT_TRUE(same_bits(expected, tracer(threads).trace(texels).image.texels)) << threads;
        }
    }
}

/// Between any two renames of a second bake into the same folder: the first bake, the second, or a refusal.
TEST(Resources, AKillBetweenRenamesLeavesOneBakeOrARefusal) {
    const TestFolder folder;
    Bake second = make_bake();
    for (LightMap& map : second.light_maps) {
        map.image.texels[0].x += 1.0F;
    }
    const auto renames = write_bake(make_scene(), second, {folder / "second", LightMapFormat::exr, "second"});
    ASSERT_GE(renames.size(), 3U);
    for (std::size_t done = 0; done <= renames.size(); ++done) {
        const std::filesystem::path place = folder / std::to_string(done);
        write_bake(make_scene(), make_bake(), {place, LightMapFormat::exr, "first"});
        for (std::size_t i = 0; i < done; ++i) { // in the order in which write_bake puts them in place
            std::filesystem::rename((folder / "second") / renames[i], place / renames[i]);
        }
        const auto state = [&]() -> std::string {
            try {
                check_bake_of(place, "room.glb");
                return read_manifest(place).at("command");
            } catch (const Error&) {
                return "refused";
            }
        }();
        EXPECT_EQ(state, done == 0 ? "first" : (done == renames.size() ? "second" : "refused")) << done;
        write_bake(make_scene(), second, {folder / "second", LightMapFormat::exr, "second"});
    }
}

} // namespace
} // namespace vkbake::test
