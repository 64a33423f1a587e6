#include "command.hpp"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "vkbake/report.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake::cli {
namespace {

void print_devices(const std::vector<DeviceReport>& devices) {
    if (devices.empty()) {
        fmt::print("no Vulkan device was found; install a driver (Debian: mesa-vulkan-drivers)\n");
    }
    for (const DeviceReport& device : devices) {
        fmt::print("{}\n  {}, {}\n  {}\n", device.name, device.type, device.driver,
                   !device.usable         ? "cannot be used:"
                   : device.deterministic ? "will do; float arithmetic rounds correctly, so bakes are reproducible"
                                          : "will do, but its float arithmetic does not round correctly: bakes may "
                                            "differ from other devices'");
        for (const std::string& refusal : device.refusals) {
            fmt::print("    {}\n", refusal);
        }
    }
}

} // namespace

void add_devices_command(CLI::App& app, Invocation& invocation) {
    const auto json = std::make_shared<bool>(false);
    CLI::App& command = *app.add_subcommand("devices", "List the Vulkan devices and whether each will do");
    command.add_flag("--json", *json, "Print them as JSON");
    command.final_callback([json, &invocation] {
        invocation.run = [json] {
            const std::vector<DeviceReport> devices = list_devices();
            if (*json) {
                fmt::print("{}\n", to_json(devices));
            } else {
                print_devices(devices);
            }
            const bool any =
                std::any_of(devices.begin(), devices.end(), [](const auto& device) { return device.usable; });
            return any ? exit_done : static_cast<int>(ErrorKind::no_device);
        };
    });
}

} // namespace vkbake::cli
