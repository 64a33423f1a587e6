#include "load/normalise.hpp"

#include <algorithm>
#include <array>

#include "load/fields.hpp"
#include "load/layout.hpp"

namespace vkbake::gltf {

namespace {

void drop_name(Json& document, const char* key, const std::string& name) {
    const auto list = document.find(key);
    if (list == document.end()) {
        return;
    }
    list->erase(std::remove(list->begin(), list->end(), Json(name)), list->end());
    if (list->empty()) {
        document.erase(key);
    }
}

} // namespace

SourceDocument normalise(Context& context, Document document) {
    check_layout(context, document.json);
    decode_meshopt_views(context, document);
    decode_draco_primitives(context, document);
    write_out_sparse_accessors(context, document);
    embed_images(context, document);
    SourceDocument plain;
    plain.binary = merge_buffers(context, document);
    for (const char* const name : {"EXT_meshopt_compression", "KHR_draco_mesh_compression"}) {
        drop_name(document.json, "extensionsUsed", name);
        drop_name(document.json, "extensionsRequired", name);
    }
    plain.json = document.json.dump();
    return plain;
}

} // namespace vkbake::gltf
