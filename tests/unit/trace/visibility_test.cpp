// What rays meet, opaque or not.
#include "trace/visibility.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "host_bake.hpp"

namespace vkbake {
namespace {

/// A sheet of n × n squares in the plane y = 0, two triangles each, [−1, 1]².
Primitive sheet_of(int n) {
    Primitive sheet;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const auto at = [&](int x, int z) {
                return glm::vec3(2.0F * static_cast<float>(x) / static_cast<float>(n) - 1.0F, 0.0F,
                                 2.0F * static_cast<float>(z) / static_cast<float>(n) - 1.0F);
            };
            test::add_quad(sheet, at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
        }
    }
    return sheet;
}

Material half_there() { return {.base_color = {1.0F, 1.0F, 1.0F, 0.5F}, .alpha_mode = AlphaMode::blend}; }

constexpr std::array kinds{Accelerator::brute, Accelerator::clusters, Accelerator::bvh};

TEST(Visibility, ASheetDimsOnceAlsoWhereItsTrianglesMeet) {
    Scene scene = test::scene_of(sheet_of(4));
    test::paint(scene, 0, half_there());
    const Surface surface = make_surface(scene);
    const std::optional<SurfaceOpacity> opacity = make_opacity(scene, surface, {});
    ASSERT_TRUE(opacity);
    for (const Accelerator kind : kinds) {
        const Visibility visibility(surface, {kind, TriangleTest::watertight, 4, 0}, &*opacity);
        VisibilityScratch scratch = visibility.make_scratch();
        // Straight down and aslant, through corners, edges and diagonals: all exact in floats.
        for (int x = -15; x <= 15; ++x) {
            for (int z = -15; z <= 15; ++z) {
                const glm::vec3 aim =
                    0.5F * glm::vec3(static_cast<float>(x) / 16.0F, 0.0F, static_cast<float>(z) / 16.0F);
                for (const glm::vec3& way : {glm::vec3(0, -1, 0), glm::vec3(0.5F, -1, 0), glm::vec3(-0.25F, 1, 0.5F)}) {
                    EXPECT_EQ(visibility.transmittance({aim - 0.5F * way, way}, scratch), glm::vec3(0.5F))
                        << x << " " << z;
                }
            }
        }
    }
}

TEST(Visibility, SurfacesAreSeenFromNearToFar) {
    Scene scene = test::scene_of(sheet_of(1));
    Material glass{.base_color = {1.0F, 0.5F, 0.25F, 1.0F}, .transmission = 1.0F};
    const std::vector<Material> materials{half_there(), glass, half_there(), {}, half_there()};
    for (std::size_t i = 0; i < materials.size(); ++i) {
        if (i > 0) {
            test::add_object(scene, "sheet", sheet_of(1), {0.0, static_cast<double>(i), 0.0});
        }
        test::paint(scene, i, materials[i]);
    }
    const Surface surface = make_surface(scene);
    const std::optional<SurfaceOpacity> opacity = make_opacity(scene, surface, {});
    const Visibility visibility(surface, {}, &*opacity);
    VisibilityScratch scratch = visibility.make_scratch();
    const Ray up{{0.01F, -0.95F, 0.02F}, {0.0F, 1.0F, 0.0F}};
    const auto seen = visibility.surfaces(up, scratch);
    ASSERT_EQ(seen.size(), 4U);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        EXPECT_EQ(surface.parts[surface.parts_of[seen[i].hit.triangle]].object, i);
        EXPECT_EQ(seen[i].hit.back_side, true);
    }
    EXPECT_EQ(seen[0].share, glm::vec3(0.5F));
    EXPECT_EQ(seen[1].share, glm::vec3(0.5F)); // all of the pane is there
    EXPECT_EQ(seen[2].share, 0.25F * glm::vec3(1.0F, 0.5F, 0.25F));
    EXPECT_EQ(seen[3].share, 0.25F * glm::vec3(1.0F, 0.5F, 0.25F));
    EXPECT_EQ(visibility.nearest(up, scratch)->triangle, visibility.surfaces(up, scratch).back().hit.triangle);
    EXPECT_EQ(visibility.transmittance(up, scratch), glm::vec3(0.0F));
    const Ray from_above{{0.01F, 0.95F, 0.02F}, {0.0F, 1.0F, 0.0F}};
    EXPECT_EQ(visibility.transmittance(from_above, scratch), glm::vec3(1.0F));
    EXPECT_TRUE(visibility.surfaces(from_above, scratch).empty());
    EXPECT_FALSE(visibility.nearest(from_above, scratch));
}

TEST(Visibility, TheTriangleThatARayLeavesDimsNothing) {
    Scene scene = test::scene_of(sheet_of(1));
    test::paint(scene, 0, half_there());
    const Surface surface = make_surface(scene);
    const std::optional<SurfaceOpacity> opacity = make_opacity(scene, surface, {});
    const Visibility visibility(surface, {}, &*opacity);
    VisibilityScratch scratch = visibility.make_scratch();
    Ray ray{{0.2F, -0.5F, 0.1F}, {0.0F, 1.0F, 0.0F}};
    ASSERT_EQ(visibility.surfaces(ray, scratch).size(), 1U);
    ray.ignored_triangle = visibility.surfaces(ray, scratch)[0].hit.triangle;
    EXPECT_EQ(visibility.transmittance(ray, scratch), glm::vec3(1.0F));
}

TEST(Visibility, WhatIsOpaqueAllOverNeedsNoLookUp) {
    const Scene opaque = test::furnished_scene();
    const Surface surface = make_surface(opaque);
    EXPECT_FALSE(make_opacity(opaque, surface, {}));
    Scene scene = test::scene_of(sheet_of(2));
    test::add_object(scene, "other", sheet_of(3), {0.0, 1.0, 0.0});
    test::paint(scene, 0, {.alpha_mode = AlphaMode::mask}); // alpha 1
    test::paint(scene, 1, {.base_color = glm::vec4(1, 1, 1, 0.25F), .alpha_mode = AlphaMode::mask});
    const Surface two = make_surface(scene);
    EXPECT_FALSE(make_opacity(scene, two, {.alpha = Alpha::opaque}));
    const std::optional<SurfaceOpacity> opacity = make_opacity(scene, two, {});
    ASSERT_TRUE(opacity);
    EXPECT_EQ(opacity->opaque().size(), 8U);
    EXPECT_TRUE(opacity->filtered().empty()); // below its cutoff everywhere: not there at all
}

} // namespace
} // namespace vkbake
