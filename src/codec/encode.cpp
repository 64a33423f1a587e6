#include "codec/encode.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "vkbake/error.hpp"

namespace vkbake {
namespace {

// The largest value that RGBE holds: mantissa 255/256, exponent 127.
constexpr float largest_rgbe = 0x1.FEp+126F;
constexpr int exr_tile = 64;

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

/// An image file in memory that OpenImageIO writes into.
class MemoryOutput {
public:
    MemoryOutput(const std::string& format, const OIIO::ImageSpec& spec, const Poll& poll)
        : m_proxy(m_bytes), m_output(OIIO::ImageOutput::create(format)), m_format(format), m_poll(poll) {
        require(m_output != nullptr);
        require(m_output->set_ioproxy(&m_proxy) && m_output->open("memory." + format, spec));
    }

    /// Calls write(output), which writes some rows and returns whether it could.
    template<class Write>
    void rows(const Write& write) {
        if (m_poll) {
            m_poll();
        }
        require(write(*m_output));
    }

    [[nodiscard]] std::vector<std::uint8_t> finish() {
        require(m_output->close());
        return std::move(m_bytes);
    }

private:
    void require(bool done) const {
        if (!done) {
            const std::string reason = m_output ? m_output->geterror() : OIIO::geterror();
            throw Error(ErrorKind::output,
                        "encoding " + m_format + ": " + one_line(reason) + "; choose another format");
        }
    }

    std::vector<std::uint8_t> m_bytes;
    OIIO::Filesystem::IOVecOutput m_proxy;
    std::unique_ptr<OIIO::ImageOutput> m_output; // closes itself into the proxy when it goes, so it goes first
    std::string m_format;
    const Poll& m_poll;
};

OIIO::ImageSpec make_spec(int width, int height, int channels, OIIO::TypeDesc::BASETYPE type,
                          const Attributes& attributes) {
    OIIO::ImageSpec spec(width, height, channels, type);
    spec.attribute("DateTime", ""); // else OpenImageIO puts the time of writing into an EXR
    spec.attribute("oiio:UnassociatedAlpha", 1);
    for (const auto& [name, value] : attributes) {
        spec.attribute(name, value);
    }
    return spec;
}

void check(const Image& image) {
    const bool sized = image.width > 0 && image.height > 0;
    const std::size_t count = sized ? image.index(0, image.height) : 0;
    if (!sized || image.texels.size() != count || (!image.coverage.empty() && image.coverage.size() != count)) {
        throw Error(ErrorKind::output, "image of " + std::to_string(image.width) + " × " +
                                           std::to_string(image.height) +
                                           " texels: its arrays have other sizes; fill one value a texel");
    }
}

EncodedFile encode_exr(const Image& image, const Attributes& attributes, const Poll& poll) {
    const std::size_t channels = image.coverage.empty() ? 4 : 5;
    OIIO::ImageSpec spec =
        make_spec(image.width, image.height, static_cast<int>(channels), OIIO::TypeDesc::FLOAT, attributes);
    spec.channelnames = {"R", "G", "B", "A", "coverage"};
    spec.channelnames.resize(channels);
    spec.alpha_channel = 3;
    spec.tile_width = spec.tile_height = exr_tile;
    spec.attribute("compression", "zip");
    spec.attribute("oiio:ColorSpace", "Linear");
    MemoryOutput memory("openexr", spec, poll);

    const auto width = static_cast<std::size_t>(image.width);
    std::vector<float> rows(width * exr_tile * channels);
    for (int top = 0; top < image.height; top += exr_tile) {
        const int bottom = std::min(top + exr_tile, image.height);
        float* next = rows.data();
        for (std::size_t texel = image.index(0, top); texel < image.index(0, bottom); ++texel) {
            next = std::copy_n(&image.texels[texel].x, 4, next);
            if (channels == 5) {
                *next++ = image.coverage[texel];
            }
        }
        memory.rows([&](OIIO::ImageOutput& output) {
            return output.write_tiles(0, image.width, top, bottom, 0, 1, OIIO::TypeDesc::FLOAT, rows.data());
        });
    }
    return {memory.finish(), 0};
}

/// NaN → 0, else the nearest value in [0, largest].
float into_range(float value, float largest, std::uint64_t& changed) {
    const bool inside = value >= 0.0F && value <= largest; // false for NaN
    changed += inside ? 0U : 1U;
    return inside ? value : (value > largest ? largest : 0.0F);
}

/// The nearest colour that RGBE holds. OpenImageIO truncates, which would darken every map by 0.2 % on average.
glm::vec3 round_to_rgbe(const glm::vec3& color) {
    glm::vec3 result = color;
    // Rounding the largest channel may carry into the next exponent; the second turn then uses that one's step.
    for (int turn = 0; turn < 2; ++turn) {
        const float largest = std::max({result.x, result.y, result.z});
        if (largest < 1e-32F) {
            return glm::vec3(0.0F); // the writer's own limit
        }
        int exponent = 0;
        (void)std::frexp(largest, &exponent);
        for (int channel = 0; channel < 3; ++channel) {
            result[channel] = std::ldexp(std::nearbyint(std::ldexp(color[channel], 8 - exponent)), exponent - 8);
        }
    }
    return glm::min(result, glm::vec3(largest_rgbe));
}

EncodedFile encode_hdr(const Image& image, const Attributes& attributes, const Poll& poll) {
    EncodedFile file;
    MemoryOutput memory("hdr", make_spec(image.width, image.height, 3, OIIO::TypeDesc::FLOAT, attributes), poll);
    std::vector<glm::vec3> row(static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            glm::vec3 color(image.texels[image.index(x, y)]);
            for (int channel = 0; channel < 3; ++channel) {
                color[channel] = into_range(color[channel], largest_rgbe, file.changed_values);
            }
            row[static_cast<std::size_t>(x)] = round_to_rgbe(color);
        }
        memory.rows(
            [&](OIIO::ImageOutput& output) { return output.write_scanline(y, 0, OIIO::TypeDesc::FLOAT, row.data()); });
    }
    file.bytes = memory.finish();
    return file;
}

template<typename Value>
constexpr OIIO::TypeDesc::BASETYPE integer_type() {
    return sizeof(Value) == 1 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16;
}

template<typename Value>
EncodedFile encode_png(const Image& image, std::string_view space, const Attributes& attributes, const Poll& poll) {
    constexpr auto largest = static_cast<float>(std::numeric_limits<Value>::max());
    const auto is_opaque = [](const glm::vec4& texel) { return texel.w == 1.0F; };
    const bool opaque = std::all_of(image.texels.begin(), image.texels.end(), is_opaque);
    const int channels = opaque ? 3 : 4;
    OIIO::ImageSpec spec = make_spec(image.width, image.height, channels, integer_type<Value>(), attributes);
    spec.attribute("oiio:ColorSpace", std::string(space));
    MemoryOutput memory("png", spec, poll);

    EncodedFile file;
    std::vector<Value> row(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(channels));
    for (int y = 0; y < image.height; ++y) {
        auto next = row.begin();
        for (int x = 0; x < image.width; ++x) {
            const glm::vec4& texel = image.texels[image.index(x, y)];
            std::uint64_t alpha_changes = 0;
            for (int channel = 0; channel < channels; ++channel) {
                const float value = into_range(texel[channel], 1.0F, channel < 3 ? file.changed_values : alpha_changes);
                *next++ = static_cast<Value>(std::nearbyint(value * largest));
            }
        }
        memory.rows(
            [&](OIIO::ImageOutput& output) { return output.write_scanline(y, 0, integer_type<Value>(), row.data()); });
    }
    file.bytes = memory.finish();
    return file;
}

} // namespace

EncodedFile encode_file(const Image& image, ImageFormat format, const Attributes& attributes, const Poll& poll) {
    check(image);
    switch (format) {
    case ImageFormat::exr:
        return encode_exr(image, attributes, poll);
    case ImageFormat::hdr:
        return encode_hdr(image, attributes, poll);
    case ImageFormat::png16:
        return encode_png<std::uint16_t>(image, "Linear", attributes, poll);
    case ImageFormat::png8:
        return encode_png<std::uint8_t>(image, "sRGB", attributes, poll);
    }
    throw Error(ErrorKind::output, "image: its format is none of the known ones; choose EXR, HDR or PNG");
}

std::vector<std::uint8_t> encode_png_bytes(int width, int height, int channels, std::span<const std::uint8_t> texels,
                                           std::string_view space, const Attributes& attributes, const Poll& poll) {
    const std::size_t count = static_cast<std::size_t>(std::max(width, 0)) *
                              static_cast<std::size_t>(std::max(height, 0)) * static_cast<std::size_t>(channels);
    if (count == 0 || texels.size() != count) {
        throw Error(ErrorKind::output, "image of " + std::to_string(width) + " × " + std::to_string(height) +
                                           " texels: its array has another size; fill one value a texel and channel");
    }
    OIIO::ImageSpec spec = make_spec(width, height, channels, OIIO::TypeDesc::UINT8, attributes);
    spec.attribute("oiio:ColorSpace", std::string(space));
    MemoryOutput memory("png", spec, poll);
    constexpr int band = 64;
    for (int top = 0; top < height; top += band) {
        const std::uint8_t* const first =
            &texels[count / static_cast<std::size_t>(height) * static_cast<std::size_t>(top)];
        memory.rows([&](OIIO::ImageOutput& output) {
            return output.write_scanlines(top, std::min(top + band, height), 0, OIIO::TypeDesc::UINT8, first);
        });
    }
    return memory.finish();
}

} // namespace vkbake
