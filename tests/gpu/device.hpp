// The device that the tests of this folder draw with: opened once, its validation layers on.
#pragma once

#include "vkbake/device.hpp"

namespace vkbake::test {

inline const Device& device() {
    static const Device opened = open_device({.name = {}, .validation = true});
    return opened;
}

inline gpu::Context& context() { return device().context(); }

} // namespace vkbake::test
