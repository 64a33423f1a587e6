// A reader of binary glTF for tests: independent of what wrote it and of the project's loader.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/json.hpp"

namespace vkbake::test {

inline std::vector<std::uint8_t> read_file(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// NOLINTNEXTLINE(bugprone-exception-escape): what the JSON library calls in its noexcept moves throws nothing
struct Glb {
    Json json;
    std::vector<std::uint8_t> binary;

    [[nodiscard]] std::vector<std::uint8_t> view(std::size_t index) const {
        const Json& entry = json.at("bufferViews").at(index);
        const auto first = binary.begin() + entry.at("byteOffset").get<std::ptrdiff_t>();
        return {first, first + entry.at("byteLength").get<std::ptrdiff_t>()};
    }

    /// The bytes of each element. Scalars and vectors only.
    [[nodiscard]] std::vector<std::vector<std::uint8_t>> elements(std::size_t index) const {
        const Json& accessor = json.at("accessors").at(index);
        const int type = accessor.at("componentType").get<int>();
        const std::string shape = accessor.at("type").get<std::string>();
        const std::size_t component = type <= 5121 ? 1 : type <= 5123 ? 2 : 4;
        const std::size_t size = component * (shape == "SCALAR" ? 1U : static_cast<std::size_t>(shape.back() - '0'));
        const std::size_t view_index = accessor.at("bufferView").get<std::size_t>();
        const std::size_t stride = json["bufferViews"][view_index].value("byteStride", size);
        const std::vector<std::uint8_t> bytes = view(view_index);
        std::vector<std::vector<std::uint8_t>> result;
        for (std::size_t i = 0; i < accessor.at("count").get<std::size_t>(); ++i) {
            const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(i * stride);
            result.emplace_back(first, first + static_cast<std::ptrdiff_t>(size));
        }
        return result;
    }

    template<typename Value>
    [[nodiscard]] std::vector<std::vector<Value>> values(std::size_t index) const {
        std::vector<std::vector<Value>> result;
        for (const std::vector<std::uint8_t>& element : elements(index)) {
            result.emplace_back(element.size() / sizeof(Value));
            std::memcpy(result.back().data(), element.data(), element.size());
        }
        return result;
    }

    [[nodiscard]] std::vector<std::uint32_t> indices(std::size_t index) const {
        std::vector<std::uint32_t> result;
        for (const std::vector<std::uint8_t>& element : elements(index)) {
            std::uint32_t value = 0;
            std::memcpy(&value, element.data(), element.size()); // little-endian machines only
            result.push_back(value);
        }
        return result;
    }
};

inline Glb parse_glb(const std::vector<std::uint8_t>& file) {
    const auto word = [&](std::size_t place) {
        std::uint32_t value = 0;
        std::memcpy(&value, file.data() + place, 4);
        return value;
    };
    if (file.size() < 20 || word(0) != 0x46546C67 || word(4) != 2 || word(8) != file.size() || word(16) != 0x4E4F534A) {
        throw std::runtime_error("no GLB");
    }
    Glb glb;
    const std::size_t json_size = word(12);
    glb.json = Json::parse(file.begin() + 20, file.begin() + 20 + static_cast<std::ptrdiff_t>(json_size));
    if (file.size() > 20 + json_size) {
        if (word(24 + json_size) != 0x004E4942 || word(20 + json_size) % 4 != 0) {
            throw std::runtime_error("no binary chunk");
        }
        glb.binary.assign(file.begin() + 28 + static_cast<std::ptrdiff_t>(json_size), file.end());
    }
    return glb;
}

} // namespace vkbake::test
