// Light-map UVs: where each triangle lies in which map.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace vkbake {

struct AtlasPage {
    std::string name; ///< unique, usable as a file's name
    int width = 0;    ///< texels
    int height = 0;
};

struct Atlas {
    std::vector<AtlasPage> pages;
    std::vector<glm::vec2> uvs; ///< 3 a triangle (as Surface's corners), [0,1] of its page, (0,0) the upper left corner
    std::vector<std::uint32_t> page;  ///< 1 a triangle: index in `pages`
    std::vector<std::uint32_t> chart; ///< 1 a triangle: charts are numbered through all pages
    std::uint32_t chart_count = 0;
    double density = 0.0; ///< texels per metre of what was placed (the least over the pages of layout `object`); 0
                          ///< where all UVs stayed as they were
    std::vector<std::string> notes; ///< e.g. which object's UVs were kept or why they were not
};

} // namespace vkbake
