#include "bench/common/prepare_scene.hpp"

#include <limits>

#include "atlas/make_atlas.hpp"
#include "bench/common/ground.hpp"
#include "geometry_image/draw.hpp"
#include "surface/make_surface.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake::bench {

PreparedScene prepare_scene(const std::filesystem::path& file, const Settings& settings, bool ground) {
    Scene scene = load_scene(file);
    if (ground) {
        add_ground(scene);
    }
    PreparedScene prepared{.name = scene.name + (ground ? "-ground" : ""), .settings = settings};
    prepared.surface = make_surface(scene);
    if (prepared.surface.triangle_count() == 0) {
        throw Error(ErrorKind::bad_input, scene.name + ": no node shows a triangle; choose another scene");
    }
    prepared.atlas = make_atlas(scene, prepared.surface, settings);
    prepared.max_distance = settings.ao_distance
                                ? static_cast<float>(*settings.ao_distance * prepared.surface.frame.scale())
                                : std::numeric_limits<float>::infinity();
    const Device device = open_device();
    for (std::uint32_t page = 0; page < prepared.atlas.pages.size(); ++page) {
        prepared.pages.push_back(draw_geometry_image(device.context(), prepared.surface, prepared.atlas, page));
    }
    return prepared;
}

} // namespace vkbake::bench
