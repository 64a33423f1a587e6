// Radiance that arrives from infinitely far.
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "vkbake/image.hpp"

namespace vkbake {

/// The same radiance from everywhere.
struct ConstantSky {
    glm::vec3 radiance{1.0F};
};

/// The CIE standard clear sky (ISO 15469:2004, type 12) over a black lower hemisphere:
/// sun at 45° elevation towards +X, zenith luminance 1, no sun disc.
struct ClearSky {};

/// Width 2 × height as a rule. Centre column along +X, top row along +Y; u = atan2(z, x)/2π + ½, v = acos(y)/π.
struct EquirectangularSky {
    Image image;
};

/// Vulkan's order (+X −X +Y −Y +Z −Z) and orientation, square faces of one size.
struct CubeSky {
    std::array<Image, 6> faces;
};

struct Sky {
    std::variant<ConstantSky, ClearSky, EquirectangularSky, CubeSky> source = ClearSky{};
    double rotation_degrees = 0.0;  ///< the sky is turned about +Y by this angle, counter-clockwise seen from above
    double intensity = 1.0;         ///< multiplies every radiance; ≥ 0, finite
    std::string name = "clear";     ///< as it was asked for: for manifests
    std::vector<std::string> notes; ///< what was changed while reading it, e.g. texels that were not finite
};

} // namespace vkbake
