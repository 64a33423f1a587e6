// Lamps over a floor: what their tests share.
#pragma once

#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "hand_made.hpp"
#include "host_bake.hpp"
#include "trace/tracer.hpp"

namespace vkbake::test {

inline constexpr double pi = std::numbers::pi;
/// The scenes here are 8 m wide: bake-frame coordinates times this are metres.
inline constexpr float lit_metres = 4.0F;
inline constexpr int lit_exponent = -2;

inline Sky black_sky() { return constant_sky(glm::vec3(0.0F)); }

inline Lamp point_lamp(const glm::dvec3& position, double candela = 10.0) {
    return {.name = "point", .intensity = candela, .position = position};
}

inline Lamp spot_lamp(const glm::dvec3& position, const glm::dvec3& direction, double inner, double outer) {
    return {.name = "spot",
            .kind = LampKind::spot,
            .intensity = 10.0,
            .position = position,
            .direction = glm::normalize(direction),
            .inner_cone = inner,
            .outer_cone = outer};
}

inline Lamp sun(const glm::dvec3& direction, double lux, double degrees = 0.0) {
    return {.name = "sun",
            .kind = LampKind::directional,
            .intensity = lux,
            .direction = glm::normalize(direction),
            .angular_diameter = degrees};
}

/// A floor of 8 m × 8 m in the plane y = 0, facing up; what a test adds stands on it.
class LitFloor {
public:
    LitFloor() { m_maker.add_quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}); }

    /// A wall or roof, corners in metres.
    void add_quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
        m_maker.add_quad(a / lit_metres, b / lit_metres, c / lit_metres, d / lit_metres);
    }
    /// A texel at (x, z), metres.
    void add_texel(double x, double z) {
        // The diagonal of the quad runs from (−1, 1) to (1, −1): right of it lies triangle 0.
        const std::uint32_t triangle = x + z >= 0.0 ? 0U : 1U;
        m_points.push_back({glm::vec3(glm::dvec3(x, 0.0, z) / double{lit_metres}), {0, 1, 0}, {0, 1, 0}, triangle});
    }
    void turn_shading_normal(const glm::vec3& normal) { m_points.back().shading_normal = glm::normalize(normal); }

    [[nodiscard]] LightMap trace(const std::vector<Lamp>& lamps, const Settings& settings = {},
                                 const Sky& sky = black_sky()) {
        const Surface surface = m_maker.finish(lit_exponent);
        return Tracer(surface, sky, settings, lamps).trace(geometry_image(m_points, 16));
    }
    /// One value a texel: E/π of a white lamp.
    [[nodiscard]] std::vector<double> light(const std::vector<Lamp>& lamps, const Settings& settings = {}) {
        const LightMap map = trace(lamps, settings);
        std::vector<double> values;
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            values.push_back(double{map.image.texels[i].g});
        }
        return values;
    }

private:
    SurfaceMaker m_maker;
    std::vector<SamplePoint> m_points;
};

inline Settings with_rays(std::uint32_t rays) {
    Settings settings;
    settings.rays = rays;
    return settings;
}

} // namespace vkbake::test
