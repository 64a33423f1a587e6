// Buffer views and accessors: what the document says of them, and whether it can be.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/gltf_element.hpp"
#include "load/context.hpp"
#include "load/document.hpp"

namespace vkbake::gltf {

struct BufferView {
    std::uint32_t buffer = 0;
    std::uint64_t offset = 0; ///< bytes
    std::uint64_t length = 0; ///< bytes, not 0
    std::uint64_t stride = 0; ///< bytes; 0: tightly packed
};

struct Accessor {
    std::optional<std::uint32_t> view; ///< none: zeros (or sparse values over zeros)
    std::uint64_t offset = 0;          ///< bytes in the view
    ElementType type;
    std::uint64_t count = 0; ///< not 0
    bool normalized = false;
    bool is_sparse = false;
};

/// They read entry `index` (it must exist) and throw Error{bad_input} where a value is missing, out of range or breaks
/// a rule of the specification: sizes, strides, alignment, bounds (a view in its buffer's byteLength, an accessor in
/// its view).
[[nodiscard]] BufferView read_view(const Context& context, const Json& document, std::size_t index);
[[nodiscard]] Accessor read_accessor(const Context& context, const Json& document, std::size_t index);

/// Reads them all.
void check_layout(const Context& context, const Json& document);

/// The bytes of a view. Throws where its buffer has no data.
[[nodiscard]] std::span<const std::byte> view_bytes(const Context& context, const Document& document,
                                                    std::size_t index);

/// Throws unless `count` elements of `type`, `stride` bytes apart from `offset` on, fit a view of `length` bytes.
/// `where` names the accessor in the message.
void check_fits(const Context& context, const std::string& where, const ElementType& type, std::uint64_t count,
                std::uint64_t offset, std::uint64_t stride, std::uint64_t length);

} // namespace vkbake::gltf
