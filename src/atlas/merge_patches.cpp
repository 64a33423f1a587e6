#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <queue>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "atlas/common_sides.hpp"
#include "atlas/crease_run.hpp"
#include "atlas/patches.hpp"
#include "atlas/plane_grid.hpp"
#include "atlas/rigid_motion.hpp"
#include "atlas/sew.hpp"

namespace vkbake {

namespace {

class PatchMerger {
public:
    PatchMerger(Patches& patches, std::vector<Patch>& pieces, const PatchLimits& limits)
        : m_all(patches), m_mesh(*patches.mesh), m_pieces(pieces), m_limits(limits), m_own(pieces.size()) {
        for (std::uint32_t name = 0; name < pieces.size(); ++name) {
            begin(name);
        }
        for (std::uint32_t name = 0; name < pieces.size(); ++name) {
            for (auto& [other, joint] : m_own[name].joints) {
                if (name < other) {
                    push(name, other, joint);
                }
            }
        }
    }

    void run() {
        while (!m_queue.empty()) {
            const Candidate candidate = m_queue.top();
            m_queue.pop();
            const auto joint = m_own[candidate.first].joints.find(candidate.second);
            if (joint != m_own[candidate.first].joints.end() && joint->second.stamp == candidate.stamp) {
                try_to_join(candidate.first, candidate.second);
            }
        }
        std::erase_if(m_pieces, [](const Patch& piece) { return piece.triangles.empty(); });
        for (std::uint32_t name = 0; name < m_pieces.size(); ++name) {
            for (const std::uint32_t triangle : m_pieces[name].triangles) {
                m_all.patch_of[triangle] = name;
            }
        }
    }

private:
    /// What two patches have in common.
    struct Joint {
        double length = 0.0;
        double flat_length = 0.0; ///< of it, what is no crease
        double bend = 0.0;        ///< Σ length · (1 − cosine between the triangles)
        std::uint32_t stamp = 0;  ///< of the candidate that speaks for it
    };

    /// What is known of a patch beside its triangles.
    struct Own {
        double outline = 0.0; ///< length
        PlaneBox box;
        CreaseRun creases;                     ///< that it was joined across
        std::map<std::uint32_t, Joint> joints; ///< by neighbour
        std::unique_ptr<PlaneGrid> grid;       ///< of the triangles at its outline; made when it is asked for
    };

    struct Candidate {
        double worth;
        std::uint32_t first;
        std::uint32_t second;
        std::uint32_t stamp;

        bool operator<(const Candidate& other) const {
            return std::tie(worth, other.first, other.second, other.stamp) <
                   std::tie(other.worth, first, second, stamp);
        }
    };

    [[nodiscard]] double length_of(std::uint32_t side) const {
        return glm::length(m_mesh.corner(next_corner(side)) - m_mesh.corner(side));
    }

    /// Whether the triangles are not bent where this side meets the one across, however they are shaded.
    [[nodiscard]] bool is_flat(std::uint32_t side) const {
        const std::uint32_t beyond = m_mesh.across[side];
        return !m_mesh.is_crease(side) &&
               glm::dot(m_mesh.normals[side / 3], m_mesh.normals[beyond / 3]) >= crease_cosine;
    }

    [[nodiscard]] PlaneTriangle laid(std::uint32_t triangle) const {
        return {m_all.places[3 * triangle], m_all.places[3 * triangle + 1], m_all.places[3 * triangle + 2]};
    }

    /// Whether what lies across a side hangs together with it in the plane.
    [[nodiscard]] bool is_inner(std::uint32_t side) const {
        const std::uint32_t beyond = m_mesh.across[side];
        return beyond != ChartMesh::none && m_all.patch_of[beyond / 3] == m_all.patch_of[side / 3] &&
               m_all.places[side] == m_all.places[next_corner(beyond)] &&
               m_all.places[next_corner(side)] == m_all.places[beyond];
    }

    [[nodiscard]] bool at_outline(std::uint32_t triangle) const {
        return !is_inner(3 * triangle) || !is_inner(3 * triangle + 1) || !is_inner(3 * triangle + 2);
    }

    void begin(std::uint32_t name) {
        Own& own = m_own[name];
        for (const std::uint32_t triangle : m_pieces[name].triangles) {
            for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
                own.box.add(m_all.places[side]);
                if (is_inner(side)) {
                    if (m_mesh.is_crease(side) && side < m_mesh.across[side]) {
                        own.creases.add(m_all.places[next_corner(side)] - m_all.places[side]);
                    }
                    continue;
                }
                const double length = length_of(side);
                own.outline += length;
                const std::uint32_t beyond = m_mesh.across[side];
                if (beyond != ChartMesh::none && m_all.patch_of[beyond / 3] != name) {
                    Joint& joint = own.joints[m_all.patch_of[beyond / 3]];
                    joint.length += length;
                    joint.flat_length += m_mesh.is_crease(side) ? 0.0 : length;
                    joint.bend += length * (1.0 - glm::dot(m_mesh.normals[side / 3], m_mesh.normals[beyond / 3]));
                }
            }
        }
    }

    void push(std::uint32_t a, std::uint32_t b, Joint& joint) {
        joint.stamp = ++m_stamp;
        m_own[b].joints.at(a).stamp = joint.stamp;
        const double share = joint.length / std::min(m_own[a].outline, m_own[b].outline);
        const double flat = joint.flat_length / joint.length;
        m_queue.push({share + flat, std::min(a, b), std::max(a, b), joint.stamp});
    }

    /// Light changes abruptly across a crease: in one chart the faces' texels would be mixed along it, and be seen as a
    /// bright line in a dark corner, or as teeth where it runs aslant through texels. Of small faces gutters take more
    /// than that is worth, and a slight bend changes light less. `creases`: of both.
    [[nodiscard]] bool may_join(std::uint32_t a, std::uint32_t b, const CreaseRun& creases) const {
        constexpr double slight = 0.27; // 1 − cosine: 43°, an icosahedron has 42° and a bevel 45°
        const Joint& joint = m_own[a].joints.at(b);
        const bool is_slight = joint.bend < slight * joint.length;
        const double more = creases.are_straight() ? (is_slight ? 50.0 : 2.0) : (is_slight ? 14.0 : 1.0);
        return joint.flat_length > 0.5 * joint.length ||
               m_pieces[a].area + m_pieces[b].area <= more * m_limits.free_area;
    }

    /// The smaller one moves.
    void try_to_join(std::uint32_t a, std::uint32_t b) {
        if (m_pieces[a].triangles.size() < m_pieces[b].triangles.size()) {
            std::swap(a, b);
        }
        const std::vector<std::uint32_t> common = common_sides(m_all, m_pieces[b], a);
        if (common.empty()) {
            return;
        }
        CreaseRun creases = m_own[a].creases;
        creases.add(m_own[b].creases, hinge_motion(common[0]).turn);
        add_creases_across(m_all, common, creases);
        if (may_join(a, b, creases) && join_at(a, b, common)) {
            m_own[a].creases = creases;
        }
    }

    [[nodiscard]] bool join_at(std::uint32_t a, std::uint32_t b, const std::vector<std::uint32_t>& common) {
        std::vector<bool> met(common.size(), false);
        if (lay_beside(a, b, common, hinge_motion(common[0]), 0, met, 1e-3)) {
            return true;
        }
        // What is small beside the other must fit without the other's being laid out anew.
        const std::size_t count = m_pieces[b].triangles.size();
        return (count <= 20 && lay_beside(a, b, common, best_motion(m_all, common), 0, met, 1.0)) ||
               ((count > 20 || 20 * count > m_pieces[a].triangles.size()) && sew_on(a, b, common));
    }

    [[nodiscard]] bool sew_on(std::uint32_t a, std::uint32_t b, const std::vector<std::uint32_t>& common) {
        const RigidMotion motion = best_motion(m_all, common);
        double mismatch = 0.0;
        double length = 0.0;
        for (const std::uint32_t side : common) {
            const glm::dvec2 way = motion(m_all.places[side]) - m_all.places[next_corner(m_mesh.across[side])];
            mismatch += length_of(side) * glm::length(way);
            length += length_of(side);
        }
        // Hopeless ones need no system solved: what is this far off has to be bent about as much.
        if (mismatch > 0.1 * length * length || !good_shape(a, b, box_beside(a, b, motion))) {
            return false;
        }
        const auto sewn = sew(m_all, m_pieces[a], m_pieces[b], motion, m_limits, 3);
        if (!sewn) {
            return false;
        }
        PlaneBox box;
        for (const glm::dvec2& place : sewn->places) {
            box.add(place);
        }
        if (!good_shape(a, b, box)) {
            return false;
        }
        const std::size_t own_count = m_pieces[a].triangles.size();
        for (std::size_t i = 0; i < own_count; ++i) {
            std::copy_n(sewn->places.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                        m_all.places.begin() + 3 * static_cast<std::ptrdiff_t>(m_pieces[a].triangles[i]));
        }
        m_own[a].grid.reset();
        join(a, b, {sewn->places.begin() + static_cast<std::ptrdiff_t>(3 * own_count), sewn->places.end()}, box);
        m_pieces[a].energy = sewn->energy;
        return true;
    }

    /// Of a, and of b moved.
    [[nodiscard]] PlaneBox box_beside(std::uint32_t a, std::uint32_t b, const RigidMotion& motion) const {
        PlaneBox box = m_own[a].box;
        for (const std::uint32_t triangle : m_pieces[b].triangles) {
            for (std::uint32_t place = 3 * triangle; place < 3 * triangle + 3; ++place) {
                box.add(motion(m_all.places[place]));
            }
        }
        return box;
    }

    [[nodiscard]] RigidMotion hinge_motion(std::uint32_t own) const {
        const std::uint32_t theirs = m_mesh.across[own];
        return RigidMotion::between(m_all.places[own], m_all.places[next_corner(own)],
                                    m_all.places[next_corner(theirs)], m_all.places[theirs]);
    }

    /// Sides that come within `tolerance` of their lengths of each other are joined, the hinge in any case.
    [[nodiscard]] bool lay_beside(std::uint32_t a, std::uint32_t b, const std::vector<std::uint32_t>& common,
                                  const RigidMotion& motion, std::size_t hinge, std::vector<bool>& met,
                                  double tolerance) {
        const std::uint32_t own = common[hinge];
        const std::uint32_t theirs = m_mesh.across[own];
        PlaneBox box = m_own[a].box;
        std::vector<glm::dvec2> moved;
        moved.reserve(3 * m_pieces[b].triangles.size());
        for (const std::uint32_t triangle : m_pieces[b].triangles) {
            for (std::uint32_t place = 3 * triangle; place < 3 * triangle + 3; ++place) {
                moved.push_back(motion(m_all.places[place]));
                box.add(moved.back());
            }
        }
        if (!good_shape(a, b, box)) {
            return false;
        }
        // Corners at sides that meet go exactly where they are on the other side.
        std::map<std::pair<std::uint32_t, std::pair<double, double>>, glm::dvec2> welds; // by vertex and old place
        const auto weld_corner = [&](std::uint32_t from, std::uint32_t to) {
            welds[{m_mesh.vertices[from], {m_all.places[from].x, m_all.places[from].y}}] = m_all.places[to];
        };
        for (std::size_t i = 0; i < common.size(); ++i) {
            const std::uint32_t side = common[i];
            const std::uint32_t beyond = m_mesh.across[side];
            const double near = tolerance * length_of(side);
            const double begin = glm::length(motion(m_all.places[side]) - m_all.places[next_corner(beyond)]);
            const double end = glm::length(motion(m_all.places[next_corner(side)]) - m_all.places[beyond]);
            if (begin <= near && end <= near) {
                met[i] = true;
                weld_corner(side, next_corner(beyond));
                weld_corner(next_corner(side), beyond);
            } else if (i != hinge && is_flat(side) && std::min(begin, end) < length_of(side)) {
                return false; // a slit in a flat surface would open or overlap; far apart it is a cut
            }
        }
        met[hinge] = true;
        weld_corner(own, next_corner(theirs));
        weld_corner(next_corner(own), theirs);
        std::size_t at = 0;
        for (const std::uint32_t triangle : m_pieces[b].triangles) {
            for (std::uint32_t place = 3 * triangle; place < 3 * triangle + 3; ++place, ++at) {
                const auto weld = welds.find({m_mesh.vertices[place], {m_all.places[place].x, m_all.places[place].y}});
                moved[at] = weld != welds.end() ? weld->second : moved[at];
            }
        }
        const auto energy = fits(a, b, moved);
        if (!energy) {
            return false;
        }
        m_pieces[b].energy = *energy;
        join(a, b, moved, box);
        return true;
    }

    /// Small things may be laid out at will; large ones only where the page's space is not wasted.
    [[nodiscard]] bool good_shape(std::uint32_t a, std::uint32_t b, const PlaneBox& box) const {
        if (box.longest() <= m_limits.free_length) {
            return true;
        }
        const double area = m_pieces[a].area + m_pieces[b].area;
        return box.area() * 0.95 <= m_own[a].box.area() + m_own[b].box.area() || area >= 0.75 * box.area();
    }

    /// The energy that b has in its new places, or nothing where they will not do.
    [[nodiscard]] std::optional<double> fits(std::uint32_t a, std::uint32_t b, const std::vector<glm::dvec2>& moved) {
        double energy = 0.0;
        const double slack = 1e-9 * std::max(m_own[a].box.longest(), m_own[b].box.longest());
        const std::vector<std::uint32_t>& mine = m_pieces[b].triangles;
        for (std::size_t i = 0; i < mine.size(); ++i) {
            const LaidTriangle triangle = lay_down(m_mesh, 3 * mine[i]);
            const Distortion bent = distortion(triangle, moved[3 * i], moved[3 * i + 1], moved[3 * i + 2]);
            if (!(bent.product > 0.0 && bent.energy() <= m_limits.triangle_energy)) {
                return std::nullopt;
            }
            energy += 0.5 * triangle.x1 * triangle.y2 * bent.energy();
        }
        if (m_pieces[a].energy + energy > m_limits.mean_energy * (m_pieces[a].area + m_pieces[b].area)) {
            return std::nullopt;
        }
        PlaneGrid& grid = grid_of(a);
        for (std::size_t i = 0; i < mine.size(); ++i) {
            if (at_outline(mine[i]) && grid.meets({moved[3 * i], moved[3 * i + 1], moved[3 * i + 2]}, slack)) {
                return std::nullopt;
            }
        }
        return energy;
    }

    PlaneGrid& grid_of(std::uint32_t name) {
        Own& own = m_own[name];
        if (!own.grid) {
            double length = 0.0;
            double count = 0.0;
            for (const std::uint32_t triangle : m_pieces[name].triangles) {
                for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
                    length += length_of(side);
                    count += 1.0;
                }
            }
            own.grid = std::make_unique<PlaneGrid>(length / count);
            for (const std::uint32_t triangle : m_pieces[name].triangles) {
                if (at_outline(triangle)) {
                    own.grid->add(laid(triangle));
                }
            }
        }
        return *own.grid;
    }

    /// b becomes part of a.
    void join(std::uint32_t a, std::uint32_t b, const std::vector<glm::dvec2>& moved, const PlaneBox& box) {
        Patch& into = m_pieces[a];
        Patch& from = m_pieces[b];
        for (std::size_t i = 0; i < from.triangles.size(); ++i) {
            const std::uint32_t triangle = from.triangles[i];
            m_all.patch_of[triangle] = a;
            std::copy_n(moved.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                        m_all.places.begin() + 3 * static_cast<std::ptrdiff_t>(triangle));
            if (m_own[a].grid) {
                m_own[a].grid->add(laid(triangle));
            }
        }
        into.triangles.insert(into.triangles.end(), from.triangles.begin(), from.triangles.end());
        into.area += from.area;
        into.energy += from.energy;
        into.relaxed = false;
        from = {};
        Own& own = m_own[a];
        own.outline += m_own[b].outline - 2.0 * own.joints.at(b).length;
        own.box = box;
        own.joints.erase(b);
        m_own[b].joints.erase(a);
        for (const auto& [other, joint] : m_own[b].joints) {
            Joint& sum = own.joints[other];
            sum.length += joint.length;
            sum.flat_length += joint.flat_length;
            sum.bend += joint.bend;
            m_own[other].joints.erase(b);
            m_own[other].joints[a] = sum;
            push(a, other, sum);
        }
        m_own[b] = {};
    }

    Patches& m_all;
    const ChartMesh& m_mesh;
    std::vector<Patch>& m_pieces;
    const PatchLimits& m_limits;
    std::vector<Own> m_own;
    std::priority_queue<Candidate> m_queue;
    std::uint32_t m_stamp = 0;
};

} // namespace

void merge_patches(Patches& patches, std::vector<Patch>& pieces, const PatchLimits& limits) {
    PatchMerger(patches, pieces, limits).run();
}

} // namespace vkbake
