// Vulkan as src/gpu uses it, and how its failures become vkbake::Error. Included by src/gpu/*.cpp alone: it is heavy.
#pragma once

#include <string>

#include <vulkan/vulkan_raii.hpp>

#include "vkbake/error.hpp"

namespace vkbake::gpu {

/// Runs `work`; what Vulkan throws becomes Error{kind} "WHERE: WHAT; TO DO".
template<class Work>
auto translated(const std::string& where, Work&& work, ErrorKind kind = ErrorKind::bake_failed) {
    try {
        return work();
    } catch (const vk::OutOfDeviceMemoryError&) {
        throw Error(kind, where + ": out of device memory; use smaller maps or another device");
    } catch (const vk::OutOfHostMemoryError&) {
        throw Error(kind, where + ": out of host memory; use smaller maps");
    } catch (const vk::DeviceLostError&) {
        throw Error(kind, where + ": the Vulkan device was lost; run again, or use another device");
    } catch (const vk::SystemError& failure) {
        throw Error(kind, where + ": Vulkan failed with " + failure.what() + "; use another device or driver");
    }
}

} // namespace vkbake::gpu
