// The Vulkan objects behind Context. For src/gpu alone.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "gpu/context.hpp"
#include "gpu/instance.hpp"
#include "gpu/resources.hpp"

namespace vkbake::gpu {

/// Descriptor sets of one run. Pools are kept from run to run and grow in number when one run needs more.
class DescriptorPools {
public:
    [[nodiscard]] vk::DescriptorSet allocate(const vk::raii::Device& device, vk::DescriptorSetLayout layout,
                                             std::uint32_t descriptors);
    void reset();

private:
    std::vector<vk::raii::DescriptorPool> m_pools;
    std::size_t m_in_use = 0;      ///< pools that this run has taken from, the last of them still open
    std::uint32_t m_sets_left = 0; ///< of the open pool
    std::uint32_t m_descriptors_left = 0;
};

/// The order of the members is the order in which they may be destroyed, from the last to the first.
struct Context::State {
    std::shared_ptr<Instance> instance;
    vk::raii::PhysicalDevice physical_device{nullptr};
    vk::raii::Device device{nullptr};
    vk::raii::Queue queue{nullptr};
    std::uint32_t queue_family = 0;

    std::string name;
    Limits limits;
    vk::PhysicalDeviceMemoryProperties memory;

    vk::raii::CommandPool command_pool{nullptr};
    vk::raii::CommandBuffer command_buffer{nullptr};
    vk::raii::Fence fence{nullptr};
    DescriptorPools descriptor_pools;
    std::map<std::tuple<Wrap, Wrap, Filter>, vk::raii::Sampler> samplers;
    std::set<const Buffer::Handle*> incoherent; ///< mapped buffers, to be flushed before and invalidated after a run
    std::unique_ptr<Buffer> staging_upload;
    std::unique_ptr<Buffer> staging_read_back;
    bool recording = false;
};

/// What every context needs beside its device: properties, command pool, fence. `state` has instance, devices and
/// queue.
void complete(Context::State& state);

[[nodiscard]] std::string device_name(const vk::raii::PhysicalDevice& device);

[[nodiscard]] vk::Sampler find_sampler(Context::State& state, const Sampler& sampler);

/// The staging buffers, made on first use. Large data passes through them in pieces.
[[nodiscard]] Buffer& staging_upload(Context& context);
[[nodiscard]] Buffer& staging_read_back(Context& context);

struct Buffer::Handle {
    Context* context = nullptr;
    vk::raii::DeviceMemory memory{nullptr}; ///< outlives the buffer bound to it
    vk::raii::Buffer buffer{nullptr};
    std::size_t size = 0;
    std::byte* mapped = nullptr;
    bool coherent = true;
    Memory host_access = Memory::device;
};

struct Image::Handle {
    Context* context = nullptr;
    vk::raii::DeviceMemory memory{nullptr};
    vk::raii::Image image{nullptr};
    vk::raii::ImageView view{nullptr};        ///< all levels
    vk::raii::ImageView first_level{nullptr}; ///< for targets and storage where there are mip maps
    ImageDescription description;
    std::uint32_t levels = 1;
};

[[nodiscard]] vk::Format vulkan_format(Format format);
[[nodiscard]] vk::ImageAspectFlags aspect_of(Format format);

} // namespace vkbake::gpu
