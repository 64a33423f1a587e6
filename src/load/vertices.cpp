#include "load/vertices.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace vkbake::gltf {

namespace {

/// Where the elements of an accessor start. Files and the machines that are supported are both little-endian.
struct Elements {
    const std::byte* first = nullptr; ///< null: zeros
    std::size_t stride = 0;
    std::size_t count = 0;
};

Elements find_elements(const Model& model, const tinygltf::Accessor& accessor, std::size_t element_size) {
    if (accessor.bufferView < 0) {
        return {.count = accessor.count};
    }
    const auto& view = model.data.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
    return {.first = model.binary.data() + view.byteOffset + accessor.byteOffset,
            .stride = view.byteStride != 0 ? view.byteStride : element_size,
            .count = accessor.count};
}

template<typename Component>
float to_float(Component value, bool normalized) {
    if constexpr (std::is_floating_point_v<Component>) {
        return value;
    } else {
        const auto number = static_cast<float>(value);
        const auto largest = static_cast<float>(std::numeric_limits<Component>::max());
        return normalized ? std::max(number / largest, -1.0F) : number;
    }
}

template<typename Vector, typename Component>
std::vector<Vector> read_as(const Model& model, const tinygltf::Accessor& accessor) {
    constexpr auto length = static_cast<std::size_t>(Vector::length());
    const Elements elements = find_elements(model, accessor, length * sizeof(Component));
    std::vector<Vector> result(elements.count, Vector(0.0F));
    if (elements.first == nullptr) {
        return result;
    }
    for (std::size_t i = 0; i < elements.count; ++i) {
        Component components[length];
        std::memcpy(components, elements.first + i * elements.stride, sizeof(components));
        for (std::size_t c = 0; c < length; ++c) {
            result[i][static_cast<glm::length_t>(c)] = to_float(components[c], accessor.normalized);
        }
    }
    return result;
}

template<typename Vector>
std::vector<Vector> read_vectors(const Model& model, std::size_t index) {
    const tinygltf::Accessor& accessor = model.data.accessors.at(index);
    switch (accessor.componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return read_as<Vector, std::int8_t>(model, accessor);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return read_as<Vector, std::uint8_t>(model, accessor);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return read_as<Vector, std::int16_t>(model, accessor);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return read_as<Vector, std::uint16_t>(model, accessor);
    default:
        return read_as<Vector, float>(model, accessor);
    }
}

template<typename Component>
std::vector<std::uint32_t> read_indices_as(const Model& model, const tinygltf::Accessor& accessor) {
    const Elements elements = find_elements(model, accessor, sizeof(Component));
    std::vector<std::uint32_t> result(elements.count, 0);
    for (std::size_t i = 0; elements.first != nullptr && i < elements.count; ++i) {
        Component value = 0;
        std::memcpy(&value, elements.first + i * elements.stride, sizeof(value));
        result[i] = value;
    }
    return result;
}

} // namespace

std::vector<glm::vec2> read_vec2(const Model& model, std::size_t index) {
    return read_vectors<glm::vec2>(model, index);
}

std::vector<glm::vec3> read_vec3(const Model& model, std::size_t index) {
    return read_vectors<glm::vec3>(model, index);
}

std::vector<glm::vec4> read_vec4(const Model& model, std::size_t index) {
    return read_vectors<glm::vec4>(model, index);
}

std::vector<std::uint32_t> read_indices(const Model& model, std::size_t index) {
    const tinygltf::Accessor& accessor = model.data.accessors.at(index);
    switch (accessor.componentType) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return read_indices_as<std::uint8_t>(model, accessor);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return read_indices_as<std::uint16_t>(model, accessor);
    default:
        return read_indices_as<std::uint32_t>(model, accessor);
    }
}

} // namespace vkbake::gltf
