#include "trace/resample_sky.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "base/elementary.hpp"
#include "base/parallel.hpp"
#include "bvh/ray_block.hpp"
#include "trace/sky_sum.hpp"

namespace vkbake {

namespace {

// 384² words are what a core's own cache holds beside all else. With 1024² look-ups take twice as long.
constexpr int least_side = 128;
constexpr int greatest_side = 384;

struct Picture {
    const BorderedImages* images = nullptr;
    int width = 0; ///< texels once around the horizon
};

std::optional<Picture> picture_of(const SkyLookup& sky) {
    if (const auto* const panorama = std::get_if<EquirectangularLookup>(&sky)) {
        return Picture{&panorama->image, panorama->image.width()};
    }
    if (const auto* const cube = std::get_if<CubeLookup>(&sky)) {
        return Picture{&cube->faces, 4 * cube->faces.width()};
    }
    return std::nullopt;
}

/// Look-ups along a texel of the map. Pictures that would ask for more are halved first, which costs less.
constexpr double most_points = 8.0;

// A map's texel is 3.54 / side wide, the root of its mean solid angle, a picture's 6.28 / width: two points for each.
double points_wanted(int width, int side) { return 1.13 * width / side; }

/// Each texel the mean of four by their solid angles.
EquirectangularLookup halved(const EquirectangularLookup& sky, int threads) {
    const int width = sky.image.width() / 2;
    const int height = sky.image.height() / 2;
    EquirectangularLookup half{sky.turn, BorderedImages(1, width, height)};
    parallel_ranges(static_cast<std::size_t>(height), 8, threads, [&](std::size_t begin, std::size_t end) {
        for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
            const auto sine = [&](int row) { return sine_cosine_degrees(90.0 * (row + 0.5) / height).sine; };
            const double above = sine(2 * y) / (sine(2 * y) + sine(2 * y + 1));
            for (int x = 0; x < width; ++x) {
                const auto pair = [&](int row) {
                    return glm::dvec3(sky.image.at(0, 2 * x, row)) + glm::dvec3(sky.image.at(0, 2 * x + 1, row));
                };
                half.image.at(0, x, y) = glm::vec3(0.5 * (above * pair(2 * y) + (1.0 - above) * pair(2 * y + 1)));
            }
        }
    });
    wrap_around(half.image);
    return half;
}

bool can_be_halved(const EquirectangularLookup& sky) {
    return sky.image.width() % 2 == 0 && sky.image.height() % 2 == 0;
}

/// The means over texels of a map, by look-ups of a picture at a grid of points in each.
class MeanRadiance {
public:
    MeanRadiance(const SkyLookup& picture, int side, int points) : m_picture(&picture), m_side(side), m_points(points) {
        m_all.fill(static_cast<RayBlock::LaneBits>((1U << RayBlock::lanes) - 1U));
    }

    void fill(int row, std::span<glm::dvec3> means) const {
        const std::size_t in_line = means.size() * static_cast<std::size_t>(m_points);
        std::vector<double> solid_angles(means.size(), 0.0);
        std::ranges::fill(means, glm::dvec3(0.0));
        for (int line = 0; line < m_points; ++line) {
            for (std::size_t first = 0; first < in_line; first += RayBlock::rays) {
                add(row + (line + 0.5) / m_points, first, std::min(in_line, first + RayBlock::rays), means,
                    solid_angles);
            }
        }
        for (std::size_t x = 0; x < means.size(); ++x) {
            means[x] /= solid_angles[x];
        }
    }

private:
    /// Points `first` … `end` of a line of them.
    void add(double y, std::size_t first, std::size_t end, std::span<glm::dvec3> sums,
             std::span<double> solid_angles) const {
        RayBlock block;
        std::array<double, RayBlock::rays> solid_angle{};
        for (std::size_t i = first; i < end; ++i) {
            const glm::dvec3 point = SkyMap::octahedron_point(m_side, (static_cast<double>(i) + 0.5) / m_points, y);
            const double square = glm::dot(point, point);
            solid_angle[i - first] = 1.0 / (square * std::sqrt(square));         // dω = dA · distance / |p|³
            auto& [xs, ys, zs] = block.direction[(i - first) / RayBlock::lanes]; // of any length, for a picture
            const std::size_t lane = (i - first) % RayBlock::lanes;
            xs[lane] = static_cast<float>(point.x);
            ys[lane] = static_cast<float>(point.y);
            zs[lane] = static_cast<float>(point.z);
        }
        RadianceRows radiance;
        look_up_sky(*m_picture, block, m_all, radiance);
        for (std::size_t i = first; i < end; ++i) {
            const auto& [red, green, blue] = radiance[(i - first) / RayBlock::lanes];
            const std::size_t lane = (i - first) % RayBlock::lanes;
            const std::size_t texel = i / static_cast<std::size_t>(m_points);
            sums[texel] += solid_angle[i - first] * glm::dvec3(red[lane], green[lane], blue[lane]);
            solid_angles[texel] += solid_angle[i - first];
        }
    }

    const SkyLookup* m_picture; ///< never null
    int m_side;
    int m_points; ///< of a texel, along each axis
    BlockedRays m_all{};
};

} // namespace

void resample(SkyLookup& sky, int threads) {
    const std::optional<Picture> picture = picture_of(sky);
    if (!picture) {
        return;
    }
    const int side = std::clamp(picture->width / 16 * 6, least_side, greatest_side);
    const bool packs = picture->images->has_shared_exponents();
    int width = picture->width;
    for (auto* panorama = std::get_if<EquirectangularLookup>(&sky);
         panorama != nullptr && points_wanted(width, side) > most_points && can_be_halved(*panorama); width /= 2) {
        *panorama = halved(*panorama, threads);
    }
    const int points = std::max(2, static_cast<int>(std::ceil(points_wanted(width, side))));
    const MeanRadiance radiance(sky, side, points);
    const SkyMap::FillRow fill_row = [&](int row, std::span<glm::dvec3> means) { radiance.fill(row, means); };
    SkyMap map(side, fill_row, threads);
    if (packs) {
        map.pack();
    }
    sky = MapLookup{std::move(map)};
}

} // namespace vkbake
