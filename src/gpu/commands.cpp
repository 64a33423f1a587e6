#include "gpu/commands.hpp"

#include <algorithm>

#include "gpu/recording.hpp"

namespace vkbake::gpu {

namespace {

vk::SamplerAddressMode address_mode(Wrap wrap) {
    switch (wrap) {
    case Wrap::repeat:
        return vk::SamplerAddressMode::eRepeat;
    case Wrap::mirror:
        return vk::SamplerAddressMode::eMirroredRepeat;
    case Wrap::clamp:
        break;
    }
    return vk::SamplerAddressMode::eClampToEdge;
}

/// What one slot is written with. Lives until the set is written.
struct SlotContent {
    vk::DescriptorBufferInfo buffer;
    vk::DescriptorImageInfo image;
    Slot slot = Slot::storage_buffer;
};

SlotContent content_of(Context::State& state, const Resource& resource) {
    SlotContent content;
    if (const auto* range = std::get_if<BufferRange>(&resource)) {
        const std::size_t bytes = range->bytes > 0 ? range->bytes : range->buffer->size() - range->offset;
        content.buffer = vk::DescriptorBufferInfo(*range->buffer->handle().buffer, range->offset, bytes);
        content.slot = Slot::storage_buffer;
    } else if (const auto* storage_image = std::get_if<StorageImage>(&resource)) {
        content.image =
            vk::DescriptorImageInfo({}, *storage_image->image->handle().first_level, vk::ImageLayout::eGeneral);
        content.slot = Slot::storage_image;
    } else {
        const auto& sampled_image = std::get<SampledImage>(resource);
        content.image = vk::DescriptorImageInfo(find_sampler(state, sampled_image.sampler),
                                                *sampled_image.image->handle().view, vk::ImageLayout::eGeneral);
        content.slot = Slot::sampled_image;
    }
    return content;
}

vk::DescriptorSet make_set(Context::State& state, const Program& program, std::span<const Resource> resources) {
    std::vector<SlotContent> contents;
    for (const Resource& resource : resources) {
        contents.push_back(content_of(state, resource));
    }
    if (!std::ranges::equal(contents, program.slots, {}, &SlotContent::slot)) {
        throw Error(ErrorKind::bake_failed,
                    "gpu: resources do not match the program's slots; this is a fault of the program");
    }
    const vk::DescriptorSet set =
        state.descriptor_pools.allocate(state.device, *program.set_layout, static_cast<std::uint32_t>(contents.size()));
    std::vector<vk::WriteDescriptorSet> writes;
    for (std::uint32_t i = 0; i < contents.size(); ++i) {
        vk::WriteDescriptorSet write(set, i, 0, 1);
        switch (contents[i].slot) {
        case Slot::storage_buffer:
            write.descriptorType = vk::DescriptorType::eStorageBuffer;
            write.pBufferInfo = &contents[i].buffer;
            break;
        case Slot::storage_image:
            write.descriptorType = vk::DescriptorType::eStorageImage;
            write.pImageInfo = &contents[i].image;
            break;
        case Slot::sampled_image:
            write.descriptorType = vk::DescriptorType::eCombinedImageSampler;
            write.pImageInfo = &contents[i].image;
            break;
        }
        writes.push_back(write);
    }
    state.device.updateDescriptorSets(writes, nullptr);
    return set;
}

void bind(Context::State& state, const Program& program, vk::PipelineBindPoint point,
          std::span<const Resource> resources, std::span<const std::byte> constants) {
    if (constants.size() != program.constant_bytes) {
        throw Error(ErrorKind::bake_failed,
                    "gpu: constants do not match the program's block; this is a fault of the program");
    }
    const vk::raii::CommandBuffer& commands = state.command_buffer;
    commands.bindPipeline(point, *program.pipeline);
    if (!program.slots.empty() || !resources.empty()) {
        commands.bindDescriptorSets(point, *program.layout, 0, make_set(state, program, resources), nullptr);
    }
    if (!constants.empty()) {
        commands.getDispatcher()->vkCmdPushConstants(*commands, *program.layout,
                                                     static_cast<VkShaderStageFlags>(program.stages), 0,
                                                     static_cast<std::uint32_t>(constants.size()), constants.data());
    }
}

vk::RenderingAttachmentInfo attachment(const ColorTarget& target) {
    vk::RenderingAttachmentInfo info(*target.image->handle().first_level, vk::ImageLayout::eGeneral);
    info.storeOp = vk::AttachmentStoreOp::eStore;
    info.loadOp = vk::AttachmentLoadOp::eClear;
    if (const auto* floats = std::get_if<std::array<float, 4>>(&target.clear)) {
        info.clearValue = vk::ClearValue(vk::ClearColorValue(*floats));
    } else if (const auto* integers = std::get_if<std::array<std::uint32_t, 4>>(&target.clear)) {
        info.clearValue = vk::ClearValue(vk::ClearColorValue(*integers));
    } else {
        info.loadOp = vk::AttachmentLoadOp::eLoad;
    }
    return info;
}

vk::RenderingAttachmentInfo attachment(const DepthTarget& target) {
    vk::RenderingAttachmentInfo info(*target.image->handle().first_level, vk::ImageLayout::eGeneral);
    info.storeOp = vk::AttachmentStoreOp::eStore;
    info.loadOp = target.clear ? vk::AttachmentLoadOp::eClear : vk::AttachmentLoadOp::eLoad;
    info.clearValue = vk::ClearValue(vk::ClearDepthStencilValue(target.clear.value_or(1.0F)));
    return info;
}

struct StageMasks {
    vk::PipelineStageFlags2 stages;
    vk::AccessFlags2 reads_and_writes;
};

StageMasks masks_of(Stage stage) {
    using enum vk::AccessFlagBits2;
    switch (stage) {
    case Stage::compute:
        return {vk::PipelineStageFlagBits2::eComputeShader, eShaderRead | eShaderWrite};
    case Stage::draw:
        return {vk::PipelineStageFlagBits2::eAllGraphics, eShaderRead | eShaderWrite | eColorAttachmentRead |
                                                              eColorAttachmentWrite | eDepthStencilAttachmentRead |
                                                              eDepthStencilAttachmentWrite};
    case Stage::copy:
        break;
    }
    return {vk::PipelineStageFlagBits2::eAllTransfer, eTransferRead | eTransferWrite};
}

vk::BufferImageCopy image_region(const Image& image, const Region& region, std::size_t offset) {
    return {offset,
            0,
            0,
            {aspect_of(image.description().format), 0, 0, 1},
            {region.x, region.y, 0},
            {static_cast<std::uint32_t>(region.width), static_cast<std::uint32_t>(region.height), 1}};
}

} // namespace

vk::Sampler find_sampler(Context::State& state, const Sampler& sampler) {
    const std::tuple key(sampler.u, sampler.v, sampler.filter);
    auto found = state.samplers.find(key);
    if (found == state.samplers.end()) {
        const bool linear = sampler.filter == Filter::linear;
        const vk::Filter filter = linear ? vk::Filter::eLinear : vk::Filter::eNearest;
        vk::SamplerCreateInfo info({}, filter, filter,
                                   linear ? vk::SamplerMipmapMode::eLinear : vk::SamplerMipmapMode::eNearest,
                                   address_mode(sampler.u), address_mode(sampler.v));
        info.maxLod = VK_LOD_CLAMP_NONE;
        found = state.samplers.emplace(key, vk::raii::Sampler(state.device, info)).first;
    }
    return *found->second;
}

void Commands::dispatch(const ComputeProgram& program, Groups groups, std::span<const Resource> resources,
                        std::span<const std::byte> constants) {
    bind(m_state.context, program.program(), vk::PipelineBindPoint::eCompute, resources, constants);
    m_state.context.command_buffer.dispatch(groups.x, groups.y, groups.z);
}

void Commands::render(const Targets& targets, const std::function<void()>& draws, std::optional<Region> region) {
    std::vector<vk::RenderingAttachmentInfo> colors;
    for (const ColorTarget& color : targets.colors) {
        colors.push_back(attachment(color));
    }
    const vk::RenderingAttachmentInfo depth =
        targets.depth ? attachment(*targets.depth) : vk::RenderingAttachmentInfo();
    if (!region) {
        const Image& any = targets.colors.empty() ? *targets.depth->image : *targets.colors.front().image;
        region = Region{0, 0, any.description().width, any.description().height};
    }
    const vk::Rect2D area({region->x, region->y},
                          {static_cast<std::uint32_t>(region->width), static_cast<std::uint32_t>(region->height)});
    const vk::raii::CommandBuffer& commands = m_state.context.command_buffer;
    commands.beginRendering(vk::RenderingInfo({}, area, 1, 0, colors, targets.depth ? &depth : nullptr));
    commands.setViewport(0, vk::Viewport(static_cast<float>(region->x), static_cast<float>(region->y),
                                         static_cast<float>(region->width), static_cast<float>(region->height), 0.0F,
                                         1.0F));
    commands.setScissor(0, area);
    draws();
    commands.endRendering();
}

void Commands::draw(const GraphicsProgram& program, std::uint32_t vertices, std::span<const Resource> resources,
                    std::span<const std::byte> constants, std::uint32_t first_vertex, std::uint32_t instances) {
    bind(m_state.context, program.program(), vk::PipelineBindPoint::eGraphics, resources, constants);
    m_state.context.command_buffer.draw(vertices, instances, first_vertex, 0);
}

void Commands::barrier(Stage before, Stage after) {
    const StageMasks first = masks_of(before);
    const StageMasks second = masks_of(after);
    const vk::MemoryBarrier2 barrier(first.stages, first.reads_and_writes, second.stages, second.reads_and_writes);
    m_state.context.command_buffer.pipelineBarrier2(vk::DependencyInfo({}, barrier));
}

void Commands::copy(const Buffer& source, const Buffer& target, std::size_t source_offset, std::size_t target_offset,
                    std::size_t bytes) {
    const vk::BufferCopy region(source_offset, target_offset, bytes > 0 ? bytes : source.size() - source_offset);
    m_state.context.command_buffer.copyBuffer(*source.handle().buffer, *target.handle().buffer, region);
}

void Commands::copy(const Image& source, const Region& region, const Buffer& target, std::size_t offset) {
    m_state.context.command_buffer.copyImageToBuffer(*source.handle().image, vk::ImageLayout::eGeneral,
                                                     *target.handle().buffer, image_region(source, region, offset));
}

void Commands::copy(const Buffer& source, std::size_t offset, const Image& target, const Region& region) {
    m_state.context.command_buffer.copyBufferToImage(*source.handle().buffer, *target.handle().image,
                                                     vk::ImageLayout::eGeneral, image_region(target, region, offset));
}

void Commands::fill(const Buffer& target, std::uint32_t value) {
    m_state.context.command_buffer.fillBuffer(*target.handle().buffer, 0, VK_WHOLE_SIZE, value);
}

} // namespace vkbake::gpu
