// Devices: which there are, which is chosen, what validation says.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "gpu/commands.hpp"
#include "gpu/context.hpp"
#include "gpu/spirv.hpp"
#include "self_test.h"
#include "vkbake/device.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

TEST(Device, ListHasAUsableOneThatRoundsCorrectly) {
    const std::vector<DeviceReport> reports = list_devices();
    ASSERT_FALSE(reports.empty());
    for (const DeviceReport& report : reports) {
        EXPECT_FALSE(report.name.empty());
        EXPECT_EQ(report.usable, report.refusals.empty()) << report.name;
    }
    EXPECT_TRUE(std::ranges::any_of(reports, [](const DeviceReport& r) { return r.usable && r.deterministic; }));
}

TEST(Device, IsChosenByPartOfItsNameInAnyCase) {
    const Device first = open_device();
    const std::string name = first.name().substr(1, 6);
    std::string upper = name;
    std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    EXPECT_NE(open_device({.name = upper}).name().find(name), std::string::npos);
}

TEST(Device, RefusalsAreNamed) {
    try {
        static_cast<void>(open_device({.name = "no such device"}));
        FAIL() << "opened";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::no_device);
        EXPECT_NE(std::string(error.what()).find("not named \"no such device\""), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find(open_device().name()), std::string::npos) << error.what();
    }
}

TEST(Spirv, ModulesAreSortedAndStartWithTheMagicNumber) {
    const auto modules = gpu::spirv_modules();
    ASSERT_FALSE(modules.empty());
    EXPECT_TRUE(std::ranges::is_sorted(modules, {}, &gpu::SpirvModule::name));
    for (const gpu::SpirvModule& module : modules) {
        EXPECT_EQ(module.words.front(), 0x07230203U) << module.name;
    }
}

} // namespace
} // namespace vkbake
