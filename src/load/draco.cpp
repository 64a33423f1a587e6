#include "load/fields.hpp"
#include "load/normalise.hpp"

namespace vkbake::gltf {

void decode_draco_primitives(Context& context, Document& document) {
    const Json& meshes = root_array(context, document.json, "meshes");
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const Fields mesh = element(context, document.json, "meshes", "mesh", i);
        for (const Json& primitive : mesh.json().at("primitives")) {
            if (Fields(context, primitive, mesh.where()).extension("KHR_draco_mesh_compression")) {
                mesh.fail("KHR_draco_mesh_compression is not supported yet");
            }
        }
    }
}

} // namespace vkbake::gltf
