// The two shapes that follow something else: a part on a round body, and walls on a grid.
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "make_scenes/shapes.hpp"
#include "make_scenes/turn.hpp"

namespace vkbake::scenes {

Solid on_cylinder(double body_radius, double gap, const Profile& profile, int segments, Paint paint) {
    std::vector<Ring> rings;
    for (std::size_t r = 0; r < profile.size(); ++r) {
        if (profile[r].x == 0.0) {
            rings.push_back({{profile[r].y, 0.0, 0.0}});
            continue;
        }
        Ring ring;
        for (int k = 0; k < segments; ++k) {
            const glm::dvec2 c = on_circle(static_cast<double>(k) / segments) * profile[r].x;
            // Points k and n − k have the same y, so the first cap's rungs run along the body's axis and lie on it.
            const double on_body = std::sqrt((body_radius + gap) * (body_radius + gap) - c.x * c.x);
            ring.emplace_back(r == 0 ? on_body : profile[r].y, c.x, c.y);
        }
        rings.push_back(std::move(ring));
    }
    return loft(rings, paint);
}

namespace {

using Place = std::array<int, 3>;

class BlockSkin {
public:
    explicit BlockSkin(const Cuts& cuts) : m_cuts({&cuts.x, &cuts.y, &cuts.z}) {}

    [[nodiscard]] int block_count(std::size_t axis) const { return static_cast<int>(m_cuts[axis]->size()) - 1; }

    [[nodiscard]] glm::dvec3 centre(const Place& block) const {
        glm::dvec3 sum;
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            sum[axis] = 0.5 * (coordinate(a, block[a]) + coordinate(a, block[a] + 1));
        }
        return sum;
    }

    /// The face of `block` towards the high end (1) or the low end (0) of `axis`.
    void add_face(const Place& block, std::size_t axis, int side,
                  const std::function<Paint(const glm::dvec3&, const glm::dvec3&)>& paint) {
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        std::array<std::uint32_t, 4> corners{};
        glm::dvec3 middle(0.0);
        for (std::size_t k = 0; k < 4; ++k) {
            Place place = block;
            place[axis] += side;
            place[u] += (k == 1 || k == 2) ? 1 : 0;
            place[v] += k >= 2 ? 1 : 0;
            corners[k] = point(place);
            middle += 0.25 * m_solid.points[corners[k]];
        }
        glm::dvec3 normal(0.0);
        normal[static_cast<int>(axis)] = side == 1 ? 1.0 : -1.0;
        const Paint colour = paint(middle, normal);
        if (side == 0) {
            std::swap(corners[1], corners[3]);
        }
        m_solid.triangles.push_back({{corners[0], corners[1], corners[2]}, colour});
        m_solid.triangles.push_back({{corners[0], corners[2], corners[3]}, colour});
    }

    [[nodiscard]] Solid take() { return std::move(m_solid); }

private:
    [[nodiscard]] double coordinate(std::size_t axis, int cut) const {
        return (*m_cuts[axis])[static_cast<std::size_t>(cut)];
    }

    std::uint32_t point(const Place& place) {
        const auto [found, is_new] = m_points.try_emplace(place, static_cast<std::uint32_t>(m_solid.points.size()));
        if (is_new) {
            m_solid.points.emplace_back(coordinate(0, place[0]), coordinate(1, place[1]), coordinate(2, place[2]));
        }
        return found->second;
    }

    std::array<const std::vector<double>*, 3> m_cuts;
    std::map<Place, std::uint32_t> m_points;
    Solid m_solid;
};

} // namespace

Solid blocks(const Cuts& cuts, const std::function<bool(const glm::dvec3&)>& filled,
             const std::function<Paint(const glm::dvec3&, const glm::dvec3&)>& paint) {
    BlockSkin skin(cuts);
    const auto is_filled = [&](const Place& block) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (block[axis] < 0 || block[axis] >= skin.block_count(axis)) {
                return false;
            }
        }
        return filled(skin.centre(block));
    };
    for (int i = 0; i < skin.block_count(0); ++i) {
        for (int j = 0; j < skin.block_count(1); ++j) {
            for (int k = 0; k < skin.block_count(2); ++k) {
                const Place block{i, j, k};
                if (!is_filled(block)) {
                    continue;
                }
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    for (int side = 0; side < 2; ++side) {
                        Place next = block;
                        next[axis] += side == 1 ? 1 : -1;
                        if (!is_filled(next)) {
                            skin.add_face(block, axis, side, paint);
                        }
                    }
                }
            }
        }
    }
    return skin.take();
}

} // namespace vkbake::scenes
