// Small glTF documents, made in memory and written to a folder that goes away.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "base/json.hpp"
#include "vkbake/error.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake::test {

class TemporaryFolder {
public:
    TemporaryFolder() {
        const auto* const info = testing::UnitTest::GetInstance()->current_test_info();
        std::string pattern = (std::filesystem::temp_directory_path() / "vkbake-load-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) {
            throw std::runtime_error(std::string("no temporary folder for ") + info->name());
        }
        m_path = pattern;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

    // NOLINTNEXTLINE(modernize-use-nodiscard): called for what it does
    std::filesystem::path write(const std::string& name, std::string_view text) const {
        std::filesystem::create_directories((m_path / name).parent_path());
        std::ofstream stream(m_path / name, std::ios::binary);
        stream.write(text.data(), static_cast<std::streamsize>(text.size()));
        return m_path / name;
    }

private:
    std::filesystem::path m_path;
};

inline std::string word(std::uint32_t value) {
    std::string bytes(4, '\0');
    for (unsigned i = 0; i < 4; ++i) {
        bytes[i] = static_cast<char>((value >> (8 * i)) & 0xFFU);
    }
    return bytes;
}

inline std::string chunk(std::string_view type, std::string_view data) {
    return word(static_cast<std::uint32_t>(data.size())) + std::string(type) + std::string(data);
}

/// Header and chunks; the lengths are right.
inline std::string glb_of(const std::string& chunks) {
    return "glTF" + word(2) + word(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

template<typename Value>
std::string raw(const std::vector<Value>& values) {
    std::string bytes(values.size() * sizeof(Value), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

/// One binary chunk and the JSON that a test fills in further.
class DocumentBuilder {
public:
    DocumentBuilder() { json["asset"]["version"] = "2.0"; }

    /// Returns the view's index.
    std::size_t add_view(std::string_view data, std::size_t stride = 0) {
        binary.resize((binary.size() + 3) / 4 * 4, '\0');
        Json view = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", data.size()}};
        if (stride != 0) {
            view["byteStride"] = stride;
        }
        binary += data;
        json["bufferViews"].push_back(view);
        return json["bufferViews"].size() - 1;
    }

    /// Returns the accessor's index. `values` are packed without gaps.
    template<typename Value>
    std::size_t add(const std::vector<Value>& values, const std::string& type, bool normalized = false) {
        const std::size_t parts = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.at(3) - '0');
        Json accessor = {{"bufferView", add_view(raw(values))},
                         {"componentType", component_type<Value>()},
                         {"count", values.size() / parts},
                         {"type", type}};
        if (normalized) {
            accessor["normalized"] = true;
        }
        json["accessors"].push_back(accessor);
        return json["accessors"].size() - 1;
    }

    /// A mesh of one primitive, a node that shows it, and a scene of that node (all are added to).
    Json& add_mesh(const Json& attributes, int mode = 4) {
        Json primitive = {{"attributes", attributes}, {"mode", mode}};
        json["meshes"].push_back({{"primitives", Json::array({primitive})}});
        const std::size_t mesh = json["meshes"].size() - 1;
        json["nodes"].push_back({{"mesh", mesh}});
        json["scene"] = 0;
        json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
        return json["meshes"][mesh]["primitives"][0];
    }

    [[nodiscard]] std::string glb() const {
        Json document = json;
        std::string padded = binary;
        if (!binary.empty() && !document.contains("buffers")) {
            document["buffers"] = Json::array({Json{{"byteLength", binary.size()}}});
        }
        padded.resize((padded.size() + 3) / 4 * 4, '\0');
        std::string text = document.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        return glb_of(chunk("JSON", text) + (padded.empty() ? "" : chunk(std::string_view("BIN\0", 4), padded)));
    }

    [[nodiscard]] Scene load() const {
        const TemporaryFolder folder;
        return load_scene(folder.write("scene.glb", glb()));
    }

    Json json = Json::object();
    std::string binary;

private:
    template<typename Value>
    static int component_type() {
        if constexpr (std::is_same_v<Value, float>) {
            return 5126;
        } else if constexpr (sizeof(Value) == 1) {
            return std::is_signed_v<Value> ? 5120 : 5121;
        } else if constexpr (sizeof(Value) == 2) {
            return std::is_signed_v<Value> ? 5122 : 5123;
        } else {
            return 5125;
        }
    }
};

/// The message of the Error{bad_input} that `action` throws; an empty string where it throws none.
template<typename Action>
std::string refusal(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        std::string message = error.what();
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_NE(message.find("; "), std::string::npos) << message;
        return message;
    }
    return {};
}

/// Expects that loading it is refused with a message that holds `part`.
inline void expect_refused(const DocumentBuilder& builder, const std::string& part) {
    const std::string message = refusal([&] { (void)builder.load(); });
    EXPECT_NE(message.find(part), std::string::npos) << "message: " << message << "\nexpected in it: " << part;
}

inline bool has_note(const Scene& scene, const std::string& part) {
    for (const std::string& note : scene.notes) {
        if (note.find(part) != std::string::npos) {
            return true;
        }
    }
    return false;
}

/// The corners of one triangle in the plane z = 0, counter-clockwise seen from +z.
inline const std::vector<float>& triangle_corners() {
    static const std::vector<float> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    return corners;
}

/// A document of that triangle.
inline DocumentBuilder triangle_document() {
    DocumentBuilder builder;
    builder.add_mesh({{"POSITION", builder.add(triangle_corners(), "VEC3")}});
    return builder;
}

} // namespace vkbake::test
