// A glTF document as its files hold it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/json.hpp"
#include "load/context.hpp"

namespace vkbake::gltf {

// NOLINTNEXTLINE(bugprone-exception-escape): what the JSON library calls in its noexcept moves throws nothing
struct Document {
    Json json;
    /// One for each of json["buffers"], of its byteLength; nullopt: nothing holds its bytes (a fallback of
    /// EXT_meshopt_compression, or a placeholder), so no plain view may refer to it.
    std::vector<std::optional<std::vector<std::byte>>> buffers;
    std::filesystem::path directory; ///< what relative references are relative to
    std::uint64_t size = 0;          ///< bytes held so far
};

/// Reads a .gltf or .glb and all its buffers; images stay where they are. Checks the container, asset.version, and that
/// every required extension is one that this program supports. Throws Error{bad_input}.
[[nodiscard]] Document read_document(Context& context, const std::filesystem::path& file);

/// Counts `bytes` towards the document's size, before they are allocated. Throws where it would grow past what a GLB
/// holds.
void reserve_bytes(const Context& context, Document& document, std::uint64_t bytes);

/// Adds a buffer that holds `bytes` (not empty), and a view of all of it; returns the view's index.
/// The bytes must have been reserved.
std::uint32_t append_view(Document& document, std::vector<std::byte> bytes);

} // namespace vkbake::gltf
