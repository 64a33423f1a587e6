// A scene's lamps made ready for texels.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "vkbake/lamp.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// A lamp in the bake frame.
struct ReadyLamp {
    LampKind kind = LampKind::point;
    glm::dvec3 place{0.0}; ///< point, spot
    glm::dvec3 axis{0.0};  ///< unit; directional: towards the lamp; spot: the way its light goes
    /// E/π of a surface that faces it; point, spot: at the distance 1.
    glm::dvec3 light{0.0};
    double size = 0.0; ///< directional: sine of half its angular diameter; point, spot: radius. 0: hard
    double range = std::numeric_limits<double>::infinity();
    double cone_scale = 0.0; ///< spot: strength² = clamp(cos · scale + offset)²
    double cone_offset = 1.0;
    std::size_t number = 0; ///< in the lamps that it was made from
};

/// Those that shine, in an order of their own values: a file's order changes no bit of a sum.
struct LampSet {
    std::vector<ReadyLamp> hard;
    std::vector<ReadyLamp> soft;
    std::size_t count = 0; ///< of the lamps that it was made from

    [[nodiscard]] bool empty() const { return hard.empty() && soft.empty(); }
};

/// 1/d² grows no further than at this distance, bake frame: nearer than that the offset of rays (ray_origin.hpp)
/// decides, not the scene.
inline constexpr double least_lamp_distance = 0x1p-20;

/// `unit`: what light is counted in. Throws Error{bad_input} that names a lamp whose values are out of range, or whose
/// light is more than a float holds.
[[nodiscard]] LampSet make_lamp_set(std::span<const Lamp> lamps, const BakeFrame& frame, double unit);

/// How much of a lamp's light goes to a point at `distance` ≥ 0 from it, in the direction `outwards` (unit) from it:
/// the extension's recommended formulas for range and cone, without 1/d². 1 for directional lamps.
[[nodiscard]] double attenuation(const ReadyLamp& lamp, double distance, const glm::dvec3& outwards);

} // namespace vkbake
