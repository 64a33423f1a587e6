// Triangles without area: they need a place, but no room.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace vkbake {

/// Folds each triangle that is in no chart onto one corner of a triangle that shares a vertex with it, or of any where
/// none does, and adds it to that chart; without any chart they are one of their own. `vertices` and `flat`: 3 a
/// triangle; `charts`: their triangles, which are ascending afterwards.
void fold_in(std::span<const std::uint32_t> vertices, std::span<glm::vec2> flat,
             std::vector<std::vector<std::uint32_t>>& charts);

} // namespace vkbake
