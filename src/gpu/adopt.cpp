// A device of the caller's (include/vkbake/vulkan_interop.hpp).
#include "gpu/state.hpp"
#include "vkbake/vulkan_interop.hpp"

namespace vkbake {

namespace {

[[noreturn]] void refuse(const std::string& reason) {
    throw Error(ErrorKind::no_device, "adopting a Vulkan device: " + reason);
}

/// The RAII classes destroy what they hold, and these handles are not ours: the calls that would do it are replaced.
/// The dispatchers are objects of our own that are handed out as const only.
void never_destroy(const vk::raii::Instance& instance, const vk::raii::Device& device) {
    using InstanceDispatcher = vk::raii::InstanceDispatcher;
    using DeviceDispatcher = vk::raii::DeviceDispatcher;
    // NOLINTBEGIN(cppcoreguidelines-pro-type-const-cast)
    const_cast<InstanceDispatcher*>(instance.getDispatcher())->vkDestroyInstance = [](VkInstance,
                                                                                      const VkAllocationCallbacks*) {};
    const_cast<DeviceDispatcher*>(device.getDispatcher())->vkDestroyDevice = [](VkDevice,
                                                                                const VkAllocationCallbacks*) {};
    // NOLINTEND(cppcoreguidelines-pro-type-const-cast)
}

void check_handles(const VulkanHandles& handles) {
    if (handles.instance == VK_NULL_HANDLE || handles.physical_device == VK_NULL_HANDLE ||
        handles.device == VK_NULL_HANDLE || handles.queue == VK_NULL_HANDLE) {
        refuse("a handle is null; give the instance, the physical device, the device and the queue");
    }
}

void check_device(const VulkanHandles& handles, const gpu::Context::State& state) {
    std::string missing;
    const auto add = [&](const std::string& reason) { missing += (missing.empty() ? "" : ", ") + reason; };
    for (const std::string& reason : gpu::refusals(state.physical_device)) {
        add(reason);
    }
    if (handles.enabled_features != nullptr) {
        for (const std::string& name : gpu::missing_features(*handles.enabled_features)) {
            add("feature " + name + " is not enabled");
        }
    }
    const auto families = state.physical_device.getQueueFamilyProperties();
    const vk::QueueFlags needed = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
    if (handles.queue_family >= families.size() || (families[handles.queue_family].queueFlags & needed) != needed) {
        add("the queue's family has not both graphics and compute");
    }
    const auto* calls = state.device.getDispatcher();
    if (calls->vkCmdBeginRendering == nullptr || calls->vkQueueSubmit2 == nullptr) {
        add("the device is not of Vulkan 1.3");
    }
    if (!missing.empty()) {
        refuse(missing + "; enable it, or let open_device make a device");
    }
}

std::shared_ptr<gpu::Instance> adopt_instance(const VulkanHandles& handles) {
    auto adopted = std::make_shared<gpu::Instance>();
    if (handles.get_instance_proc_addr != nullptr) {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): the dispatcher is our own object
        const_cast<vk::raii::ContextDispatcher*>(adopted->loader.getDispatcher())->vkGetInstanceProcAddr =
            handles.get_instance_proc_addr;
    }
    adopted->instance = vk::raii::Instance(adopted->loader, handles.instance);
    return adopted;
}

} // namespace

Device adopt_device(const VulkanHandles& handles) {
    check_handles(handles);
    const auto adopt = [&] {
        auto state = std::make_unique<gpu::Context::State>();
        state->instance = adopt_instance(handles);
        state->physical_device = vk::raii::PhysicalDevice(state->instance->instance, handles.physical_device);
        state->device = vk::raii::Device(state->physical_device, handles.device);
        never_destroy(state->instance->instance, state->device);
        state->queue = vk::raii::Queue(state->device, handles.queue);
        state->queue_family = handles.queue_family;
        check_device(handles, *state);
        gpu::complete(*state);
        return Device(std::make_shared<gpu::Context>(std::move(state)));
    };
    return gpu::translated("adopting a Vulkan device", adopt, ErrorKind::no_device);
}

} // namespace vkbake
