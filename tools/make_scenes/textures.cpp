#include "make_scenes/textures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/vec2.hpp>

#include "make_scenes/turn.hpp"

namespace vkbake::scenes {
namespace {

constexpr std::uint32_t side = 256;

std::uint32_t mixed(std::uint32_t h) { // a 32-bit finaliser after MurmurHash3
    h ^= h >> 16;
    h *= 0x85EBCA6BU;
    h ^= h >> 13;
    h *= 0xC2B2AE35U;
    return h ^ h >> 16;
}

// Smooth noise in 0…1 that repeats after one texture; `across` and `along` are its lattice's counts.
double noise(double u, double v, std::uint32_t across, std::uint32_t along, std::uint32_t seed) {
    const double x = u * across;
    const double y = v * along;
    const auto x0 = static_cast<std::uint32_t>(x);
    const auto y0 = static_cast<std::uint32_t>(y);
    const auto eased = [](double t) { return t * t * (3.0 - 2.0 * t); };
    const double fx = eased(x - x0);
    const double fy = eased(y - y0);
    const auto value = [&](std::uint32_t i, std::uint32_t j) {
        return random_of(mixed(seed + (i % across) * 7919U) + (j % along) * 104729U);
    };
    const double low = value(x0, y0) + (value(x0 + 1, y0) - value(x0, y0)) * fx;
    const double high = value(x0, y0 + 1) + (value(x0 + 1, y0 + 1) - value(x0, y0 + 1)) * fx;
    return low + (high - low) * fy;
}

double wood(double u, double v) {
    // Lines that wander: the noise that bends them is long along the fibres.
    const double bent = u + 0.05 * noise(u, v, 4, 2, 1);
    const double wrapped = bent - std::floor(bent);
    const double rings = noise(wrapped, v, 22, 2, 2);
    const double fibres = noise(wrapped, v, 110, 6, 3);
    return 0.62 * rings + 0.38 * fibres;
}

double grain(double u, double v) {
    return 0.30 * noise(u, v, 6, 6, 11) + 0.30 * noise(u, v, 24, 24, 12) + 0.40 * noise(u, v, 110, 110, 13);
}

// Whether a place lies on a leaf that grows from `foot` towards `tip`, and how far from its midrib: 0 … 1.
struct OnLeaf {
    bool inside = false;
    double beside = 0.0;
};

OnLeaf on_leaf(const glm::dvec2& place, const glm::dvec2& foot, const glm::dvec2& tip) {
    const glm::dvec2 along = tip - foot;
    const glm::dvec2 offset = place - foot;
    const double length_squared = along.x * along.x + along.y * along.y;
    const double t = (offset.x * along.x + offset.y * along.y) / length_squared;
    if (t <= 0.0 || t >= 1.0) {
        return {};
    }
    const double across = std::abs(offset.x * along.y - offset.y * along.x) / length_squared;
    const double half_width = 0.62 * std::sqrt(t) * (1.0 - t) * (1.0 - 0.25 * t); // widest near the foot, pointed
    return {across < half_width, across / half_width};
}

// A twig along v with pairs of leaves; 0: nothing there, 1: wood, 2 … 15: leaf, from its midrib outwards.
std::uint8_t sprig(double u, double v) {
    const glm::dvec2 place(u, 1.0 - v);
    std::uint8_t texel = std::abs(place.x - 0.5 - 0.03 * on_circle(place.y).x) < 0.007 && place.y < 0.9 ? 1 : 0;
    constexpr std::uint32_t leaves = 11;
    for (std::uint32_t leaf = 0; leaf < leaves; ++leaf) {
        const double height = leaf + 1 < leaves ? 0.03 + 0.075 * leaf : 0.72;
        const double side_of = leaf + 1 == leaves ? 0.0 : (leaf % 2 == 0 ? 1.0 : -1.0);
        const double reach = 0.36 + 0.08 * random_of(leaf + 5);
        const glm::dvec2 foot(0.5 + 0.03 * on_circle(height).x, height);
        const glm::dvec2 tip =
            foot + reach * glm::dvec2(0.96 * side_of, side_of == 0.0 ? 0.55 : 0.12 + 0.4 * random_of(leaf + 50));
        const OnLeaf on = on_leaf(place, foot, tip);
        if (on.inside) {
            texel = static_cast<std::uint8_t>(2.0 + std::min(13.0, 3.0 * (leaf % 3) + 8.0 * on.beside));
        }
    }
    return texel;
}

PaletteImage make_sprig() {
    PaletteImage image{.side = side, .palette = {{96, 118, 60}, {96, 74, 48}}, .texels = {}, .first_is_clear = true};
    for (int k = 0; k < 14; ++k) {
        const auto mixed_colour = [&](double from, double to) {
            return static_cast<std::uint8_t>(std::lround(from + (to - from) * k / 13.0));
        };
        image.palette.push_back({mixed_colour(132, 78), mixed_colour(150, 106), mixed_colour(84, 52)});
    }
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            image.texels.push_back(sprig((x + 0.5) / side, (y + 0.5) / side));
        }
    }
    return image;
}

} // namespace

double random_of(std::uint32_t number) { return mixed(number * 0x9E3779B9U + 0x7F4A7C15U) / 4294967296.0; }

PaletteImage make_texture(Texture texture) {
    if (texture == Texture::sprig) {
        return make_sprig();
    }
    PaletteImage image;
    image.side = side;
    // sRGB bytes from the darkest to the lightest: wood's dark lines are warmer than its light ones.
    const std::array<double, 3> dark =
        texture == Texture::wood ? std::array{188.0, 172.0, 158.0} : std::array{214.0, 212.0, 210.0};
    const std::array<double, 3> light =
        texture == Texture::wood ? std::array{252.0, 250.0, 246.0} : std::array{254.0, 254.0, 254.0};
    for (int k = 0; k < 16; ++k) {
        std::array<std::uint8_t, 3> colour{};
        for (std::size_t c = 0; c < 3; ++c) {
            colour[c] = static_cast<std::uint8_t>(std::lround(dark[c] + (light[c] - dark[c]) * k / 15.0));
        }
        image.palette.push_back(colour);
    }
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const double u = static_cast<double>(x) / side;
            const double v = static_cast<double>(y) / side;
            const double value = texture == Texture::wood ? wood(u, v) : grain(u, v);
            const double stretched = std::clamp((value - 0.2) / 0.6, 0.0, 1.0);
            image.texels.push_back(static_cast<std::uint8_t>(std::lround(stretched * 15.0)));
        }
    }
    return image;
}

ColorImage make_cobble_normals() {
    constexpr std::int64_t cells = 8; // along each side, a cobble in each
    // Height over the joints, in sides of the texture: a dome by how much farther the second nearest middle is.
    const auto height_at = [](double u, double v) {
        double nearest = 9.0;
        double second = 9.0;
        const auto column = static_cast<std::int64_t>(std::floor(u * cells));
        const auto row = static_cast<std::int64_t>(std::floor(v * cells));
        for (std::int64_t y = row - 2; y <= row + 2; ++y) {
            for (std::int64_t x = column - 2; x <= column + 2; ++x) {
                const auto number = static_cast<std::uint32_t>((x + cells) % cells + cells * ((y + cells) % cells));
                const double away_u = (static_cast<double>(x) + 0.2 + 0.6 * random_of(number)) / cells - u;
                const double away_v = (static_cast<double>(y) + 0.2 + 0.6 * random_of(number + 500)) / cells - v;
                const double away = std::sqrt(away_u * away_u + away_v * away_v);
                second = std::min(second, std::max(away, nearest));
                nearest = std::min(nearest, away);
            }
        }
        const double inside = std::min((second - nearest) * cells / 0.6, 1.0);
        return 0.018 * std::sqrt(inside * (2.0 - inside) + 0.02);
    };
    ColorImage image{.side = side, .texels = {}};
    constexpr double step = 1.0 / side;
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const double u = (x + 0.5) * step;
            const double v = (y + 0.5) * step;
            const double along_u = (height_at(u + step, v) - height_at(u - step, v)) / (2.0 * step);
            const double along_v = (height_at(u, v + step) - height_at(u, v - step)) / (2.0 * step);
            const double length = std::sqrt(along_u * along_u + along_v * along_v + 1.0);
            const auto byte = [&](double part) {
                return static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * part / length));
            };
            image.texels.push_back({byte(-along_u), byte(along_v), byte(1.0)}); // green is up, v is down
        }
    }
    return image;
}

} // namespace vkbake::scenes
