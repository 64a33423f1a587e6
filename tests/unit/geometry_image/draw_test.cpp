// The pass against the reference in the same arithmetic, to the bit; and what must not change the bits.
#include <gtest/gtest.h>

#include "geometry_image/draw.hpp"
#include "geometry_image/reference.hpp"
#include "same_bits.hpp"
#include "unit/geometry_image/surfaces.hpp"
#include "vkbake/device.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

using test::Kind;
using test::MappedSurface;
using test::same_bits;

class DrawGeometryImage : public testing::Test {
protected:
    static void SetUpTestSuite() { device() = std::make_unique<Device>(open_device({.name = {}, .validation = true})); }
    static void TearDownTestSuite() { device().reset(); }

    static GeometryImage draw(const MappedSurface& mapped, int tile = 2048) {
        return draw_geometry_image(device()->context(), mapped.surface, mapped.atlas, 0, {.tile = tile});
    }

private:
    static std::unique_ptr<Device>& device() {
        static std::unique_ptr<Device> opened;
        return opened;
    }
};

void expect_same(const GeometryImage& a, const GeometryImage& b) {
    ASSERT_EQ(a.width, b.width);
    ASSERT_EQ(a.height, b.height);
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.texel_count(); ++i) {
        different += a.triangle[i] != b.triangle[i] ? 1U : 0U;
    }
    EXPECT_EQ(different, 0U) << "texels of " << a.texel_count() << " have another triangle";
    EXPECT_TRUE(same_bits(a.position, b.position));
    EXPECT_TRUE(same_bits(a.shading_normal, b.shading_normal));
    EXPECT_TRUE(same_bits(a.geometric_normal, b.geometric_normal));
}

struct Case {
    const char* name;
    Kind kind;
    std::size_t count;
    int width;
    int height;
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest's own name
void PrintTo(const Case& sample, std::ostream* out) { *out << sample.name; }

class AgainstReference : public DrawGeometryImage, public testing::WithParamInterface<Case> {};

TEST_P(AgainstReference, EveryBitIsTheSame) {
    const Case& sample = GetParam();
    const MappedSurface mapped =
        test::map_triangles(test::make_triangles(sample.kind, sample.count, 7), sample.width, sample.height);
    const GeometryImage reference = reference_geometry_image(mapped.surface, mapped.atlas, 0);
    ASSERT_GT(std::ranges::count_if(reference.triangle, [](auto t) { return t != GeometryImage::empty; }), 0);
    expect_same(draw(mapped), reference);
}

INSTANTIATE_TEST_SUITE_P(
    Surfaces, AgainstReference,
    testing::Values(Case{"large", Kind::large, 40, 256, 256}, Case{"small", Kind::small, 900, 311, 203},
                    Case{"tiny", Kind::tiny, 5000, 128, 128}, Case{"needles", Kind::needles, 300, 256, 256},
                    Case{"aligned", Kind::aligned, 60, 64, 64}, Case{"aligned_to_centres", Kind::aligned, 60, 8, 8},
                    Case{"odd", Kind::mixed, 30, 1531, 1531}, Case{"one_texel", Kind::mixed, 20, 1, 1},
                    Case{"strip", Kind::mixed, 50, 4096, 3}, Case{"more_than_a_batch", Kind::tiny, 40000, 96, 96}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(DrawGeometryImage, TileSizeChangesNothing) {
    const MappedSurface mapped = test::map_triangles(test::make_triangles(Kind::mixed, 400, 11), 331, 257);
    const GeometryImage whole = draw(mapped, 2048);
    expect_same(draw(mapped, 64), whole);
    expect_same(draw(mapped, 100), whole);
}

TEST_F(DrawGeometryImage, OrderOfTrianglesChangesNothing) {
    std::vector<test::Triangle> triangles = test::make_triangles(Kind::mixed, 400, 13);
    const GeometryImage before = draw(test::map_triangles(triangles, 200, 200));
    std::ranges::reverse(triangles);
    GeometryImage after = draw(test::map_triangles(triangles, 200, 200));
    for (std::uint32_t& number : after.triangle) {
        number = number == GeometryImage::empty ? number : static_cast<std::uint32_t>(triangles.size()) - 1U - number;
    }
    expect_same(after, before);
}

TEST_F(DrawGeometryImage, MirroredMapCoversMirroredTexels) {
    std::vector<test::Triangle> triangles = test::make_triangles(Kind::mixed, 100, 17);
    for (test::Triangle& triangle : triangles) {
        for (test::Corner& corner : triangle) { // to where 1 − u is exact
            corner.uv = glm::round(corner.uv * 4096.0F) / 4096.0F;
        }
    }
    const GeometryImage straight = draw(test::map_triangles(triangles, 160, 120));
    for (test::Triangle& triangle : triangles) {
        for (test::Corner& corner : triangle) {
            corner.uv.x = 1.0F - corner.uv.x;
        }
    }
    const GeometryImage mirrored = draw(test::map_triangles(triangles, 160, 120));
    std::size_t different = 0;
    for (std::size_t y = 0; y < 120; ++y) {
        for (std::size_t x = 0; x < 160; ++x) {
            const bool covered = straight.triangle[y * 160 + x] != GeometryImage::empty;
            different += covered != (mirrored.triangle[y * 160 + 159 - x] != GeometryImage::empty) ? 1U : 0U;
        }
    }
    EXPECT_EQ(different, 0U);
}

/// A square that fills the page in two triangles, z = 0, x = u, y = v.
std::vector<test::Triangle> full_page() {
    const auto corner = [](float u, float v) {
        return test::Corner{glm::vec3(u, v, 0.0F), glm::vec3(0.0F, 0.0F, 1.0F), glm::vec2(u, v)};
    };
    return {{corner(0, 0), corner(1, 0), corner(1, 1)}, {corner(0, 0), corner(1, 1), corner(0, 1)}};
}

TEST_F(DrawGeometryImage, AFullPageHasItsTexelsCentres) {
    const MappedSurface mapped = test::map_triangles(full_page(), 64, 64);
    const GeometryImage image = draw(mapped);
    for (std::size_t y = 0; y < 64; ++y) {
        for (std::size_t x = 0; x < 64; ++x) {
            const std::size_t texel = y * 64 + x;
            const auto centre = glm::vec3(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F, 0.0F) / 64.0F;
            EXPECT_EQ(image.position[texel], centre);
            EXPECT_EQ(image.shading_normal[texel], glm::vec3(0.0F, 0.0F, 1.0F));
            // On the diagonal both hold the centre: the canonical order decides.
            const std::uint32_t expected = x > y ? 0U : x < y ? 1U : mapped.surface.canonical_order.front();
            EXPECT_EQ(image.triangle[texel], expected);
        }
    }
}

TEST_F(DrawGeometryImage, ANormalThatOpposesItsTriangleIsTurnedAndAVanishingOneReplaced) {
    std::vector<test::Triangle> triangles = full_page();
    for (test::Corner& corner : triangles[0]) {
        corner.normal = glm::vec3(0.0F, 0.6F, -0.8F);
    }
    for (test::Corner& corner : triangles[1]) {
        corner.normal = glm::vec3(0.0F);
    }
    const GeometryImage image = draw(test::map_triangles(triangles, 16, 16));
    EXPECT_EQ(image.shading_normal[15], glm::vec3(0.0F, -0.6F, 0.8F));
    EXPECT_EQ(image.shading_normal[15 * 16], glm::vec3(0.0F, 0.0F, 1.0F));
}

TEST_F(DrawGeometryImage, OnlyThePagesOwnTrianglesWithAreaInSpaceAreDrawn) {
    MappedSurface mapped = test::map_triangles(full_page(), 16, 16);
    mapped.atlas.pages.push_back({.name = "other", .width = 16, .height = 16});
    mapped.atlas.page[0] = 1;
    GeometryImage image = draw(mapped);
    EXPECT_EQ(image.triangle[15], GeometryImage::empty);
    EXPECT_EQ(image.triangle[15 * 16], 1U);
    mapped.surface.geometric_normals[1] = glm::vec3(0.0F);
    image = draw(mapped);
    EXPECT_EQ(image.triangle[15 * 16], GeometryImage::empty);
    EXPECT_EQ(image.position[15 * 16], glm::vec3(0.0F));
}

TEST_F(DrawGeometryImage, UvsOutsideThePageAreAnError) {
    std::vector<test::Triangle> triangles = full_page();
    triangles[1][1].uv.x = 1.5F;
    EXPECT_THROW(static_cast<void>(draw(test::map_triangles(triangles, 16, 16))), Error);
}

} // namespace
} // namespace vkbake
