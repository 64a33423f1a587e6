// Where patches meet on the surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "atlas/crease_run.hpp"
#include "atlas/patches.hpp"

namespace vkbake {

/// Sides of the patch that have the other, by its name, across; the longest first.
[[nodiscard]] std::vector<std::uint32_t> common_sides(const Patches& patches, const Patch& patch, std::uint32_t other);

/// Adds those of the sides that are creases, as they run in the patch across.
void add_creases_across(const Patches& patches, std::span<const std::uint32_t> sides, CreaseRun& creases);

} // namespace vkbake
