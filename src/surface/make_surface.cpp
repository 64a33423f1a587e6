#include "surface/make_surface.hpp"

#include "base/normal_transform.hpp"
#include "base/parallel.hpp"
#include "surface/bake_frame.hpp"
#include "surface/canonical.hpp"
#include "surface/object_names.hpp"
#include "vkbake/error.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace vkbake {
namespace {

constexpr std::size_t triangles_a_task = 4096;

/// Differences of floats of one frame, and products of two such differences, are exact in double (but for spreads
/// beyond 2²⁹), so this is zero if and only if the triangle has no area.
glm::dvec3 doubled_area_vector(const std::array<glm::vec3, 3>& positions) {
    const glm::dvec3 origin(positions[0]);
    return glm::cross(glm::dvec3(positions[1]) - origin, glm::dvec3(positions[2]) - origin);
}

/// What turns one instance's vertices into the bake frame's.
class InstanceTransform {
public:
    InstanceTransform(const Instance& instance, const BakeFrame& frame)
        : m_linear(instance.linear), m_normal(instance.linear), m_translation(instance.translation - frame.centre),
          m_scale(frame.scale()) {}

    [[nodiscard]] bool mirrored() const { return m_normal.mirrored; }
    [[nodiscard]] glm::vec3 position(const glm::vec3& vertex) const {
        return glm::vec3(m_scale * (transform_vertex(m_linear, vertex) + m_translation)) + glm::vec3(0.0F);
    }
    [[nodiscard]] glm::vec3 normal(const glm::vec3& vertex_normal) const {
        return unit_or_zero(m_normal.matrix * glm::dvec3(vertex_normal));
    }

private:
    glm::dmat3 m_linear;
    NormalTransform m_normal;
    glm::dvec3 m_translation;
    double m_scale;
};

void fill_triangle(Surface& surface, const Primitive& primitive, const InstanceTransform& transform,
                   std::size_t triangle, std::size_t primitive_triangle) {
    std::array<std::uint32_t, 3> vertices{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        vertices[corner] = primitive.indices[3 * primitive_triangle + corner];
    }
    if (transform.mirrored()) {
        std::swap(vertices[1], vertices[2]);
    }
    std::array<glm::vec3, 3> positions{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        positions[corner] = transform.position(primitive.positions[vertices[corner]]);
    }
    const glm::vec3 geometric = unit_or_zero(doubled_area_vector(positions));
    std::array<glm::vec3, 3> normals{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        normals[corner] =
            primitive.normals.empty() ? glm::vec3(0.0F) : transform.normal(primitive.normals[vertices[corner]]);
        if (normals[corner] == glm::vec3(0.0F)) {
            normals[corner] = geometric;
        }
    }
    const auto first = static_cast<std::size_t>(first_corner(positions, normals));
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::size_t from = (first + corner) % 3;
        surface.positions[3 * triangle + corner] = positions[from];
        surface.normals[3 * triangle + corner] = normals[from];
        surface.vertices[3 * triangle + corner] = vertices[from];
    }
    // From the rotated corners, so that its bits do not depend on how the file wrote the triangle.
    surface.geometric_normals[triangle] = unit_or_zero(doubled_area_vector(
        {surface.positions[3 * triangle], surface.positions[3 * triangle + 1], surface.positions[3 * triangle + 2]}));
}

void check_primitive(const Scene& scene, const Mesh& mesh, const Primitive& primitive) {
    const auto fail = [&](const std::string& what) {
        throw Error(ErrorKind::bad_input, scene.name + ": mesh \"" + mesh.name + "\": " + what + "; repair the scene");
    };
    if (primitive.indices.size() % 3 != 0) {
        fail("a primitive has " + std::to_string(primitive.indices.size()) + " indices, not three a triangle");
    }
    for (const std::uint32_t index : primitive.indices) {
        if (index >= primitive.positions.size()) {
            fail("an index (" + std::to_string(index) + ") lies beyond the " +
                 std::to_string(primitive.positions.size()) + " vertices");
        }
    }
    const auto check_count = [&](std::size_t count, const std::string& attribute) {
        if (count != 0 && count != primitive.positions.size()) {
            fail(attribute + " has " + std::to_string(count) + " values for " +
                 std::to_string(primitive.positions.size()) + " vertices");
        }
    };
    check_count(primitive.normals.size(), "NORMAL");
    for (std::size_t set = 0; set < primitive.tex_coords.size(); ++set) {
        check_count(primitive.tex_coords[set].size(), "TEXCOORD_" + std::to_string(set));
    }
}

void check_scene(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes) {
        for (const Primitive& primitive : mesh.primitives) {
            check_primitive(scene, mesh, primitive);
        }
    }
    for (const Instance& instance : scene.instances) {
        if (instance.mesh >= scene.meshes.size()) {
            throw Error(ErrorKind::bad_input, scene.name + ": node \"" + instance.name + "\" refers to mesh " +
                                                  std::to_string(instance.mesh) + " of " +
                                                  std::to_string(scene.meshes.size()) + "; repair the scene");
        }
    }
}

/// Objects and parts with their triangle ranges. Returns the count of triangles.
std::size_t lay_out_objects(const Scene& scene, Surface& surface) {
    std::size_t total = 0;
    std::vector<std::string> names;
    for (std::size_t index = 0; index < scene.instances.size(); ++index) {
        const Mesh& mesh = scene.meshes[scene.instances[index].mesh];
        const std::size_t before = total;
        for (std::size_t primitive = 0; primitive < mesh.primitives.size(); ++primitive) {
            const std::size_t count = mesh.primitives[primitive].indices.size() / 3;
            if (count > 0) {
                surface.parts.push_back({static_cast<std::uint32_t>(surface.objects.size()),
                                         static_cast<std::uint32_t>(primitive), static_cast<std::uint32_t>(total),
                                         static_cast<std::uint32_t>(count)});
            }
            total += count;
            if (total >= std::numeric_limits<std::uint32_t>::max() / 3) {
                throw Error(ErrorKind::bad_input, scene.name + ": more than 1.4 billion triangles; split the scene");
            }
        }
        if (total > before) {
            const std::string& own = scene.instances[index].name;
            names.push_back(own.empty() ? mesh.name : own);
            surface.objects.push_back({{},
                                       static_cast<std::uint32_t>(index),
                                       static_cast<std::uint32_t>(before),
                                       static_cast<std::uint32_t>(total - before)});
        }
    }
    const std::vector<std::string> unique = unique_file_names(names);
    for (std::size_t object = 0; object < unique.size(); ++object) {
        surface.objects[object].name = unique[object];
    }
    return total;
}

} // namespace

Surface make_surface(const Scene& scene) {
    check_scene(scene);
    Surface surface;
    surface.frame = make_bake_frame(scene);
    const std::size_t count = lay_out_objects(scene, surface);
    surface.positions.resize(3 * count);
    surface.normals.resize(3 * count);
    surface.vertices.resize(3 * count);
    surface.geometric_normals.resize(count);
    surface.parts_of.resize(count);
    for (std::size_t index = 0; index < surface.parts.size(); ++index) {
        const SurfacePart part = surface.parts[index];
        const Instance& instance = scene.instances[surface.objects[part.object].instance];
        const Primitive& primitive = scene.meshes[instance.mesh].primitives[part.primitive];
        const InstanceTransform transform(instance, surface.frame);
        parallel_ranges(part.triangle_count, triangles_a_task, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t triangle = begin; triangle < end; ++triangle) {
                fill_triangle(surface, primitive, transform, part.first_triangle + triangle, triangle);
                surface.parts_of[part.first_triangle + triangle] = static_cast<std::uint32_t>(index);
            }
        });
    }
    surface.canonical_order = canonical_order(surface.positions, surface.normals);
    return surface;
}

} // namespace vkbake
