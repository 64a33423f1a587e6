#include "bench/accelerators/uniform_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vkbake::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A flat scene's grid has some thickness.
constexpr float least_extent = 0x1p-10F;

} // namespace

UniformGrid::UniformGrid(const std::vector<Triangle>& triangles, const Box& bounds)
    : m_bounds(bounds), m_triangles(triangles) {
    m_bounds.low -= least_extent;
    m_bounds.high += least_extent;
    const glm::dvec3 size = glm::dvec3(m_bounds.high) - glm::dvec3(m_bounds.low);
    const double density =
        std::cbrt(cells_a_triangle * static_cast<double>(std::max<std::size_t>(triangles.size(), 1)) /
                  (size.x * size.y * size.z));
    for (int axis = 0; axis < 3; ++axis) {
        m_resolution[axis] = std::clamp(static_cast<int>(std::lround(size[axis] * density)), 1, 1024);
        m_cell[axis] = size[axis] / m_resolution[axis];
    }
    const glm::ivec3 last = m_resolution - 1;
    m_first.assign(index(last) + 2, 0);
    for (const Triangle& triangle : m_triangles) {
        for_each_cell(triangle, [&](std::size_t cell) { ++m_first[cell + 1]; });
    }
    for (std::size_t cell = 1; cell < m_first.size(); ++cell) {
        m_first[cell] += m_first[cell - 1];
    }
    std::vector<std::uint32_t> next = m_first;
    m_indices.resize(m_first.back());
    for (std::uint32_t rank = 0; rank < m_triangles.size(); ++rank) {
        for_each_cell(m_triangles[rank], [&](std::size_t cell) { m_indices[next[cell]++] = rank; });
    }
}

std::size_t UniformGrid::index(const glm::ivec3& cell) const {
    return static_cast<std::size_t>((static_cast<std::int64_t>(cell.z) * m_resolution.y + cell.y) * m_resolution.x +
                                    cell.x);
}

glm::ivec3 UniformGrid::cell_of(const glm::dvec3& point) const {
    glm::ivec3 cell;
    for (int axis = 0; axis < 3; ++axis) {
        const double place = (point[axis] - m_bounds.low[axis]) / m_cell[axis];
        cell[axis] = static_cast<int>(std::clamp(std::floor(place), 0.0, m_resolution[axis] - 1.0));
    }
    return cell;
}

Box UniformGrid::box_of(const glm::ivec3& cell) const {
    const glm::dvec3 low = glm::dvec3(m_bounds.low) + m_cell * glm::dvec3(cell);
    return {glm::vec3(low), glm::vec3(low + m_cell)};
}

template<typename Visit>
void UniformGrid::for_each_cell(const Triangle& triangle, const Visit& visit) const {
    const Box bounds = triangle.bounds();
    // A cell's own borders are rounded too: twice the reach.
    const glm::dvec3 reach(2.0 * reach_of_rounding);
    const glm::ivec3 low = cell_of(glm::dvec3(bounds.low) - reach);
    const glm::ivec3 high = cell_of(glm::dvec3(bounds.high) + reach);
    for (int z = low.z; z <= high.z; ++z) {
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                if (touches(triangle, box_of({x, y, z}))) {
                    visit(index({x, y, z}));
                }
            }
        }
    }
}

bool UniformGrid::occluded(const PreparedRay& ray) const {
    const Interval inside = pass(ray, m_bounds);
    if (inside.entry > inside.exit) {
        return false;
    }
    const glm::dvec3 origin(ray.origin);
    const glm::dvec3 direction(ray.direction);
    glm::ivec3 cell = cell_of(origin + static_cast<double>(inside.entry) * direction);
    glm::ivec3 step(0);
    glm::dvec3 next(infinity); ///< where the ray leaves the cell along each axis
    glm::dvec3 advance(infinity);
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] != 0.0) {
            step[axis] = direction[axis] > 0.0 ? 1 : -1;
            const double border = m_bounds.low[axis] + m_cell[axis] * (cell[axis] + (direction[axis] > 0.0 ? 1 : 0));
            next[axis] = (border - origin[axis]) / direction[axis];
            advance[axis] = m_cell[axis] / std::abs(direction[axis]);
        }
    }
    while (true) {
        const std::size_t here = index(cell);
        for (std::uint32_t i = m_first[here]; i < m_first[here + 1]; ++i) {
            if (m_indices[i] != ray.ignored_rank && test_watertight(ray, m_triangles[m_indices[i]]).hit) {
                return true;
            }
        }
        const int axis = next.x <= next.y && next.x <= next.z ? 0 : (next.y <= next.z ? 1 : 2);
        cell[axis] += step[axis];
        if (next[axis] > inside.exit || cell[axis] < 0 || cell[axis] >= m_resolution[axis]) {
            return false;
        }
        next[axis] += advance[axis];
    }
}

std::size_t UniformGrid::bytes() const {
    return sizeof(*this) + (m_first.capacity() + m_indices.capacity()) * sizeof(std::uint32_t) +
           m_triangles.capacity() * sizeof(Triangle);
}

} // namespace vkbake::bench
