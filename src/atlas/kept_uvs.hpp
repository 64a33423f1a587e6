// Whether a mesh's own light-map UVs will do.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "vkbake/scene.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Why TEXCOORD_1 will not do, in words that fit after "TEXCOORD_1 ". Triangles are named by their numbers in their
/// primitives.
struct UvFaults {
    /// A primitive lacks it, a value that is used is not finite or not in [0,1], or it has no area where the object
    /// has.
    std::optional<std::string> unusable;
    /// Two triangles overlap (exactly, whatever the size of the map; mirrored triangles are no fault).
    std::optional<std::string> overlap;

    /// The graver one; nothing where it will do.
    [[nodiscard]] const std::optional<std::string>& any() const { return unusable ? unusable : overlap; }
};

/// Reads TEXCOORD_1 for these triangles (all of one object, ascending) into `flat`, three a triangle; all of them
/// unless it is unusable.
[[nodiscard]] UvFaults read_light_map_uvs(const Scene& scene, const Surface& surface,
                                          std::span<const std::uint32_t> triangles, std::span<glm::vec2> flat);

/// The first two of these triangles whose UVs overlap; nothing where none do. Exact. "First" follows the order given.
[[nodiscard]] std::optional<std::pair<std::uint32_t, std::uint32_t>>
first_overlap(std::span<const glm::vec2> flat, std::span<const std::uint32_t> triangles);

/// Cuts kept UVs into connected pieces: triangles that share an edge in UV space.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> uv_islands(std::span<const glm::vec2> flat,
                                                                 std::span<const std::uint32_t> triangles);

} // namespace vkbake
