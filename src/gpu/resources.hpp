// Buffers and images. Each owns its memory; keep them from tile to tile: the first touch of fresh memory costs most.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <variant>

namespace vkbake::gpu {

class Context;

enum class Memory : std::uint8_t {
    device,    ///< the host reaches it by upload and download, through a staging buffer
    upload,    ///< mapped; the host writes, shaders read it or it is copied from
    read_back, ///< mapped and cached by the host where such memory exists; copied to, then read by the host
};

/// Usable as a storage buffer and as either end of a copy. Its content is undefined until written.
class Buffer {
public:
    /// `bytes` > 0.
    Buffer(Context& context, std::size_t bytes, Memory memory);
    ~Buffer();
    Buffer(Buffer&&) noexcept;
    Buffer& operator=(Buffer&&) noexcept;
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    [[nodiscard]] std::size_t size() const; ///< bytes

    /// The mapped memory; `upload` and `read_back` only. To be written and read between runs, never during one.
    [[nodiscard]] std::span<std::byte> bytes() const;

    /// The mapped memory as an array of T.
    template<class T>
    [[nodiscard]] std::span<T> as() const {
        const std::span<std::byte> all = bytes();
        return {reinterpret_cast<T*>(all.data()), all.size() / sizeof(T)};
    }

    /// Copy to and from memory of any kind. offset + data.size() ≤ size(); both multiples of 4.
    void upload(std::span<const std::byte> data, std::size_t offset = 0);
    void download(std::span<std::byte> data, std::size_t offset = 0) const;

    struct Handle;
    [[nodiscard]] const Handle& handle() const { return *m_handle; } ///< for src/gpu alone

private:
    std::unique_ptr<Handle> m_handle;
};

enum class Format : std::uint8_t { rgba8, rgba8_srgb, r32ui, rgba32ui, r32f, rgba32f, d32 };

[[nodiscard]] std::size_t bytes_per_texel(Format format);

struct ImageDescription {
    Format format = Format::rgba32f;
    int width = 0;
    int height = 0;
    bool target = false;   ///< drawn to: colour, or depth for d32
    bool storage = false;  ///< read and written by shaders (not rgba8_srgb, d32)
    bool sampled = false;  ///< read through a sampler
    bool mip_maps = false; ///< has all levels down to 1×1; upload makes them by halving (sampled rgba8, rgba8_srgb)
};

/// Usable as either end of a copy as well. Its content is undefined until written. Stays in one layout from its making
/// on, so that a barrier names stages only.
class Image {
public:
    /// Throws Error{bake_failed} above Limits::image_side.
    Image(Context& context, const ImageDescription& description);
    ~Image();
    Image(Image&&) noexcept;
    Image& operator=(Image&&) noexcept;
    Image(const Image&) = delete;
    Image& operator=(const Image&) = delete;

    [[nodiscard]] const ImageDescription& description() const;
    [[nodiscard]] std::size_t size() const; ///< bytes of the largest level, rows without padding

    /// Whole image, row 0 first, rows without padding.
    void upload(std::span<const std::byte> texels);
    void download(std::span<std::byte> texels) const;

    struct Handle;
    [[nodiscard]] const Handle& handle() const { return *m_handle; } ///< for src/gpu alone

private:
    std::unique_ptr<Handle> m_handle;
};

enum class Wrap : std::uint8_t { repeat, clamp, mirror };
enum class Filter : std::uint8_t { nearest, linear };

struct Sampler {
    Wrap u = Wrap::clamp;
    Wrap v = Wrap::clamp;
    Filter filter = Filter::linear; ///< within and between mip levels
};

/// What a shader's slot sees during one draw or dispatch.
struct BufferRange {
    const Buffer* buffer = nullptr;
    std::size_t offset = 0; ///< multiple of 256
    std::size_t bytes = 0;  ///< 0: to the end; ≤ Limits::storage_buffer_range
};
struct StorageImage {
    const Image* image = nullptr;
};
struct SampledImage {
    const Image* image = nullptr;
    Sampler sampler = {};
};
using Resource = std::variant<BufferRange, StorageImage, SampledImage>;

[[nodiscard]] inline Resource storage(const Buffer& buffer) { return BufferRange{.buffer = &buffer}; }
[[nodiscard]] inline Resource storage(const Image& image) { return StorageImage{.image = &image}; }
[[nodiscard]] inline Resource sampled(const Image& image, const Sampler& sampler = {}) {
    return SampledImage{.image = &image, .sampler = sampler};
}

} // namespace vkbake::gpu
