// What Commands records into. For src/gpu alone.
#pragma once

#include "gpu/commands.hpp"
#include "gpu/state.hpp"

namespace vkbake::gpu {

struct Commands::State {
    Context::State& context;
};

/// A pipeline and what it expects to be bound.
struct Program {
    vk::raii::DescriptorSetLayout set_layout{nullptr};
    vk::raii::PipelineLayout layout{nullptr};
    vk::raii::Pipeline pipeline{nullptr};
    std::vector<Slot> slots;
    std::uint32_t constant_bytes = 0;
    vk::ShaderStageFlags stages;
};

} // namespace vkbake::gpu
