// The compiled shaders, embedded at build time from spirv/.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace vkbake::gpu {

struct SpirvModule {
    std::string_view name; ///< its source's file name, e.g. "dilate.comp"
    std::span<const std::uint32_t> words;
};

/// Sorted by name.
[[nodiscard]] std::span<const SpirvModule> spirv_modules();

} // namespace vkbake::gpu
