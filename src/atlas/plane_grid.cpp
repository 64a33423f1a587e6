#include "atlas/plane_grid.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace vkbake {

namespace {

std::uint64_t cell_key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ULL ^ static_cast<std::uint64_t>(y);
}

bool boxes_apart(const PlaneTriangle& a, const PlaneTriangle& b, double slack) {
    for (int axis = 0; axis < 2; ++axis) {
        const auto [a_low, a_high] = std::minmax({a[0][axis], a[1][axis], a[2][axis]});
        const auto [b_low, b_high] = std::minmax({b[0][axis], b[1][axis], b[2][axis]});
        if (a_high <= b_low + slack || b_high <= a_low + slack) {
            return true;
        }
    }
    return false;
}

/// Whether a side of `t` has all of `other` beyond it, but for `slack`.
bool parted_by_side(const PlaneTriangle& t, const PlaneTriangle& other, double slack) {
    for (unsigned side = 0; side < 3; ++side) {
        const glm::dvec2 along = t[(side + 1) % 3] - t[side];
        const double length = glm::length(along);
        double inmost = -1e300;
        for (const glm::dvec2& point : other) {
            const glm::dvec2 way = point - t[side];
            inmost = std::max(inmost, along.x * way.y - along.y * way.x);
        }
        if (inmost <= slack * length) {
            return true;
        }
    }
    return false;
}

} // namespace

bool reach_into(const PlaneTriangle& first, const PlaneTriangle& second, double slack) {
    return !boxes_apart(first, second, slack) && !parted_by_side(first, second, slack) &&
           !parted_by_side(second, first, slack);
}

PlaneGrid::Box PlaneGrid::box_of(const PlaneTriangle& triangle) {
    const auto [x_low, x_high] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
    const auto [y_low, y_high] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    return {{x_low, y_low}, {x_high, y_high}};
}

PlaneGrid::Cells PlaneGrid::cells_of(const Box& box) const {
    // Far out cells are one; their number squared still fits.
    const auto cell = [&](double value) {
        return static_cast<std::int64_t>(std::clamp(std::floor(value / m_cell), -1e9, 1e9));
    };
    return {cell(box.lower.x), cell(box.upper.x) + 1, cell(box.lower.y), cell(box.upper.y) + 1};
}

void PlaneGrid::add(const PlaneTriangle& triangle) {
    m_triangles.push_back(triangle);
    m_boxes.push_back(box_of(triangle));
    if (m_triangles.size() == few + 1) {
        for (std::uint32_t index = 0; index <= few; ++index) {
            enter(index);
        }
    } else if (m_triangles.size() > few) {
        enter(static_cast<std::uint32_t>(m_triangles.size() - 1));
    }
}

void PlaneGrid::enter(std::uint32_t index) {
    const Cells cells = cells_of(m_boxes[index]);
    if (cells.many()) {
        m_large.push_back(index);
        return;
    }
    for (std::int64_t y = cells.y_begin; y < cells.y_end; ++y) {
        for (std::int64_t x = cells.x_begin; x < cells.x_end; ++x) {
            m_cells[cell_key(x, y)].push_back(index);
        }
    }
}

bool PlaneGrid::meets(const PlaneTriangle& triangle, double slack) const {
    const Box box = box_of(triangle);
    const auto hits = [&](std::uint32_t index) {
        const Box& own = m_boxes[index];
        const bool apart = box.upper.x <= own.lower.x + slack || own.upper.x <= box.lower.x + slack ||
                           box.upper.y <= own.lower.y + slack || own.upper.y <= box.lower.y + slack;
        return !apart && reach_into(triangle, m_triangles[index], slack);
    };
    const bool all = m_triangles.size() <= few;
    const Cells cells = all ? Cells{} : cells_of(box);
    if (all || cells.many()) {
        for (std::uint32_t index = 0; index < m_triangles.size(); ++index) {
            if (hits(index)) {
                return true;
            }
        }
        return false;
    }
    if (std::any_of(m_large.begin(), m_large.end(), hits)) {
        return true;
    }
    for (std::int64_t y = cells.y_begin; y < cells.y_end; ++y) {
        for (std::int64_t x = cells.x_begin; x < cells.x_end; ++x) {
            const auto found = m_cells.find(cell_key(x, y));
            if (found != m_cells.end() && std::any_of(found->second.begin(), found->second.end(), hits)) {
                return true;
            }
        }
    }
    return false;
}

} // namespace vkbake
