// Image files ↔ numbers: what the codec module does. OpenImageIO brings some 260 shared libraries, which a process
// would bind for half a second before its first line, whether or not it ever reads an image; so its only user is a
// module that is loaded when a codec is first asked for (imageio/load_codec.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "vkbake/image.hpp"

namespace vkbake {

/// All channels of an image's first part, interleaved, row 0 at the top. Alpha is as the file stores it.
template<typename Value>
struct Samples {
    int width = 0;
    int height = 0;
    std::vector<std::string> channels; ///< names, at least one
    bool integer = false;              ///< the file stores integers; float values are then integer ÷ largest integer
    bool eight_bit = false;            ///< … of 8 bits
    std::vector<Value> values;         ///< width · height · channels.size()
};

/// Guards against files that are small and decode to something huge.
struct SampleLimits {
    int side = 32768;                  ///< texels
    std::uint64_t bytes = 8ULL << 30U; ///< of the decoded values
};

enum class ImageFormat : std::uint8_t {
    exr,   ///< channels R, G, B, A and, where the image has it, coverage; 32-bit floats, bit by bit; tiles of 64², zip
    hdr,   ///< Radiance RGBE: RGB rounded to 8 bits of the largest channel; no alpha, no coverage
    png16, ///< linear values in [0,1] × 65535, rounded
    png8,  ///< values in [0,1] × 255, rounded, not encoded any further
};

/// Names and values that go into the file's metadata, in this order (EXR sorts them; HDR keeps none).
using Attributes = std::vector<std::pair<std::string, std::string>>;

struct EncodedFile {
    std::vector<std::uint8_t> bytes;
    /// Channels (of red, green, blue) that the format cannot hold and that were changed: NaN is written as 0, what is
    /// below the format's range as its least value and what is above as its largest. Rounding does not count. EXR holds
    /// all.
    std::uint64_t changed_values = 0;
};

/// Called between bands of rows and blocks of bytes, so many times a second; what it throws ends the work. May be
/// empty.
using Poll = std::function<void()>;

/// Reads PNG, JPEG, EXR and HDR, told from a file's first bytes, and writes HDR; what bakes write by default needs no
/// module (imageio/encode.hpp). Calls from several threads at a time are fine.
class Codec {
public:
    Codec() = default;
    virtual ~Codec() = default;
    Codec(const Codec&) = delete;
    Codec& operator=(const Codec&) = delete;
    Codec(Codec&&) = delete;
    Codec& operator=(Codec&&) = delete;

    /// Throws Error{bad_input}.
    [[nodiscard]] virtual Samples<float> read_floats(const std::filesystem::path& file) const = 0;
    /// From memory; `name` is for messages. Throws Error{bad_input}.
    [[nodiscard]] virtual Samples<float> read_floats(std::span<const std::byte> bytes, const std::string& name,
                                                     const SampleLimits& limits) const = 0;
    /// The same; where the file has more than 8 bits they are rounded.
    [[nodiscard]] virtual Samples<std::uint8_t> read_bytes(std::span<const std::byte> bytes, const std::string& name,
                                                           const SampleLimits& limits) const = 0;
    /// Width and height alone, from the header. Throws Error{bad_input} as read_bytes.
    [[nodiscard]] virtual std::pair<int, int> read_size(std::span<const std::byte> bytes, const std::string& name,
                                                        const SampleLimits& limits) const = 0;
    /// As encode_image (imageio/encode.hpp) writes HDR: the image's arrays fit its size. Throws Error{output}.
    [[nodiscard]] virtual EncodedFile encode_hdr(const Image& image, const Poll& poll) const = 0;
};

/// What the module exports, under this name; never null. Its file's name carries the version, so both sides agree on
/// Codec.
constexpr const char* codec_entry = "vkbake_codec";
using CodecEntry = const Codec* (*)();

} // namespace vkbake
