#include "load/document.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "load/fields.hpp"
#include "load/files.hpp"
#include "load/glb.hpp"
#include "load/parse_json.hpp"
#include "load/uri.hpp"

namespace vkbake::gltf {

namespace {

constexpr std::array<std::string_view, 9> supported_extensions = {"KHR_mesh_quantization",
                                                                  "EXT_meshopt_compression",
                                                                  "KHR_draco_mesh_compression",
                                                                  "KHR_texture_transform",
                                                                  "KHR_materials_emissive_strength",
                                                                  "KHR_materials_pbrSpecularGlossiness",
                                                                  "KHR_materials_transmission",
                                                                  "MOZ_lightmap",
                                                                  "KHR_lights_punctual"};

bool is_supported(std::string_view extension) {
    return std::find(supported_extensions.begin(), supported_extensions.end(), extension) != supported_extensions.end();
}

void check_asset(const Context& context, const Json& json) {
    const Fields asset = Fields(context, json, "the document").required_object("asset");
    const std::string version = asset.required_string("version");
    const bool well_formed =
        version.size() > 2 && version[1] == '.' && version.find_first_not_of("0123456789", 2) == std::string::npos;
    if (!well_formed || version[0] != '2') {
        context.fail("glTF version \"" + printable(version) + "\" is not supported", "convert it to glTF 2.0");
    }
    const auto least = asset.string("minVersion");
    if (least && *least != "2.0") {
        context.fail("it asks for a reader of glTF \"" + printable(*least) + '"', "export it as glTF 2.0");
    }
}

void check_extensions(Context& context, const Json& json) {
    const auto names = [&](const char* key) {
        std::vector<std::string> result;
        for (const Json& name : root_array(context, json, key)) {
            if (!name.is_string()) {
                context.fail('"' + std::string(key) + "\" holds something that is not a string");
            }
            result.push_back(name.get<std::string>());
        }
        return result;
    };
    for (const std::string& name : names("extensionsRequired")) {
        if (!is_supported(name)) {
            context.fail("it requires the extension " + printable(name) + ", which vkbake does not support",
                         "export it without that extension");
        }
    }
    for (const std::string& name : names("extensionsUsed")) {
        if (!is_supported(name)) {
            context.note("the extension " + printable(name) + " is not supported: its data are kept, and ignored");
        }
    }
}

/// Empty arrays break the specification and harm nobody; exporters write them.
void drop_empty_arrays(Context& context, Json& json) {
    constexpr std::array<const char*, 15> keys = {
        "accessors", "animations", "buffers",        "bufferViews", "cameras",
        "images",    "materials",  "meshes",         "nodes",       "samplers",
        "scenes",    "skins",      "extensionsUsed", "textures",    "extensionsRequired"};
    for (const char* const key : keys) {
        const auto found = json.find(key);
        if (found != json.end() && found->is_array() && found->empty()) {
            context.note('"' + std::string(key) + "\" is an empty array, against the glTF specification: left out");
            json.erase(key);
        }
    }
}

std::vector<std::byte> read_buffer_uri(const Context& context, Document& document, const Fields& buffer,
                                       const std::string& uri, std::uint64_t length) {
    if (is_data_uri(uri)) {
        reserve_bytes(context, document, uri.size() / 4 * 3);
        auto data = decode_data_uri(uri);
        if (!data) {
            buffer.fail("the data URI is malformed");
        }
        if (data->media_type != "application/octet-stream" && data->media_type != "application/gltf-buffer") {
            buffer.fail("the data URI's media type is \"" + printable(data->media_type) +
                        "\", not application/octet-stream or application/gltf-buffer");
        }
        return std::move(data->bytes);
    }
    const auto path = relative_path(uri);
    if (!path) {
        buffer.fail("the URI \"" + printable(uri) + "\" is not a path relative to the scene's folder");
    }
    context.require_inside(*path, buffer.where());
    const std::string what = quoted(*path) + " (" + buffer.where() + ")";
    reserve_bytes(context, document, std::min(file_size(context, document.directory / *path, what), length));
    return read_file(context, document.directory / *path, what, length);
}

std::optional<std::vector<std::byte>> read_buffer(Context& context, Document& document, std::size_t index,
                                                  std::optional<std::span<const std::byte>> binary_chunk) {
    const Fields buffer = element(context, document.json, "buffers", "buffer", index);
    const std::uint64_t length = buffer.required_unsigned_integer("byteLength");
    if (length == 0) {
        buffer.fail("\"byteLength\" is 0");
    }
    const auto meshopt = buffer.extension("EXT_meshopt_compression");
    if (meshopt && meshopt->boolean("fallback", false)) {
        return std::nullopt; // its views are compressed: nothing needs it, even where it has a URI
    }
    const auto uri = buffer.string("uri");
    std::vector<std::byte> bytes;
    if (uri) {
        bytes = read_buffer_uri(context, document, buffer, *uri, length);
    } else if (index == 0 && binary_chunk) {
        const auto wanted = binary_chunk->subspan(0, std::min<std::uint64_t>(binary_chunk->size(), length));
        reserve_bytes(context, document, wanted.size());
        bytes.assign(wanted.begin(), wanted.end());
    } else {
        context.note(buffer.where() + " has no data");
        return std::nullopt;
    }
    if (bytes.size() < length) {
        buffer.fail("\"byteLength\" is " + std::to_string(length) + ", but there are only " +
                    std::to_string(bytes.size()) + " bytes");
    }
    bytes.resize(length);
    return bytes;
}

} // namespace

Document read_document(Context& context, const std::filesystem::path& file) {
    const std::vector<std::byte> bytes = read_file(context, file, "file");
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    GlbChunks chunks;
    const bool is_glb = extension == ".glb" || has_glb_magic(bytes);
    if (is_glb) {
        chunks = read_glb(context, bytes);
    } else {
        chunks.json = std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }

    Document document;
    document.directory = file.parent_path();
    document.json = parse_json(context, chunks.json);
    check_asset(context, document.json);
    check_extensions(context, document.json);
    drop_empty_arrays(context, document.json);
    const std::size_t buffer_count = root_array(context, document.json, "buffers").size();
    for (std::size_t i = 0; i < buffer_count; ++i) {
        document.buffers.push_back(read_buffer(context, document, i, chunks.binary));
        if (i == 0 && is_glb && !chunks.binary && !document.buffers[0]) {
            const Fields buffer = element(context, document.json, "buffers", "buffer", 0);
            if (!buffer.extension("EXT_meshopt_compression")) {
                buffer.fail("it is the GLB's binary chunk, but there is none");
            }
        }
    }
    return document;
}

void reserve_bytes(const Context& context, Document& document, std::uint64_t bytes) {
    if (bytes > largest_document - document.size) {
        context.fail("its buffers and images together are larger than 4 GiB", "split the scene");
    }
    document.size += bytes;
}

std::uint32_t append_view(Document& document, std::vector<std::byte> bytes) {
    document.json["bufferViews"]; // made where it is missing, before references into the document are taken
    Json& buffers = document.json["buffers"];
    Json& views = document.json["bufferViews"];
    Json view = Json::object();
    view["buffer"] = buffers.size();
    view["byteLength"] = bytes.size();
    views.push_back(std::move(view));
    buffers.push_back(Json::object({{"byteLength", bytes.size()}}));
    document.buffers.emplace_back(std::move(bytes));
    return static_cast<std::uint32_t>(views.size() - 1);
}

} // namespace vkbake::gltf
