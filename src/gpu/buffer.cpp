#include <algorithm>
#include <cstring>

#include "gpu/commands.hpp"
#include "gpu/memory.hpp"

namespace vkbake::gpu {

namespace {

/// The first type that has all of `wanted`, else the first that has all of `needed`.
std::uint32_t find_memory_type(const Context::State& state, std::uint32_t allowed, vk::MemoryPropertyFlags needed,
                               vk::MemoryPropertyFlags wanted) {
    for (const vk::MemoryPropertyFlags flags : {needed | wanted, needed}) {
        for (std::uint32_t type = 0; type < state.memory.memoryTypeCount; ++type) {
            const bool fits = (allowed & (1U << type)) != 0;
            if (fits && (state.memory.memoryTypes[type].propertyFlags & flags) == flags) {
                return type;
            }
        }
    }
    throw Error(ErrorKind::bake_failed, "gpu: the device has no memory of the kind needed; use another device");
}

constexpr std::size_t staging_bytes = std::size_t{16}
                                      << 20U; // large enough that the submission's cost is lost in the copy

Buffer& staging(Context& context, std::unique_ptr<Buffer>& buffer, Memory memory) {
    if (!buffer) {
        buffer = std::make_unique<Buffer>(context, staging_bytes, memory);
    }
    return *buffer;
}

} // namespace

vk::raii::DeviceMemory allocate(const Context::State& state, const vk::MemoryRequirements& requirements, Memory memory,
                                vk::MemoryPropertyFlags& properties) {
    using enum vk::MemoryPropertyFlagBits;
    vk::MemoryPropertyFlags needed;
    vk::MemoryPropertyFlags wanted;
    switch (memory) {
    case Memory::device:
        wanted = eDeviceLocal;
        break;
    case Memory::upload:
        needed = eHostVisible;
        wanted = eHostCoherent;
        break;
    case Memory::read_back: // uncached memory reads at a fraction of the speed
        needed = eHostVisible;
        wanted = eHostCached;
        break;
    }
    const std::uint32_t type = find_memory_type(state, requirements.memoryTypeBits, needed, wanted);
    properties = state.memory.memoryTypes[type].propertyFlags;
    return {state.device, vk::MemoryAllocateInfo(requirements.size, type)};
}

Buffer& staging_upload(Context& context) { return staging(context, context.state().staging_upload, Memory::upload); }

Buffer& staging_read_back(Context& context) {
    return staging(context, context.state().staging_read_back, Memory::read_back);
}

Buffer::Buffer(Context& context, std::size_t bytes, Memory memory) : m_handle(std::make_unique<Handle>()) {
    translated("gpu: buffer of " + std::to_string(bytes) + " bytes", [&] {
        const Context::State& state = context.state();
        using enum vk::BufferUsageFlagBits;
        const vk::BufferCreateInfo info({}, bytes, eStorageBuffer | eTransferSrc | eTransferDst);
        vk::raii::Buffer buffer(state.device, info);
        vk::MemoryPropertyFlags properties;
        m_handle->memory = allocate(state, buffer.getMemoryRequirements(), memory, properties);
        buffer.bindMemory(*m_handle->memory, 0);
        m_handle->buffer = std::move(buffer);
        if (memory != Memory::device) {
            m_handle->mapped = static_cast<std::byte*>(m_handle->memory.mapMemory(0, VK_WHOLE_SIZE));
        }
        m_handle->coherent = static_cast<bool>(properties & vk::MemoryPropertyFlagBits::eHostCoherent);
    });
    m_handle->context = &context;
    m_handle->size = bytes;
    m_handle->host_access = memory;
    if (!m_handle->coherent && m_handle->mapped != nullptr) {
        context.state().incoherent.insert(m_handle.get());
    }
}

Buffer::~Buffer() {
    if (m_handle) {
        m_handle->context->state().incoherent.erase(m_handle.get());
    }
}

Buffer::Buffer(Buffer&&) noexcept = default;

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(m_handle, other.m_handle); // the other's destructor sees to what this one held
    return *this;
}

std::size_t Buffer::size() const { return m_handle->size; }

std::span<std::byte> Buffer::bytes() const {
    return {m_handle->mapped, m_handle->mapped == nullptr ? 0 : m_handle->size};
}

void Buffer::upload(std::span<const std::byte> data, std::size_t offset) {
    if (m_handle->mapped != nullptr) {
        std::ranges::copy(data, bytes().subspan(offset).begin());
        return;
    }
    const Buffer& stage = staging_upload(*m_handle->context);
    for (std::size_t done = 0; done < data.size(); done += stage.size()) {
        const std::span<const std::byte> piece = data.subspan(done, std::min(stage.size(), data.size() - done));
        std::ranges::copy(piece, stage.bytes().begin());
        m_handle->context->run(
            [&](Commands& commands) { commands.copy(stage, *this, 0, offset + done, piece.size()); });
    }
}

void Buffer::download(std::span<std::byte> data, std::size_t offset) const {
    if (m_handle->mapped != nullptr) {
        std::ranges::copy(bytes().subspan(offset, data.size()), data.begin());
        return;
    }
    const Buffer& stage = staging_read_back(*m_handle->context);
    for (std::size_t done = 0; done < data.size(); done += stage.size()) {
        const std::span<std::byte> piece = data.subspan(done, std::min(stage.size(), data.size() - done));
        m_handle->context->run(
            [&](Commands& commands) { commands.copy(*this, stage, offset + done, 0, piece.size()); });
        std::ranges::copy(stage.bytes().first(piece.size()), piece.begin());
    }
}

} // namespace vkbake::gpu
