#include "base/gltf_element.hpp"

#include <array>

namespace vkbake::gltf {

std::uint64_t ElementType::component_size() const {
    return visit_component(component, [](auto value) { return sizeof(value); });
}

std::uint64_t ElementType::column_size() const {
    const std::uint64_t column = rows * component_size();
    return columns == 1 ? column : (column + 3) / 4 * 4;
}

std::uint64_t ElementType::size() const { return columns * column_size(); }

std::uint64_t ElementType::vertex_stride() const { return (size() + 3) / 4 * 4; }

bool is_component_type(std::uint64_t number) {
    constexpr std::uint64_t double_type = 5124; // of an older glTF
    return number >= byte_type && number <= float_type && number != double_type;
}

std::optional<ElementType> element_type(std::string_view shape, int component) {
    struct Shape {
        std::string_view name;
        std::uint32_t rows;
        std::uint32_t columns;
    };
    static constexpr std::array<Shape, 7> shapes{{{"SCALAR", 1, 1},
                                                  {"VEC2", 2, 1},
                                                  {"VEC3", 3, 1},
                                                  {"VEC4", 4, 1},
                                                  {"MAT2", 2, 2},
                                                  {"MAT3", 3, 3},
                                                  {"MAT4", 4, 4}}};
    for (const Shape& candidate : shapes) {
        if (candidate.name == shape) {
            return ElementType{.component = component, .rows = candidate.rows, .columns = candidate.columns};
        }
    }
    return std::nullopt;
}

} // namespace vkbake::gltf
