#include "finish/dilate_reference.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "dilate.h"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

bool is_finite(const glm::vec4& texel) {
    return std::isfinite(texel.r) && std::isfinite(texel.g) && std::isfinite(texel.b);
}

glm::vec3 without_tiny(const glm::vec3& value) {
    const auto kept = [](float v) { return std::abs(v) < DILATE_TINY ? 0.0F : v; };
    return {kept(value.r), kept(value.g), kept(value.b)};
}

/// The neighbours' average, kept between the least and the largest of them: so equal neighbours give their own value to
/// the bit, and a sum beyond the range of floats gives a finite one.
class Average {
public:
    void add(const glm::vec4& neighbour) {
        const glm::vec3 value = without_tiny(glm::vec3(neighbour));
        m_sum = without_tiny(m_sum + value);
        m_least = glm::min(m_least, value);
        m_largest = glm::max(m_largest, value);
        ++m_count;
    }
    [[nodiscard]] bool empty() const { return m_count == 0; }
    [[nodiscard]] glm::vec4 texel() const {
        constexpr std::array<float, 9> reciprocals = DILATE_RECIPROCALS;
        return {glm::min(glm::max(m_sum * reciprocals[m_count], m_least), m_largest), 1.0F};
    }

private:
    glm::vec3 m_sum{0.0F};
    glm::vec3 m_least{std::numeric_limits<float>::max()};
    glm::vec3 m_largest{std::numeric_limits<float>::lowest()};
    std::size_t m_count = 0;
};

Average average_around(const Image& image, int x, int y) {
    Average average;
    for (int row = std::max(y - 1, 0); row <= std::min(y + 1, image.height - 1); ++row) {
        for (int column = std::max(x - 1, 0); column <= std::min(x + 1, image.width - 1); ++column) {
            const glm::vec4& neighbour = image.texels[image.index(column, row)]; // (x, y) itself is empty
            if (is_filled(neighbour) && is_finite(neighbour)) {
                average.add(neighbour);
            }
        }
    }
    return average;
}

} // namespace

bool is_filled(const glm::vec4& texel) { return (std::bit_cast<std::uint32_t>(texel.a) << 1U) != 0; }

std::uint64_t dilate_reference(Image& image, int rounds) {
    if (rounds < 0) {
        throw Error(ErrorKind::usage, "padding: must not be negative; give 0 or more rounds");
    }
    std::uint64_t filled = 0;
    std::vector<glm::vec4> next = image.texels;
    for (int round = 0; round < rounds; ++round) {
        const std::uint64_t before = filled;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                if (is_filled(image.texels[image.index(x, y)])) {
                    continue;
                }
                if (const Average average = average_around(image, x, y); !average.empty()) {
                    next[image.index(x, y)] = average.texel();
                    ++filled;
                }
            }
        }
        if (filled == before) {
            break;
        }
        image.texels = next;
    }
    return filled;
}

} // namespace vkbake
