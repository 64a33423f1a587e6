// URIs as glTF uses them: data URIs and relative paths (RFC 3986, RFC 2397).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vkbake::gltf {

struct DataUri {
    std::string media_type; ///< "image/png"; empty where the URI names none
    std::vector<std::byte> bytes;
};

[[nodiscard]] bool is_data_uri(std::string_view uri);

/// nullopt where it is malformed: no comma, a parameter that is none, bad base64, a bad percent escape.
[[nodiscard]] std::optional<DataUri> decode_data_uri(std::string_view uri);

/// The path that a relative reference names, percent escapes decoded. nullopt for anything else: a scheme, an absolute
/// path, a network path, a query or fragment, a backslash, a bad escape, a NUL, nothing at all.
[[nodiscard]] std::optional<std::string> relative_path(std::string_view uri);

/// Whether a relative path climbs out of the folder that it begins in. Links are not followed.
[[nodiscard]] bool leaves_folder(const std::string& path);

} // namespace vkbake::gltf
