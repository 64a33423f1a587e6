#include <limits>
#include <variant>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "test_images.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake {
namespace {

using test::filled;
using test::message_of;
using test::TemporaryFolder;

/// The direction through the middle of texel (x, y) of a face: the table of the Vulkan specification, chapter "Cube Map
/// Face Selection and Transformations" (s_c, t_c, r_c for each face), solved for the direction.
glm::vec3 direction_of(int face, int x, int y, int side) {
    const float s = (static_cast<float>(2 * x) + 1.0F) / static_cast<float>(side) - 1.0F;
    const float t = (static_cast<float>(2 * y) + 1.0F) / static_cast<float>(side) - 1.0F;
    switch (face) {
    case 0:
        return {1.0F, -t, -s};
    case 1:
        return {-1.0F, -t, s};
    case 2:
        return {s, 1.0F, t};
    case 3:
        return {s, -1.0F, -t};
    case 4:
        return {s, -t, 1.0F};
    default:
        return {-s, -t, -1.0F};
    }
}

/// A colour from which the direction can be told.
glm::vec4 color_of(const glm::vec3& direction) { return {glm::normalize(direction) * 0.5F + 0.5F, 1.0F}; }

/// A layout as a person would draw it: each face by the direction at its upper left corner's side and along its axes.
struct Drawn {
    int column;
    int row;
    glm::vec3 outward;
    glm::vec3 right; ///< of the picture, when looking from inside the cube
    glm::vec3 down;
};

const glm::vec3 x_axis{1, 0, 0};
const glm::vec3 y_axis{0, 1, 0};
const glm::vec3 z_axis{0, 0, 1};

Image draw(int columns, int rows, int side, const std::vector<Drawn>& faces) {
    Image picture = filled(columns * side, rows * side, {-5.0F, std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F});
    for (const Drawn& face : faces) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const float s = (static_cast<float>(2 * x) + 1.0F) / static_cast<float>(side) - 1.0F;
                const float t = (static_cast<float>(2 * y) + 1.0F) / static_cast<float>(side) - 1.0F;
                picture.texels[picture.index(face.column * side + x, face.row * side + y)] =
                    color_of(face.outward + s * face.right + t * face.down);
            }
        }
    }
    return picture;
}

void expect_directions(const Sky& sky, int side) {
    EXPECT_TRUE(sky.notes.empty()) << sky.notes.front(); // cells of a cross without a face are not looked at
    const auto* cube = std::get_if<CubeSky>(&sky.source);
    ASSERT_NE(cube, nullptr);
    for (int face = 0; face < 6; ++face) {
        const Image& image = cube->faces.at(static_cast<std::size_t>(face));
        ASSERT_EQ(image.width, side);
        ASSERT_EQ(image.height, side);
        ASSERT_EQ(image.texels.size(), static_cast<std::size_t>(side * side));
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const glm::vec4 error = image.texels[image.index(x, y)] - color_of(direction_of(face, x, y, side));
                EXPECT_LT(glm::length(error), 1e-6F) << "face " << face << " at " << x << ", " << y;
            }
        }
    }
}

/// A horizontal cross folds to a cube seen from inside: the row in the middle turns about +Y, +Y stands above +Z, −Y
/// below. Seen from inside with +Y up and looking along +Z, the right is +X in a left-handed cube map's picture.
const std::vector<Drawn> horizontal_cross{{1, 0, y_axis, x_axis, z_axis},    {0, 1, -x_axis, z_axis, -y_axis},
                                          {1, 1, z_axis, x_axis, -y_axis},   {2, 1, x_axis, -z_axis, -y_axis},
                                          {3, 1, -z_axis, -x_axis, -y_axis}, {1, 2, -y_axis, x_axis, -z_axis}};
/// The vertical one continues below −Y: there −Z has +X to its right still, and its top is at −Y.
const std::vector<Drawn> vertical_cross{{1, 0, y_axis, x_axis, z_axis},   {0, 1, -x_axis, z_axis, -y_axis},
                                        {1, 1, z_axis, x_axis, -y_axis},  {2, 1, x_axis, -z_axis, -y_axis},
                                        {1, 2, -y_axis, x_axis, -z_axis}, {1, 3, -z_axis, x_axis, y_axis}};

TEST(Sky, Crosses) {
    const TemporaryFolder folder;
    write_image(folder / "horizontal.exr", draw(4, 3, 3, horizontal_cross));
    expect_directions(load_sky((folder / "horizontal.exr").string()), 3);
    write_image(folder / "vertical.exr", draw(3, 4, 3, vertical_cross));
    expect_directions(load_sky((folder / "vertical.exr").string()), 3);
}

TEST(Sky, StripsAndSixFiles) {
    const TemporaryFolder folder;
    const int side = 3;
    Image wide = filled(6 * side, side, glm::vec4(0.0F));
    Image high = filled(side, 6 * side, glm::vec4(0.0F));
    std::string list;
    for (int face = 0; face < 6; ++face) {
        Image single = filled(side, side, glm::vec4(0.0F));
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const glm::vec4 color = color_of(direction_of(face, x, y, side));
                single.texels[single.index(x, y)] = color;
                wide.texels[wide.index(face * side + x, y)] = color;
                high.texels[high.index(x, face * side + y)] = color;
            }
        }
        const std::filesystem::path file = folder / ("face" + std::to_string(face) + ".exr");
        write_image(file, single);
        list.append(face == 0 ? "" : ",").append(file.string());
    }
    write_image(folder / "wide.exr", wide);
    write_image(folder / "high.exr", high);
    expect_directions(load_sky((folder / "wide.exr").string()), side);
    expect_directions(load_sky((folder / "high.exr").string()), side);
    expect_directions(load_sky(list), side);
    EXPECT_EQ(load_sky(list).name, list);
}

TEST(Sky, EquirectangularStaysAsItIs) {
    const TemporaryFolder folder;
    Image image = filled(4, 2, {0.0F, 0.0F, 0.0F, 1.0F});
    image.texels[image.index(2, 0)] = {5.0F, 6.0F, 7.0F, 1.0F};
    write_image(folder / "sky, with a comma.exr", image);
    const Sky sky = load_sky((folder / "sky, with a comma.exr").string());
    const auto* equirectangular = std::get_if<EquirectangularSky>(&sky.source);
    ASSERT_NE(equirectangular, nullptr);
    EXPECT_EQ(equirectangular->image.texels, image.texels);
    EXPECT_TRUE(sky.notes.empty());
}

TEST(Sky, ValuesThatAreNoRadianceAreReplacedAndCounted) {
    const TemporaryFolder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    Image image = filled(4, 2, {1.0F, 2.0F, 3.0F, 1.0F});
    image.texels[0] = {nan, -1.0F, infinity, 1.0F};
    image.texels[1] = {-infinity, 1e30F, infinity, nan};
    write_image(folder / "sky.exr", image);
    const Sky sky = load_sky((folder / "sky.exr").string());
    const Image& read = std::get<EquirectangularSky>(sky.source).image;
    EXPECT_EQ(read.texels[0], glm::vec4(0.0F, 0.0F, 1e30F, 1.0F));
    EXPECT_EQ(read.texels[1], glm::vec4(0.0F, 1e30F, 1e30F, 1.0F));
    EXPECT_EQ(read.texels[2], glm::vec4(1.0F, 2.0F, 3.0F, 1.0F));
    ASSERT_EQ(sky.notes.size(), 3U);
    EXPECT_NE(sky.notes[0].find("1 values were NaN"), std::string::npos) << sky.notes[0];
    EXPECT_NE(sky.notes[1].find("2 values were negative"), std::string::npos) << sky.notes[1];
    EXPECT_NE(sky.notes[2].find("2 values were infinite"), std::string::npos) << sky.notes[2];
}

TEST(Sky, ColoursAndTheBuiltInSky) {
    EXPECT_TRUE(std::holds_alternative<ClearSky>(load_sky("clear").source));
    const Sky sky = load_sky("1, 0.5,2e3");
    ASSERT_TRUE(std::holds_alternative<ConstantSky>(sky.source));
    EXPECT_EQ(std::get<ConstantSky>(sky.source).radiance, glm::vec3(1.0F, 0.5F, 2000.0F));
    EXPECT_EQ(sky.name, "1, 0.5,2e3");
}

TEST(Sky, RefusesWhatIsNone) {
    const TemporaryFolder folder;
    for (const char* text : {"", "1,2", "1,2,x", "1,2,-3", "1,2,inf", "1,nan,1", "1,2,3,4,5,6", "no-such-file.exr"}) {
        message_of(ErrorKind::bad_input, [&] { (void)load_sky(text); });
    }
    write_image(folder / "odd.exr", filled(5, 3, glm::vec4(1.0F)));
    const std::string message =
        message_of(ErrorKind::bad_input, [&] { (void)load_sky((folder / "odd.exr").string()); });
    EXPECT_NE(message.find("5 × 3"), std::string::npos) << message;
    EXPECT_NE(message.find("2:1"), std::string::npos) << message;
    write_image(folder / "a.exr", filled(2, 2, glm::vec4(1.0F)));
    write_image(folder / "b.exr", filled(3, 3, glm::vec4(1.0F)));
    const std::string a = (folder / "a.exr").string();
    message_of(ErrorKind::bad_input,
               [&] { (void)load_sky(a + "," + a + "," + a + "," + a + "," + a + "," + (folder / "b.exr").string()); });
}

} // namespace
} // namespace vkbake
