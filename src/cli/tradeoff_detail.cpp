#include "tradeoff_page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace vkbake::cli {
namespace {

constexpr int detail_side = 64;
constexpr double error_gain = 10.0;

double grey(const Image& image, int x, int y) {
    const glm::vec4& texel = image.texels[image.index(x, y)];
    return 0.2126 * static_cast<double>(texel.x) + 0.7152 * static_cast<double>(texel.y) +
           0.0722 * static_cast<double>(texel.z);
}

std::uint8_t srgb_byte(double linear) {
    const double value = std::clamp(linear, 0.0, 1.0);
    const double encoded = value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * encoded));
}

std::string base64(const std::vector<std::uint8_t>& bytes) {
    constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t word = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            word = (word << 8U) | (i + j < bytes.size() ? bytes[i + j] : 0U);
        }
        for (unsigned j = 0; j < 4; ++j) {
            text += i + j <= bytes.size() ? letters[(word >> (18U - 6U * j)) & 63U] : '=';
        }
    }
    return text;
}

/// Rows from the top, three bytes a pixel (red, green, blue).
std::vector<std::uint8_t> bmp(int width, int height, const std::vector<std::uint8_t>& pixels) {
    constexpr std::uint32_t header = 54;
    const auto row = static_cast<std::uint32_t>((3 * width + 3) / 4 * 4);
    std::vector<std::uint8_t> bytes(header + row * static_cast<std::uint32_t>(height), 0);
    const auto put = [&](std::size_t place, std::uint32_t value, std::size_t size) {
        for (std::size_t i = 0; i < size; ++i) {
            bytes[place + i] = static_cast<std::uint8_t>(value >> (8U * i));
        }
    };
    put(0, 0x4D42, 2);
    put(2, static_cast<std::uint32_t>(bytes.size()), 4);
    put(10, header, 4);
    put(14, 40, 4);
    put(18, static_cast<std::uint32_t>(width), 4);
    put(22, static_cast<std::uint32_t>(-height), 4); // rows from the top
    put(26, 1, 2);
    put(28, 24, 2);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t from =
                3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
            const std::size_t to = header + static_cast<std::size_t>(y) * row + 3 * static_cast<std::size_t>(x);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                bytes[to + channel] = pixels[from + 2 - channel];
            }
        }
    }
    return bytes;
}

} // namespace

DetailPlace choose_detail(const Bake& reference) {
    DetailPlace best;
    double most = -1.0;
    for (std::size_t index = 0; index < reference.light_maps.size(); ++index) {
        const Image& image = reference.light_maps[index].image;
        const int side = std::min({detail_side, image.width, image.height});
        for (int top = 0; top + side <= image.height; top += std::max(side / 2, 1)) {
            for (int left = 0; left + side <= image.width; left += std::max(side / 2, 1)) {
                double sum = 0.0;
                double squares = 0.0;
                double white = 0.0;
                double covered = 0.0;
                for (int y = top; y < top + side; ++y) {
                    for (int x = left; x < left + side; ++x) {
                        if (image.coverage[image.index(x, y)] > 0.5F) {
                            const double value = grey(image, x, y);
                            sum += value;
                            squares += value * value;
                            white = std::max(white, value);
                            covered += 1.0;
                        }
                    }
                }
                // Total variation, not mean: an empty square with one bright texel shows nothing.
                const double varies = covered > 0.0 ? squares - sum * sum / covered : 0.0;
                if (varies > most) {
                    most = varies;
                    best = {index, left, top, side, std::max(white, 1e-30)};
                }
            }
        }
    }
    return best;
}

std::string detail_picture(const Bake& bake, const Bake& reference, const DetailPlace& place) {
    const Image& image = bake.light_maps.at(place.map).image;
    const Image& truth = reference.light_maps.at(place.map).image;
    std::vector<std::uint8_t> pixels;
    for (int y = place.y; y < place.y + place.side; ++y) {
        for (int x = place.x; x < place.x + place.side; ++x) {
            const glm::vec4& texel = image.texels[image.index(x, y)];
            for (int channel = 0; channel < 3; ++channel) {
                pixels.push_back(srgb_byte(static_cast<double>(texel[channel]) / place.white));
            }
        }
        for (int x = place.x; x < place.x + place.side; ++x) {
            const bool covered = image.coverage[image.index(x, y)] > 0.5F;
            const double error =
                covered ? error_gain * std::abs(grey(image, x, y) - grey(truth, x, y)) / place.white : 0.0;
            pixels.insert(pixels.end(), 3, srgb_byte(error));
        }
    }
    return base64(bmp(2 * place.side, place.side, pixels));
}

} // namespace vkbake::cli
