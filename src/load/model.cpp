#include "load/model.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "base/glb.hpp"
#include "base/json.hpp"

namespace vkbake::gltf {

namespace {

bool keep_encoded(tinygltf::Image* /*image*/, int /*index*/, std::string* /*error*/, std::string* /*warning*/,
                  int /*width*/, int /*height*/, const unsigned char* /*bytes*/, int /*size*/, void* /*user_data*/) {
    return true;
}

/// What a static scene does not need is not shown to tinygltf: it would refuse a whole document for a fault there.
std::string static_part(const std::string& json) {
    Json document = Json::parse(json);
    for (const char* const key : {"animations", "skins", "extensions", "extras"}) {
        document.erase(key);
    }
    return document.dump();
}

} // namespace

Model make_model(const Context& context, const SourceDocument& source) {
    const std::array binary{std::span<const std::byte>(source.binary)};
    const std::vector<std::byte> file = glb::make<std::byte>(static_part(source.json), binary);
    Model model;
    model.binary = source.binary;
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keep_encoded, nullptr);
    std::string error;
    std::string warning;
    const bool good =
        loader.LoadBinaryFromMemory(&model.data, &error, &warning, reinterpret_cast<const unsigned char*>(file.data()),
                                    static_cast<unsigned int>(file.size()));
    if (!good) {
        std::replace(error.begin(), error.end(), '\n', ' ');
        context.fail("the document cannot be read: " + printable(error));
    }
    for (tinygltf::Buffer& buffer : model.data.buffers) {
        buffer.data = {};
    }
    return model;
}

} // namespace vkbake::gltf
