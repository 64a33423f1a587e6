#include "probe_balls.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/elementary.hpp"
#include "base/json.hpp"
#include "vkbake/error.hpp"
#include "vkbake_light.h"

namespace vkbake {

namespace {

constexpr double radius_share = 0.015; ///< of the scene's diagonal
constexpr int ball_columns = 32;       ///< of its sides, and of its map's texels
constexpr int ball_rows = 16;

/// Towards a place of the ball's map, (0, 0) its upper left corner: +Y on top.
glm::dvec3 ball_direction(double u, double v) {
    const SineCosine around = sine_cosine_degrees(360.0 * u);
    const SineCosine down = sine_cosine_degrees(180.0 * v);
    return {down.sine * around.cosine, down.cosine, -down.sine * around.sine};
}

Primitive unit_ball() {
    Primitive ball;
    for (int row = 0; row <= ball_rows; ++row) {
        for (int column = 0; column <= ball_columns; ++column) {
            const double u = static_cast<double>(column) / ball_columns;
            const double v = static_cast<double>(row) / ball_rows;
            ball.positions.emplace_back(ball_direction(u, v));
            ball.tex_coords[1].emplace_back(u, v);
            if (row < ball_rows && column < ball_columns) {
                const auto first = static_cast<std::uint32_t>(row * (ball_columns + 1) + column);
                const std::uint32_t below = first + ball_columns + 1;
                ball.indices.insert(ball.indices.end(), {first, below, first + 1, first + 1, below, below + 1});
            }
        }
    }
    ball.normals = ball.positions;
    return ball;
}

Image ball_map(const LightProbe& probe) {
    std::array<glm::vec3, 9> coefficients = probe.coefficients;
    Image map{.width = ball_columns, .height = ball_rows, .texels = {}, .coverage = {}};
    for (int row = 0; row < ball_rows; ++row) {
        for (int column = 0; column < ball_columns; ++column) {
            const glm::dvec3 normal = ball_direction((column + 0.5) / ball_columns, (row + 0.5) / ball_rows);
            map.texels.emplace_back(shared::vkbake_probe_light(coefficients.data(), glm::vec3(normal)), 1.0F);
        }
    }
    return map;
}

double diagonal_of(const Scene& scene) {
    bool first = true;
    glm::dvec3 low(0.0);
    glm::dvec3 high(0.0);
    for (const Instance& instance : scene.instances) {
        for (const Primitive& primitive : scene.meshes.at(instance.mesh).primitives) {
            for (const glm::vec3& position : primitive.positions) {
                const glm::dvec3 place = instance.linear * glm::dvec3(position) + instance.translation;
                low = first ? place : glm::min(low, place);
                high = first ? place : glm::max(high, place);
                first = false;
            }
        }
    }
    return glm::length(high - low);
}

glm::dvec3 vector_from(const Json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

} // namespace

std::vector<LightProbe> read_probes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw Error(ErrorKind::bad_input, file.string() + ": no light probes are there; bake a scene that has some");
    }
    try {
        std::vector<LightProbe> probes;
        const Json json = Json::parse(stream);
        for (const Json& entry : json.at("probes")) {
            LightProbe probe{.name = entry.value("name", std::string()),
                             .position = vector_from(entry.at("position")),
                             .back_sides = entry.value("back_sides", 0.0)};
            for (std::size_t i = 0; i < probe.coefficients.size(); ++i) {
                probe.coefficients[i] = glm::vec3(vector_from(entry.at("coefficients").at(i)));
            }
            probes.push_back(std::move(probe));
        }
        return probes;
    } catch (const Json::exception& error) {
        throw Error(ErrorKind::bad_input, file.string() + ": " + error.what() + "; bake the scene again");
    }
}

void add_probe_balls(std::span<const LightProbe> probes, Scene& scene, PreviewImages& images) {
    const double radius = radius_share * diagonal_of(scene);
    for (const LightProbe& probe : probes) {
        Primitive ball = unit_ball();
        ball.material = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back({.name = probe.name, .light_map = LightMapUse{.texture = {.tex_coord = 1}}});
        images.light_map_of.push_back(static_cast<std::uint32_t>(images.light_maps.size()));
        images.light_maps.push_back(ball_map(probe));
        Instance instance;
        instance.name = probe.name;
        instance.mesh = static_cast<std::uint32_t>(scene.meshes.size());
        instance.linear = glm::dmat3(radius);
        instance.translation = probe.position;
        scene.instances.push_back(std::move(instance));
        scene.meshes.push_back({.name = probe.name, .primitives = {std::move(ball)}});
    }
}

} // namespace vkbake
