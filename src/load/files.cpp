#include "load/files.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace vkbake::gltf {

std::uint64_t file_size(const Context& context, const std::filesystem::path& path, const std::string& what) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        context.fail(what + " not found", "check the path");
    }
    // A pipe or a device would block, or never end.
    if (!std::filesystem::is_regular_file(status)) {
        context.fail(what + " is not a regular file", "name a .gltf or .glb file and keep what it refers to beside it");
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) {
        context.fail(what + " cannot be read: " + error.message(), "check its permissions");
    }
    return size;
}

std::vector<std::byte> read_file(const Context& context, const std::filesystem::path& path, const std::string& what,
                                 std::uint64_t most) {
    const std::uint64_t size = file_size(context, path, what);
    if (size > largest_document) {
        context.fail(what + " is larger than 4 GiB", "split the scene");
    }
    std::ifstream stream(path, std::ios::binary);
    std::vector<std::byte> bytes(std::min(size, most));
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream || static_cast<std::uint64_t>(stream.gcount()) != bytes.size()) {
        context.fail(what + " cannot be read", "check its permissions");
    }
    return bytes;
}

} // namespace vkbake::gltf
