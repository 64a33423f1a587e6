// What an unwrapper made of a surface.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "vkbake/surface.hpp"

namespace vkbake::bench {

struct Unwrapped {
    std::vector<glm::vec2> texels;   ///< three a triangle
    std::vector<std::uint32_t> page; ///< one a triangle
    double pages_area = 0.0;         ///< texels²
    double density = 0.0;            ///< texels a metre
    double chart_seconds = 0.0;      ///< where it tells them apart; else all of it is here
    double pack_seconds = 0.0;
};

} // namespace vkbake::bench
