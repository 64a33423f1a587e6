// A device made by hand, as an engine would, and handed over.
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <vulkan/vulkan.h>

#include "gpu/context.hpp"
#include "vkbake/error.hpp"
#include "vkbake/vulkan_interop.hpp"

namespace vkbake {
namespace {

/// Instance, the loader's first device and its queue of graphics and compute, by Vulkan's own calls.
class OwnDevice {
public:
    explicit OwnDevice(bool dynamic_rendering) {
        VkApplicationInfo application{};
        application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
        application.apiVersion = VK_API_VERSION_1_3;
        VkInstanceCreateInfo instance{};
        instance.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
        instance.pApplicationInfo = &application;
        check(vkCreateInstance(&instance, nullptr, &handles.instance));
        std::uint32_t count = 1;
        vkEnumeratePhysicalDevices(handles.instance, &count, &handles.physical_device);
        find_family();

        m_features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
        m_features13.synchronization2 = VK_TRUE;
        m_features13.dynamicRendering = dynamic_rendering ? VK_TRUE : VK_FALSE;
        m_features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
        m_features.pNext = &m_features13;
        m_features.features.shaderFloat64 = VK_TRUE;
        const float priority = 1.0F;
        VkDeviceQueueCreateInfo queue{};
        queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
        queue.queueFamilyIndex = handles.queue_family;
        queue.queueCount = 1;
        queue.pQueuePriorities = &priority;
        VkDeviceCreateInfo device{};
        device.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
        device.pNext = &m_features;
        device.queueCreateInfoCount = 1;
        device.pQueueCreateInfos = &queue;
        check(vkCreateDevice(handles.physical_device, &device, nullptr, &handles.device));
        vkGetDeviceQueue(handles.device, handles.queue_family, 0, &handles.queue);
        handles.enabled_features = &m_features;
    }
    ~OwnDevice() {
        vkDestroyDevice(handles.device, nullptr);
        vkDestroyInstance(handles.instance, nullptr);
    }
    OwnDevice(const OwnDevice&) = delete;
    OwnDevice& operator=(const OwnDevice&) = delete;

    VulkanHandles handles;

private:
    static void check(VkResult result) {
        if (result != VK_SUCCESS) {
            throw std::runtime_error("Vulkan failed with " + std::to_string(result));
        }
    }

    void find_family() {
        std::uint32_t count = 0;
        vkGetPhysicalDeviceQueueFamilyProperties(handles.physical_device, &count, nullptr);
        std::vector<VkQueueFamilyProperties> families(count);
        vkGetPhysicalDeviceQueueFamilyProperties(handles.physical_device, &count, families.data());
        constexpr VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
        while ((families.at(handles.queue_family).queueFlags & needed) != needed) {
            ++handles.queue_family;
        }
    }

    VkPhysicalDeviceVulkan13Features m_features13{};
    VkPhysicalDeviceFeatures2 m_features{};
};

std::string refusal_of(const VulkanHandles& handles) {
    try {
        static_cast<void>(adopt_device(handles));
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::no_device);
        return error.what();
    }
    return "adopted";
}

TEST(Interop, AnAdoptedDeviceWorksAndOutlivesItsAdoption) {
    const OwnDevice own(true);
    for (int repeat = 0; repeat < 2; ++repeat) { // the second fails if the first destroyed what is not its own
        const Device device = adopt_device(own.handles);
        EXPECT_FALSE(device.name().empty());
        EXPECT_TRUE(device.context().arithmetic_is_exact());
    }
    EXPECT_EQ(vkDeviceWaitIdle(own.handles.device), VK_SUCCESS);
}

TEST(Interop, TheCallersLoaderIsUsed) {
    OwnDevice own(true);
    own.handles.get_instance_proc_addr = vkGetInstanceProcAddr;
    EXPECT_TRUE(adopt_device(own.handles).context().arithmetic_is_exact());
}

TEST(Interop, AFeatureThatIsNotEnabledIsNamed) {
    const OwnDevice own(false);
    EXPECT_NE(refusal_of(own.handles).find("feature dynamicRendering is not enabled"), std::string::npos)
        << refusal_of(own.handles);
}

TEST(Interop, ANullHandleIsRefused) {
    const OwnDevice own(true);
    VulkanHandles handles = own.handles;
    handles.queue = VK_NULL_HANDLE;
    EXPECT_NE(refusal_of(handles).find("null"), std::string::npos);
}

} // namespace
} // namespace vkbake
