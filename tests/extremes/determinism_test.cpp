// One scene and one seed: one set of bytes, however they are computed and wherever the work stops.
#include <gtest/gtest.h>

#include "amount.hpp"
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
        Settings settings = small_settings(amount(32, 24), 32);
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

TEST(Determinism, TheScenesOfTheProjectGiveOneSetOfBytesEach) {
    for (const auto& entry : std::filesystem::directory_iterator(VKBAKE_SOURCE_DIR "/scenes/test")) {
        SCOPED_TRACE(entry.path());
        const Scene scene = load_scene(entry.path());
        Settings settings = small_settings(16);
        settings.threads = 1;
        const HostBake expected = bake_on_host(scene, {}, settings);
        for_every_target([&] { EXPECT_TRUE(same_light(expected, bake_on_host(scene, {}, settings))); });
        for (const int threads : {2, 16}) {
            settings.threads = threads;
            EXPECT_TRUE(same_light(expected, bake_on_host(scene, {}, settings))) << threads;
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
