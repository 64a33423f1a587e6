// The eight objects of the thesis's table 4.1, each with exactly its number of triangles.
#pragma once

#include "make_scenes/solid.hpp"

namespace vkbake::scenes {

[[nodiscard]] Model make_wall();   ///< 4999; the one that is not all closed: its core is open where it meets the ground
[[nodiscard]] Model make_cannon(); ///< 1350; the barrel along +Z, the trunnions' axis through the origin along X
[[nodiscard]] Model make_fire_hydrant(); ///< 4634
[[nodiscard]] Model make_storage_room(); ///< 1500; open to the front, +Z
[[nodiscard]] Model make_apartment();    ///< 504; without a ceiling, so that one looks in
[[nodiscard]] Model make_wheelbarrow();  ///< 1700; rolls along +Z
[[nodiscard]] Model make_cannon_mount(); ///< 766; for make_cannon at cannon_on_mount
[[nodiscard]] Model make_door();         ///< 5772; its front towards +Z

/// The room of the scene storage-room.glb, not one of the table's: three walls under open rafters, open to +Z.
[[nodiscard]] Model make_store();

/// Where the cannon's origin lies when it rests on the mount, metres.
inline constexpr glm::dvec3 cannon_on_mount{0.0, 0.62, 0.30};
inline constexpr double trunnion_radius = 0.055;

} // namespace vkbake::scenes
