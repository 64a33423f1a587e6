#include "load/layout.hpp"

#include <string>

#include "load/fields.hpp"

namespace vkbake::gltf {

namespace {

int read_component_type(const Fields& fields) {
    const std::uint64_t number = fields.required_unsigned_integer("componentType");
    if (!is_component_type(number)) {
        fields.fail("\"componentType\" is none that glTF has");
    }
    return static_cast<int>(number);
}

ElementType read_element_type(const Fields& fields) {
    const std::string shape = fields.required_string("type");
    const auto type = element_type(shape, float_type);
    if (!type) {
        fields.fail("\"type\" is \"" + printable(shape) + "\", which glTF does not have");
    }
    return {.component = read_component_type(fields), .rows = type->rows, .columns = type->columns};
}

void check_alignment(const Fields& fields, const ElementType& type, std::uint64_t offset, const BufferView& view) {
    const std::uint64_t unit = type.columns > 1 ? 4 : type.component_size();
    if (offset % unit != 0 || (view.offset + offset) % unit != 0) {
        fields.fail("it starts at byte " + std::to_string(view.offset + offset) +
                    " of its buffer, not at a multiple of " + std::to_string(unit));
    }
}

/// The parts of `sparse` that can be wrong without their values being read.
void check_sparse(const Context& context, const Json& document, const Fields& accessor, const Accessor& base) {
    const Fields sparse = accessor.required_object("sparse");
    const std::uint64_t count = sparse.required_unsigned_integer("count");
    if (count == 0 || count > base.count) {
        sparse.fail("its sparse \"count\" is " + std::to_string(count) + " of " + std::to_string(base.count) +
                    " elements");
    }
    const std::size_t views = root_array(context, document, "bufferViews").size();
    const auto check_part = [&](const char* key, const ElementType& type) {
        const Fields part = sparse.required_object(key);
        const BufferView view = read_view(context, document, part.required_index("bufferView", views));
        const std::uint64_t offset = part.unsigned_integer("byteOffset").value_or(0);
        if (view.stride != 0) {
            part.fail("its sparse " + std::string(key) + " lie in a bufferView with a byteStride");
        }
        check_alignment(part, type, offset, view);
        check_fits(context, part.where(), type, count, offset, type.size(), view.length);
    };
    const ElementType index_type{.component = read_component_type(sparse.required_object("indices"))};
    if (index_type.component != unsigned_byte_type && index_type.component != unsigned_short_type &&
        index_type.component != unsigned_int_type) {
        sparse.fail("its sparse indices are not unsigned integers");
    }
    check_part("indices", index_type);
    check_part("values", base.type);
}

} // namespace

void check_fits(const Context& context, const std::string& where, const ElementType& type, std::uint64_t count,
                std::uint64_t offset, std::uint64_t stride, std::uint64_t length) {
    // In this order nothing can overflow: offset and length are below 2^53, stride and size at most 252.
    const bool fits =
        offset <= length && type.size() <= length - offset && (count - 1) <= (length - offset - type.size()) / stride;
    if (!fits) {
        context.fail(std::to_string(count) + " elements from byte " + std::to_string(offset) +
                     " on do not fit its bufferView of " + std::to_string(length) + " bytes (" + where + ')');
    }
}

BufferView read_view(const Context& context, const Json& document, std::size_t index) {
    const Fields fields = element(context, document, "bufferViews", "bufferView", index);
    const std::size_t buffers = root_array(context, document, "buffers").size();
    BufferView view;
    view.buffer = fields.required_index("buffer", buffers);
    view.offset = fields.unsigned_integer("byteOffset").value_or(0);
    view.length = fields.required_unsigned_integer("byteLength");
    if (view.length == 0) {
        fields.fail("\"byteLength\" is 0");
    }
    const std::uint64_t whole =
        element(context, document, "buffers", "buffer", view.buffer).required_unsigned_integer("byteLength");
    if (view.offset > whole || view.length > whole - view.offset) {
        fields.fail("it does not fit its buffer of " + std::to_string(whole) + " bytes");
    }
    const auto stride = fields.unsigned_integer("byteStride");
    if (!stride) {
        return view;
    }
    if (*stride < 4 || *stride > 252 || *stride % 4 != 0) {
        fields.fail("\"byteStride\" is " + std::to_string(*stride) + ", not a multiple of 4 from 4 to 252");
    }
    if (*stride > view.length) {
        fields.fail("\"byteStride\" is larger than \"byteLength\"");
    }
    if (fields.unsigned_integer("target") == static_cast<std::uint64_t>(ViewTarget::indices)) {
        fields.fail("it is for indices, but has a \"byteStride\"");
    }
    view.stride = *stride;
    return view;
}

Accessor read_accessor(const Context& context, const Json& document, std::size_t index) {
    const Fields fields = element(context, document, "accessors", "accessor", index);
    Accessor accessor;
    accessor.type = read_element_type(fields);
    accessor.count = fields.required_unsigned_integer("count");
    accessor.normalized = fields.boolean("normalized", false);
    accessor.view = fields.index("bufferView", root_array(context, document, "bufferViews").size());
    accessor.offset = fields.unsigned_integer("byteOffset").value_or(0);
    accessor.is_sparse = fields.has("sparse");
    if (accessor.count == 0) {
        fields.fail("\"count\" is 0");
    }
    const bool integer_type = accessor.type.component != float_type && accessor.type.component != unsigned_int_type;
    if (accessor.normalized && !integer_type) {
        fields.fail("it is normalized, but holds neither bytes nor shorts");
    }
    if (accessor.view) {
        const BufferView view = read_view(context, document, *accessor.view);
        if (view.stride != 0 && view.stride < accessor.type.size()) {
            fields.fail("its bufferView's byteStride of " + std::to_string(view.stride) +
                        " is less than the element's size of " + std::to_string(accessor.type.size()));
        }
        check_alignment(fields, accessor.type, accessor.offset, view);
        check_fits(context, fields.where(), accessor.type, accessor.count, accessor.offset,
                   view.stride != 0 ? view.stride : accessor.type.size(), view.length);
    } else if (fields.has("byteOffset")) {
        fields.fail("it has a \"byteOffset\", but no \"bufferView\"");
    }
    if (accessor.is_sparse) {
        check_sparse(context, document, fields, accessor);
    }
    return accessor;
}

void check_layout(const Context& context, const Json& document) {
    const std::size_t buffers = root_array(context, document, "buffers").size();
    for (std::size_t i = 0; i < buffers; ++i) {
        (void)element(context, document, "buffers", "buffer", i);
    }
    const std::size_t views = root_array(context, document, "bufferViews").size();
    for (std::size_t i = 0; i < views; ++i) {
        (void)read_view(context, document, i);
    }
    const std::size_t accessors = root_array(context, document, "accessors").size();
    for (std::size_t i = 0; i < accessors; ++i) {
        (void)read_accessor(context, document, i);
    }
}

std::span<const std::byte> view_bytes(const Context& context, const Document& document, std::size_t index) {
    const BufferView view = read_view(context, document.json, index);
    const auto& buffer = document.buffers.at(view.buffer);
    if (!buffer) {
        element(context, document.json, "bufferViews", "bufferView", index)
            .fail("its buffer " + std::to_string(view.buffer) + " has no data");
    }
    return std::span(*buffer).subspan(view.offset, view.length);
}

} // namespace vkbake::gltf
