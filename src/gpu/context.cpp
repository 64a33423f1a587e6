#include "gpu/context.hpp"

#include <algorithm>
#include <limits>

#include "gpu/commands.hpp"
#include "gpu/recording.hpp"
#include "gpu/state.hpp"

namespace vkbake::gpu {

namespace {

Limits limits_of(const vk::raii::PhysicalDevice& device) {
    const vk::PhysicalDeviceLimits limits = device.getProperties().limits;
    Limits result;
    result.image_side =
        static_cast<int>(std::min({limits.maxImageDimension2D, limits.maxFramebufferWidth, limits.maxFramebufferHeight,
                                   limits.maxViewportDimensions[0], limits.maxViewportDimensions[1]}));
    result.storage_buffer_range = limits.maxStorageBufferRange;
    result.push_constant_bytes = limits.maxPushConstantsSize;
    result.dispatch_groups = limits.maxComputeWorkGroupCount[0];
    result.sub_pixel_precision_bits = limits.subPixelPrecisionBits;
    const vk::PhysicalDeviceMemoryProperties memory = device.getMemoryProperties();
    for (std::uint32_t heap = 0; heap < memory.memoryHeapCount; ++heap) {
        if (memory.memoryHeaps[heap].flags & vk::MemoryHeapFlagBits::eDeviceLocal) {
            result.heap_size = std::max(result.heap_size, memory.memoryHeaps[heap].size);
        }
    }
    return result;
}

std::string joined(const std::vector<std::string>& messages) {
    std::string all;
    for (const std::string& message : messages) {
        all += (all.empty() ? "" : " | ") + message;
    }
    std::ranges::replace(all, '\n', ' ');
    return all;
}

/// Marks the state as recording, and as not recording again however the run ends.
class Recording {
public:
    explicit Recording(Context::State& state) : m_state(state) {
        if (m_state.recording) {
            throw Error(ErrorKind::bake_failed, "gpu: run inside a run; upload and download outside of it");
        }
        m_state.recording = true;
    }
    ~Recording() { m_state.recording = false; }
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

private:
    Context::State& m_state;
};

/// Waiting on the fence alone makes device writes visible neither to the host nor to the next run.
void make_visible(const vk::raii::CommandBuffer& commands) {
    using enum vk::AccessFlagBits2;
    const vk::MemoryBarrier2 barrier(vk::PipelineStageFlagBits2::eAllCommands, eMemoryWrite,
                                     vk::PipelineStageFlagBits2::eAllCommands | vk::PipelineStageFlagBits2::eHost,
                                     eMemoryRead | eMemoryWrite | eHostRead);
    commands.pipelineBarrier2(vk::DependencyInfo({}, barrier));
}

std::vector<vk::MappedMemoryRange> incoherent_ranges(const Context::State& state) {
    std::vector<vk::MappedMemoryRange> ranges;
    for (const Buffer::Handle* buffer : state.incoherent) {
        ranges.emplace_back(*buffer->memory, 0, VK_WHOLE_SIZE);
    }
    return ranges;
}

void submit_and_wait(Context::State& state) {
    const std::vector<vk::MappedMemoryRange> ranges = incoherent_ranges(state);
    if (!ranges.empty()) {
        state.device.flushMappedMemoryRanges(ranges);
    }
    const vk::CommandBufferSubmitInfo commands(*state.command_buffer);
    state.queue.submit2(vk::SubmitInfo2({}, {}, commands), *state.fence);
    const vk::Result result =
        state.device.waitForFences(*state.fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max());
    if (result != vk::Result::eSuccess) {
        throw Error(ErrorKind::bake_failed, "gpu: waiting for the device failed with " + vk::to_string(result) +
                                                "; run again, or use another device");
    }
    state.device.resetFences(*state.fence);
    if (!ranges.empty()) {
        state.device.invalidateMappedMemoryRanges(ranges);
    }
}

} // namespace

vk::DescriptorSet DescriptorPools::allocate(const vk::raii::Device& device, vk::DescriptorSetLayout layout,
                                            std::uint32_t descriptors) {
    constexpr std::uint32_t sets = 256;
    constexpr std::uint32_t descriptors_of_a_kind = 2048;
    if (m_sets_left == 0 || m_descriptors_left < descriptors) {
        if (m_in_use == m_pools.size()) {
            const std::array sizes{
                vk::DescriptorPoolSize(vk::DescriptorType::eStorageBuffer, descriptors_of_a_kind),
                vk::DescriptorPoolSize(vk::DescriptorType::eStorageImage, descriptors_of_a_kind),
                vk::DescriptorPoolSize(vk::DescriptorType::eCombinedImageSampler, descriptors_of_a_kind)};
            m_pools.emplace_back(device, vk::DescriptorPoolCreateInfo({}, sets, sizes));
        }
        ++m_in_use;
        m_sets_left = sets;
        m_descriptors_left = descriptors_of_a_kind;
    }
    --m_sets_left;
    m_descriptors_left -= descriptors;
    const vk::DescriptorSetAllocateInfo info(*m_pools[m_in_use - 1], layout);
    // Freed with the pool's reset, never one by one: hence no RAII set.
    VkDescriptorSet set = VK_NULL_HANDLE;
    const auto result = static_cast<vk::Result>(device.getDispatcher()->vkAllocateDescriptorSets(
        *device, reinterpret_cast<const VkDescriptorSetAllocateInfo*>(&info), &set));
    if (result != vk::Result::eSuccess) {
        throw Error(ErrorKind::bake_failed, "gpu: no memory for descriptors; use another device");
    }
    return set;
}

void DescriptorPools::reset() {
    for (const vk::raii::DescriptorPool& pool : m_pools) {
        pool.reset();
    }
    m_in_use = 0;
    m_sets_left = 0;
    m_descriptors_left = 0;
}

std::string device_name(const vk::raii::PhysicalDevice& device) {
    const auto properties = device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    const std::string name = properties.get<vk::PhysicalDeviceProperties2>().properties.deviceName.data();
    const std::string driver = properties.get<vk::PhysicalDeviceDriverProperties>().driverInfo.data();
    return driver.empty() ? name : name + ", " + driver;
}

void complete(Context::State& state) {
    state.name = device_name(state.physical_device);
    state.limits = limits_of(state.physical_device);
    state.memory = state.physical_device.getMemoryProperties();
    state.command_pool =
        vk::raii::CommandPool(state.device, {vk::CommandPoolCreateFlagBits::eResetCommandBuffer, state.queue_family});
    state.command_buffer = std::move(
        vk::raii::CommandBuffers(state.device, {*state.command_pool, vk::CommandBufferLevel::ePrimary, 1}).front());
    state.fence = vk::raii::Fence(state.device, vk::FenceCreateInfo());
}

Context::Context(std::unique_ptr<State> state) : m_state(std::move(state)) {}

Context::~Context() {
    m_kept.clear();
    m_state->staging_upload.reset(); // buffers use the state until they are gone
    m_state->staging_read_back.reset();
}

const std::string& Context::name() const { return m_state->name; }

const Limits& Context::limits() const { return m_state->limits; }

void Context::run(const std::function<void(Commands&)>& record) {
    translated("gpu", [&] {
        const Recording recording(*m_state);
        const vk::raii::CommandBuffer& commands = m_state->command_buffer;
        commands.reset(); // also what a run that was left by an exception had recorded
        m_state->descriptor_pools.reset();
        commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        Commands::State recorded{*m_state};
        Commands recorder(recorded);
        record(recorder);
        make_visible(commands);
        commands.end();
        submit_and_wait(*m_state);
    });
    if (const std::vector<std::string> messages = take_validation_messages(); !messages.empty()) {
        throw Error(ErrorKind::bake_failed,
                    "gpu: validation: " + joined(messages) + "; this is a fault of the program");
    }
}

std::vector<std::string> Context::take_validation_messages() { return m_state->instance->messages->take(); }

} // namespace vkbake::gpu
