// The GLB container as it is read (glTF 2.0 §4).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "load/context.hpp"

namespace vkbake::gltf {

/// Both point into the file's bytes.
struct GlbChunks {
    std::string_view json;
    std::optional<std::span<const std::byte>> binary; ///< with up to three bytes of padding
};

[[nodiscard]] bool has_glb_magic(std::span<const std::byte> file);

/// Throws Error{bad_input} where header, lengths, alignment, order or number of the chunks break the specification.
/// Chunks of unknown type and bytes behind the container are skipped with a note.
[[nodiscard]] GlbChunks read_glb(Context& context, std::span<const std::byte> file);

} // namespace vkbake::gltf
