// A dense furnished interior.
#pragma once

#include "make_scenes/document.hpp"

namespace vkbake::scenes {

/// Five rooms, three of them under a roof and two under beams, furniture and small things in all of them. The camera
/// stands in the living room.
[[nodiscard]] Document make_furnished_apartment();

} // namespace vkbake::scenes
