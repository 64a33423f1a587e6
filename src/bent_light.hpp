// What bent normals are for: light of a sky that was not there when they were baked.
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "vkbake/image.hpp"
#include "vkbake/sky.hpp"

namespace vkbake {

/// The sky's light as that of a light probe to which nothing is hidden: nine coefficients, as vkbake_light.h has them.
[[nodiscard]] std::array<glm::vec3, 9> sky_coefficients(const Sky& sky);

/// Puts in the place of each bent normal (world axes, as long as visibility) the light, E/π, that it stands for:
/// visibility times what the probe gives a surface that looks along it. Where nothing is open it is 0.
void light_bent_normals(Image& bent_normals, const std::array<glm::vec3, 9>& sky_coefficients);

} // namespace vkbake
