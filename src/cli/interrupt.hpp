// Ctrl-C, asked for and not acted on at once.
#pragma once

namespace vkbake::cli {

/// From now on SIGINT and SIGTERM set a flag; a second one ends the process as it would have without us.
void catch_interrupts();
[[nodiscard]] bool interrupted();

} // namespace vkbake::cli
