// Ctrl-C. Until something is written there is nothing to lose and nothing to clean up: the process ends at once,
// whatever it is at. While files are written it is asked to stop, so that what was begun is removed.
#pragma once

#include "vkbake/progress.hpp"

namespace vkbake::cli {

/// From now on SIGINT and SIGTERM end the process with a line that says so and status 130.
void end_on_interrupt();

/// From now on they set a flag; a second one ends the process as it would have without us.
void stop_on_interrupt();
[[nodiscard]] bool interrupted();

/// For what writes files: stop_on_interrupt, and a callback that tells the flag.
[[nodiscard]] Progress stopping();

} // namespace vkbake::cli
