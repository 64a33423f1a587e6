// Buffers, images and runs, under the validation layers.
#include <array>
#include <cstring>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "gpu/commands.hpp"
#include "gpu/context.hpp"
#include "self_test.h"
#include "vkbake/device.hpp"
#include "vkbake/error.hpp"

namespace vkbake::gpu {
namespace {

class Resources : public testing::Test {
protected:
    [[nodiscard]] Context& context() const { return m_device.context(); }

private:
    Device m_device = open_device({.name = {}, .validation = true});
};

template<class T>
std::vector<T> counted(std::size_t count) {
    std::vector<T> values(count);
    std::iota(values.begin(), values.end(), T{1});
    return values;
}

TEST_F(Resources, BuffersKeepWhatIsUploaded) {
    const auto values = counted<std::uint32_t>((std::size_t{16} << 18U) + 100); // more than one staging buffer
    for (const Memory memory : {Memory::device, Memory::upload, Memory::read_back}) {
        Buffer buffer(context(), values.size() * 4 + 8, memory);
        buffer.upload(std::as_bytes(std::span(values)), 8);
        std::vector<std::uint32_t> read(values.size());
        buffer.download(std::as_writable_bytes(std::span(read)), 8);
        EXPECT_TRUE(read == values);
        EXPECT_EQ(buffer.bytes().empty(), memory == Memory::device);
    }
}

TEST_F(Resources, ImagesKeepWhatIsUploaded) {
    constexpr int width = 1531;
    constexpr int height = 1531; // more than one staging buffer at 16 bytes a texel
    for (const Format format : {Format::rgba32ui, Format::rgba8, Format::r32ui}) {
        Image image(context(), {.format = format, .width = width, .height = height, .storage = true});
        const auto values = counted<std::uint32_t>(image.size() / 4);
        image.upload(std::as_bytes(std::span(values)));
        std::vector<std::uint32_t> read(values.size());
        image.download(std::as_writable_bytes(std::span(read)));
        EXPECT_TRUE(read == values);
    }
}

TEST_F(Resources, MipMapsAreMadeDownToOneTexel) {
    Image image(context(), {.format = Format::rgba8_srgb, .width = 37, .height = 5, .sampled = true, .mip_maps = true});
    const std::vector<std::uint32_t> texels(37U * 5U, 0xFF808080U);
    image.upload(std::as_bytes(std::span(texels)));
    EXPECT_TRUE(context().take_validation_messages().empty());
}

TEST_F(Resources, TooLargeAnImageIsAnError) {
    const int side = context().limits().image_side + 1;
    EXPECT_THROW(Image(context(), {.width = side, .height = 1}), Error);
}

TEST_F(Resources, TooLargeABufferIsAnError) {
    try {
        const Buffer buffer(context(), std::size_t{1} << 46U, Memory::device);
        FAIL() << "allocated";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bake_failed);
    }
    static_cast<void>(context().take_validation_messages()); // the layers speak of it too
}

TEST_F(Resources, AMissingShaderIsNamed) {
    try {
        const ComputeProgram program(context(), {.shader = "nothing.comp", .slots = {}});
        FAIL() << "made";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("nothing.comp"), std::string::npos);
    }
}

TEST_F(Resources, ARunInsideARunIsAnErrorAndTheNextOneWorks) {
    EXPECT_THROW(context().run([&](Commands&) { context().run([](Commands&) {}); }), Error);
    EXPECT_NO_THROW(context().run([](Commands&) {}));
}

TEST_F(Resources, ArithmeticIsExact) { EXPECT_TRUE(context().arithmetic_is_exact()); }

/// A dispatch writes the buffer that the copy reads.
void dispatch_and_copy(Context& context, bool with_barrier) {
    Buffer pairs(context, sizeof(shared::SelfTestPair) * shared::self_test_group, Memory::device);
    Buffer results(context, sizeof(shared::SelfTestResult) * shared::self_test_group, Memory::device);
    Buffer read_back(context, results.size(), Memory::read_back);
    const ComputeProgram program(context,
                                 {.shader = "self_test.comp", .slots = {Slot::storage_buffer, Slot::storage_buffer}});
    context.run([&](Commands& commands) {
        commands.fill(pairs, 0);
        commands.barrier(Stage::copy, Stage::compute);
        const std::array resources{storage(pairs), storage(results)};
        commands.dispatch(program, {1}, resources);
        if (with_barrier) {
            commands.barrier(Stage::compute, Stage::copy);
        }
        commands.copy(results, read_back);
    });
}

TEST_F(Resources, ValidationIsSilentWhereABarrierStandsAndReportsOneLeftOut) {
    EXPECT_NO_THROW(dispatch_and_copy(context(), true));
    try {
        dispatch_and_copy(context(), false);
        FAIL() << "the missing barrier was not reported";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("SYNC-HAZARD"), std::string::npos) << error.what();
    }
}

TEST_F(Resources, ResourcesThatDoNotFitTheSlotsAreAnError) {
    const Buffer buffer(context(), 4096, Memory::device);
    const ComputeProgram program(context(),
                                 {.shader = "self_test.comp", .slots = {Slot::storage_buffer, Slot::storage_buffer}});
    const std::array one{storage(buffer)};
    EXPECT_THROW(context().run([&](Commands& commands) { commands.dispatch(program, {1}, one); }), Error);
}

TEST_F(Resources, ManyDescriptorSetsInOneRun) {
    const Buffer pairs(context(), sizeof(shared::SelfTestPair) * shared::self_test_group, Memory::device);
    const Buffer results(context(), sizeof(shared::SelfTestResult) * shared::self_test_group, Memory::device);
    const ComputeProgram program(context(),
                                 {.shader = "self_test.comp", .slots = {Slot::storage_buffer, Slot::storage_buffer}});
    const std::array resources{storage(pairs), storage(results)};
    for (int repeat = 0; repeat < 2; ++repeat) {
        context().run([&](Commands& commands) {
            commands.fill(pairs, 0);
            commands.barrier(Stage::copy, Stage::compute);
            for (int i = 0; i < 600; ++i) { // more than two pools hold
                commands.dispatch(program, {1}, resources);
                commands.barrier(Stage::compute, Stage::compute);
            }
        });
    }
}

} // namespace
} // namespace vkbake::gpu
