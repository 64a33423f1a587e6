#include "glb.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace vkbake::test {
namespace {

template<class T>
T value_at(const Glb& glb, std::size_t accessor, std::size_t index) {
    const Json& a = glb.json.at("accessors").at(accessor);
    const Json& view = glb.json.at("bufferViews").at(a.at("bufferView").get<std::size_t>());
    T value{};
    std::memcpy(&value, glb.binary.data() + view.at("byteOffset").get<std::size_t>() + index * sizeof(T), sizeof(T));
    return value;
}

glm::dvec3 vector_of(const Json& node, const char* key, const glm::dvec3& otherwise) {
    if (!node.contains(key)) {
        return otherwise;
    }
    const Json& v = node.at(key);
    return {v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>()};
}

glm::dmat4 local_matrix(const Json& node) {
    glm::dmat4 matrix(1.0);
    glm::dmat3 rotation(1.0);
    if (node.contains("rotation")) {
        const Json& r = node.at("rotation");
        const double x = r.at(0).get<double>();
        const double y = r.at(1).get<double>();
        const double z = r.at(2).get<double>();
        const double w = r.at(3).get<double>();
        rotation = {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
                    {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
                    {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
    }
    const glm::dvec3 scale = vector_of(node, "scale", glm::dvec3(1.0));
    for (int c = 0; c < 3; ++c) {
        matrix[c] = glm::dvec4(rotation[c] * scale[c], 0.0);
    }
    matrix[3] = glm::dvec4(vector_of(node, "translation", glm::dvec3(0.0)), 1.0);
    return matrix;
}

void add_node(const Glb& glb, std::size_t index, const glm::dmat4& parent, std::vector<Face>& faces) {
    const Json& node = glb.json.at("nodes").at(index);
    const glm::dmat4 matrix = parent * local_matrix(node);
    if (node.contains("mesh")) {
        const glm::dmat3 linear(matrix);
        const glm::dmat3 for_normals = glm::transpose(glm::inverse(linear));
        for (Face face : faces_of_mesh(glb, node.at("mesh").get<std::size_t>())) {
            for (Corner& corner : face) {
                corner.position = glm::vec3(matrix * glm::dvec4(corner.position, 1.0));
                corner.normal = glm::vec3(glm::normalize(for_normals * glm::dvec3(corner.normal)));
            }
            if (glm::determinant(linear) < 0.0) {
                std::swap(face[1], face[2]);
            }
            faces.push_back(face);
        }
    }
    if (node.contains("children")) {
        for (const Json& child : node.at("children")) {
            add_node(glb, child.get<std::size_t>(), matrix, faces);
        }
    }
}

} // namespace

std::string read_bytes(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        throw std::runtime_error(path + ": cannot be opened");
    }
    return {std::istreambuf_iterator<char>(stream), {}};
}

Glb parse_glb(const std::string& bytes) {
    std::uint32_t json_length = 0;
    std::memcpy(&json_length, bytes.data() + 12, sizeof json_length);
    return {Json::parse(bytes.substr(20, json_length)), bytes.substr(20 + json_length + 8)};
}

std::vector<Face> faces_of_mesh(const Glb& glb, std::size_t mesh) {
    std::vector<Face> faces;
    for (const Json& primitive : glb.json.at("meshes").at(mesh).at("primitives")) {
        const Json& attributes = primitive.at("attributes");
        const auto indices = primitive.at("indices").get<std::size_t>();
        const auto count = glb.json.at("accessors").at(indices).at("count").get<std::size_t>();
        for (std::size_t first = 0; first < count; first += 3) {
            Face face;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t vertex = value_at<std::uint16_t>(glb, indices, first + k);
                face[k].position = value_at<glm::vec3>(glb, attributes.at("POSITION").get<std::size_t>(), vertex);
                face[k].normal = value_at<glm::vec3>(glb, attributes.at("NORMAL").get<std::size_t>(), vertex);
                if (attributes.contains("TEXCOORD_1")) {
                    face[k].light_map_uv =
                        value_at<glm::vec2>(glb, attributes.at("TEXCOORD_1").get<std::size_t>(), vertex);
                }
            }
            faces.push_back(face);
        }
    }
    return faces;
}

std::vector<Face> faces_of_scene(const Glb& glb) {
    std::vector<Face> faces;
    for (const Json& root : glb.json.at("scenes").at(0).at("nodes")) {
        add_node(glb, root.get<std::size_t>(), glm::dmat4(1.0), faces);
    }
    return faces;
}

} // namespace vkbake::test
