// What the tracer asks of its settings.
#pragma once

#include "vkbake/settings.hpp"

namespace vkbake {

/// Throws Error{usage} where a setting of "Light" or "Machine" is out of range or contradicts another.
void check_trace_settings(const Settings& settings);

} // namespace vkbake
