#include "codec/read.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <type_traits>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "codec/exr_header.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

[[noreturn]] void refuse(const std::string& where, std::string what, const std::string& advice) {
    while (!what.empty() && (what.back() == '\n' || what.back() == '.')) {
        what.pop_back();
    }
    std::replace(what.begin(), what.end(), '\n', ' ');
    throw Error(ErrorKind::bad_input, where + ": " + what + "; " + advice);
}

constexpr const char* damaged_advice = "the image is damaged or incomplete, get it again";

[[noreturn]] void refuse_damaged(const std::string& where, const OIIO::ImageInput& input) {
    refuse(where, "cannot be decoded: " + input.geterror(), damaged_advice);
}

// Alpha must come as it is stored: by default OpenImageIO multiplies a PNG's colours by it.
OIIO::ImageSpec open_hints() {
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    return hints;
}

template<typename Value>
constexpr OIIO::TypeDesc::BASETYPE value_type() {
    return std::is_same_v<Value, float> ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
}

/// All channels of the first part at full size, where a file's truth is; mip levels and layers are left alone. Band by
/// band of rows: a few bytes that announce a huge picture end at the first band, before there is memory for it.
template<typename Value>
bool read_rows(OIIO::ImageInput& input, std::vector<Value>& values) {
    const OIIO::ImageSpec spec = input.spec();
    constexpr std::size_t band_bytes = std::size_t{16} << 20U;
    const std::size_t row = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.nchannels);
    const int least = std::max(spec.tile_height, 1); // tiles are read whole
    const auto fitting = static_cast<int>(std::min<std::size_t>(band_bytes / (row * sizeof(Value)), 1U << 20U));
    const int band = std::max(fitting / least, 1) * least;
    for (int y = 0; y < spec.height;) {
        if (y > 0) { // address space for all, once there is something of what was announced
            values.reserve(row * static_cast<std::size_t>(spec.height));
        }
        const int rows = std::min(band, spec.height - y);
        const std::size_t begin = values.size();
        values.resize(begin + row * static_cast<std::size_t>(rows));
        Value* const to = &values[begin];
        const int first = spec.y + y;
        const bool done =
            spec.tile_width > 0
                ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, first, first + rows, spec.z, spec.z + 1, 0,
                                   spec.nchannels, value_type<Value>(), to)
                : input.read_scanlines(0, 0, first, first + rows, spec.z, 0, spec.nchannels, value_type<Value>(), to);
        if (!done) {
            return false;
        }
        y += rows;
    }
    return true;
}

template<typename Value>
void check_size(const OIIO::ImageSpec& spec, const std::string& where, const SampleLimits& limits) {
    if (spec.width <= 0 || spec.height <= 0 || spec.depth > 1 || spec.nchannels <= 0 || spec.deep) {
        refuse(where, "is not a flat picture with at least one texel and one channel", "give a two-dimensional image");
    }
    const auto texels = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
    const std::uint64_t bytes = texels * static_cast<std::uint64_t>(spec.nchannels) * sizeof(Value);
    if (spec.width > limits.side || spec.height > limits.side || bytes > limits.bytes) {
        refuse(where,
               "has " + std::to_string(spec.width) + " × " + std::to_string(spec.height) + " texels and " +
                   std::to_string(spec.nchannels) + " channels, which is more than the limit of " +
                   std::to_string(limits.side) + " a side and " + std::to_string(limits.bytes >> 20U) + " MiB decoded",
               "make it smaller");
    }
}

template<typename Value>
Samples<Value> read_open_input(OIIO::ImageInput& input, const std::string& where, const SampleLimits& limits) {
    const OIIO::ImageSpec& spec = input.spec();
    check_size<Value>(spec, where, limits);
    Samples<Value> samples;
    samples.width = spec.width;
    samples.height = spec.height;
    samples.channels = spec.channelnames;
    samples.channels.resize(static_cast<std::size_t>(spec.nchannels));
    samples.integer = !spec.format.is_floating_point();
    samples.eight_bit = samples.integer && spec.format.size() == 1;
    if (!read_rows(input, samples.values)) {
        refuse_damaged(where, input);
    }
    return samples;
}

/// The name of OpenImageIO's reader for what begins so, or empty.
std::string_view format_of(std::span<const std::byte> bytes) {
    struct Signature {
        std::string_view magic;
        std::string_view format;
    };
    static constexpr std::array<Signature, 4> signatures{{{"\x89PNG\r\n\x1a\n", "png"},
                                                          {"\xff\xd8\xff", "jpeg"},
                                                          {"\x76\x2f\x31\x01", "openexr"},
                                                          {"#?", "hdr"}}}; // #?RADIANCE, #?RGBE
    for (const Signature& signature : signatures) {
        const auto same = [](char character, std::byte byte) { return static_cast<std::byte>(character) == byte; };
        if (bytes.size() >= signature.magic.size() &&
            std::equal(signature.magic.begin(), signature.magic.end(), bytes.begin(), same)) {
            return signature.format;
        }
    }
    return {};
}

/// The reader that the first bytes call for: OpenImageIO, left to itself, would try all that it has on a file that none
/// can read, and each of them has faults of its own.
std::unique_ptr<OIIO::ImageInput> make_input(OIIO::Filesystem::IOProxy& file, const std::string& where) {
    std::array<std::byte, 16> head{};
    const std::size_t length = file.pread(head.data(), head.size(), 0);
    const std::string_view format = format_of(std::span(head).first(std::min(length, head.size())));
    if (format.empty()) {
        refuse(where, "is of no format known here", "give an EXR, HDR, PNG or JPEG image");
    }
    if (format == "openexr" && !holds_its_attributes(file)) {
        refuse(where, "cannot be decoded: its header announces what the file does not hold", damaged_advice);
    }
    auto input = OIIO::ImageInput::create(std::string(format));
    if (!input) {
        refuse(where, "there is no reader for " + std::string(format) + ": " + OIIO::geterror(),
               "install OpenImageIO with it, or give another format");
    }
    return input;
}

std::unique_ptr<OIIO::ImageInput> open_memory(OIIO::Filesystem::IOMemReader& memory, const std::string& name,
                                              const std::string& where) {
    auto input = make_input(memory, where);
    OIIO::ImageSpec spec;
    if (!input->set_ioproxy(&memory) || !input->open(name, spec, open_hints())) {
        refuse_damaged(where, *input);
    }
    return input;
}

} // namespace

template<typename Value>
Samples<Value> read_samples(const std::filesystem::path& file) {
    const std::string where = file.string();
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        refuse(where, "there is no such file", "check the path");
    }
    OIIO::Filesystem::IOFile stored(where, OIIO::Filesystem::IOProxy::Read);
    const auto input = make_input(stored, where);
    OIIO::ImageSpec spec;
    if (!input->open(where, spec, open_hints())) {
        refuse_damaged(where, *input);
    }
    return read_open_input<Value>(*input, where, SampleLimits{});
}

template<typename Value>
Samples<Value> read_samples(std::span<const std::byte> bytes, const std::string& name, const SampleLimits& limits) {
    const std::string where = "image " + name;
    OIIO::Filesystem::IOMemReader memory(const_cast<std::byte*>(bytes.data()), bytes.size()); // read only
    return read_open_input<Value>(*open_memory(memory, name, where), where, limits);
}

std::pair<int, int> read_size(std::span<const std::byte> bytes, const std::string& name, const SampleLimits& limits) {
    const std::string where = "image " + name;
    OIIO::Filesystem::IOMemReader memory(const_cast<std::byte*>(bytes.data()), bytes.size()); // read only
    const auto input = open_memory(memory, name, where);
    check_size<std::uint8_t>(input->spec(), where, limits);
    return {input->spec().width, input->spec().height};
}

template Samples<float> read_samples<float>(const std::filesystem::path&);
template Samples<float> read_samples<float>(std::span<const std::byte>, const std::string&, const SampleLimits&);
template Samples<std::uint8_t> read_samples<std::uint8_t>(std::span<const std::byte>, const std::string&,
                                                          const SampleLimits&);

} // namespace vkbake
