// A renderer that bakes a scene held in memory, on the Vulkan device that it has already, and reads the light map back.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include <vulkan/vulkan.h>

#include "vkbake/vkbake.hpp"
#include "vkbake/vulkan_interop.hpp"

namespace {

/// A floor of 2 m × 2 m: nothing occludes it, so every texel is 1 under a white sky.
vkbake::Scene floor_scene() {
    vkbake::Scene scene;
    scene.name = "floor";
    vkbake::Primitive quad;
    quad.positions = {{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}};
    quad.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back({"floor", {quad}, 0});
    vkbake::Instance instance;
    instance.name = "floor";
    scene.instances.push_back(instance);
    return scene;
}

bool check(VkResult result, const char* what) {
    if (result != VK_SUCCESS) {
        std::fprintf(stderr, "%s failed: %d\n", what, static_cast<int>(result));
    }
    return result == VK_SUCCESS;
}

/// The first queue family with graphics and compute; -1 if there is none.
int find_queue_family(VkPhysicalDevice physical_device) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical_device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical_device, &count, families.data());
    constexpr VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t family = 0; family < count; ++family) {
        if ((families[family].queueFlags & needed) == needed) {
            return static_cast<int>(family);
        }
    }
    return -1;
}

bool create_device(vkbake::VulkanHandles& handles) {
    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo instance_info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    instance_info.pApplicationInfo = &application;
    if (!check(vkCreateInstance(&instance_info, nullptr, &handles.instance), "vkCreateInstance")) {
        return false;
    }
    std::uint32_t count = 1;
    const VkResult listed = vkEnumeratePhysicalDevices(handles.instance, &count, &handles.physical_device);
    if (count == 0 || (listed != VK_SUCCESS && listed != VK_INCOMPLETE)) {
        std::fprintf(stderr, "no Vulkan device\n");
        return false;
    }
    const int family = find_queue_family(handles.physical_device);
    if (family < 0) {
        return false;
    }
    handles.queue_family = static_cast<std::uint32_t>(family);
    const float priority = 1.0F;
    VkDeviceQueueCreateInfo queue_info{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue_info.queueFamilyIndex = handles.queue_family;
    queue_info.queueCount = 1;
    queue_info.pQueuePriorities = &priority;
    // Everything that the device has: what a bake needs is among it, or adopt_device says what is not.
    VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
    features.pNext = &features13;
    vkGetPhysicalDeviceFeatures2(handles.physical_device, &features);
    VkDeviceCreateInfo device_info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    device_info.pNext = &features;
    device_info.queueCreateInfoCount = 1;
    device_info.pQueueCreateInfos = &queue_info;
    if (!check(vkCreateDevice(handles.physical_device, &device_info, nullptr, &handles.device), "vkCreateDevice")) {
        return false;
    }
    vkGetDeviceQueue(handles.device, handles.queue_family, 0, &handles.queue);
    return true;
}

int bake_floor(const vkbake::VulkanHandles& handles) {
    vkbake::Settings settings;
    settings.size = 64;
    settings.rays = 64;
    settings.padding = 2;
    const vkbake::Sky white{.source = vkbake::ConstantSky{}, .name = "white"};
    const vkbake::Bake bake = vkbake::bake(floor_scene(), white, settings, vkbake::adopt_device(handles));
    if (bake.light_maps.size() != 1) {
        std::fprintf(stderr, "expected one light map, got %zu\n", bake.light_maps.size());
        return 1;
    }
    const vkbake::Image& image = bake.light_maps[0].image;
    std::size_t covered = 0;
    for (std::size_t texel = 0; texel < image.texels.size(); ++texel) {
        if (image.coverage[texel] > 0.5F) {
            ++covered;
            if (std::abs(image.texels[texel].x - 1.0F) > 1e-6F) {
                std::fprintf(stderr, "texel %zu is %g, not 1\n", texel, static_cast<double>(image.texels[texel].x));
                return 1;
            }
        }
    }
    std::printf("%zu texels covered, all 1\n", covered);
    return covered > image.texels.size() / 2 ? 0 : 1;
}

} // namespace

int main() {
    vkbake::VulkanHandles handles;
    if (!create_device(handles)) {
        return 1;
    }
    int status = 1;
    try {
        status = bake_floor(handles);
    } catch (const vkbake::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
    }
    // The caller's objects are still the caller's.
    check(vkDeviceWaitIdle(handles.device), "vkDeviceWaitIdle");
    vkDestroyDevice(handles.device, nullptr);
    vkDestroyInstance(handles.instance, nullptr);
    return status;
}
