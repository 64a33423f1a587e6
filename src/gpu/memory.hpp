// Device memory by what it is for. For src/gpu alone.
#pragma once

#include "gpu/state.hpp"

namespace vkbake::gpu {

/// `properties` receives what the memory that was found is like.
[[nodiscard]] vk::raii::DeviceMemory allocate(const Context::State& state, const vk::MemoryRequirements& requirements,
                                              Memory memory, vk::MemoryPropertyFlags& properties);

} // namespace vkbake::gpu
