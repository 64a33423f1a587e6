#include "load/glb.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "base/glb.hpp"

namespace vkbake::gltf {

namespace {

using glb::chunk_header_size;
using glb::header_size;

std::uint32_t read_word(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        word |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8 * i);
    }
    return word;
}

/// The header checked; the container alone, without what may stand behind it.
std::span<const std::byte> read_header(Context& context, std::span<const std::byte> file) {
    if (!has_glb_magic(file)) {
        context.fail("not a GLB: it does not start with \"glTF\"", "check that the file is what its name says");
    }
    if (file.size() < header_size) {
        context.fail("the GLB header is cut short", "copy or download the file again");
    }
    const std::uint32_t version = read_word(file, 4);
    if (version != glb::version) {
        context.fail("GLB version " + std::to_string(version) + " is not supported", "convert it to glTF 2.0");
    }
    const std::uint32_t length = read_word(file, 8);
    if (length > file.size()) {
        context.fail("the GLB says it is " + std::to_string(length) + " bytes long, but the file has " +
                         std::to_string(file.size()),
                     "copy or download the file again");
    }
    if (length < header_size + chunk_header_size) {
        context.fail("the GLB says it is " + std::to_string(length) + " bytes long, too short for any content");
    }
    if (length < file.size()) {
        context.note(std::to_string(file.size() - length) + " bytes behind the GLB's end are ignored");
    }
    return file.subspan(0, length);
}

} // namespace

bool has_glb_magic(std::span<const std::byte> file) { return file.size() >= 4 && read_word(file, 0) == glb::magic; }

GlbChunks read_glb(Context& context, std::span<const std::byte> file) {
    const std::span<const std::byte> container = read_header(context, file);
    GlbChunks chunks;
    std::size_t position = header_size;
    for (std::size_t number = 0; position < container.size(); ++number) {
        const std::string where = " (GLB chunk " + std::to_string(number) + ')';
        if (container.size() - position < chunk_header_size) {
            context.fail("a chunk's header is cut short" + where, "copy or download the file again");
        }
        const std::size_t length = read_word(container, position);
        const std::uint32_t type = read_word(container, position + 4);
        position += chunk_header_size;
        if (length > container.size() - position) {
            context.fail("a chunk is longer than what is left of the file" + where, "copy or download the file again");
        }
        if (length % 4 != 0) {
            context.fail("a chunk's length is not a multiple of 4" + where);
        }
        if ((number == 0) != (type == glb::json_type)) {
            context.fail(number == 0 ? "the first chunk is not of type JSON" : "there is a second JSON chunk" + where);
        }
        if (type == glb::binary_type && number != 1) {
            context.fail("a BIN chunk is not the second chunk" + where);
        }
        const std::span<const std::byte> data = container.subspan(position, length);
        if (type == glb::json_type) {
            if (data.empty()) {
                context.fail("the JSON chunk is empty");
            }
            chunks.json = std::string_view(reinterpret_cast<const char*>(data.data()), data.size());
        } else if (type == glb::binary_type) {
            chunks.binary = data;
        } else {
            context.note("a chunk of unknown type is ignored" + where);
        }
        position += length;
    }
    return chunks;
}

} // namespace vkbake::gltf
