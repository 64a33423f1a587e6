#include <algorithm>
#include <string>

#include <meshoptimizer.h>

#include "load/fields.hpp"
#include "load/layout.hpp"
#include "load/normalise.hpp"

namespace vkbake::gltf {

namespace {

constexpr const char* meshopt_extension = "EXT_meshopt_compression";

/// What the extension says of one view.
struct Compressed {
    std::uint32_t buffer = 0;
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
    std::uint64_t stride = 0;
    std::uint64_t count = 0;
    std::string mode;
    std::string filter;
};

Compressed read_compressed(const Document& document, const Fields& fields) {
    Compressed compressed;
    compressed.buffer = fields.required_index("buffer", document.buffers.size());
    compressed.offset = fields.unsigned_integer("byteOffset").value_or(0);
    compressed.length = fields.required_unsigned_integer("byteLength");
    compressed.stride = fields.required_unsigned_integer("byteStride");
    compressed.count = fields.required_unsigned_integer("count");
    compressed.mode = fields.required_string("mode");
    compressed.filter = fields.string("filter").value_or("NONE");
    return compressed;
}

void check_mode(const Fields& fields, const Compressed& compressed) {
    const std::uint64_t stride = compressed.stride;
    if (compressed.mode == "ATTRIBUTES") {
        if (stride == 0 || stride > 256 || stride % 4 != 0) {
            fields.fail("the compressed byteStride is not a multiple of 4 up to 256");
        }
    } else if (compressed.mode == "TRIANGLES" || compressed.mode == "INDICES") {
        if (stride != 2 && stride != 4) {
            fields.fail("the compressed byteStride of indices is neither 2 nor 4");
        }
        if (compressed.mode == "TRIANGLES" && compressed.count % 3 != 0) {
            fields.fail("the compressed \"count\" is not a multiple of 3");
        }
    } else {
        fields.fail("the compression's mode \"" + printable(compressed.mode) + "\" is unknown");
    }
    const std::string& filter = compressed.filter;
    const bool filter_fits = filter == "NONE" || (compressed.mode == "ATTRIBUTES" &&
                                                  ((filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) ||
                                                   (filter == "QUATERNION" && stride == 8) || filter == "EXPONENTIAL"));
    if (!filter_fits) {
        fields.fail("the compression's filter \"" + printable(filter) +
                    "\" is unknown, or does not suit its mode and stride");
    }
}

/// The codec's formats bound what a byte can expand to, so that a short file cannot ask for a long allocation:
/// attributes spend at least 2 bits on 16 vertices for each byte of the stride, indices at least a byte on three.
void check_expansion(const Fields& fields, const Compressed& compressed) {
    const std::uint64_t most =
        compressed.mode == "ATTRIBUTES" ? compressed.length * 64 / compressed.stride : compressed.length * 3;
    if (compressed.count > most) {
        fields.fail(std::to_string(compressed.count) + " elements cannot come from " +
                    std::to_string(compressed.length) + " compressed bytes");
    }
}

std::vector<std::byte> decode(const Fields& fields, const Compressed& compressed, std::span<const std::byte> source) {
    std::vector<std::byte> result(compressed.count * compressed.stride);
    const auto* const bytes = reinterpret_cast<const unsigned char*>(source.data());
    int error = 0;
    if (compressed.mode == "ATTRIBUTES") {
        error = meshopt_decodeVertexBuffer(result.data(), compressed.count, compressed.stride, bytes, source.size());
    } else if (compressed.mode == "TRIANGLES") {
        error = meshopt_decodeIndexBuffer(result.data(), compressed.count, compressed.stride, bytes, source.size());
    } else {
        error = meshopt_decodeIndexSequence(result.data(), compressed.count, compressed.stride, bytes, source.size());
    }
    if (error != 0) {
        fields.fail("the compressed data are damaged");
    }
    if (compressed.filter == "OCTAHEDRAL") {
        meshopt_decodeFilterOct(result.data(), compressed.count, compressed.stride);
    } else if (compressed.filter == "QUATERNION") {
        meshopt_decodeFilterQuat(result.data(), compressed.count, compressed.stride);
    } else if (compressed.filter == "EXPONENTIAL") {
        meshopt_decodeFilterExp(result.data(), compressed.count, compressed.stride);
    }
    return result;
}

std::vector<std::byte> decode_view(const Context& context, Document& document, std::size_t index,
                                   const Fields& fields) {
    const Compressed compressed = read_compressed(document, fields);
    check_mode(fields, compressed);
    const auto& buffer = document.buffers.at(compressed.buffer);
    if (!buffer) {
        fields.fail("the buffer of its compressed data, " + std::to_string(compressed.buffer) + ", has no data");
    }
    if (compressed.offset > buffer->size() || compressed.length > buffer->size() - compressed.offset) {
        fields.fail("its compressed data do not fit their buffer of " + std::to_string(buffer->size()) + " bytes");
    }
    check_expansion(fields, compressed);
    if (read_view(context, document.json, index).length != compressed.count * compressed.stride) {
        fields.fail("its \"byteLength\" is not what the compression's count and byteStride make");
    }
    reserve_bytes(context, document, compressed.count * compressed.stride);
    return decode(fields, compressed, std::span(*buffer).subspan(compressed.offset, compressed.length));
}

} // namespace

void decode_meshopt_views(Context& context, Document& document) {
    const std::size_t count = root_array(context, document.json, "bufferViews").size();
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<std::byte> bytes;
        {
            const Fields view = element(context, document.json, "bufferViews", "bufferView", i);
            const auto fields = view.extension(meshopt_extension);
            if (!fields) {
                continue;
            }
            bytes = decode_view(context, document, i, *fields);
        }
        Json& view = document.json["bufferViews"][i];
        drop_extension(view, meshopt_extension);
        view.erase("byteOffset");
        view["buffer"] = document.buffers.size();
        document.json["buffers"].push_back(Json::object({{"byteLength", bytes.size()}}));
        document.buffers.emplace_back(std::move(bytes));
    }
}

} // namespace vkbake::gltf
