#include "trace/texel_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "vkbake/error.hpp"

namespace vkbake {

namespace {

constexpr int side = 4;
static_assert(side * side == RayBlock::lanes);
using Square = std::array<std::uint32_t, RayBlock::lanes>;

void check(const GeometryImage& geometry, std::size_t triangle_count) {
    const std::size_t count = geometry.texel_count();
    if (geometry.width < 0 || geometry.height < 0 ||
        count != static_cast<std::size_t>(geometry.width) * static_cast<std::size_t>(geometry.height) ||
        geometry.position.size() != count || geometry.shading_normal.size() != count ||
        geometry.geometric_normal.size() != count || count > GeometryImage::empty) {
        throw Error(ErrorKind::bake_failed,
                    "trace: the geometry image's arrays do not fit its size; give width × height values in each");
    }
    for (const std::uint32_t triangle : geometry.triangle) {
        if (triangle != GeometryImage::empty && triangle >= triangle_count) {
            throw Error(ErrorKind::bake_failed, "trace: the geometry image names triangle " + std::to_string(triangle) +
                                                    " of " + std::to_string(triangle_count) +
                                                    "; draw it from the same surface");
        }
    }
}

std::uint64_t spread_bits(std::uint64_t word) { // 21 bits, to every third place
    word = (word | (word << 32U)) & 0x001F00000000FFFFULL;
    word = (word | (word << 16U)) & 0x001F0000FF0000FFULL;
    word = (word | (word << 8U)) & 0x100F00F00F00F00FULL;
    word = (word | (word << 4U)) & 0x10C30C30C30C30C3ULL;
    return (word | (word << 2U)) & 0x1249249249249249ULL;
}

/// Along Morton's curve through the bake frame, in cells of 2⁻²⁰.
std::uint64_t place_code(const glm::vec3& position) {
    const auto cell = [](float coordinate) {
        return spread_bits(static_cast<std::uint64_t>(std::clamp((coordinate + 1.0F) * 0x1p20F, 0.0F, 0x1p21F - 1.0F)));
    };
    return (cell(position.x) << 2U) | (cell(position.y) << 1U) | cell(position.z);
}

/// 5 × 5 cells on each face of a cube: an odd number, so that what faces along an axis lies inside a cell and not on
/// the border of four.
std::uint32_t normal_bucket(const glm::vec3& normal) {
    const glm::vec3 size = glm::abs(normal);
    const int major = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    const auto cell = [&](int axis) {
        const float share = size[major] > 0.0F ? normal[axis] / size[major] : 0.0F;
        return static_cast<std::uint32_t>(std::clamp((share + 1.0F) * 2.5F, 0.0F, 4.0F));
    };
    const auto face = static_cast<std::uint32_t>(2 * major) + (normal[major] < 0.0F ? 1U : 0U);
    return (face * 5 + cell((major + 1) % 3)) * 5 + cell((major + 2) % 3);
}

class Tiler {
public:
    explicit Tiler(const GeometryImage& geometry) : m_geometry(&geometry) {}

    std::vector<TexelTile> run() {
        take_squares();
        const Limits strict{std::cos(20.0F * degree), 16.0F * typical_step()};
        std::vector<TexelTile> groups = group(std::exchange(m_left, {}), strict);
        // What even so fills less than half its lanes is worth more together than narrow.
        const Limits loose{std::cos(40.0F * degree), 4.0F * strict.reach};
        for (const TexelTile& tile : groups) {
            if (2 * tile.count >= RayBlock::lanes) {
                m_tiles.push_back(tile);
            } else {
                m_left.insert(m_left.end(), tile.texels.begin(), tile.texels.begin() + tile.count);
            }
        }
        groups = group(m_left, loose);
        m_tiles.insert(m_tiles.end(), groups.begin(), groups.end());
        return in_order();
    }

private:
    static constexpr float degree = 3.14159265F / 180.0F;

    /// How unlike the texels of a group may be.
    struct Limits {
        float cosine; ///< of the angle between a normal and the group's first
        float reach;  ///< the longest side of the group's box
    };

    void take_squares() {
        for (int top = 0; top < m_geometry->height; top += side) {
            for (int left = 0; left < m_geometry->width; left += side) {
                Square texels{};
                std::uint32_t count = 0;
                for (int y = top; y < std::min(top + side, m_geometry->height); ++y) {
                    for (int x = left; x < std::min(left + side, m_geometry->width); ++x) {
                        const std::size_t texel =
                            static_cast<std::size_t>(y) * static_cast<std::size_t>(m_geometry->width) +
                            static_cast<std::size_t>(x);
                        if (m_geometry->triangle[texel] != GeometryImage::empty) {
                            texels[count++] = static_cast<std::uint32_t>(texel);
                        }
                    }
                }
                if (count == texels.size() && holds_together(texels)) {
                    m_tiles.push_back({texels, count});
                } else {
                    m_left.insert(m_left.end(), texels.begin(), texels.begin() + count);
                }
            }
        }
    }

    /// Normals within 10° of their mean, so within 20° of each other, and no step between neighbours that stands out,
    /// as one from chart to chart does.
    bool holds_together(const Square& texels) {
        glm::vec3 sum(0.0F);
        for (const std::uint32_t texel : texels) {
            sum += m_geometry->shading_normal[texel];
        }
        const float least = std::cos(10.0F * degree) * glm::length(sum);
        float longest = 0.0F;
        float steps = 0.0F;
        const auto step = [&](std::size_t i, std::size_t j) {
            const float length = glm::distance(m_geometry->position[texels[i]], m_geometry->position[texels[j]]);
            longest = std::max(longest, length);
            steps += length;
        };
        for (std::size_t i = 0; i < texels.size(); ++i) {
            if (!(glm::dot(m_geometry->shading_normal[texels[i]], sum) >= least)) {
                return false;
            }
            if (i % side + 1 < side) {
                step(i, i + 1);
            }
            if (i + side < texels.size()) {
                step(i, i + side);
            }
        }
        constexpr float step_count = 2.0F * side * (side - 1);
        // Of 24 steps 4 lead across a cut: it is found where they are 5 times as long as the others.
        if (longest * step_count > 3.0F * steps) {
            return false;
        }
        m_steps.push_back(steps / step_count);
        return true;
    }

    /// How far a texel is from the next one; a tenth of the frame where no square tells.
    float typical_step() {
        if (m_steps.empty()) {
            return 0.1F;
        }
        const auto middle = m_steps.begin() + static_cast<std::ptrdiff_t>(m_steps.size() / 2);
        std::nth_element(m_steps.begin(), middle, m_steps.end());
        return *middle;
    }

    /// By normal, then along the curve; a new tile where the next texel is too unlike the first ones.
    [[nodiscard]] std::vector<TexelTile> group(const std::vector<std::uint32_t>& texels, const Limits& limits) const {
        struct Entry {
            std::uint64_t place;
            std::uint32_t bucket;
            std::uint32_t texel;
        };
        std::vector<Entry> entries;
        entries.reserve(texels.size());
        for (const std::uint32_t texel : texels) {
            entries.push_back(
                {place_code(m_geometry->position[texel]), normal_bucket(m_geometry->shading_normal[texel]), texel});
        }
        std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
            return std::tie(a.bucket, a.place, a.texel) < std::tie(b.bucket, b.place, b.texel);
        });
        std::vector<TexelTile> tiles;
        glm::vec3 low(0.0F);
        glm::vec3 high(0.0F);
        for (const Entry& entry : entries) {
            const glm::vec3& position = m_geometry->position[entry.texel];
            const glm::vec3 size = glm::max(high, position) - glm::min(low, position);
            if (tiles.empty() || tiles.back().count == RayBlock::lanes ||
                std::max({size.x, size.y, size.z}) > limits.reach ||
                glm::dot(m_geometry->shading_normal[entry.texel], m_geometry->shading_normal[tiles.back().texels[0]]) <
                    limits.cosine) {
                tiles.emplace_back();
                low = high = position;
            }
            low = glm::min(low, position);
            high = glm::max(high, position);
            tiles.back().texels[tiles.back().count++] = entry.texel;
        }
        return tiles;
    }

    /// Along the curve, each tile by its first texel.
    [[nodiscard]] std::vector<TexelTile> in_order() const {
        std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
        order.reserve(m_tiles.size());
        for (const TexelTile& tile : m_tiles) {
            order.emplace_back(place_code(m_geometry->position[tile.texels[0]]),
                               static_cast<std::uint32_t>(order.size()));
        }
        std::sort(order.begin(), order.end());
        std::vector<TexelTile> ordered;
        ordered.reserve(m_tiles.size());
        for (const auto& [place, tile] : order) {
            ordered.push_back(m_tiles[tile]);
        }
        return ordered;
    }

    const GeometryImage* m_geometry; ///< never null
    std::vector<TexelTile> m_tiles;
    std::vector<std::uint32_t> m_left; ///< covered texels that are in no tile yet
    std::vector<float> m_steps;        ///< of each square that became a tile: the mean step between neighbours
};

} // namespace

std::vector<TexelTile> make_tiles(const GeometryImage& geometry, std::size_t triangle_count) {
    check(geometry, triangle_count);
    return Tiler(geometry).run();
}

double occupancy(std::span<const TexelTile> tiles) {
    std::size_t texels = 0;
    for (const TexelTile& tile : tiles) {
        texels += tile.count;
    }
    return tiles.empty() ? 1.0 : static_cast<double>(texels) / static_cast<double>(tiles.size() * RayBlock::lanes);
}

} // namespace vkbake
