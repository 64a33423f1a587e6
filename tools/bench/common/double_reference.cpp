#include "bench/common/double_reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace vkbake::bench {
namespace {

using Corners = std::array<glm::dvec3, 3>;

constexpr std::uint32_t leaf_size = 8;
// Doubles err by some 2⁻⁵⁰ of a frame that spans 2; this is far more, and nothing beside a box.
constexpr double pad = 0x1p-36;

/// By the volumes that the ray's direction spans with the edges. `corners` are relative to the origin.
bool is_met(const Corners& corners, const glm::dvec3& direction, double max_distance) {
    const auto& [a, b, c] = corners;
    const double u = glm::dot(direction, glm::cross(c, b));
    const double v = glm::dot(direction, glm::cross(a, c));
    const double w = glm::dot(direction, glm::cross(b, a));
    const bool inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
    if (!inside || u + v + w == 0.0) {
        return false;
    }
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double distance = glm::dot(normal, a) / glm::dot(normal, direction);
    return distance > 0.0 && distance < max_distance;
}

double distance_to_segment(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 along = b - a;
    const double square = glm::dot(along, along);
    const double place = square > 0.0 ? std::clamp(-glm::dot(a, along) / square, 0.0, 1.0) : 0.0;
    return glm::length(a + place * along);
}

double slack_of(const Corners& corners, const glm::dvec3& direction, double max_distance) {
    const glm::dvec3 along = glm::normalize(direction);
    Corners flat; // as seen along the ray
    for (std::size_t i = 0; i < 3; ++i) {
        flat[i] = corners[i] - along * glm::dot(corners[i], along);
    }
    const bool inside = is_met(corners, direction, std::numeric_limits<double>::infinity()) ||
                        is_met(corners, -direction, std::numeric_limits<double>::infinity());
    const double outline = std::min({distance_to_segment(flat[0], flat[1]), distance_to_segment(flat[1], flat[2]),
                                     distance_to_segment(flat[2], flat[0])});
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double size = glm::length(normal);
    if (size == 0.0) {
        return -std::numeric_limits<double>::infinity();
    }
    // Across the plane: the origin's distance from it, and its end's, positive where the plane lies between them.
    const double facing = glm::dot(normal, along) < 0.0 ? -1.0 : 1.0;
    const double behind = facing * glm::dot(normal, corners[0]) / size;
    const double before = std::isfinite(max_distance)
                              ? facing * glm::dot(normal, direction * max_distance - corners[0]) / size
                              : std::numeric_limits<double>::infinity();
    return std::min({inside ? outline : -outline, behind, before});
}

bool passes(const glm::dvec3& low, const glm::dvec3& high, const Ray& ray) {
    double entry = 0.0;
    double exit = ray.max_distance;
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = ray.origin[axis];
        const double direction = ray.direction[axis];
        if (direction == 0.0) {
            if (origin < low[axis] || origin > high[axis]) {
                return false;
            }
            continue;
        }
        const double first = (low[axis] - origin) / direction;
        const double second = (high[axis] - origin) / direction;
        entry = std::max(entry, std::min(first, second));
        exit = std::min(exit, std::max(first, second));
    }
    return entry <= exit;
}

Corners seen_from(const Corners& corners, const glm::vec3& origin) {
    const glm::dvec3 o(origin);
    return {corners[0] - o, corners[1] - o, corners[2] - o};
}

} // namespace

DoubleReference::DoubleReference(const Surface& surface) : m_surface(&surface), m_order(surface.triangle_count()) {
    std::iota(m_order.begin(), m_order.end(), 0U);
    if (!m_order.empty()) {
        split(0, static_cast<std::uint32_t>(m_order.size()));
    }
}

Corners DoubleReference::corners(std::uint32_t triangle) const {
    const glm::vec3* const first = &m_surface->positions[std::size_t{3} * triangle];
    return {glm::dvec3(first[0]), glm::dvec3(first[1]), glm::dvec3(first[2])};
}

// At the median of the centroids along the longest side: no heuristic, so that little can be wrong.
std::uint32_t DoubleReference::split(std::uint32_t begin, std::uint32_t end) {
    const auto index = static_cast<std::uint32_t>(m_nodes.size());
    Node node{.low = glm::dvec3(std::numeric_limits<double>::infinity()),
              .high = glm::dvec3(-std::numeric_limits<double>::infinity()),
              .begin = begin,
              .end = end};
    for (std::uint32_t i = begin; i < end; ++i) {
        for (const glm::dvec3& corner : corners(m_order[i])) {
            node.low = glm::min(node.low, corner - pad);
            node.high = glm::max(node.high, corner + pad);
        }
    }
    m_nodes.push_back(node);
    if (end - begin <= leaf_size) {
        return index;
    }
    const glm::dvec3 size = node.high - node.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    const auto centre = [&](std::uint32_t triangle) {
        const Corners c = corners(triangle);
        return c[0][axis] + c[1][axis] + c[2][axis];
    };
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(m_order.begin() + begin, m_order.begin() + middle, m_order.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return centre(a) < centre(b); });
    split(begin, middle);
    const std::uint32_t right = split(middle, end);
    m_nodes[index].right = right;
    return index;
}

bool DoubleReference::meets(std::uint32_t triangle, const Ray& ray) const {
    return triangle != ray.ignored_triangle &&
           is_met(seen_from(corners(triangle), ray.origin), glm::dvec3(ray.direction), ray.max_distance);
}

bool DoubleReference::occluded_below(std::uint32_t index, const Ray& ray) const {
    const Node& node = m_nodes[index];
    if (!passes(node.low, node.high, ray)) {
        return false;
    }
    if (node.right != 0) {
        return occluded_below(index + 1, ray) || occluded_below(node.right, ray);
    }
    return std::any_of(m_order.begin() + node.begin, m_order.begin() + node.end,
                       [&](std::uint32_t triangle) { return meets(triangle, ray); });
}

bool DoubleReference::occluded(const Ray& ray) const { return !m_nodes.empty() && occluded_below(0, ray); }

bool DoubleReference::occluded_by_any(const Ray& ray) const {
    return std::any_of(m_order.begin(), m_order.end(), [&](std::uint32_t triangle) { return meets(triangle, ray); });
}

Slack DoubleReference::surest(const Ray& ray) const {
    Slack best{.length = -std::numeric_limits<double>::infinity()};
    for (const std::uint32_t triangle : m_order) {
        if (triangle == ray.ignored_triangle) {
            continue;
        }
        const double length =
            slack_of(seen_from(corners(triangle), ray.origin), glm::dvec3(ray.direction), ray.max_distance);
        if (length > best.length) {
            best = {length, triangle};
        }
    }
    return best;
}

} // namespace vkbake::bench
