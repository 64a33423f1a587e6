#include <algorithm>
#include <bit>

#include "gpu/commands.hpp"
#include "gpu/memory.hpp"
#include "gpu/recording.hpp"

namespace vkbake::gpu {

namespace {

vk::ImageUsageFlags usage_of(const ImageDescription& description) {
    using enum vk::ImageUsageFlagBits;
    vk::ImageUsageFlags usage = eTransferSrc | eTransferDst;
    if (description.target) {
        usage |= description.format == Format::d32 ? eDepthStencilAttachment : eColorAttachment;
    }
    if (description.storage) {
        usage |= eStorage;
    }
    if (description.sampled) {
        usage |= eSampled;
    }
    return usage;
}

vk::raii::ImageView make_view(const Context::State& state, const Image::Handle& image, std::uint32_t levels) {
    const vk::ImageSubresourceRange range(aspect_of(image.description.format), 0, levels, 0, 1);
    return {state.device, vk::ImageViewCreateInfo({}, *image.image, vk::ImageViewType::e2D,
                                                  vulkan_format(image.description.format), {}, range)};
}

void check_size(const Context& context, const ImageDescription& description) {
    const int limit = context.limits().image_side;
    if (description.width < 1 || description.height < 1 || description.width > limit || description.height > limit) {
        throw Error(ErrorKind::bake_failed, "gpu: an image of " + std::to_string(description.width) + " x " +
                                                std::to_string(description.height) + " texels; the device has 1 to " +
                                                std::to_string(limit) + " a side");
    }
}

/// All images stay in the general layout: what a driver gains from others is small beside what a wrong one costs.
void enter_general_layout(Context& context, const Image::Handle& image) {
    context.run([&](Commands& commands) {
        const vk::ImageSubresourceRange range(aspect_of(image.description.format), 0, image.levels, 0, 1);
        const vk::ImageMemoryBarrier2 barrier({}, {}, vk::PipelineStageFlagBits2::eAllCommands,
                                              vk::AccessFlagBits2::eMemoryWrite, vk::ImageLayout::eUndefined,
                                              vk::ImageLayout::eGeneral, VK_QUEUE_FAMILY_IGNORED,
                                              VK_QUEUE_FAMILY_IGNORED, *image.image, range);
        commands.state().context.command_buffer.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barrier));
    });
}

/// Each level is half the one before, by linear blits.
void make_mip_maps(const Image::Handle& image, Commands& commands) {
    vk::Offset3D size(image.description.width, image.description.height, 1);
    for (std::uint32_t level = 1; level < image.levels; ++level) {
        const vk::Offset3D half(std::max(size.x / 2, 1), std::max(size.y / 2, 1), 1);
        const vk::ImageBlit blit({vk::ImageAspectFlagBits::eColor, level - 1, 0, 1}, {vk::Offset3D(), size},
                                 {vk::ImageAspectFlagBits::eColor, level, 0, 1}, {vk::Offset3D(), half});
        commands.barrier(Stage::copy, Stage::copy);
        commands.state().context.command_buffer.blitImage(*image.image, vk::ImageLayout::eGeneral, *image.image,
                                                          vk::ImageLayout::eGeneral, blit, vk::Filter::eLinear);
        size = half;
    }
}

/// Calls visit(first row, rows) for bands that a staging buffer can hold.
template<class Visit>
void for_each_band(const ImageDescription& image, const Buffer& stage, Visit&& visit) {
    const std::size_t row_bytes = static_cast<std::size_t>(image.width) * bytes_per_texel(image.format);
    const int rows = static_cast<int>(stage.size() / row_bytes);
    for (int row = 0; row < image.height; row += rows) {
        visit(row, std::min(rows, image.height - row), row_bytes);
    }
}

} // namespace

std::size_t bytes_per_texel(Format format) { return format == Format::rgba32f || format == Format::rgba32ui ? 16 : 4; }

vk::Format vulkan_format(Format format) {
    switch (format) {
    case Format::rgba8:
        return vk::Format::eR8G8B8A8Unorm;
    case Format::rgba8_srgb:
        return vk::Format::eR8G8B8A8Srgb;
    case Format::r32ui:
        return vk::Format::eR32Uint;
    case Format::rgba32ui:
        return vk::Format::eR32G32B32A32Uint;
    case Format::r32f:
        return vk::Format::eR32Sfloat;
    case Format::rgba32f:
        return vk::Format::eR32G32B32A32Sfloat;
    case Format::d32:
        return vk::Format::eD32Sfloat;
    }
    return vk::Format::eUndefined;
}

vk::ImageAspectFlags aspect_of(Format format) {
    return format == Format::d32 ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
}

Image::Image(Context& context, const ImageDescription& description) : m_handle(std::make_unique<Handle>()) {
    check_size(context, description);
    m_handle->context = &context;
    m_handle->description = description;
    if (description.mip_maps) {
        m_handle->levels = static_cast<std::uint32_t>(
            std::bit_width(static_cast<unsigned>(std::max(description.width, description.height))));
    }
    const std::string what =
        "gpu: image of " + std::to_string(description.width) + " x " + std::to_string(description.height) + " texels";
    translated(what, [&] {
        const Context::State& state = context.state();
        const vk::Extent3D extent(static_cast<std::uint32_t>(description.width),
                                  static_cast<std::uint32_t>(description.height), 1);
        vk::raii::Image image(state.device,
                              vk::ImageCreateInfo({}, vk::ImageType::e2D, vulkan_format(description.format), extent,
                                                  m_handle->levels, 1, vk::SampleCountFlagBits::e1,
                                                  vk::ImageTiling::eOptimal, usage_of(description)));
        vk::MemoryPropertyFlags properties;
        m_handle->memory = allocate(state, image.getMemoryRequirements(), Memory::device, properties);
        image.bindMemory(*m_handle->memory, 0);
        m_handle->image = std::move(image);
        if (description.target || description.storage || description.sampled) {
            m_handle->view = make_view(state, *m_handle, m_handle->levels);
            m_handle->first_level = make_view(state, *m_handle, 1);
        }
    });
    enter_general_layout(context, *m_handle);
}

Image::~Image() = default;
Image::Image(Image&&) noexcept = default;
Image& Image::operator=(Image&&) noexcept = default;

const ImageDescription& Image::description() const { return m_handle->description; }

std::size_t Image::size() const {
    return static_cast<std::size_t>(m_handle->description.width) *
           static_cast<std::size_t>(m_handle->description.height) * bytes_per_texel(m_handle->description.format);
}

void Image::upload(std::span<const std::byte> texels) {
    const Buffer& stage = staging_upload(*m_handle->context);
    const ImageDescription& image = m_handle->description;
    for_each_band(image, stage, [&](int row, int rows, std::size_t row_bytes) {
        const auto band =
            texels.subspan(static_cast<std::size_t>(row) * row_bytes, static_cast<std::size_t>(rows) * row_bytes);
        std::ranges::copy(band, stage.bytes().begin());
        m_handle->context->run([&](Commands& commands) {
            commands.copy(stage, 0, *this, Region{0, row, image.width, rows});
            if (row + rows == image.height) {
                make_mip_maps(*m_handle, commands);
            }
        });
    });
}

void Image::download(std::span<std::byte> texels) const {
    const Buffer& stage = staging_read_back(*m_handle->context);
    const ImageDescription& image = m_handle->description;
    for_each_band(image, stage, [&](int row, int rows, std::size_t row_bytes) {
        m_handle->context->run([&](Commands& commands) {
            commands.copy(*this, Region{0, row, image.width, rows}, stage);
        });
        const std::size_t bytes = static_cast<std::size_t>(rows) * row_bytes;
        std::ranges::copy(stage.bytes().first(bytes),
                          texels.subspan(static_cast<std::size_t>(row) * row_bytes, bytes).begin());
    });
}

} // namespace vkbake::gpu
