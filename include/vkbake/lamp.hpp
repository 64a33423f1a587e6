// Lights at a place or from a direction: KHR_lights_punctual.
#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <string>

#include <glm/vec3.hpp>

namespace vkbake {

enum class LampKind : std::uint8_t { directional, point, spot };

/// A lamp where its node puts it, in the world. Its intensity and the sky's radiance are in one system: a sky of
/// radiance L is one of L candela a square metre.
struct Lamp {
    std::string name; ///< the node's, or the light's, or "node N"; not unique
    LampKind kind = LampKind::point;
    glm::dvec3 color{1.0}; ///< linear, ≥ 0
    /// ≥ 0. directional: lux, on a surface that faces it; point, spot: candela, along the axis of a spot.
    double intensity = 1.0;
    glm::dvec3 position{0.0};                   ///< metres; point, spot
    glm::dvec3 direction{0.0, 0.0, -1.0};       ///< unit, the way that its light goes; directional, spot
    double inner_cone = 0.0;                    ///< spot: radians from the axis, full strength within; ≤ outer_cone
    double outer_cone = std::numbers::pi / 4.0; ///< spot: radians from the axis, nothing beyond; ≤ π/2
    std::optional<double> range;                ///< metres, > 0: where its light ends; point, spot. Absent: nowhere
    double angular_diameter = 0.0; ///< directional: degrees, 0 … 90, of the disc that it is seen as; 0: hard shadows
    double radius = 0.0;           ///< point, spot: metres, ≥ 0, of the sphere that shines; 0: hard shadows
    std::uint32_t source_node = 0; ///< index in the source document's nodes

    /// Whether it has half-shadows.
    [[nodiscard]] bool is_soft() const { return kind == LampKind::directional ? angular_diameter > 0.0 : radius > 0.0; }
};

} // namespace vkbake
