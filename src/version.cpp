#include "vkbake/vkbake.hpp"

namespace vkbake {

std::string version() { return VKBAKE_VERSION; }

} // namespace vkbake
