// JSON documents. The only place that names the JSON library.
#pragma once

#include <nlohmann/json.hpp>

namespace vkbake {

/// Keeps the order of a file's keys, so that what is read and written again stays as its author ordered it.
using Json = nlohmann::ordered_json;

} // namespace vkbake
