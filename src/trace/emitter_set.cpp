#include "trace/emitter_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/luminance.hpp"

namespace vkbake {

namespace {

/// So many times the mean over all surfaces is sought.
constexpr double much_brighter = 4.0;

std::array<glm::dvec3, 3> corners_of(const Surface& surface, std::uint32_t triangle) {
    const std::size_t first = std::size_t{3} * triangle;
    return {glm::dvec3(surface.positions[first]), glm::dvec3(surface.positions[first + 1]),
            glm::dvec3(surface.positions[first + 2])};
}

glm::dvec3 cross_of(const Surface& surface, std::uint32_t triangle) {
    const auto [a, b, c] = corners_of(surface, triangle);
    return glm::cross(b - a, c - a);
}

/// Mean of what is sought, from the centres of 16 equal parts.
double mean_luminance(const SurfaceLight& light, std::uint32_t triangle) {
    constexpr int rows = 4;
    double sum = 0.0;
    for (int row = 0; row < rows; ++row) {
        for (int place = 0; place <= 2 * row; ++place) {
            // In a row, triangles that point up and down by turns.
            const double across = std::floor(0.5 * place) + (place % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0);
            const double down = place % 2 == 0 ? row + 2.0 / 3.0 : row + 1.0 / 3.0;
            const double v = across / rows;
            const double w = (down - across) / rows;
            sum += luminance(glm::dvec3(light.sought_at(triangle, {1.0 - v - w, v, w})));
        }
    }
    return sum / (rows * rows);
}

double sine_of(double cosine) { return std::sqrt(std::max(0.0, 1.0 - cosine * cosine)); }

/// cos(max(0, a − b)) of angles in [0, π].
double cosine_of_difference(double cosine_a, double cosine_b) {
    return cosine_a > cosine_b ? 1.0 : cosine_a * cosine_b + sine_of(cosine_a) * sine_of(cosine_b);
}

auto order_of(const glm::dvec3& point) { return std::tuple(point.x, point.y, point.z); }

} // namespace

EmitterSet::EmitterSet(const Surface& surface, const SurfaceLight& light, const SurfaceOpacity* opacity)
    : m_surface(&surface), m_light(&light) {
    const auto count = static_cast<std::uint32_t>(surface.triangle_count());
    std::vector<std::uint8_t> whole(count, opacity == nullptr ? 1 : 0);
    if (opacity != nullptr) {
        for (const std::uint32_t triangle : opacity->opaque()) {
            whole[triangle] = 1;
        }
    }
    std::vector<double> bright(count, 0.0);
    double power = 0.0;
    double all = 0.0;
    for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
        if (whole[triangle] != 0) {
            bright[triangle] = mean_luminance(light, triangle);
            power += bright[triangle] * area(triangle);
            all += area(triangle);
        }
    }
    std::vector<Candidate> candidates;
    for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
        if (area(triangle) > 0.0 && bright[triangle] * all > much_brighter * power) {
            const auto [a, b, c] = corners_of(surface, triangle);
            const bool two_sided = light.shows_back(triangle);
            candidates.push_back({triangle,
                                  {.low = glm::min(a, glm::min(b, c)),
                                   .high = glm::max(a, glm::max(b, c)),
                                   .axis = normal(triangle),
                                   .two_sided = two_sided,
                                   .power = bright[triangle] * area(triangle)}});
        }
    }
    m_nodes.reserve(2 * candidates.size());
    if (!candidates.empty()) {
        build(candidates, 0, 0);
    }
    std::ranges::sort(m_triangles, {}, &Known::triangle);
}

double EmitterSet::area(std::uint32_t triangle) const { return 0.5 * glm::length(cross_of(*m_surface, triangle)); }

glm::dvec3 EmitterSet::normal(std::uint32_t triangle) const { return glm::normalize(cross_of(*m_surface, triangle)); }

EmitterSet::Bounds EmitterSet::join(const Bounds& a, const Bounds& b) {
    Bounds both{.low = glm::min(a.low, b.low),
                .high = glm::max(a.high, b.high),
                .two_sided = a.two_sided || b.two_sided,
                .power = a.power + b.power};
    // A cone about the mean axis, as wide as either needs.
    const glm::dvec3 sum = a.axis + b.axis;
    both.axis = glm::length(sum) > 1e-3 ? glm::normalize(sum) : a.axis;
    const auto reach = [&](const Bounds& part) { // cos(angle between the axes + the cone's)
        const double between = std::clamp(glm::dot(both.axis, part.axis), -1.0, 1.0);
        const double wide = between * part.cosine - sine_of(between) * sine_of(part.cosine);
        return between <= -part.cosine ? -1.0 : wide;
    };
    both.cosine = std::min(reach(a), reach(b));
    return both;
}

void EmitterSet::build(std::span<Candidate> candidates, std::uint64_t path, unsigned depth) {
    const std::size_t place = m_nodes.size();
    m_nodes.emplace_back();
    if (candidates.size() == 1) {
        m_nodes[place] = {candidates[0].bounds, 0, candidates[0].triangle};
        m_triangles.push_back({candidates[0].triangle, path});
        return;
    }
    const auto centre = [](const Candidate& some) { return some.bounds.low + some.bounds.high; };
    glm::dvec3 low = centre(candidates[0]);
    glm::dvec3 high = low;
    for (const Candidate& some : candidates) {
        low = glm::min(low, centre(some));
        high = glm::max(high, centre(some));
    }
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    std::ranges::sort(candidates, [&](const Candidate& a, const Candidate& b) {
        const auto key = [&](const Candidate& some) {
            const auto corners = corners_of(*m_surface, some.triangle);
            return std::tuple(centre(some)[axis], order_of(corners[0]), order_of(corners[1]), order_of(corners[2]));
        };
        return key(a) < key(b);
    });
    const std::size_t half = candidates.size() / 2; // so no path is longer than 32 turns
    build(candidates.first(half), path, depth + 1);
    const auto second = static_cast<std::uint32_t>(m_nodes.size());
    build(candidates.subspan(half), path | std::uint64_t{1} << depth, depth + 1);
    m_nodes[place] = {join(m_nodes[place + 1].bounds, m_nodes[second].bounds), second, 0};
}

double EmitterSet::importance(const Bounds& bounds, const Receiver& receiver) const {
    const glm::dvec3 centre = 0.5 * (bounds.low + bounds.high);
    const glm::dvec3 way = centre - receiver.place;
    const double radius_square = 0.25 * glm::dot(bounds.high - bounds.low, bounds.high - bounds.low);
    const double square = glm::dot(way, way);
    // Inside the ball around the box any direction may lead to it.
    if (!(square > radius_square)) {
        return bounds.power / std::max(radius_square, 1e-30);
    }
    const glm::dvec3 direction = way / std::sqrt(square);
    const double cosine_ball = std::sqrt(std::max(0.0, 1.0 - radius_square / square));
    double cosine_sent = -glm::dot(bounds.axis, direction);
    if (bounds.two_sided) {
        cosine_sent = std::abs(cosine_sent);
    }
    const double sent = cosine_of_difference(cosine_of_difference(cosine_sent, bounds.cosine), cosine_ball);
    const double received = receiver.normal == glm::dvec3(0.0)
                                ? 1.0
                                : cosine_of_difference(glm::dot(receiver.normal, direction), cosine_ball);
    return sent > 0.0 && received > 0.0 ? bounds.power * sent * received / square : 0.0;
}

std::optional<double> EmitterSet::share_of_first(const Node& node, const Receiver& receiver) const {
    const auto first = static_cast<std::size_t>(&node - m_nodes.data()) + 1;
    const double a = importance(m_nodes[first].bounds, receiver);
    const double b = importance(m_nodes[node.second].bounds, receiver);
    return a + b > 0.0 ? std::optional(a / (a + b)) : std::nullopt;
}

std::optional<EmitterSet::Sample> EmitterSet::sample(const Receiver& receiver, double u, double v) const {
    double probability = 1.0;
    std::size_t place = 0;
    while (m_nodes[place].second != 0) {
        const Node& node = m_nodes[place];
        const std::optional<double> first = share_of_first(node, receiver);
        if (!first) {
            return std::nullopt;
        }
        const bool takes_first = u < *first;
        const double share = takes_first ? *first : 1.0 - *first;
        u = std::clamp((takes_first ? u : u - *first) / share, 0.0, 1.0);
        probability *= share;
        place = takes_first ? place + 1 : node.second;
    }
    const std::uint32_t triangle = m_nodes[place].triangle;
    const double root = std::sqrt(u); // P. Shirley, C. Wang, K. Zimmerman, Monte Carlo Techniques for Direct Lighting
                                      // Calculations, 1996
    const glm::dvec3 weights(1.0 - root, root * (1.0 - v), root * v);
    const auto [a, b, c] = corners_of(*m_surface, triangle);
    return Sample{.point = weights.x * a + weights.y * b + weights.z * c,
                  .normal = normal(triangle),
                  .two_sided = m_light->shows_back(triangle),
                  .radiance = m_light->sought_at(triangle, weights),
                  .density = probability / area(triangle)};
}

double EmitterSet::density(const Receiver& receiver, std::uint32_t triangle) const {
    const auto known = std::ranges::lower_bound(m_triangles, triangle, {}, &Known::triangle);
    if (known == m_triangles.end() || known->triangle != triangle) {
        return 0.0;
    }
    double probability = 1.0;
    std::size_t place = 0;
    for (std::uint64_t path = known->path; m_nodes[place].second != 0; path >>= 1U) {
        const Node& node = m_nodes[place];
        const std::optional<double> first = share_of_first(node, receiver);
        if (!first) {
            return 0.0;
        }
        probability *= (path & 1U) == 0 ? *first : 1.0 - *first;
        place = (path & 1U) == 0 ? place + 1 : node.second;
    }
    return probability / area(triangle);
}

} // namespace vkbake
