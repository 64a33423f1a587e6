// The Vulkan instance and what it is asked about devices. For src/gpu alone.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/messages.hpp"
#include "gpu/vulkan.hpp"

namespace vkbake::gpu {

/// The order of the members is the order in which they may be destroyed, from the last to the first.
struct Instance {
    std::unique_ptr<Messages> messages = std::make_unique<Messages>(); ///< outlives what reports to it
    vk::raii::Context loader;
    vk::raii::Instance instance{nullptr};
    vk::raii::DebugUtilsMessengerEXT messenger{nullptr};
};

/// Whether the environment variable VKBAKE_VALIDATION asks for the validation layers.
[[nodiscard]] bool validation_from_environment();

/// Throws Error{no_device} where there is no loader, no Vulkan 1.3, or no validation layer although it is asked for.
[[nodiscard]] std::shared_ptr<Instance> make_instance(bool validation);

/// The features that the passes need, chained for vkCreateDevice.
using Features = vk::StructureChain<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan13Features>;
[[nodiscard]] Features needed_features();

/// Names of needed features that the chain does not hold.
[[nodiscard]] std::vector<std::string> missing_features(const VkPhysicalDeviceFeatures2& chain);

/// Why the device will not do, a line each; empty: it will.
[[nodiscard]] std::vector<std::string> refusals(const vk::raii::PhysicalDevice& device);

/// A family with graphics and compute.
[[nodiscard]] std::optional<std::uint32_t> find_queue_family(const vk::raii::PhysicalDevice& device);

} // namespace vkbake::gpu
