// A scene up to where rays start: the same stages as a bake runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vkbake/atlas.hpp"
#include "vkbake/geometry_image.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/surface.hpp"

namespace vkbake::bench {

struct PreparedScene {
    std::string name; ///< the file's stem, with "-ground" where one was added
    Settings settings;
    Surface surface;
    Atlas atlas;
    std::vector<GeometryImage> pages;
    float max_distance = 0.0F; ///< of occlusion rays, bake frame
};

/// `ground`: puts a square of three times the scene's extent under it.
[[nodiscard]] PreparedScene prepare_scene(const std::filesystem::path& file, const Settings& settings, bool ground);

} // namespace vkbake::bench
