#include "atlas/common_sides.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace vkbake {

std::vector<std::uint32_t> common_sides(const Patches& patches, const Patch& patch, std::uint32_t other) {
    const ChartMesh& mesh = *patches.mesh;
    std::vector<std::uint32_t> sides;
    for (const std::uint32_t triangle : patch.triangles) {
        for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
            const std::uint32_t beyond = mesh.across[side];
            if (beyond != ChartMesh::none && patches.patch_of[beyond / 3] == other) {
                sides.push_back(side);
            }
        }
    }
    const auto length_of = [&](std::uint32_t side) {
        return glm::length(mesh.corner(next_corner(side)) - mesh.corner(side));
    };
    std::stable_sort(sides.begin(), sides.end(),
                     [&](std::uint32_t s, std::uint32_t t) { return length_of(s) > length_of(t); });
    return sides;
}

void add_creases_across(const Patches& patches, std::span<const std::uint32_t> sides, CreaseRun& creases) {
    for (const std::uint32_t side : sides) {
        if (patches.mesh->is_crease(side)) {
            const std::uint32_t beyond = patches.mesh->across[side];
            creases.add(patches.places[next_corner(beyond)] - patches.places[beyond]);
        }
    }
}

} // namespace vkbake
