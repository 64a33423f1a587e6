// What an unwrapper made of a surface.
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>
#include <vector>

#include <glm/vec2.hpp>

#include "vkbake/surface.hpp"

namespace vkbake::bench {

struct Unwrapped {
    std::vector<glm::vec2> uvs;         ///< three a triangle
    std::vector<std::uint32_t> page;    ///< one a triangle
    std::vector<glm::dvec2> page_sizes; ///< one a page: texels a unit of its UVs
    double pages_area = 0.0;            ///< texels²
    double density = 0.0;               ///< texels a metre
    double wall_seconds = 0.0;
    double cpu_seconds = 0.0; ///< of all threads: for machines that others use meanwhile
};

/// Wall and processor time since it was made.
class Stopwatch {
public:
    void read(Unwrapped& result) const {
        result.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
        result.cpu_seconds = static_cast<double>(std::clock() - m_cpu) / CLOCKS_PER_SEC;
    }

private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
    std::clock_t m_cpu = std::clock();
};

} // namespace vkbake::bench
