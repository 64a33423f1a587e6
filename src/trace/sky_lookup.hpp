// Radiance of the sky by direction: each kind of sky made ready for many look-ups.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <variant>

#include <glm/vec3.hpp>

#include "base/elementary.hpp"
#include "trace/sky_image.hpp"
#include "vkbake/sky.hpp"

namespace vkbake {

/// Turns a direction of the scene into one of the sky that was turned about +Y: by −angle where the sky was turned by
/// +angle, counter-clockwise seen from above (so a sky turned by 90° shows towards −Z what it had towards +X).
class SkyTurn {
public:
    SkyTurn() = default;
    explicit SkyTurn(double degrees)
        : m_sine(static_cast<float>(sine_cosine_degrees(degrees).sine)),
          m_cosine(static_cast<float>(sine_cosine_degrees(degrees).cosine)) {}

    [[nodiscard]] glm::vec3 into_sky(const glm::vec3& direction) const {
        return {direction.x * m_cosine - direction.z * m_sine, direction.y,
                direction.x * m_sine + direction.z * m_cosine};
    }

private:
    float m_sine = 0.0F;
    float m_cosine = 1.0F;
};

/// The same radiance from everywhere.
class ConstantLookup {
public:
    explicit ConstantLookup(const glm::vec3& radiance) : m_radiance(radiance) {}
    [[nodiscard]] glm::vec3 operator()(const glm::vec3& /*direction*/) const { return m_radiance; }

private:
    glm::vec3 m_radiance;
};

/// ISO 15469:2004 (CIE S 011), type 12, relative to the zenith, all three channels alike (the standard says nothing of
/// colour). Below the horizon 0.
class ClearSkyLookup {
public:
    explicit ClearSkyLookup(const SkyTurn& turn);
    [[nodiscard]] glm::vec3 operator()(const glm::vec3& direction) const {
        const glm::vec3 turned = m_turn.into_sky(direction);
        return turned.y >= 0.0F ? glm::vec3(static_cast<float>(relative_luminance(turned) * m_scale)) : glm::vec3(0.0F);
    }

    static constexpr double sun_elevation_degrees = 45.0; ///< towards +X

private:
    /// φ(Z) · f(χ): gradation by the zenith distance, scattering indicatrix by the distance from the sun.
    [[nodiscard]] double relative_luminance(const glm::vec3& direction) const;

    SkyTurn m_turn;
    double m_scale = 1.0;
};

/// An equirectangular picture: around the horizon it wraps, at the poles it is held.
class EquirectangularLookup {
public:
    /// Throws Error{bad_input} for a picture without texels.
    EquirectangularLookup(const EquirectangularSky& sky, const SkyTurn& turn);
    [[nodiscard]] glm::vec3 operator()(const glm::vec3& direction) const {
        const glm::vec3 turned = m_turn.into_sky(direction);
        const double x = turned.x;
        const double y = turned.y;
        const double z = turned.z;
        const double u = arc_tangent(z, x) * (0.5 / std::numbers::pi) + 0.5;
        // acos(y) loses its digits near the poles; the angle between +Y and the direction does not.
        const double v = arc_tangent(std::sqrt(x * x + z * z), y) * (1.0 / std::numbers::pi);
        return m_image.sample(u, v);
    }

private:
    SkyTurn m_turn;
    BorderedImage m_image;
};

/// Where a direction meets the cube: Vulkan's faces (+X −X +Y −Y +Z −Z) and coordinates, (0, 0) the face's upper left
/// corner.
struct CubePoint {
    int face = 0;
    double s = 0.5;
    double t = 0.5;
};

/// Vulkan 1.3, "Cube Map Face Selection" and "Cube Map Coordinate Transformation": the face of the greatest coordinate,
/// Z before Y before X where they are equal. The same choice as the thesis's §2.5.3.1, whose v counts from the bottom.
[[nodiscard]] CubePoint cube_point(const glm::dvec3& direction);

/// Six faces, filtered across the cube's edges; at a corner the ring holds the mean of the three texels that meet
/// there.
class CubeLookup {
public:
    /// Throws Error{bad_input} unless all faces are square, of one size, and have texels.
    CubeLookup(const CubeSky& sky, const SkyTurn& turn);
    [[nodiscard]] glm::vec3 operator()(const glm::vec3& direction) const {
        const CubePoint point = cube_point(glm::dvec3(m_turn.into_sky(direction)));
        return m_faces[static_cast<std::size_t>(point.face)].sample(point.s, point.t);
    }

private:
    SkyTurn m_turn;
    std::array<BorderedImage, 6> m_faces;
};

/// One of them; visited once a map, so that a ray's look-up is a plain call. Intensity is not in it: it multiplies
/// sums.
using SkyLookup = std::variant<ConstantLookup, ClearSkyLookup, EquirectangularLookup, CubeLookup>;

/// Throws Error{usage} where intensity or rotation is out of range, Error{bad_input} where a picture cannot be a sky or
/// its greatest value times the intensity does not fit a float.
[[nodiscard]] SkyLookup make_sky_lookup(const Sky& sky);

} // namespace vkbake
