// A Vulkan layer that makes a device fail as VKBAKE_FAULT says, so that the program can be seen to bear it:
//   lost N      from the Nth submission on the device is lost
//   memory N    from the Nth allocation on there is no device memory
//   feature     the device has no dynamic rendering
//   hang N      the Nth submission says so on standard error and never returns
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <unistd.h>

#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

namespace {

struct Fault {
    std::string kind;
    int first = 0; ///< the call, from 1, that fails first
};

Fault fault() {
    const char* const text = std::getenv("VKBAKE_FAULT"); // NOLINT(concurrency-mt-unsafe): nothing here sets it
    const std::string words = text == nullptr ? "" : text;
    const std::size_t blank = words.find(' ');
    return {words.substr(0, blank), blank == std::string::npos ? 1 : std::atoi(words.c_str() + blank)};
}

/// Of the one instance and device that the program has at a time.
struct Next {
    PFN_vkGetInstanceProcAddr instance = nullptr;
    PFN_vkGetDeviceProcAddr device = nullptr;
    PFN_vkGetPhysicalDeviceFeatures2 features = nullptr;
    PFN_vkQueueSubmit2 submit = nullptr;
    PFN_vkAllocateMemory allocate = nullptr;
};
Next next;

bool fails(const char* kind, std::atomic<int>& calls) {
    const Fault wanted = fault();
    return wanted.kind == kind && ++calls >= wanted.first;
}

VKAPI_ATTR VkResult VKAPI_CALL submit(VkQueue queue, std::uint32_t count, const VkSubmitInfo2* submissions,
                                      VkFence fence) {
    static std::atomic<int> lost{0};
    static std::atomic<int> hung{0};
    if (fails("lost", lost)) {
        return VK_ERROR_DEVICE_LOST;
    }
    if (fails("hang", hung)) {
        std::fputs("hanging\n", stderr);
        for (;;) {
            pause();
        }
    }
    return next.submit(queue, count, submissions, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL allocate(VkDevice device, const VkMemoryAllocateInfo* info,
                                        const VkAllocationCallbacks* allocator, VkDeviceMemory* memory) {
    static std::atomic<int> calls{0};
    return fails("memory", calls) ? VK_ERROR_OUT_OF_DEVICE_MEMORY : next.allocate(device, info, allocator, memory);
}

VKAPI_ATTR void VKAPI_CALL get_features(VkPhysicalDevice device, VkPhysicalDeviceFeatures2* features) {
    next.features(device, features);
    if (fault().kind != "feature") {
        return;
    }
    for (auto* link = static_cast<VkBaseOutStructure*>(features->pNext); link != nullptr; link = link->pNext) {
        if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES) {
            reinterpret_cast<VkPhysicalDeviceVulkan13Features*>(link)->dynamicRendering = VK_FALSE;
        }
    }
}

/// The loader's link in a chain of create-infos: how the next layer is found.
template<class Link>
Link* find_link(const void* chain, VkStructureType type) {
    for (auto* link = static_cast<const VkBaseInStructure*>(chain); link != nullptr; link = link->pNext) {
        if (link->sType == type) {
            auto* found = reinterpret_cast<Link*>(const_cast<VkBaseInStructure*>(link));
            if (found->function == VK_LAYER_LINK_INFO) {
                return found;
            }
        }
    }
    return nullptr;
}

VKAPI_ATTR VkResult VKAPI_CALL create_instance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* allocator,
                                               VkInstance* instance) {
    auto* link = find_link<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    next.instance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(next.instance(VK_NULL_HANDLE, "vkCreateInstance"));
    const VkResult result = create(info, allocator, instance);
    if (result == VK_SUCCESS) {
        next.features = reinterpret_cast<PFN_vkGetPhysicalDeviceFeatures2>(
            next.instance(*instance, "vkGetPhysicalDeviceFeatures2"));
    }
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL create_device(VkPhysicalDevice physical_device, const VkDeviceCreateInfo* info,
                                             const VkAllocationCallbacks* allocator, VkDevice* device) {
    auto* link = find_link<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    next.device = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    const auto instance_functions = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(instance_functions(VK_NULL_HANDLE, "vkCreateDevice"));
    const VkResult result = create(physical_device, info, allocator, device);
    if (result == VK_SUCCESS) {
        next.submit = reinterpret_cast<PFN_vkQueueSubmit2>(next.device(*device, "vkQueueSubmit2"));
        next.allocate = reinterpret_cast<PFN_vkAllocateMemory>(next.device(*device, "vkAllocateMemory"));
    }
    return result;
}

PFN_vkVoidFunction own_function(const char* name);

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_device_function(VkDevice device, const char* name) {
    const PFN_vkVoidFunction own = own_function(name);
    return own != nullptr ? own : next.device(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_instance_function(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction own = own_function(name);
    return own != nullptr ? own : next.instance(instance, name);
}

PFN_vkVoidFunction own_function(const char* name) {
    const struct {
        const char* name;
        PFN_vkVoidFunction function;
    } functions[] = {{"vkGetInstanceProcAddr", reinterpret_cast<PFN_vkVoidFunction>(get_instance_function)},
                     {"vkGetDeviceProcAddr", reinterpret_cast<PFN_vkVoidFunction>(get_device_function)},
                     {"vkCreateInstance", reinterpret_cast<PFN_vkVoidFunction>(create_instance)},
                     {"vkCreateDevice", reinterpret_cast<PFN_vkVoidFunction>(create_device)},
                     {"vkGetPhysicalDeviceFeatures2", reinterpret_cast<PFN_vkVoidFunction>(get_features)},
                     {"vkQueueSubmit2", reinterpret_cast<PFN_vkVoidFunction>(submit)},
                     {"vkAllocateMemory", reinterpret_cast<PFN_vkVoidFunction>(allocate)}};
    for (const auto& [own, function] : functions) {
        if (std::strcmp(own, name) == 0) {
            return function;
        }
    }
    return nullptr;
}

} // namespace

extern "C" __attribute__((visibility("default"))) VkResult
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version) {
    version->loaderLayerInterfaceVersion = 2;
    version->pfnGetInstanceProcAddr = get_instance_function;
    version->pfnGetDeviceProcAddr = get_device_function;
    version->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
