// The scene as the tracer sees it: every instance's triangles in one bake frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace vkbake {

/// Bake-frame position = 2^exponent · (linear · v + (translation − centre)), in double, rounded to float once.
/// `centre` is the scene box's centre rounded to a multiple of 2⁻⁶ of the box's power-of-two size, so that a scene
/// keeps its bits when it is scaled by a power of two or moved by a multiple of that grid. All coordinates lie in [−1,
/// 1].
struct BakeFrame {
    glm::dvec3 centre{0.0};
    int exponent = 0;

    [[nodiscard]] double scale() const;                                 ///< 2^exponent: bake-frame units a metre
    [[nodiscard]] glm::dvec3 to_world(const glm::vec3& position) const; ///< metres
};

/// The triangles that one primitive of one instance gives: [first_triangle, first_triangle + triangle_count).
struct SurfacePart {
    std::uint32_t object = 0;    ///< index in Surface::objects
    std::uint32_t primitive = 0; ///< index in the mesh's primitives
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_count = 0;
};

/// One instance: what `--layout object` gives a map of its own.
struct SurfaceObject {
    std::string name;           ///< unique in the scene, usable as a file's name: letters, digits, '-', '_', '.'
    std::uint32_t instance = 0; ///< index in Scene::instances
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_count = 0;
};

/// Structure of arrays. Corner c of triangle t is entry 3·t + c of the arrays of corners. Within a triangle the corners
/// are rotated so that the lexicographically least bake-frame position comes first, and their order is
/// counter-clockwise seen from the front (a mirrored instance's winding is turned), so nothing downstream depends on
/// how the file wrote them.
struct Surface {
    BakeFrame frame;
    std::vector<glm::vec3> positions;    ///< 3 a triangle, bake frame, finite
    std::vector<glm::vec3> normals;      ///< 3 a triangle, shading, unit length (flat where the primitive has none)
    std::vector<std::uint32_t> vertices; ///< 3 a triangle: the corner's vertex in its Primitive
    std::vector<glm::vec3>
        geometric_normals; ///< 1 a triangle, unit, from the bake-frame positions in double; 0 if they have no area
    std::vector<std::uint32_t> parts_of; ///< 1 a triangle: index in `parts`
    /// Every triangle once, ascending by its bake-frame positions (lexicographic over the nine floats), then by
    /// normals: the canonical order, by which every tie between triangles is broken.
    std::vector<std::uint32_t> canonical_order;
    std::vector<SurfacePart> parts;
    std::vector<SurfaceObject> objects;

    [[nodiscard]] std::size_t triangle_count() const { return parts_of.size(); }
};

} // namespace vkbake
