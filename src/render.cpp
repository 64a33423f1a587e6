// Has the preview draw a baked scene.
#include "vkbake/render.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "base/boundary.hpp"
#include "preview/camera.hpp"
#include "preview/preview.hpp"
#include "preview_images.hpp"
#include "probe_balls.hpp"
#include "trace/sky_lookup.hpp"
#include "trace/sky_sum.hpp"
#include "vkbake/vkbake.hpp"
#include "write/manifest.hpp"

namespace vkbake {

namespace {

/// Squares of 4 × 4 texels; what was baked or filled is no matter.
void draw_checker(Image& light_map) {
    for (int y = 0; y < light_map.height; ++y) {
        for (int x = 0; x < light_map.width; ++x) {
            const float light = (x / 4 + y / 4) % 2 == 0 ? 1.0F : 0.25F;
            light_map.texels[light_map.index(x, y)] = glm::vec4(light, light, light, 1.0F);
        }
    }
}

Image draw(const Scene& scene, const Sky& sky, const RenderSettings& settings, const Device& device) {
    PreviewImages images = decode_images(scene, sky, settings);
    if (settings.checker) {
        std::ranges::for_each(images.light_maps, draw_checker);
    }
    Scene with_probes;
    if (settings.probes) {
        with_probes = scene;
        add_probe_balls(read_probes(std::filesystem::path(scene.directory) / "probes.json"), with_probes, images);
    }
    const Scene& baked = settings.probes ? with_probes : scene;
    const double aspect = static_cast<double>(std::max(settings.width, 1)) / std::max(settings.height, 1);
    const Camera camera = settings.view ? *settings.view : choose_camera(baked, settings.camera, aspect);
    PreviewSky radiance;
    if (settings.show_sky) {
        radiance = [lookup = make_sky_lookup(sky), intensity = static_cast<float>(sky.intensity)](
                       const glm::vec3& direction) { return intensity * vkbake::radiance(lookup, direction); };
    }
    const PreviewSettings preview{.width = settings.width,
                                  .height = settings.height,
                                  .light_only = settings.light_only || settings.checker,
                                  .exposure = std::exp2(settings.exposure),
                                  .metered = true};
    return draw_preview(device.context(), baked, images, camera, radiance, preview);
}

} // namespace

Image render(const Scene& baked, const Sky& sky, const RenderSettings& settings, const Device& device) {
    return at_boundary([&] {
        if (baked.source) {
            check_bake_of(baked.directory, baked.name + ".glb");
        }
        return draw(baked, sky, settings, device);
    });
}

} // namespace vkbake
