#include "atlas/sew.hpp"

#include "atlas/disjoint_sets.hpp"
#include "atlas/plane_grid.hpp"
#include "atlas/relax.hpp"

namespace vkbake {

namespace {

class Sewing {
public:
    Sewing(Patches& patches, const Patch& first, const Patch& second, const RigidMotion& motion)
        : m_patches(patches), m_mesh(*patches.mesh), m_first_count(first.triangles.size()) {
        m_piece.triangles = first.triangles;
        m_piece.triangles.insert(m_piece.triangles.end(), second.triangles.begin(), second.triangles.end());
        for (std::uint32_t local = 0; local < m_piece.triangles.size(); ++local) {
            const std::uint32_t triangle = m_piece.triangles[local];
            patches.local[triangle] = local;
            for (std::uint32_t place = 3 * triangle; place < 3 * triangle + 3; ++place) {
                m_piece.places.push_back(local < m_first_count ? patches.places[place] : motion(patches.places[place]));
            }
        }
        number_points();
    }

    std::optional<SewnPiece> run(const PatchLimits& limits, int rounds) {
        if (!relax(m_mesh, m_piece.triangles, m_points, m_places, rounds)) {
            return std::nullopt;
        }
        double area = 0.0;
        for (std::size_t local = 0; local < m_piece.triangles.size(); ++local) {
            for (std::size_t c = 0; c < 3; ++c) {
                m_piece.places[3 * local + c] = m_places[m_points[3 * local + c]];
            }
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
                const std::uint32_t other = m_patches.local[beyond / 3];
                if (other >= m_piece.triangles.size() || m_piece.triangles[other] != beyond / 3) {
                    continue;
                }
                const bool hangs = m_patches.patch_of[beyond / 3] == name
                                       ? m_patches.places[side] == m_patches.places[next_corner(beyond)] &&
                                             m_patches.places[next_corner(side)] == m_patches.places[beyond]
                                       : !is_crease(m_mesh, side);
                if (hangs) {
                    visit(3 * local + side % 3, 3 * other + next_corner(beyond) % 3, 3 * local + next_corner(side) % 3,
                          3 * other + beyond % 3);
                }
            }
        }
    }

    void number_points() {
        DisjointSets sets(m_piece.places.size());
        for_each_seam([&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
            sets.join(a, b);
            sets.join(c, d);
        });
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
        std::vector<std::uint8_t> inner(m_piece.triangles.size(), 0); // sides that hang together
        for_each_seam([&](std::uint32_t a, std::uint32_t, std::uint32_t, std::uint32_t) { ++inner[a / 3]; });
        PlaneBox box;
        double length = 0.0;
        for (std::size_t corner = 0; corner < m_piece.places.size(); ++corner) {
            box.add(m_piece.places[corner]);
            length += glm::length(m_piece.places[corner] - m_piece.places[corner % 3 == 2 ? corner - 2 : corner + 1]);
        }
        PlaneGrid grid(length / static_cast<double>(m_piece.places.size()));
        for (std::size_t local = 0; local < inner.size(); ++local) {
            if (inner[local] < 3) {
                const PlaneTriangle triangle{m_piece.places[3 * local], m_piece.places[3 * local + 1],
                                             m_piece.places[3 * local + 2]};
                if (grid.meets(triangle, 1e-9 * box.longest())) {
                    return true;
                }
                grid.add(triangle);
            }
        }
        return false;
    }

    Patches& m_patches;
    const ChartMesh& m_mesh;
    std::size_t m_first_count;
    SewnPiece m_piece;
    std::vector<std::uint32_t> m_points; ///< 3 a triangle
    std::vector<glm::dvec2> m_places;    ///< by point
};

} // namespace

std::optional<SewnPiece> sew(Patches& patches, const Patch& first, const Patch& second, const RigidMotion& motion,
                             const PatchLimits& limits, int rounds) {
    return Sewing(patches, first, second, motion).run(limits, rounds);
}

} // namespace vkbake
