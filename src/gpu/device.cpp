// Finding, judging and opening devices (include/vkbake/device.hpp).
#include "vkbake/device.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "gpu/state.hpp"

namespace vkbake {

namespace {

/// GPUs before CPUs; among equals the loader's order stands.
int preference(vk::PhysicalDeviceType type) {
    switch (type) {
    case vk::PhysicalDeviceType::eDiscreteGpu:
        return 0;
    case vk::PhysicalDeviceType::eIntegratedGpu:
        return 1;
    case vk::PhysicalDeviceType::eVirtualGpu:
        return 2;
    case vk::PhysicalDeviceType::eCpu:
        return 3;
    default:
        return 4;
    }
}

std::string type_name(vk::PhysicalDeviceType type) {
    constexpr std::array names{"discrete GPU", "integrated GPU", "virtual GPU", "CPU", "other"};
    return names.at(static_cast<std::size_t>(preference(type)));
}

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
}

std::vector<vk::raii::PhysicalDevice> sorted_devices(const gpu::Instance& instance) {
    std::vector<vk::raii::PhysicalDevice> devices;
    try {
        for (vk::raii::PhysicalDevice& device : vk::raii::PhysicalDevices(instance.instance)) {
            devices.push_back(std::move(device));
        }
    } catch (const vk::InitializationFailedError&) { // what a loader without any driver may answer
        return {};
    }
    std::ranges::stable_sort(devices, {}, [](const vk::raii::PhysicalDevice& device) {
        return preference(device.getProperties().deviceType);
    });
    return devices;
}

std::unique_ptr<gpu::Context> make_context(const std::shared_ptr<gpu::Instance>& instance,
                                           vk::raii::PhysicalDevice physical_device) {
    auto state = std::make_unique<gpu::Context::State>();
    state->instance = instance;
    state->queue_family = gpu::find_queue_family(physical_device).value();
    state->physical_device = std::move(physical_device);
    const float priority = 1.0F;
    const vk::DeviceQueueCreateInfo queue({}, state->queue_family, 1, &priority);
    const gpu::Features features = gpu::needed_features();
    vk::DeviceCreateInfo info({}, queue);
    info.pNext = &features.get<vk::PhysicalDeviceFeatures2>();
    state->device = vk::raii::Device(state->physical_device, info);
    state->queue = vk::raii::Queue(state->device, state->queue_family, 0);
    gpu::complete(*state);
    return std::make_unique<gpu::Context>(std::move(state));
}

DeviceReport report_on(const std::shared_ptr<gpu::Instance>& instance, const vk::raii::PhysicalDevice& device) {
    const auto properties = device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    const auto& core = properties.get<vk::PhysicalDeviceProperties2>().properties;
    const auto& driver = properties.get<vk::PhysicalDeviceDriverProperties>();
    DeviceReport report;
    report.name = core.deviceName.data();
    report.driver = std::string(driver.driverName.data()) + " " + driver.driverInfo.data();
    report.type = type_name(core.deviceType);
    report.refusals = gpu::refusals(device);
    if (!report.refusals.empty()) {
        return report;
    }
    try {
        report.deterministic = make_context(instance, device)->arithmetic_is_exact();
        report.usable = true;
    } catch (const vk::SystemError& failure) {
        report.refusals.push_back(std::string("it cannot be opened: ") + failure.what());
    } catch (const Error& failure) {
        report.refusals.push_back(std::string("its self-test failed: ") + failure.what());
    }
    return report;
}

} // namespace

Device::Device(std::shared_ptr<gpu::Context> context) : m_context(std::move(context)) {}

std::string Device::name() const { return m_context->name(); }

Device open_device(const DeviceOptions& options) {
    const auto instance = gpu::make_instance(options.validation || gpu::validation_from_environment());
    const auto open = [&] {
        std::string reasons;
        for (const vk::raii::PhysicalDevice& device : sorted_devices(*instance)) {
            const std::string name = gpu::device_name(device);
            std::vector<std::string> refusals = gpu::refusals(device);
            if (lower_case(name).find(lower_case(options.name)) == std::string::npos) {
                refusals.insert(refusals.begin(), "not named \"" + options.name + "\"");
            }
            if (refusals.empty()) {
                return Device(make_context(instance, device));
            }
            for (const std::string& refusal : refusals) {
                reasons.append(reasons.empty() ? "" : "; ").append(name).append(": ").append(refusal);
            }
        }
        throw Error(ErrorKind::no_device,
                    "no usable Vulkan device: " + (reasons.empty() ? "the loader finds no driver" : reasons) +
                        "; install a Vulkan 1.3 driver (Mesa's software driver will do)");
    };
    return gpu::translated("opening a Vulkan device", open, ErrorKind::no_device);
}

std::vector<DeviceReport> list_devices() {
    std::shared_ptr<gpu::Instance> instance;
    try {
        instance = gpu::make_instance(gpu::validation_from_environment());
    } catch (const Error&) {
        if (gpu::validation_from_environment()) {
            throw; // the layer that was asked for is missing: no reason to say that there are no devices
        }
        return {};
    }
    std::vector<DeviceReport> reports;
    for (const vk::raii::PhysicalDevice& device : sorted_devices(*instance)) {
        reports.push_back(report_on(instance, device));
    }
    return reports;
}

} // namespace vkbake
