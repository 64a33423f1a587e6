// Bakes of the largest and the smallest. Of the largest map little is covered: what is empty takes the map's own memory
// and no more.
#include <sys/resource.h>

#include <gtest/gtest.h>

#include "base/machine_memory.hpp"
#include "device.hpp"
#include "host_bake.hpp"
#include "memory_plan.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake::test {
namespace {

constexpr std::uint64_t gibibyte = 1ULL << 30U;

/// The largest resident set that this process ever had.
std::uint64_t peak_bytes() {
    rusage usage{};
    (void)getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) << 10U;
}

TEST(LargeMap, AChartOf64TexelsOn16384TakesTheMapsOwnMemory) {
    constexpr int size = 16384;
    constexpr std::uint64_t side = 64;
#ifdef VKBAKE_SANITIZED
    GTEST_SKIP() << "an address sanitizer's memory is not the program's";
#endif
    if (machine_memory() < 12 * gibibyte) {
        GTEST_SKIP() << "the machine has less than 12 GiB";
    }
    Primitive floor = floor_of(1.0F);
    for (std::size_t i = 0; i < floor.positions.size(); ++i) {
        const glm::vec2 place = (glm::vec2(floor.positions[i].x, floor.positions[i].z) + 1.0F) * 0.5F;
        floor.tex_coords[1].push_back(place * (static_cast<float>(side) / static_cast<float>(size)));
    }
    Settings settings = small_settings(size, 1);
    settings.uv = UvSource::trust; // mirrored or not
    settings.padding = 2;
    settings.memory_limit = 7 * gibibyte; // of a full one 20.8 would be foretold
    const Scene scene = scene_of(floor);
    const Sky sky = constant_sky(glm::vec3(1.0F));
    const Bake baked = bake(scene, sky, settings, device());
    const LightMap& map = baked.light_maps.at(0);
    EXPECT_GE(map.statistics.covered_texels, side * side);
    EXPECT_LE(map.statistics.covered_texels, (side + 1) * (side + 1)); // the texels that a border touches
    EXPECT_EQ(map.image.texels[map.image.index(10, 20)], glm::vec4(1.0F));
    EXPECT_EQ(map.image.texels[map.image.index(size - 1, size - 1)], glm::vec4(0.0F));
    // RGBA and coverage 20 bytes a texel, triangle 4; a tile of 2048² on the device; the program and its driver.
    const std::uint64_t foretold = peak_memory(memory_need(scene, sky, settings, &baked.atlas));
    EXPECT_LE(foretold, 24ULL * size * size + 76ULL * 2048 * 2048 + gibibyte / 2);
    EXPECT_LE(peak_bytes(), foretold);
}

/// tests/extremes asks it of what bake calls; this, that bake calls it.
TEST(Frame, BakeNamesWhatIsTooSmall) {
    Scene scene = scene_of(floor_of(0.5F), {}, glm::dmat3(1e5));
    add_object(scene, "box", box_of({-0.005F, 0.0F, -0.005F}, {0.005F, 0.01F, 0.005F}));
    try {
        (void)bake(scene, {}, small_settings(), device());
        ADD_FAILURE() << "baked";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        EXPECT_NE(std::string(error.what()).find("\"box\""), std::string::npos) << error.what();
    }
    scene = scene_of(floor_of(500.0F));
    add_object(scene, "detail", floor_of(0.05F), {0.0, 1.0, 0.0});
    Settings settings = small_settings(64, 1);
    settings.layout = Layout::object;
    const Bake baked = bake(scene, {}, settings, device());
    EXPECT_TRUE(std::ranges::any_of(baked.notes, [](const std::string& note) {
        return note.find("texels are smaller than 64 steps") != std::string::npos;
    }));
}

} // namespace
} // namespace vkbake::test
