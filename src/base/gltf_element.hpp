// Elements of glTF's accessors (glTF 2.0 §3.6.2): what they are made of and how many bytes they take.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace vkbake::gltf {

inline constexpr int byte_type = 5120;
inline constexpr int unsigned_byte_type = 5121;
inline constexpr int short_type = 5122;
inline constexpr int unsigned_short_type = 5123;
inline constexpr int unsigned_int_type = 5125;
inline constexpr int float_type = 5126;

/// glTF's numbers for what a buffer view is for.
enum class ViewTarget : std::uint16_t { none = 0, vertices = 34962, indices = 34963 };

struct ElementType {
    int component = float_type;
    std::uint32_t rows = 1;
    std::uint32_t columns = 1; ///< more than 1 for matrices, whose columns start at multiples of 4 bytes

    [[nodiscard]] std::uint64_t component_size() const;
    [[nodiscard]] std::uint64_t column_size() const; ///< from a column's first byte to the next one's
    [[nodiscard]] std::uint64_t size() const;        ///< of one element, and its stride where tightly packed
    /// Where an element starts in a vertex attribute, which must be at a multiple of 4 bytes.
    [[nodiscard]] std::uint64_t vertex_stride() const;
};

[[nodiscard]] bool is_component_type(std::uint64_t number);

/// `shape` is an accessor's "type": "SCALAR", "VEC3" and so on. nullopt where glTF has no such shape.
[[nodiscard]] std::optional<ElementType> element_type(std::string_view shape, int component);

/// Calls visit(Component{}) with the C++ type that a component type stands for, and returns what it returns.
template<typename Visit>
decltype(auto) visit_component(int component, const Visit& visit) {
    switch (component) {
    case byte_type:
        return visit(std::int8_t{});
    case unsigned_byte_type:
        return visit(std::uint8_t{});
    case short_type:
        return visit(std::int16_t{});
    case unsigned_short_type:
        return visit(std::uint16_t{});
    case unsigned_int_type:
        return visit(std::uint32_t{});
    default:
        return visit(float{});
    }
}

} // namespace vkbake::gltf
