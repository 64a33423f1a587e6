// Axis-aligned boxes.
#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace vkbake {

/// A closed box; as constructed it is empty, with low > high.
struct Box {
    glm::vec3 low{std::numeric_limits<float>::infinity()};
    glm::vec3 high{-std::numeric_limits<float>::infinity()};

    void add(const glm::vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void add(const Box& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    [[nodiscard]] bool empty() const { return !(low.x <= high.x); }
    /// Half the surface's area; 0 where empty. In double: the sum must not drown thin boxes.
    [[nodiscard]] double half_area() const {
        if (empty()) {
            return 0.0;
        }
        const double x = static_cast<double>(high.x) - low.x;
        const double y = static_cast<double>(high.y) - low.y;
        const double z = static_cast<double>(high.z) - low.z;
        return x * y + y * z + z * x;
    }
};

} // namespace vkbake
