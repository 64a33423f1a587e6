#include "atlas/sew.hpp"

#include <algorithm>
#include <tuple>

#include "atlas/plane_grid.hpp"
#include "atlas/relax.hpp"
#include "base/disjoint_sets.hpp"

namespace vkbake {

namespace {

class Sewing {
public:
    Sewing(Patches& patches, const Patch& first, const Patch& second, const RigidMotion& motion)
        : m_patches(patches), m_mesh(*patches.mesh), m_first_count(first.triangles.size()),
          m_first_name(patches.patch_of[first.triangles.front()]),
          m_second_name(second.triangles.empty() ? m_first_name : patches.patch_of[second.triangles.front()]) {
        m_piece.triangles = first.triangles;
        m_piece.triangles.insert(m_piece.triangles.end(), second.triangles.begin(), second.triangles.end());
        for (std::uint32_t local = 0; local < m_piece.triangles.size(); ++local) {
            const std::uint32_t triangle = m_piece.triangles[local];
            patches.local[triangle] = local;
            for (std::uint32_t place = 3 * triangle; place < 3 * triangle + 3; ++place) {
                m_piece.places.push_back(local < m_first_count ? patches.places[place] : motion(patches.places[place]));
            }
        }
    }

    std::optional<SewnPiece> run(const PatchLimits& limits, int rounds) {
        if (rounds > 0 && !relax_places(rounds)) {
            return std::nullopt;
        }
        double area = 0.0;
        for (std::size_t local = 0; local < m_piece.triangles.size(); ++local) {
            const LaidTriangle laid = lay_down(m_mesh, 3 * m_piece.triangles[local]);
            const glm::dvec2* const at = &m_piece.places[3 * local];
            const Distortion bent = distortion(laid, at[0], at[1], at[2]);
            if (!(bent.product > 0.0 && bent.energy() <= limits.triangle_energy)) {
                return std::nullopt;
            }
            const double own_area = 0.5 * laid.x1 * laid.y2;
            area += own_area;
            m_piece.energy += own_area * bent.energy();
        }
        if (m_piece.energy > limits.mean_energy * area || overlaps()) {
            return std::nullopt;
        }
        return std::move(m_piece);
    }

private:
    bool relax_places(int rounds) {
        number_points();
        if (!relax(m_mesh, m_piece.triangles, m_points, m_places, rounds)) {
            return false;
        }
        for (std::size_t corner = 0; corner < m_piece.places.size(); ++corner) {
            m_piece.places[corner] = m_places[m_points[corner]];
        }
        return true;
    }

    /// Calls visit(corner, corner beyond, next corner, next corner beyond), corners by their places in m_piece, for
    /// each side at which triangles hang together.
    template<typename Visit>
    void for_each_seam(const Visit& visit) const {
        for (std::uint32_t local = 0; local < m_piece.triangles.size(); ++local) {
            const std::uint32_t triangle = m_piece.triangles[local];
            const std::uint32_t name = m_patches.patch_of[triangle];
            for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
                const std::uint32_t beyond = m_mesh.across[side];
                if (beyond == ChartMesh::none) {
                    continue;
                }
                const std::uint32_t beyond_name = m_patches.patch_of[beyond / 3];
                if (beyond_name != m_first_name && beyond_name != m_second_name) {
                    continue;
                }
                const std::uint32_t other = m_patches.local[beyond / 3];
                const bool hangs = beyond_name == name
                                       ? m_patches.places[side] == m_patches.places[next_corner(beyond)] &&
                                             m_patches.places[next_corner(side)] == m_patches.places[beyond]
                                       : !m_mesh.is_crease(side);
                if (hangs) {
                    visit(3 * local + side % 3, 3 * other + next_corner(beyond) % 3, 3 * local + next_corner(side) % 3,
                          3 * other + beyond % 3);
                }
            }
        }
    }

    /// Where a piece touches itself in a corner alone it stays together. `inner`: 1 a side, whether it hangs on
    /// another.
    void join_pinches(const std::vector<bool>& inner, DisjointSets& sets) const {
        using Corner = std::tuple<std::uint32_t, std::uint32_t, double, double, std::uint32_t>;
        std::vector<Corner> corners;
        for (std::uint32_t corner = 0; corner < m_piece.places.size(); ++corner) {
            // Triangles around a corner hang together, and end at the outline where they do not go around it.
            if (inner[corner] && inner[last_corner(corner)]) {
                continue;
            }
            const std::uint32_t triangle = m_piece.triangles[corner / 3];
            const glm::dvec2& place = m_patches.places[3 * triangle + corner % 3];
            corners.emplace_back(m_mesh.vertices[3 * triangle + corner % 3], m_patches.patch_of[triangle], place.x,
                                 place.y, corner);
        }
        std::sort(corners.begin(), corners.end());
        for (std::size_t i = 1; i < corners.size(); ++i) {
            const auto& [vertex, patch, x, y, corner] = corners[i - 1];
            const auto& [next_vertex, next_patch, next_x, next_y, next_corner] = corners[i];
            if (vertex == next_vertex && patch == next_patch && x == next_x && y == next_y) {
                sets.join(corner, next_corner);
            }
        }
    }

    void number_points() {
        DisjointSets sets(m_piece.places.size());
        std::vector<bool> inner(m_piece.places.size(), false);
        for_each_seam([&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
            sets.join(a, b);
            sets.join(c, d);
            inner[a] = true;
        });
        join_pinches(inner, sets);
        m_points.resize(m_piece.places.size());
        std::vector<double> counts;
        for (std::uint32_t corner = 0; corner < m_points.size(); ++corner) {
            const std::uint32_t stands = sets.find(corner);
            if (stands == corner) {
                m_points[corner] = static_cast<std::uint32_t>(m_places.size());
                m_places.emplace_back(0.0);
                counts.push_back(0.0);
            }
            m_points[corner] = m_points[stands];
            m_places[m_points[corner]] += m_piece.places[corner];
            counts[m_points[corner]] += 1.0;
        }
        for (std::size_t point = 0; point < m_places.size(); ++point) {
            m_places[point] /= counts[point];
        }
    }

    /// Only triangles at the outline are looked at: a piece whose outline does not cross itself does not overlap itself
    /// where none of its triangles is mirrored.
    [[nodiscard]] bool overlaps() const {
        if (m_piece.triangles.size() == 1) {
            return false;
        }
        std::vector<std::uint8_t> inner(m_piece.triangles.size(), 0); // sides that hang together
        for_each_seam([&](std::uint32_t a, std::uint32_t, std::uint32_t, std::uint32_t) { ++inner[a / 3]; });
        PlaneBox box;
        double length = 0.0;
        for (std::size_t corner = 0; corner < m_piece.places.size(); ++corner) {
            box.add(m_piece.places[corner]);
            length += glm::length(m_piece.places[corner] - m_piece.places[corner % 3 == 2 ? corner - 2 : corner + 1]);
        }
        PlaneGrid outline(length / static_cast<double>(m_piece.places.size()));
        for (std::size_t local = 0; local < inner.size(); ++local) {
            if (inner[local] < 3) {
                const PlaneTriangle triangle{m_piece.places[3 * local], m_piece.places[3 * local + 1],
                                             m_piece.places[3 * local + 2]};
                if (outline.meets(triangle, 1e-9 * box.longest())) {
                    return true;
                }
                outline.add(triangle);
            }
        }
        return false;
    }

    Patches& m_patches;
    const ChartMesh& m_mesh;
    std::size_t m_first_count;
    std::uint32_t m_first_name; ///< in Patches::patch_of
    std::uint32_t m_second_name;
    SewnPiece m_piece;
    std::vector<std::uint32_t> m_points; ///< 3 a triangle
    std::vector<glm::dvec2> m_places;    ///< by point
};

void take_places(Patches& patches, const Patch& patch, const SewnPiece& laid) {
    for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
        std::copy_n(laid.places.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                    patches.places.begin() + 3 * static_cast<std::ptrdiff_t>(patch.triangles[i]));
    }
}

} // namespace

std::optional<SewnPiece> sew(Patches& patches, const Patch& first, const Patch& second, const RigidMotion& motion,
                             const PatchLimits& limits, int rounds) {
    return Sewing(patches, first, second, motion).run(limits, rounds);
}

bool lay_out_patch(Patches& patches, Patch& patch, const PatchLimits& limits) {
    const ChartMesh& mesh = *patches.mesh;
    glm::dvec3 facing(0.0);
    for (const std::uint32_t triangle : patch.triangles) {
        const LaidTriangle laid = lay_down(mesh, 3 * triangle);
        patch.area += 0.5 * laid.x1 * laid.y2;
        facing += 0.5 * laid.x1 * laid.y2 * mesh.normals[triangle];
    }
    if (glm::length(facing) == 0.0) {
        return false;
    }
    facing = glm::normalize(facing);
    const glm::dvec3 aside = std::abs(facing.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 u = glm::normalize(glm::cross(aside, facing));
    const glm::dvec3 v = glm::cross(facing, u);
    const glm::dvec3 origin = mesh.corner(3 * patch.triangles.front());
    double shadow_energy = 0.0;
    for (const std::uint32_t triangle : patch.triangles) {
        for (std::uint32_t place = 3 * triangle; place < 3 * triangle + 3; ++place) {
            const glm::dvec3 way = mesh.corner(place) - origin;
            patches.places[place] = {glm::dot(way, u), glm::dot(way, v)};
        }
        const LaidTriangle laid = lay_down(mesh, 3 * triangle);
        const glm::dvec2* const at = &patches.places[3 * std::size_t{triangle}];
        shadow_energy += 0.5 * laid.x1 * laid.y2 * distortion(laid, at[0], at[1], at[2]).energy();
    }
    constexpr double flat = 1e-3; // of what a patch may be bent
    const int rounds = shadow_energy <= flat * limits.mean_energy * patch.area ? 0 : 8;
    const auto laid = sew(patches, patch, {}, {}, limits, rounds);
    if (!laid) {
        return false;
    }
    patch.energy = laid->energy;
    patch.relaxed = true;
    take_places(patches, patch, *laid);
    return true;
}

RigidMotion best_motion(const Patches& patches, std::span<const std::uint32_t> common) {
    glm::dvec2 from(0.0);
    glm::dvec2 to(0.0);
    double length = 0.0;
    const auto length_of = [&](std::uint32_t side) {
        return glm::length(patches.mesh->corner(next_corner(side)) - patches.mesh->corner(side));
    };
    const auto middle = [&](std::uint32_t side) {
        return 0.5 * (patches.places[side] + patches.places[next_corner(side)]);
    };
    for (const std::uint32_t side : common) {
        const double own = length_of(side);
        length += own;
        from += own * middle(side);
        to += own * middle(patches.mesh->across[side]);
    }
    from /= length;
    to /= length;
    glm::dvec2 sum(0.0);
    for (const std::uint32_t side : common) {
        const std::uint32_t beyond = patches.mesh->across[side];
        for (const auto& [mine, theirs] :
             {std::pair(side, next_corner(beyond)), std::pair(next_corner(side), beyond)}) {
            const glm::dvec2 a = patches.places[mine] - from;
            const glm::dvec2 b = patches.places[theirs] - to;
            sum += length_of(side) * glm::dvec2(glm::dot(a, b), a.x * b.y - a.y * b.x);
        }
    }
    const double size = glm::length(sum);
    RigidMotion motion{size > 0.0 ? sum / size : glm::dvec2(1.0, 0.0), glm::dvec2(0.0)};
    motion.move = to - motion(from);
    return motion;
}

bool relax_patch(Patches& patches, Patch& patch, const PatchLimits& limits) {
    constexpr double hardly = 0.1; // of what a patch may be bent: less gains next to nothing
    constexpr int rounds = 4;
    if (patch.relaxed || patch.triangles.size() < 3 || patch.energy <= hardly * limits.mean_energy * patch.area) {
        return false;
    }
    patch.relaxed = true;
    const auto laid = sew(patches, patch, {}, {}, limits, rounds);
    if (!laid || laid->energy >= patch.energy) {
        return false;
    }
    patch.energy = laid->energy;
    take_places(patches, patch, *laid);
    return true;
}

} // namespace vkbake
