#include "gpu/instance.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

namespace vkbake::gpu {

namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL collect_message(VkDebugUtilsMessageSeverityFlagBitsEXT /*severity*/,
                                               VkDebugUtilsMessageTypeFlagsEXT /*types*/,
                                               const VkDebugUtilsMessengerCallbackDataEXT* data, void* messages) {
    static_cast<Messages*>(messages)->add(data->pMessage);
    return VK_FALSE;
}

void require_layer(const vk::raii::Context& loader) {
    const auto layers = loader.enumerateInstanceLayerProperties();
    const bool found = std::ranges::any_of(layers, [](const vk::LayerProperties& layer) {
        return std::string_view(layer.layerName.data()) == validation_layer;
    });
    if (!found) {
        throw Error(ErrorKind::no_device, std::string("gpu: validation is asked for, but the layer ") +
                                              validation_layer +
                                              " is not installed; install it or turn validation off");
    }
}

void fill_instance(Instance& made, bool validation) {
    if (made.loader.enumerateInstanceVersion() < VK_API_VERSION_1_3) {
        throw Error(ErrorKind::no_device, "gpu: the Vulkan loader is older than 1.3; install a newer one");
    }
    const vk::ApplicationInfo application("vkbake", 1, "vkbake", 1, VK_API_VERSION_1_3);
    if (!validation) {
        made.instance = vk::raii::Instance(made.loader, vk::InstanceCreateInfo({}, &application));
        return;
    }
    require_layer(made.loader);
    // Messages of the loader itself (a driver that cannot be opened) are of the general kind and no fault of ours.
    const vk::DebugUtilsMessengerCreateInfoEXT messenger(
        {}, vk::DebugUtilsMessageSeverityFlagBitsEXT::eWarning | vk::DebugUtilsMessageSeverityFlagBitsEXT::eError,
        vk::DebugUtilsMessageTypeFlagBitsEXT::eValidation, &collect_message, made.messages.get());
    const vk::ValidationFeatureEnableEXT synchronization = vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
    const vk::ValidationFeaturesEXT features(synchronization, {}, &messenger);
    const std::array layers{validation_layer};
    const std::array extensions{VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
    made.instance =
        vk::raii::Instance(made.loader, vk::InstanceCreateInfo({}, &application, layers, extensions, &features));
    made.messenger = vk::raii::DebugUtilsMessengerEXT(made.instance, messenger);
}

/// Calls visit(name, is it enabled) for each needed feature.
template<class Visit>
void for_each_feature(const vk::PhysicalDeviceFeatures& base, vk::Bool32 dynamic_rendering, vk::Bool32 synchronization2,
                      Visit&& visit) {
    visit("shaderFloat64", base.shaderFloat64);
    visit("dynamicRendering", dynamic_rendering);
    visit("synchronization2", synchronization2);
}

void check_formats(const vk::raii::PhysicalDevice& device, std::vector<std::string>& reasons) {
    struct Need {
        vk::Format format;
        vk::FormatFeatureFlags features;
        const char* what;
    };
    using enum vk::FormatFeatureFlagBits;
    const std::array needs{
        Need{vk::Format::eR32G32B32A32Sfloat, eColorAttachment | eStorageImage,
             "RGBA32F as a target and storage image"},
        Need{vk::Format::eR32G32B32A32Uint, eStorageImage, "RGBA32UI as a storage image"},
        Need{vk::Format::eR32Uint, eColorAttachment, "R32UI as a target"},
        Need{vk::Format::eD32Sfloat, eDepthStencilAttachment, "D32 as a depth target"},
    };
    for (const Need& need : needs) {
        if ((device.getFormatProperties(need.format).optimalTilingFeatures & need.features) != need.features) {
            reasons.push_back(std::string("no ") + need.what);
        }
    }
}

} // namespace

bool validation_from_environment() {
    const char* value = std::getenv("VKBAKE_VALIDATION"); // NOLINT(concurrency-mt-unsafe): nothing here sets it
    return value != nullptr && std::string_view(value) == "1";
}

std::shared_ptr<Instance> make_instance(bool validation) {
    std::shared_ptr<Instance> made;
    try {
        made = std::make_shared<Instance>();
    } catch (const std::runtime_error&) { // vk::raii::Context finds no library to load
        throw Error(ErrorKind::no_device, "gpu: there is no Vulkan loader; install libvulkan1 and a driver");
    }
    translated(
        "gpu: Vulkan instance", [&] { fill_instance(*made, validation); }, ErrorKind::no_device);
    return made;
}

Features needed_features() {
    Features features;
    features.get<vk::PhysicalDeviceFeatures2>().features.shaderFloat64 = VK_TRUE;
    features.get<vk::PhysicalDeviceVulkan13Features>().dynamicRendering = VK_TRUE;
    features.get<vk::PhysicalDeviceVulkan13Features>().synchronization2 = VK_TRUE;
    return features;
}

std::vector<std::string> missing_features(const VkPhysicalDeviceFeatures2& chain) {
    vk::Bool32 dynamic_rendering = VK_FALSE;
    vk::Bool32 synchronization2 = VK_FALSE;
    for (const auto* link = static_cast<const VkBaseInStructure*>(chain.pNext); link != nullptr; link = link->pNext) {
        if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES) {
            const auto* features = reinterpret_cast<const VkPhysicalDeviceVulkan13Features*>(link);
            dynamic_rendering |= features->dynamicRendering;
            synchronization2 |= features->synchronization2;
        } else if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES) {
            dynamic_rendering |=
                reinterpret_cast<const VkPhysicalDeviceDynamicRenderingFeatures*>(link)->dynamicRendering;
        } else if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SYNCHRONIZATION_2_FEATURES) {
            synchronization2 |=
                reinterpret_cast<const VkPhysicalDeviceSynchronization2Features*>(link)->synchronization2;
        }
    }
    std::vector<std::string> missing;
    for_each_feature(vk::PhysicalDeviceFeatures(chain.features), dynamic_rendering, synchronization2,
                     [&](const char* name, vk::Bool32 enabled) {
                         if (enabled == VK_FALSE) {
                             missing.emplace_back(name);
                         }
                     });
    return missing;
}

std::vector<std::string> refusals(const vk::raii::PhysicalDevice& device) {
    const std::uint32_t version = device.getProperties().apiVersion;
    if (version < VK_API_VERSION_1_3) { // older devices must not be asked for 1.3's features
        return {"Vulkan " + std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
                std::to_string(VK_API_VERSION_MINOR(version)) + ", 1.3 is needed"};
    }
    std::vector<std::string> reasons;
    const auto features = device.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan13Features>();
    for (const std::string& name : missing_features(features.get<vk::PhysicalDeviceFeatures2>())) {
        reasons.push_back("no feature " + name);
    }
    if (!find_queue_family(device)) {
        reasons.emplace_back("no queue family with graphics and compute");
    }
    check_formats(device, reasons);
    return reasons;
}

std::optional<std::uint32_t> find_queue_family(const vk::raii::PhysicalDevice& device) {
    const auto families = device.getQueueFamilyProperties();
    const vk::QueueFlags needed = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
    for (std::uint32_t family = 0; family < families.size(); ++family) {
        if ((families[family].queueFlags & needed) == needed) {
            return family;
        }
    }
    return std::nullopt;
}

} // namespace vkbake::gpu
