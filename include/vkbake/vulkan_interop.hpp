// Bake on a Vulkan device of the caller's. The one public header that names Vulkan.
#pragma once

#include <cstdint>

#include <vulkan/vulkan_core.h>

#include "vkbake/device.hpp"

namespace vkbake {

/// Handles that the caller owns and keeps alive longer than the Device made from them.
/// The instance and device are of Vulkan 1.3; the queue has graphics and compute. Enabled features needed:
/// dynamicRendering, synchronization2, shaderFloat64 (and what adopt_device's error names).
struct VulkanHandles {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical_device = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    std::uint32_t queue_family = 0;
    /// The chain that vkCreateDevice was given: Vulkan cannot be asked what a device has enabled. Null: it is taken to
    /// have enabled what the passes need. Read during adopt_device only.
    const VkPhysicalDeviceFeatures2* enabled_features = nullptr;
    PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr; ///< null: the loader that this library is linked to
};

/// Submits to that queue only, from the thread that calls the library, and destroys nothing that it did not create.
/// Throws Error{no_device} that names the feature or limit which is missing.
[[nodiscard]] Device adopt_device(const VulkanHandles& handles);

} // namespace vkbake
