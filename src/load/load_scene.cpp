// glTF file → Scene.
#include <cstdint>
#include <exception>
#include <map>
#include <new>
#include <stdexcept>
#include <string>

#include "base/json.hpp"
#include "load/context.hpp"
#include "load/document.hpp"
#include "load/lamps.hpp"
#include "load/materials.hpp"
#include "load/meshes.hpp"
#include "load/model.hpp"
#include "load/nodes.hpp"
#include "load/normalise.hpp"
#include "load/structure.hpp"
#include "vkbake/error.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake {

namespace {

Scene load(gltf::Context& context, const std::filesystem::path& file) {
    gltf::Document document = gltf::read_document(context, file);
    gltf::check_structure(context, document.json);
    const std::map<std::uint32_t, Lamp> lamps = gltf::read_lamps(context, document.json);

    Scene scene;
    scene.name = file.stem().string();
    scene.directory = file.parent_path().string();
    scene.source = gltf::normalise(context, std::move(document));

    const gltf::Model model = gltf::make_model(context, *scene.source);
    scene.materials = gltf::make_materials(context, model);
    scene.meshes = gltf::make_meshes(context, model, scene.materials);
    scene.images = gltf::make_images(model);
    gltf::PlacedNodes placed = gltf::place_nodes(context, model, lamps);
    scene.instances = std::move(placed.instances);
    scene.cameras = std::move(placed.cameras);
    scene.lamps = std::move(placed.lamps);
    scene.probes = std::move(placed.probes);
    scene.notes = context.take_notes();
    return scene;
}

} // namespace

Scene load_scene(const std::filesystem::path& file, const LoadSettings& settings) {
    gltf::Context context(file.string(), settings.outside_files);
    try {
        return load(context, file);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        context.fail("it does not fit the memory there is", "split the scene, or use a machine with more memory");
    } catch (const std::exception& error) {
        // What a library throws at input that the checks above did not foresee.
        context.fail("it cannot be read: " + gltf::printable(error.what()));
    }
}

} // namespace vkbake
