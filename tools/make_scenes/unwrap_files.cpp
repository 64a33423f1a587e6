// Meshes that are hard on whoever makes light-map UVs: only benchmarks use them.
#include <cmath>
#include <numbers>

#include "make_scenes/files.hpp"
#include "make_scenes/shapes.hpp"
#include "make_scenes/stage.hpp"
#include "make_scenes/textures.hpp"

namespace vkbake::scenes {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

/// One closed surface, curved everywhere, without a crease: 1,000,000 triangles.
File pebble() {
    constexpr int rings = 501; // between the poles
    constexpr int around = 1000;
    constexpr double size = 8.0; // metres
    std::vector<Ring> skin{{{0.0, -size, 0.0}}};
    for (int ring = 1; ring <= rings - 1; ++ring) {
        const double polar = 0.5 * full_turn * ring / rings;
        Ring points;
        for (int k = 0; k < around; ++k) {
            const double angle = full_turn * k / around;
            const double radius = size + size * std::sin(polar) *
                                             (0.12 * std::sin(9.0 * angle + 3.0 * std::cos(5.0 * polar)) +
                                              0.05 * std::cos(23.0 * polar) * std::sin(31.0 * angle));
            points.emplace_back(radius * std::sin(polar) * std::cos(angle), -radius * std::cos(polar),
                                -radius * std::sin(polar) * std::sin(angle));
        }
        skin.push_back(std::move(points));
    }
    skin.push_back({{0.0, size, 0.0}});
    Document document;
    Stage stage(document);
    Model model{"pebble", {}};
    model.add(facing_outward(loft(skin, Paint::white)));
    stage.place("pebble", stage.mesh(model), glm::dvec3(0.0));
    return {"pebble-1m.glb", document.to_glb()};
}

/// 100,000 cups of ten triangles, turned and sized differently: nothing hangs together with anything else.
File cups() {
    constexpr int columns = 400;
    constexpr int rows = 250;
    Patch patch{.paint = Paint::white};
    for (std::uint32_t island = 0; island < columns * rows; ++island) {
        const std::uint32_t row = island / columns;
        const glm::dvec3 middle(0.3 * (island % columns), 0.0, 0.3 * row);
        const double radius = 0.04 + 0.08 * random_of(3 * island);
        const double height = (random_of(3 * island + 1) - 0.5) * radius;
        const auto first = static_cast<std::uint32_t>(patch.positions.size());
        const auto add_point = [&](const glm::dvec3& offset, const glm::dvec3& normal) {
            patch.positions.emplace_back(middle + offset);
            patch.normals.emplace_back(normal);
        };
        add_point({0.0, height, 0.0}, {0.0, 1.0, 0.0});
        for (std::uint32_t k = 0; k < 10; ++k) {
            const double angle = full_turn * (k / 10.0 + random_of(3 * island + 2));
            const glm::dvec3 outward(std::cos(angle), 0.0, -std::sin(angle));
            add_point(radius * outward, unit(height * outward + glm::dvec3(0.0, radius, 0.0)));
            patch.indices.insert(patch.indices.end(), {first, first + 1 + k, first + 1 + (k + 1) % 10});
        }
    }
    Document document;
    Stage stage(document);
    stage.place("cups", document.add_mesh("cups", {patch}), glm::dvec3(0.0));
    return {"cups-1m.glb", document.to_glb()};
}

} // namespace

std::vector<File> make_unwrap_files() { return {pebble(), cups()}; }

} // namespace vkbake::scenes
