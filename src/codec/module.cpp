#include "codec/encode_hdr.hpp"
#include "codec/read.hpp"

namespace vkbake {
namespace {

class OpenImageIOCodec final : public Codec {
public:
    [[nodiscard]] Samples<float> read_floats(const std::filesystem::path& file) const override {
        return read_samples<float>(file);
    }

    [[nodiscard]] Samples<float> read_floats(std::span<const std::byte> bytes, const std::string& name,
                                             const SampleLimits& limits) const override {
        return read_samples<float>(bytes, name, limits);
    }

    [[nodiscard]] Samples<std::uint8_t> read_bytes(std::span<const std::byte> bytes, const std::string& name,
                                                   const SampleLimits& limits) const override {
        return read_samples<std::uint8_t>(bytes, name, limits);
    }

    [[nodiscard]] std::pair<int, int> read_size(std::span<const std::byte> bytes, const std::string& name,
                                                const SampleLimits& limits) const override {
        return vkbake::read_size(bytes, name, limits);
    }

    [[nodiscard]] EncodedFile encode_hdr(const Image& image, const Poll& poll) const override {
        return vkbake::encode_hdr(image, poll);
    }
};

} // namespace
} // namespace vkbake

// NOLINTNEXTLINE(misc-use-internal-linkage): found by its name (vkbake::codec_entry)
extern "C" const vkbake::Codec* vkbake_codec() {
    static const vkbake::OpenImageIOCodec codec;
    return &codec;
}
