#include "preview/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "vkbake/error.hpp"

namespace vkbake {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// How far points reach to both sides along one axis of the picture, each by the plane through the eye that touches
/// them.
struct Reach {
    double above = std::numeric_limits<double>::lowest();
    double below = std::numeric_limits<double>::lowest();

    void add(double across, double backward, double slope) {
        above = std::max(above, across + slope * backward);
        below = std::max(below, -across + slope * backward);
    }
    [[nodiscard]] double distance(double slope) const { return 0.5 * (above + below) / slope; }
    [[nodiscard]] double middle() const { return 0.5 * (above - below); }
};

std::string camera_names(const Scene& scene) {
    std::string names;
    for (const Camera& camera : scene.cameras) {
        names += (names.empty() ? "" : ", ") + ("'" + camera.name + "'");
    }
    return names.empty() ? "the scene has none" : "the scene has " + names;
}

} // namespace

std::vector<glm::dvec3> world_positions(const Scene& scene) {
    std::vector<glm::dvec3> points;
    for (const Instance& instance : scene.instances) {
        for (const Primitive& primitive : scene.meshes.at(instance.mesh).primitives) {
            std::vector<bool> used(primitive.positions.size(), false);
            for (const std::uint32_t index : primitive.indices) {
                used.at(index) = true;
            }
            for (std::size_t vertex = 0; vertex < used.size(); ++vertex) {
                if (used[vertex]) {
                    points.push_back(instance.linear * glm::dvec3(primitive.positions[vertex]) + instance.translation);
                }
            }
        }
    }
    return points;
}

Camera view_of_all(const std::vector<glm::dvec3>& points, double aspect) {
    constexpr double azimuth = 35.0 * degree;
    constexpr double elevation = 28.0 * degree;
    constexpr double margin = 0.04;
    Camera camera;
    camera.name = "overview";
    camera.vertical_field_of_view = 45.0 * degree;
    const glm::dvec3 backward(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                              std::cos(elevation) * std::cos(azimuth));
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), backward));
    camera.orientation = glm::dmat3(right, glm::cross(backward, right), backward);

    // For a fixed orientation the nearest eye from which all points are seen is exact: along each axis of the picture
    // the two bounding planes must touch the points.
    const double slope = std::tan(0.5 * camera.vertical_field_of_view) * (1.0 - margin);
    Reach across;
    Reach along;
    glm::dvec3 low(std::numeric_limits<double>::max());
    glm::dvec3 high(std::numeric_limits<double>::lowest());
    for (const glm::dvec3& point : points) {
        const glm::dvec3 eye = glm::transpose(camera.orientation) * point;
        across.add(eye.x, eye.z, slope * aspect);
        along.add(eye.y, eye.z, slope);
        low = glm::min(low, eye);
        high = glm::max(high, eye);
    }
    const double size = glm::length(high - low);
    const double nearest = high.z + (size > 0.0 ? 0.05 * size : 1.0); // also where all points lie in a line of sight
    const double distance = std::max({across.distance(slope * aspect), along.distance(slope), nearest});
    camera.position = camera.orientation * glm::dvec3(across.middle(), along.middle(), distance);
    camera.near_plane = 0.5 * (distance - high.z);
    return camera;
}

Camera choose_camera(const Scene& scene, const std::string& name, double aspect) {
    if (!name.empty()) {
        const auto found =
            std::ranges::find_if(scene.cameras, [&](const Camera& camera) { return camera.name == name; });
        if (found == scene.cameras.end()) {
            throw Error(ErrorKind::bad_input,
                        scene.name + ": no camera is named '" + name + "'; " + camera_names(scene));
        }
        return *found;
    }
    if (!scene.cameras.empty()) {
        return scene.cameras.front();
    }
    const std::vector<glm::dvec3> points = world_positions(scene);
    if (points.empty()) {
        throw Error(ErrorKind::bad_input, scene.name + ": has no triangles; give a scene with something to see");
    }
    return view_of_all(points, aspect);
}

glm::dvec3 to_eye(const Camera& camera, const glm::dvec3& position) {
    return glm::transpose(camera.orientation) * (position - camera.position);
}

glm::dmat4 projection(const Camera& camera, double aspect, double near, double far) {
    glm::dmat4 matrix(0.0); // columns
    if (camera.vertical_field_of_view > 0.0) {
        const double slope = std::tan(0.5 * camera.vertical_field_of_view);
        matrix[0][0] = 1.0 / (slope * aspect);
        matrix[1][1] = -1.0 / slope;
        matrix[3][2] = near;
        matrix[2][3] = -1.0;
    } else {
        const double half = 0.5 * camera.vertical_extent;
        matrix[0][0] = 1.0 / (half * aspect);
        matrix[1][1] = -1.0 / half;
        matrix[2][2] = 1.0 / (far - near);
        matrix[3][2] = far / (far - near);
        matrix[3][3] = 1.0;
    }
    return matrix;
}

glm::dvec3 direction_through(const Camera& camera, double aspect, const glm::dvec2& point) {
    if (camera.vertical_field_of_view <= 0.0) {
        return -camera.orientation[2];
    }
    const double slope = std::tan(0.5 * camera.vertical_field_of_view);
    const glm::dvec3 eye((2.0 * point.x - 1.0) * slope * aspect, (1.0 - 2.0 * point.y) * slope, -1.0);
    return glm::normalize(camera.orientation * eye);
}

} // namespace vkbake
