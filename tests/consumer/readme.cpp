#include <vkbake/vkbake.hpp>

#include <cstdio>
#include <string>
#include <vector>

namespace {

/// Stands for what a renderer does with a light map.
void upload(const std::string& name, int width, int height, const std::vector<glm::vec4>& texels) {
    std::printf("%s: %d x %d, %zu texels\n", name.c_str(), width, height, texels.size());
}

} // namespace

int main(int argument_count, char** arguments) {
    // README begin
    const vkbake::Scene scene = vkbake::load_scene(argument_count > 1 ? arguments[1] : "scene.glb");
    const vkbake::Sky sky = vkbake::load_sky("clear"); // or "noon.hdr", or "1,1,1"
    vkbake::Settings settings;                         // every field has a default
    settings.size = 512;
    settings.rays = 128;
    const vkbake::Device device = vkbake::open_device(); // or adopt_device(your handles)
    const vkbake::Bake bake = vkbake::bake(scene, sky, settings, device);
    for (const vkbake::LightMap& map : bake.light_maps) {
        upload(map.name, map.image.width, map.image.height, map.image.texels); // linear RGBA floats, E/π
    }
    vkbake::write_bake(scene, bake, {.directory = "baked"});
    // README end
}
