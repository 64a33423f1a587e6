// The Vulkan device that the passes run on. No Vulkan header is needed here; vulkan_interop.hpp takes a caller's own.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace vkbake {

namespace gpu {
class Context;
}

/// A device that is ready for use. Cheap to copy; the last copy releases what it owns. Used by one thread at a time.
class Device {
public:
    explicit Device(std::shared_ptr<gpu::Context> context);
    [[nodiscard]] std::string name() const; ///< device and driver, e.g. "llvmpipe (LLVM 15.0.6, 256 bits), Mesa 22.3.6"
    [[nodiscard]] gpu::Context& context() const { return *m_context; }

private:
    std::shared_ptr<gpu::Context> m_context;
};

struct DeviceReport {
    std::string name;
    std::string driver;
    std::string type; ///< "discrete GPU", "integrated GPU", "virtual GPU", "CPU", "other"
    bool usable = false;
    bool deterministic = false;        ///< its self-test of correctly rounded add and multiply passed
    std::vector<std::string> refusals; ///< why it is not usable, a line each
};

struct DeviceOptions {
    std::string name; ///< part of a device's name, any case; empty: the first usable, GPUs before CPUs
    bool validation =
        false; ///< with the Khronos validation layer and synchronization validation, if installed; its messages throw
};

/// Throws Error{no_device} with the reasons for which each device was refused.
[[nodiscard]] Device open_device(const DeviceOptions& options = {});

/// Every device that the loader finds, with the verdict on it. Empty where there is no loader or driver.
[[nodiscard]] std::vector<DeviceReport> list_devices();

} // namespace vkbake
