#include "atlas/relax.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/SparseCholesky>
#include <glm/geometric.hpp>

namespace vkbake {

namespace {

/// A triangle as it lies without distortion, and the cotangents of its angles: of the angle opposite side c at c.
struct RigidTriangle {
    std::array<glm::dvec2, 3> corners;
    std::array<double, 3> cotangents;
};

RigidTriangle rigid_triangle(const ChartMesh& mesh, std::uint32_t triangle) {
    const LaidTriangle laid = lay_down(mesh, 3 * triangle);
    RigidTriangle rigid{{glm::dvec2(0.0), glm::dvec2(laid.x1, 0.0), glm::dvec2(laid.x2, laid.y2)}, {}};
    const double doubled_area = laid.x1 * laid.y2;
    for (unsigned c = 0; c < 3; ++c) {
        const glm::dvec2 apex = rigid.corners[(c + 2) % 3];
        rigid.cotangents[c] = glm::dot(rigid.corners[c] - apex, rigid.corners[(c + 1) % 3] - apex) / doubled_area;
    }
    return rigid;
}

/// The rotation (a unit complex number) that comes next to taking the rigid triangle to its places.
glm::dvec2 next_rotation(const RigidTriangle& rigid, const std::array<glm::dvec2, 3>& at) {
    glm::dvec2 sum(0.0);
    for (unsigned c = 0; c < 3; ++c) {
        const glm::dvec2 from = rigid.corners[(c + 1) % 3] - rigid.corners[c];
        const glm::dvec2 to = at[(c + 1) % 3] - at[c];
        sum += rigid.cotangents[c] * glm::dvec2(glm::dot(from, to), from.x * to.y - from.y * to.x);
    }
    const double length = glm::length(sum);
    return length > 0.0 ? sum / length : glm::dvec2(1.0, 0.0);
}

using Entries = std::vector<Eigen::Triplet<double>>;

/// L·D·Lᵀ of a small matrix, row by row, each from its first entry that is not 0. (Eigen's dense one spends most of its
/// time on what makes it good at large ones.)
class SmallSolver {
public:
    void factorise(std::size_t count, const Entries& entries) {
        m_rows.assign(count * count, 0.0);
        m_inverse.resize(count);
        m_first.resize(count);
        std::iota(m_first.begin(), m_first.end(), std::size_t{0});
        m_count = count;
        for (const Eigen::Triplet<double>& entry : entries) {
            const auto row = static_cast<std::size_t>(entry.row());
            const auto column = static_cast<std::size_t>(entry.col());
            m_rows[row * count + column] += entry.value();
            m_first[row] = std::min(m_first[row], column);
        }
        for (std::size_t i = 0; i < count; ++i) {
            factorise_row(i);
        }
    }

    [[nodiscard]] bool good() const { return m_good; }

    [[nodiscard]] Eigen::MatrixX2d solve(Eigen::MatrixX2d x) const {
        double* const u = x.col(0).data();
        double* const v = x.col(1).data();
        for (std::size_t i = 0; i < m_count; ++i) {
            for (std::size_t k = m_first[i]; k < i; ++k) {
                u[i] -= row(i)[k] * u[k];
                v[i] -= row(i)[k] * v[k];
            }
        }
        for (std::size_t i = 0; i < m_count; ++i) {
            u[i] *= m_inverse[i];
            v[i] *= m_inverse[i];
        }
        for (std::size_t i = m_count; i-- > 0;) {
            for (std::size_t k = m_first[i]; k < i; ++k) {
                u[k] -= row(i)[k] * u[i];
                v[k] -= row(i)[k] * v[i];
            }
        }
        return x;
    }

private:
    [[nodiscard]] const double* row(std::size_t i) const { return &m_rows[i * m_count]; }

    void factorise_row(std::size_t i) {
        double* const own = &m_rows[i * m_count];
        for (std::size_t j = m_first[i]; j < i; ++j) {
            for (std::size_t k = std::max(m_first[i], m_first[j]); k < j; ++k) {
                own[j] -= own[k] * row(j)[k];
            }
        }
        double pivot = own[i];
        for (std::size_t j = m_first[i]; j < i; ++j) {
            const double scaled = own[j] * m_inverse[j];
            pivot -= own[j] * scaled;
            own[j] = scaled;
        }
        m_inverse[i] = 1.0 / pivot;
        m_good = m_good && std::isfinite(m_inverse[i]);
    }

    std::size_t m_count = 0;
    bool m_good = true;
    std::vector<double> m_rows;       ///< square, below the diagonal L
    std::vector<double> m_inverse;    ///< of D
    std::vector<std::size_t> m_first; ///< by row: the column of its first entry
};

/// Of a symmetric system, whose lower entries are given.
class Solver {
public:
    Solver(Eigen::Index count, const Entries& entries) : m_small(count <= small) {
        if (m_small) {
            m_dense.factorise(static_cast<std::size_t>(count), entries);
        } else {
            Eigen::SparseMatrix<double> matrix(count, count);
            matrix.setFromTriplets(entries.begin(), entries.end());
            m_sparse.compute(matrix);
        }
    }

    [[nodiscard]] bool good() const { return m_small ? m_dense.good() : m_sparse.info() == Eigen::Success; }

    [[nodiscard]] Eigen::MatrixX2d solve(const Eigen::MatrixX2d& right) const {
        return m_small ? m_dense.solve(right) : Eigen::MatrixX2d(m_sparse.solve(right));
    }

private:
    static constexpr Eigen::Index small = 96; // points: fewer have more to gain from order than from zeros

    bool m_small;
    SmallSolver m_dense;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_sparse;
};

/// The system of one piece, and what is to be solved next.
class Relaxation {
public:
    Relaxation(const ChartMesh& mesh, std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> points,
               const std::vector<glm::dvec2>& places)
        : m_points(points), m_first(places[0]), m_turns(triangles.size(), glm::dvec2(0.0)),
          m_right(static_cast<Eigen::Index>(places.size()), 2) {
        m_rigid.reserve(triangles.size());
        m_entries.reserve(3 * triangles.size() + places.size());
        std::vector<double> diagonal(places.size(), 0.0);
        double weight = 0.0;
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            m_rigid.push_back(rigid_triangle(mesh, triangles[t]));
            for (unsigned c = 0; c < 3; ++c) {
                const std::uint32_t a = points[3 * t + c];
                const std::uint32_t b = points[3 * t + (c + 1) % 3];
                const double w = m_rigid[t].cotangents[c];
                diagonal[a] += w;
                diagonal[b] += w;
                m_entries.emplace_back(std::max(a, b), std::min(a, b), -w);
                weight += std::abs(w);
            }
        }
        // Holds one point, so that the system has one solution.
        m_hold = weight / static_cast<double>(9 * triangles.size());
        diagonal[0] += m_hold;
        for (std::size_t point = 0; point < places.size(); ++point) {
            m_entries.emplace_back(point, point, diagonal[point]);
        }
    }

    [[nodiscard]] Solver solver() const { return {m_right.rows(), m_entries}; }

    /// The right side for triangles turned as is best where they are. False where none has turned since the last time.
    bool turn(const std::vector<glm::dvec2>& current) {
        constexpr double hardly = 1e-6; // (10⁻³)²: what that turns away from its best costs a millionth of its area
        bool any = false;
        m_right.setZero();
        m_right(0, 0) = m_hold * m_first.x;
        m_right(0, 1) = m_hold * m_first.y;
        for (std::size_t t = 0; t < m_rigid.size(); ++t) {
            const std::uint32_t* const own = &m_points[3 * t];
            const glm::dvec2 turn = next_rotation(m_rigid[t], {current[own[0]], current[own[1]], current[own[2]]});
            const glm::dvec2 way = turn - m_turns[t];
            any = any || glm::dot(way, way) > hardly;
            m_turns[t] = turn;
            for (unsigned c = 0; c < 3; ++c) {
                const glm::dvec2 along =
                    m_rigid[t].cotangents[c] * (m_rigid[t].corners[(c + 1) % 3] - m_rigid[t].corners[c]);
                const glm::dvec2 turned(turn.x * along.x - turn.y * along.y, turn.x * along.y + turn.y * along.x);
                m_right(own[c], 0) -= turned.x;
                m_right(own[c], 1) -= turned.y;
                m_right(own[(c + 1) % 3], 0) += turned.x;
                m_right(own[(c + 1) % 3], 1) += turned.y;
            }
        }
        return any;
    }

    [[nodiscard]] const Eigen::MatrixX2d& right() const { return m_right; }

private:
    std::span<const std::uint32_t> m_points;
    glm::dvec2 m_first;
    double m_hold = 0.0;
    std::vector<RigidTriangle> m_rigid;
    Entries m_entries;
    std::vector<glm::dvec2> m_turns; ///< 1 a triangle
    Eigen::MatrixX2d m_right;
};

} // namespace

bool relax(const ChartMesh& mesh, std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> points,
           std::vector<glm::dvec2>& places, int rounds) {
    Relaxation relaxation(mesh, triangles, points, places);
    const Solver solver = relaxation.solver();
    if (!solver.good()) {
        return false;
    }
    std::vector<glm::dvec2> current = places;
    for (int round = 0; round < rounds && relaxation.turn(current); ++round) {
        const Eigen::MatrixX2d solution = solver.solve(relaxation.right());
        if (!solution.allFinite()) {
            return false;
        }
        for (std::size_t i = 0; i < current.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            current[i] = {solution(row, 0), solution(row, 1)};
        }
    }
    places = std::move(current);
    return true;
}

} // namespace vkbake
