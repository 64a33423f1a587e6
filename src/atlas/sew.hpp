// Joins pieces that do not fit each other rigidly.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "atlas/patches.hpp"
#include "atlas/rigid_motion.hpp"

namespace vkbake {

struct SewnPiece {
    std::vector<std::uint32_t> triangles;
    std::vector<glm::dvec2> places; ///< 3 a triangle
    double energy = 0.0;            ///< as Patch::energy
};

/// Both pieces as one, `second` brought to the first one's plane by `motion`: joined at all common sides that are no
/// creases, then relaxed. Nothing where the result breaks a limit, mirrors a triangle or overlaps itself. `second` may
/// be empty: then `first` is relaxed alone. Without rounds the pieces stay where they are.
[[nodiscard]] std::optional<SewnPiece> sew(Patches& patches, const Patch& first, const Patch& second,
                                           const RigidMotion& motion, const PatchLimits& limits, int rounds);

/// Lays a patch out that faces one way: as its shadow in its own plane, then relaxed. False where that breaks a limit.
/// Reads and writes of `patches` what is the patch's own, and reads whose the triangles beside it are.
[[nodiscard]] bool lay_out_patch(Patches& patches, Patch& patch, const PatchLimits& limits);

/// The motion that brings these sides as near to those across as can be: least squares, weighed by length.
[[nodiscard]] RigidMotion best_motion(const Patches& patches, std::span<const std::uint32_t> common);

/// Lays a patch out anew that has grown and is bent, if that succeeds. Whether it did. Reads and writes as above.
bool relax_patch(Patches& patches, Patch& patch, const PatchLimits& limits);

} // namespace vkbake
