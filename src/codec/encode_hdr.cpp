#include "codec/encode_hdr.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "codec/into_range.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

// The largest value that RGBE holds: mantissa 255/256, exponent 127.
constexpr float largest_rgbe = 0x1.FEp+126F;

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

/// An image file in memory that OpenImageIO writes into.
class MemoryOutput {
public:
    MemoryOutput(const OIIO::ImageSpec& spec, const Poll& poll)
        : m_proxy(m_bytes), m_output(OIIO::ImageOutput::create("hdr")), m_poll(poll) {
        require(m_output != nullptr);
        require(m_output->set_ioproxy(&m_proxy) && m_output->open("memory.hdr", spec));
    }

    void row(int y, const std::vector<glm::vec3>& colors) {
        if (m_poll) {
            m_poll();
        }
        require(m_output->write_scanline(y, 0, OIIO::TypeDesc::FLOAT, colors.data()));
    }

    [[nodiscard]] std::vector<std::uint8_t> finish() {
        require(m_output->close());
        return std::move(m_bytes);
    }

private:
    void require(bool done) const {
        if (!done) {
            const std::string reason = m_output ? m_output->geterror() : OIIO::geterror();
            throw Error(ErrorKind::output, "encoding hdr: " + one_line(reason) + "; choose another format");
        }
    }

    std::vector<std::uint8_t> m_bytes;
    OIIO::Filesystem::IOVecOutput m_proxy;
    std::unique_ptr<OIIO::ImageOutput> m_output; // closes itself into the proxy when it goes, so it goes first
    const Poll& m_poll;
};

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

} // namespace

EncodedFile encode_hdr(const Image& image, const Poll& poll) {
    EncodedFile file;
    MemoryOutput memory(OIIO::ImageSpec(image.width, image.height, 3, OIIO::TypeDesc::FLOAT), poll);
    std::vector<glm::vec3> row(static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            glm::vec3 color(image.texels[image.index(x, y)]);
            for (int channel = 0; channel < 3; ++channel) {
                color[channel] = into_range(color[channel], largest_rgbe, file.changed_values);
            }
            row[static_cast<std::size_t>(x)] = round_to_rgbe(color);
        }
        memory.row(y, row);
    }
    file.bytes = memory.finish();
    return file;
}

} // namespace vkbake
