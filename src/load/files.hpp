// Files as bytes, never more of them than the file really has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "load/context.hpp"

namespace vkbake::gltf {

/// No document, and nothing that is made of one, may be larger: a GLB's lengths are 32 bits wide.
inline constexpr std::uint64_t largest_document = 0xFFFFFFFFULL - (1ULL << 20U);

/// The first `most` bytes of a regular file (all of them if it has fewer). `what` names the file's role in messages.
/// Throws Error{bad_input} where it is missing, no regular file, unreadable, or shorter than its own size says.
[[nodiscard]] std::vector<std::byte> read_file(const Context& context, const std::filesystem::path& path,
                                               const std::string& what, std::uint64_t most = largest_document);

/// Its size in bytes; throws as read_file does.
[[nodiscard]] std::uint64_t file_size(const Context& context, const std::filesystem::path& path,
                                      const std::string& what);

} // namespace vkbake::gltf
