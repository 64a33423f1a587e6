// What a bake gives back.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "vkbake/atlas.hpp"
#include "vkbake/image.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Counts over one map. All but `seconds` are the same for every machine, thread count and accelerator.
struct LightMapStatistics {
    std::uint64_t covered_texels = 0;
    std::uint64_t rays = 0; ///< traced
    std::uint64_t occluded_rays = 0;
    std::uint64_t skipped_directions = 0; ///< at or below the geometric plane: add nothing, not traced
    std::uint64_t probed_hits = 0;        ///< hits among the rays whose nearest hit was looked at (one a texel)
    std::uint64_t back_side_hits = 0;     ///< of those, on a triangle's back
    std::uint64_t bounce_rays = 0;        ///< traced beside `rays`, for what surfaces reflect and emit
    std::uint64_t filled_texels = 0;      ///< by dilation
    double seconds = 0.0;                 ///< tracing
};

struct LightMap {
    std::string name; ///< AtlasPage::name
    Image image;      ///< RGB: E/π or visibility; A: 1 where there is a value to sample; coverage: 1 where baked
    LightMapStatistics statistics;
};

struct StageSeconds {
    std::string stage;
    double seconds = 0.0;
};

struct Bake {
    Settings settings;
    std::string device; ///< the Vulkan device's name and driver
    std::string sky;    ///< Sky::name
    Surface surface;
    Atlas atlas;
    std::vector<LightMap> light_maps; ///< one a page, in the pages' order
    std::vector<StageSeconds> stages; ///< in the order they ran
    std::vector<std::string> notes;
};

} // namespace vkbake
