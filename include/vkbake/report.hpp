// The results' JSON forms: what `--json` prints. Keys are the fields' names.
#pragma once

#include <string>
#include <vector>

#include "vkbake/compare.hpp"
#include "vkbake/device.hpp"
#include "vkbake/inspect.hpp"
#include "vkbake/lightmap.hpp"
#include "vkbake/uv_report.hpp"

namespace vkbake {

/// Each is one JSON object, indented by two, without a final newline.
[[nodiscard]] std::string to_json(const Inspection& inspection);
/// Without the UVs themselves.
[[nodiscard]] std::string to_json(const UvReport& report);
[[nodiscard]] std::string to_json(const Comparison& comparison);
[[nodiscard]] std::string to_json(const std::vector<DeviceReport>& devices);
/// A summary of a bake: device, sky, maps with their statistics, stages, notes (no images).
[[nodiscard]] std::string to_json(const Bake& bake);

} // namespace vkbake
