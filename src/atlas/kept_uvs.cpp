#include "atlas/kept_uvs.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>

#include "atlas/edge_graph.hpp"
#include "atlas/predicates.hpp"
#include "atlas/triangle_tree.hpp"
#include "base/parallel.hpp"

namespace vkbake {

namespace {

const SurfacePart& part_of(const Surface& surface, std::uint32_t triangle) {
    return surface.parts[surface.parts_of[triangle]];
}

std::string triangle_name(const Surface& surface, std::uint32_t triangle) {
    const SurfacePart& part = part_of(surface, triangle);
    return "triangle " + std::to_string(triangle - part.first_triangle) + " of primitive " +
           std::to_string(part.primitive);
}

/// Until the first fault.
std::optional<std::string> read_values(const Scene& scene, const Surface& surface,
                                       std::span<const std::uint32_t> triangles, std::span<glm::vec2> flat) {
    bool has_surface = false;
    bool has_uv_area = false;
    for (const std::uint32_t triangle : triangles) {
        const SurfacePart& part = part_of(surface, triangle);
        const std::uint32_t mesh = scene.instances[surface.objects[part.object].instance].mesh;
        const std::vector<glm::vec2>& uvs = scene.meshes[mesh].primitives[part.primitive].tex_coords[1];
        if (uvs.empty()) {
            return "is absent from primitive " + std::to_string(part.primitive);
        }
        FlatTriangle corners{};
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t corner = 3 * std::size_t{triangle} + c;
            if (surface.vertices[corner] >= uvs.size()) {
                return "has fewer values than vertices in primitive " + std::to_string(part.primitive);
            }
            const glm::vec2 uv = uvs[surface.vertices[corner]];
            if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
                return "is not finite at " + triangle_name(surface, triangle);
            }
            if (uv.x < 0.0F || uv.x > 1.0F || uv.y < 0.0F || uv.y > 1.0F) {
                return "leaves [0,1] at " + triangle_name(surface, triangle);
            }
            corners[c] = uv;
            flat[corner] = uv;
        }
        has_surface = has_surface || surface.geometric_normals[triangle] != glm::vec3(0.0F);
        has_uv_area = has_uv_area || orientation(corners) != 0;
    }
    if (has_surface && !has_uv_area) {
        return "has no area";
    }
    return std::nullopt;
}

} // namespace

UvFaults read_light_map_uvs(const Scene& scene, const Surface& surface, std::span<const std::uint32_t> triangles,
                            std::span<glm::vec2> flat) {
    UvFaults faults{.unusable = read_values(scene, surface, triangles, flat), .overlap = {}};
    if (const auto pair = faults.unusable ? std::nullopt : first_overlap(flat, triangles)) {
        faults.overlap =
            "overlaps itself: " + triangle_name(surface, pair->first) + " and " + triangle_name(surface, pair->second);
    }
    return faults;
}

std::optional<std::pair<std::uint32_t, std::uint32_t>> first_overlap(std::span<const glm::vec2> flat,
                                                                     std::span<const std::uint32_t> triangles) {
    const TriangleTree tree(flat, triangles);
    std::atomic<std::size_t> first = triangles.size();
    parallel_ranges(triangles.size(), 1024, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < std::min(end, first.load()); ++i) {
            if (tree.overlaps_any(triangles[i])) {
                std::size_t known = first;
                while (i < known && !first.compare_exchange_weak(known, i)) {
                }
            }
        }
    });
    if (first == triangles.size()) {
        return std::nullopt;
    }
    std::vector<std::uint32_t> overlapping;
    tree.visit_overlaps(triangles[first], [&](std::uint32_t other) {
        overlapping.push_back(other);
        return true;
    });
    return std::pair(triangles[first],
                     *std::find_first_of(triangles.begin(), triangles.end(), overlapping.begin(), overlapping.end()));
}

std::vector<std::vector<std::uint32_t>> uv_islands(std::span<const glm::vec2> flat,
                                                   std::span<const std::uint32_t> triangles) {
    std::vector<glm::vec2> corners;
    corners.reserve(3 * triangles.size());
    for (const std::uint32_t triangle : triangles) {
        const auto own = flat.subspan(3 * std::size_t{triangle}, 3);
        corners.insert(corners.end(), own.begin(), own.end());
    }
    const EdgeGraph graph(weld(std::span<const glm::vec2>(corners)));
    EdgeFlood flood(graph);
    std::vector<bool> taken(triangles.size(), false);
    std::vector<std::vector<std::uint32_t>> islands;
    for (std::uint32_t seed = 0; seed < triangles.size(); ++seed) {
        if (taken[seed]) {
            continue;
        }
        taken[seed] = true;
        islands.push_back(flood.collect(seed, [&](std::uint32_t triangle) {
            const bool admitted = !taken[triangle];
            taken[triangle] = true;
            return admitted;
        }));
        for (std::uint32_t& triangle : islands.back()) {
            triangle = triangles[triangle];
        }
    }
    return islands;
}

} // namespace vkbake
