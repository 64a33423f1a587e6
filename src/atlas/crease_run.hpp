// Which way creases run within a chart.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace vkbake {

/// Directions up to quarter turns, as texels have them, summed: of a unit complex number the fourth power is the same
/// for all four quarters.
class CreaseRun {
public:
    void add(const glm::dvec2& along) {
        const double length = glm::length(along);
        if (length > 0.0) {
            m_sum += length * fourth_power(along / length);
            m_length += length;
        }
    }

    /// What runs in a patch that is turned by the unit complex number.
    void add(const CreaseRun& other, const glm::dvec2& turn) {
        m_sum += times(other.m_sum, fourth_power(turn));
        m_length += other.m_length;
    }

    /// Whether a chart can be turned so that they run along rows and columns of texels: up to about 3°.
    [[nodiscard]] bool are_straight() const { return glm::length(m_sum) >= 0.98 * m_length; }

private:
    static glm::dvec2 times(const glm::dvec2& a, const glm::dvec2& b) {
        return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
    }
    static glm::dvec2 fourth_power(const glm::dvec2& z) {
        const glm::dvec2 square = times(z, z);
        return times(square, square);
    }

    glm::dvec2 m_sum{0.0};
    double m_length = 0.0;
};

} // namespace vkbake
