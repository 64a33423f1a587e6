#include <cstring>
#include <string>

#include "load/fields.hpp"
#include "load/layout.hpp"
#include "load/normalise.hpp"

namespace vkbake::gltf {

namespace {

/// An accessor that is sparse over nothing asks for zeros that no file holds: a short document could ask for any
/// amount.
constexpr std::uint64_t most_zeros = 1ULL << 28U;

std::uint64_t unsigned_at(std::span<const std::byte> bytes, std::uint64_t offset, std::uint64_t size) {
    std::uint64_t value = 0;
    for (std::uint64_t i = 0; i < size; ++i) {
        value |= std::to_integer<std::uint64_t>(bytes[offset + i]) << (8 * i);
    }
    return value;
}

std::vector<std::byte> written_out(const Context& context, const Document& document, const Fields& fields,
                                   const Accessor& accessor) {
    const std::uint64_t size = accessor.type.size();
    std::vector<std::byte> result(accessor.count * size);
    if (accessor.view) {
        const auto base = view_bytes(context, document, *accessor.view);
        const std::uint64_t view_stride = read_view(context, document.json, *accessor.view).stride;
        const std::uint64_t stride = view_stride != 0 ? view_stride : size;
        for (std::uint64_t i = 0; i < accessor.count; ++i) {
            std::memcpy(&result[i * size], &base[accessor.offset + i * stride], size);
        }
    }
    const Fields sparse = fields.required_object("sparse");
    const Fields index_part = sparse.required_object("indices");
    const Fields value_part = sparse.required_object("values");
    const auto indices = view_bytes(context, document, index_part.required_unsigned_integer("bufferView"));
    const auto values = view_bytes(context, document, value_part.required_unsigned_integer("bufferView"));
    const std::uint64_t index_offset = index_part.unsigned_integer("byteOffset").value_or(0);
    const std::uint64_t value_offset = value_part.unsigned_integer("byteOffset").value_or(0);
    const ElementType index_type{.component = static_cast<int>(index_part.required_unsigned_integer("componentType"))};
    const std::uint64_t count = sparse.required_unsigned_integer("count");
    std::uint64_t next = 0; // the indices must strictly increase
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t index =
            unsigned_at(indices, index_offset + i * index_type.size(), index_type.component_size());
        if (index < next || index >= accessor.count) {
            fields.fail("its sparse index " + std::to_string(index) +
                        (index < next ? " does not increase" : " is out of range"));
        }
        next = index + 1;
        std::memcpy(&result[index * size], &values[value_offset + i * size], size);
    }
    return result;
}

} // namespace

void write_out_sparse_accessors(Context& context, Document& document) {
    const std::size_t count = root_array(context, document.json, "accessors").size();
    std::uint64_t zeros = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Accessor accessor = read_accessor(context, document.json, i);
        if (!accessor.is_sparse) {
            continue;
        }
        std::vector<std::byte> bytes;
        {
            const Fields fields = element(context, document.json, "accessors", "accessor", i);
            const std::uint64_t size = accessor.type.size();
            if (!accessor.view) {
                if (accessor.count > (most_zeros - zeros) / size) {
                    fields.fail("it asks for " + std::to_string(accessor.count) + " zeros that no file holds");
                }
                zeros += accessor.count * size;
            }
            reserve_bytes(context, document, accessor.count * size);
            bytes = written_out(context, document, fields, accessor);
        }
        const std::uint32_t view = append_view(document, std::move(bytes));
        Json& json = document.json["accessors"][i];
        json["bufferView"] = view;
        json.erase("byteOffset");
        json.erase("sparse");
    }
}

} // namespace vkbake::gltf
