// Radiance of the sky: each kind of sky made ready for many look-ups (trace/sky_sum.hpp).
#pragma once

#include <variant>

#include <glm/vec3.hpp>

#include "base/elementary.hpp"
#include "trace/sky_image.hpp"
#include "trace/sky_map.hpp"
#include "vkbake/sky.hpp"

namespace vkbake {

/// Turns a direction of the scene into one of the sky that was turned about +Y: by −angle where the sky was turned by
/// +angle, counter-clockwise seen from above (so a sky turned by 90° shows towards −Z what it had towards +X).
struct SkyTurn {
    float sine = 0.0F;
    float cosine = 1.0F;

    SkyTurn() = default;
    explicit SkyTurn(double degrees)
        : sine(static_cast<float>(sine_cosine_degrees(degrees).sine)),
          cosine(static_cast<float>(sine_cosine_degrees(degrees).cosine)) {}
};

/// The same radiance from everywhere.
struct ConstantLookup {
    glm::vec3 radiance{0.0F};
};

/// ISO 15469:2004 (CIE S 011), type 12, relative to the zenith, all three channels alike (the standard says nothing of
/// colour), the sun at 45° towards +X. Below the horizon 0.
struct ClearSkyLookup {
    SkyTurn turn;
};

/// An equirectangular picture: around the horizon it wraps, at the poles it is held.
struct EquirectangularLookup {
    SkyTurn turn;
    BorderedImages image;
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

/// The point of the cube's surface that cube_point maps to (face, s, t); beyond the face's border for s, t outside [0,
/// 1].
[[nodiscard]] glm::dvec3 cube_direction(int face, double s, double t);

/// Six faces, filtered across the cube's edges; at a corner the ring holds the mean of the three texels that meet
/// there.
struct CubeLookup {
    SkyTurn turn;
    BorderedImages faces;
};

/// A picture resampled for rays, turned already.
struct MapLookup {
    SkyMap map;
};

/// One of them. Intensity is not in it: it multiplies sums.
using SkyLookup = std::variant<ConstantLookup, ClearSkyLookup, EquirectangularLookup, CubeLookup, MapLookup>;

/// Throws Error{usage} where intensity or rotation is out of range, Error{bad_input} where a picture cannot be a sky,
/// or its greatest value times the intensity does not fit a float.
[[nodiscard]] SkyLookup make_sky_lookup(const Sky& sky);

} // namespace vkbake
