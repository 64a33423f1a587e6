// JSON text → a document, whatever the text holds.
#pragma once

#include <string_view>

#include "base/json.hpp"
#include "load/context.hpp"

namespace vkbake::gltf {

/// Throws Error{bad_input} where the text is no JSON (RFC 8259, UTF-8 without a byte order mark), is nested more than
/// 64 deep (functions that walk it recurse), or has an object of more than 4096 keys (finding one is linear, reading
/// them all quadratic).
[[nodiscard]] Json parse_json(const Context& context, std::string_view text);

} // namespace vkbake::gltf
