// Names of objects that can be names of files.
#pragma once

#include <string>
#include <vector>

namespace vkbake {

/// For each name one of letters, digits, '-', '_' and '.', at most 80 long, not beginning with '.', and unlike every
/// other one even where case does not count. Equal names get "-2", "-3", … in order.
[[nodiscard]] std::vector<std::string> unique_file_names(const std::vector<std::string>& names);

} // namespace vkbake
