// What fails around the program: the device, the disk, the memory, the user's patience. Each ends in its status and one
// line, and what stood there before stays as it was.
#include "fixture.hpp"

#include <fstream>
#include <map>

#include <sys/stat.h>

namespace vkbake::test {
namespace {

class Faults : public Cli {
protected:
    using Files = std::map<std::string, std::string>;

    void SetUp() override {
        Cli::SetUp();
        fs::create_directories(m_folder / "out/lightmaps");
        for (const char* const file : {"plane.glb", "manifest.json", "lightmaps/lightmap.exr"}) {
            std::ofstream(m_folder / "out" / file) << "what stood here before";
        }
        m_before = files();
    }

    /// All that lies in the output folder, by name.
    [[nodiscard]] Files files() const {
        Files all;
        for (const auto& entry : fs::recursive_directory_iterator(m_folder / "out")) {
            if (entry.is_regular_file()) {
                all[entry.path().lexically_relative(m_folder).string()] = contents(entry.path());
            }
        }
        return all;
    }

    [[nodiscard]] Outcome bake(const std::string& size, RunOptions options, const std::string& memory = "1T") const {
        options.directory = m_folder.string();
        return run_vkbake({"bake", scene("test/plane.glb"), "-o", in_folder("out"), "--size", size, "--rays", "1",
                           "--memory-limit", memory},
                          options);
    }

    /// On a device with that fault: see fault_layer.cpp.
    [[nodiscard]] Outcome bake_with(const std::string& fault, RunOptions options = {}) const {
        options.environment = {{"VK_ADD_LAYER_PATH", VKBAKE_LAYER_DIR},
                               {"VK_INSTANCE_LAYERS", "VK_LAYER_VKBAKE_fault"},
                               {"VKBAKE_FAULT", fault}};
        return bake("16", options);
    }

    void expect_refused(const Outcome& outcome, int status, const std::string& part) const {
        EXPECT_EQ(outcome.status, status) << outcome.error;
        const std::string line = last_line(outcome.error);
        EXPECT_TRUE(line.starts_with("vkbake: ")) << outcome.error;
        EXPECT_NE(line.find(part), std::string::npos) << outcome.error;
        EXPECT_EQ(files(), m_before);
    }

    /// What a bake says before that are lines of its progress.
    static std::string last_line(const std::string& text) {
        const std::size_t end = text.find_last_not_of('\n') + 1;
        const std::size_t begin = text.find_last_of('\n', end - 1) + 1;
        return text.substr(begin, end - begin);
    }

    Files m_before;
};

TEST_F(Faults, WithoutAFaultTheLayerChangesNothing) {
    const Outcome outcome = bake_with("none");
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_NE(files(), m_before);
}

TEST_F(Faults, ADeviceThatIsLost) {
    for (const std::string submission : {"1", "2"}) { // the geometry image, the dilation
        expect_refused(bake_with("lost " + submission), 1, "the Vulkan device was lost");
    }
}

TEST_F(Faults, ADeviceWithoutMemory) {
    for (const std::string allocation : {"1", "4"}) {
        expect_refused(bake_with("memory " + allocation), 1, "out of device memory");
    }
}

TEST_F(Faults, ADeviceWithoutAFeature) { expect_refused(bake_with("feature"), 4, "no feature dynamicRendering"); }

/// Whatever the program waits for, Ctrl-C ends it.
TEST_F(Faults, ADeviceThatHangsIsLeftByCtrlC) {
    expect_refused(bake_with("hang 1", {.interrupt_when = says("hanging\n")}), 130, "interrupted; nothing was written");
}

TEST_F(Faults, FilesThatAreBeingWrittenAreTakenBackAtCtrlC) {
    const auto a_file_more = [this](const std::string& /*said*/) { return files().size() > m_before.size(); };
    const std::string size = std::to_string(amount(1024, 256));
    expect_refused(bake(size, {.interrupt_when = a_file_more}), 130, "interrupted; nothing was written");
}

/// Ctrl-C is for what runs in the foreground.
TEST_F(Faults, WhoWasToldToIgnoreCtrlCDoes) {
    bool interrupted = false;
    const auto a_file_more = [&](const std::string& /*said*/) {
        interrupted = files().size() > m_before.size();
        return interrupted;
    };
    const std::string size = std::to_string(amount(1024, 256));
    const Outcome outcome = bake(size, {.interrupt_when = a_file_more, .ignores_interrupts = true});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_TRUE(interrupted);
}

/// Whatever it is at: loading, the atlas, tracing.
TEST_F(Faults, ABakeIsEndedByCtrlCAtAnyMoment) {
    for (int moment = 1; moment <= 256; moment *= 2) {
        const auto after = [moment, asked = 0](const std::string& /*said*/) mutable { return asked++ >= moment; };
        const Outcome outcome =
            run_vkbake({"bake", scene("storage-room.glb"), "-o", in_folder("out"), "--rays", "1000000"},
                       {.directory = m_folder.string(), .interrupt_when = after});
        EXPECT_EQ(outcome.status, 130) << outcome.error;
        EXPECT_EQ(files(), m_before);
    }
}

TEST_F(Faults, AFullDisk) { expect_refused(bake("64", {.largest_file = 1000}), 5, "cannot be written"); }

TEST_F(Faults, AFolderThatCannotBeWrittenTo) {
    const std::string place = geteuid() == 0 ? "/proc" : m_folder.string() + "/locked"; // nothing else stops root
    if (geteuid() != 0) {
        ASSERT_EQ(mkdir(place.c_str(), 0500), 0);
    }
    const Outcome outcome = run_vkbake({"bake", scene("test/plane.glb"), "-o", place + "/out", "--size", "16"});
    EXPECT_EQ(outcome.status, 5) << outcome.error;
    EXPECT_TRUE(one_line(outcome.error)) << outcome.error;
}

TEST_F(Faults, MapsThatDoNotFitTheMemoryAllowedAreRefusedWithASizeThatDoes) {
    const Outcome outcome = bake("16384", {}, "1G");
    expect_refused(outcome, 2, "the limit is 1.0 GiB; use --size ");
    const std::size_t place = outcome.error.find("--size ") + 7;
    const std::string size = outcome.error.substr(place, outcome.error.find(',', place) - place);
    const auto memory = [&](const std::string& side) {
        const std::string said = run_vkbake({"inspect", scene("test/plane.glb"), "--size", side, "--json"}).out;
        return std::stoull(said.substr(said.find("\"memory\": ") + 10));
    };
    EXPECT_LE(memory(size), 1ULL << 30U);
    EXPECT_GT(memory(std::to_string(std::stoi(size) + 16)), 1ULL << 30U);
}

#ifndef VKBAKE_SANITIZED // whose own memory would be counted
/// What is foretold is no less than what is taken, nor twice as much.
TEST_F(Faults, ABakeStaysBelowTheMemoryForetold) {
    for (const std::string size : {"64", "1024"}) {
        const std::string said = run_vkbake({"inspect", scene("test/plane.glb"), "--size", size, "--json"}).out;
        const std::uint64_t foretold = std::stoull(said.substr(said.find("\"memory\": ") + 10));
        const Outcome outcome = bake(size, {});
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_LT(outcome.peak_memory, foretold);
        EXPECT_GT(2 * outcome.peak_memory, foretold);
    }
}
#endif

#ifndef VKBAKE_SANITIZED // which map address space by the terabyte
TEST_F(Faults, AMachineWithoutMemory) {
    expect_refused(bake("16384", {.address_space = std::uint64_t{3} << 30U}), 1, "out of memory");
}
#endif

} // namespace
} // namespace vkbake::test
