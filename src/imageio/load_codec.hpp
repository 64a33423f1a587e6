// The module that reads and writes image files, loaded when it is first needed.
#pragma once

#include "codec/codec.hpp"

namespace vkbake {

/// Loads the module at the first call, which takes up to half a second, and keeps it as long as the process lives: what
/// it brings along is not made to be unloaded. Looked for beside this library (or program), then where the system
/// looks. Throws Error{bake_failed}, and tries again at the next call. Any thread may call it.
[[nodiscard]] const Codec& codec();

} // namespace vkbake
