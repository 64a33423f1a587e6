#include "preview/camera.hpp"

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "vkbake/error.hpp"

namespace {

using vkbake::Camera;

/// Where a world position falls in the picture, −1 … 1 to the right and downwards, by the textbook's formula.
glm::dvec2 place_of(const Camera& camera, double aspect, const glm::dvec3& world) {
    const glm::dvec3 eye = glm::transpose(camera.orientation) * (world - camera.position);
    const double slope = std::tan(0.5 * camera.vertical_field_of_view);
    return {eye.x / (-eye.z * slope * aspect), -eye.y / (-eye.z * slope)};
}

std::vector<glm::dvec3> box_corners(const glm::dvec3& low, const glm::dvec3& high) {
    std::vector<glm::dvec3> corners;
    corners.reserve(8);
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                             (i & 4) != 0 ? high.z : low.z);
    }
    return corners;
}

void expect_framed(const std::vector<glm::dvec3>& points, double aspect) {
    const Camera camera = vkbake::view_of_all(points, aspect);
    double farthest = 0.0;
    for (const glm::dvec3& point : points) {
        EXPECT_LT(vkbake::to_eye(camera, point).z, -camera.near_plane);
        const glm::dvec2 place = place_of(camera, aspect, point);
        farthest = std::max({farthest, std::abs(place.x), std::abs(place.y)});
    }
    EXPECT_LE(farthest, 0.9600001);
    EXPECT_GE(farthest, 0.9599999) << "the scene could be shown larger";
}

TEST(PreviewCamera, ShowsAWholeBoxAndNoSmallerThanNeeded) {
    for (const double aspect : {0.4, 1.0, 16.0 / 9.0, 4.0}) {
        expect_framed(box_corners({-1.0, 0.0, -1.0}, {1.0, 2.0, 1.0}), aspect);
        expect_framed(box_corners({1e6, 1e6, 1e6}, {1e6 + 3.0, 1e6 + 0.5, 1e6 + 40.0}), aspect);
        expect_framed(box_corners({-1e-4, 0.0, 0.0}, {1e-4, 1e-5, 1e-4}), aspect);
        expect_framed(box_corners({-500.0, 0.0, -500.0}, {500.0, 0.0, 500.0}), aspect);
    }
}

TEST(PreviewCamera, LooksFromTheFrontTheRightAndAbove) {
    const Camera camera = vkbake::view_of_all(box_corners(glm::dvec3(-1.0), glm::dvec3(1.0)), 1.5);
    EXPECT_GT(camera.position.x, 1.0);
    EXPECT_GT(camera.position.y, 1.0);
    EXPECT_GT(camera.position.z, 1.0);
    EXPECT_DOUBLE_EQ(camera.orientation[0].y, 0.0) << "the horizon is level";
    EXPECT_GT(camera.orientation[1].y, 0.0);
    const glm::dmat3 product = glm::transpose(camera.orientation) * camera.orientation;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            EXPECT_NEAR(product[i][j], i == j ? 1.0 : 0.0, 1e-15);
        }
    }
    EXPECT_NEAR(glm::determinant(camera.orientation), 1.0, 1e-15);
}

TEST(PreviewCamera, StaysClearOfAPointAndOfALineOfSight) {
    const Camera at_point = vkbake::view_of_all({{3.0, 4.0, 5.0}}, 1.0);
    EXPECT_LT(vkbake::to_eye(at_point, {3.0, 4.0, 5.0}).z, -at_point.near_plane);
    const glm::dvec3 backward = at_point.orientation[2];
    const Camera along = vkbake::view_of_all({glm::dvec3(0.0), 10.0 * backward}, 1.0);
    EXPECT_LT(vkbake::to_eye(along, 10.0 * backward).z, -along.near_plane);
}

TEST(PreviewCamera, ProjectsToVulkansClipSpace) {
    Camera camera;
    camera.vertical_field_of_view = std::acos(0.0); // 90°: the view's half height is its depth
    const glm::dmat4 matrix = vkbake::projection(camera, 2.0, 0.5, 100.0);
    const glm::dvec4 upper_right = matrix * glm::dvec4(6.0, 3.0, -3.0, 1.0);
    EXPECT_NEAR(upper_right.x / upper_right.w, 1.0, 1e-15);
    EXPECT_NEAR(upper_right.y / upper_right.w, -1.0, 1e-15) << "Vulkan's y points down";
    const glm::dvec4 nearest = matrix * glm::dvec4(0.0, 0.0, -0.5, 1.0);
    EXPECT_DOUBLE_EQ(nearest.z / nearest.w, 1.0);
    const glm::dvec4 far = matrix * glm::dvec4(0.0, 0.0, -100.0, 1.0);
    EXPECT_GT(far.z / far.w, 0.0);
    EXPECT_LT(far.z / far.w, nearest.z / nearest.w);

    camera.vertical_field_of_view = 0.0;
    camera.vertical_extent = 4.0;
    const glm::dmat4 flat = vkbake::projection(camera, 2.0, 0.5, 100.0);
    const glm::dvec4 corner = flat * glm::dvec4(4.0, 2.0, -50.0, 1.0);
    EXPECT_DOUBLE_EQ(corner.x, 1.0);
    EXPECT_DOUBLE_EQ(corner.y, -1.0);
    EXPECT_DOUBLE_EQ(corner.w, 1.0);
    EXPECT_DOUBLE_EQ((flat * glm::dvec4(0.0, 0.0, -0.5, 1.0)).z, 1.0);
    EXPECT_NEAR((flat * glm::dvec4(0.0, 0.0, -100.0, 1.0)).z, 0.0, 1e-15);
}

TEST(PreviewCamera, DirectionsGoThroughWhatIsProjectedThere) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const double aspect = 1.7;
    const Camera camera = vkbake::view_of_all(box_corners(glm::dvec3(-1.0), glm::dvec3(2.0)), aspect);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 world(unit(random), unit(random), unit(random));
        const glm::dvec2 point = 0.5 * place_of(camera, aspect, world) + 0.5;
        const glm::dvec3 direction = vkbake::direction_through(camera, aspect, point);
        EXPECT_NEAR(glm::distance(direction, glm::normalize(world - camera.position)), 0.0, 1e-12);
    }
}

vkbake::Scene scene_with(const std::vector<std::string>& names) {
    vkbake::Scene scene;
    scene.name = "room";
    for (const std::string& name : names) {
        scene.cameras.emplace_back();
        scene.cameras.back().name = name;
    }
    return scene;
}

TEST(PreviewCamera, IsChosenByNameOrTheFirst) {
    const vkbake::Scene scene = scene_with({"door", "window"});
    EXPECT_EQ(vkbake::choose_camera(scene, "window", 1.0).name, "window");
    EXPECT_EQ(vkbake::choose_camera(scene, "", 1.0).name, "door");
}

TEST(PreviewCamera, UnknownNameIsAnErrorThatListsTheKnownOnes) {
    try {
        (void)vkbake::choose_camera(scene_with({"door", "window"}), "roof", 1.0);
        FAIL() << "found a camera that is not there";
    } catch (const vkbake::Error& error) {
        EXPECT_EQ(error.kind(), vkbake::ErrorKind::bad_input);
        for (const char* const word : {"room", "roof", "door", "window"}) {
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
    }
}

TEST(PreviewCamera, SceneWithoutTrianglesHasNoView) {
    EXPECT_THROW((void)vkbake::choose_camera(scene_with({}), "", 1.0), vkbake::Error);
}

TEST(PreviewCamera, OnlyVerticesOfTrianglesCount) {
    vkbake::Scene scene;
    vkbake::Primitive primitive;
    primitive.positions = {{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {1e9F, 0.0F, 0.0F}};
    primitive.indices = {0, 1, 2};
    scene.meshes.emplace_back();
    scene.meshes[0].primitives.push_back(primitive);
    scene.instances.emplace_back();
    scene.instances[0].linear = glm::dmat3(2.0);
    scene.instances[0].translation = {10.0, 0.0, 0.0};
    EXPECT_EQ(vkbake::world_positions(scene),
              (std::vector<glm::dvec3>{{10.0, 0.0, 0.0}, {12.0, 0.0, 0.0}, {10.0, 2.0, 0.0}}));
}

} // namespace
