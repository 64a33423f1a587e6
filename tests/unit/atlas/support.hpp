// Scenes for atlas tests, and what must hold for every atlas.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "vkbake/atlas.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/surface.hpp"

namespace vkbake::test {

/// A scene of one mesh with one primitive, to be filled, and one instance of it.
Scene empty_scene();

/// UVs are made, on pages of that size.
Settings made_by(ChartMaker charts, int size);

/// Adds a quad of two triangles, counter-clockwise from the front, with vertices of its own.
void add_quad(Primitive& primitive, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);

void add_triangle(Primitive& primitive, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// An axis-aligned box seen from outside.
void add_box(Primitive& primitive, const glm::vec3& low, const glm::vec3& high);

/// Gives each triangle of a primitive without shared vertices its own UVs, three a triangle.
void set_light_map_uvs(Primitive& primitive, const std::vector<glm::vec2>& uvs);

/// Another instance of mesh 0.
void add_instance(Scene& scene, const glm::dvec3& translation);

/// Uneven ground: n × n quads, heights from a hash.
void add_rough_ground(Primitive& primitive, int n, float height);

/// Turns triangles about as a hash says.
void shuffle_triangles(Primitive& primitive, std::uint32_t seed);

/// Twice the area of triangle t in texels, negative where it turns clockwise as seen in the image (v down: as seen by a
/// viewer of the image it then is counter-clockwise).
double doubled_texel_area(const Atlas& atlas, std::size_t triangle);

/// Twice the triangle's area in metres, along its normal's greatest axis (what planar projection leaves of it).
double doubled_projected_area(const Surface& surface, std::size_t triangle);

/// UVs in [0,1], pages and charts numbered without holes, no two triangles of a page overlap (every pair is tried).
void expect_sound(const Surface& surface, const Atlas& atlas);

/// Closed texel squares that different charts meet are more than `gutter` apart, along x or along y. Found by testing
/// every texel of each triangle's box.
void expect_gutter(const Atlas& atlas, int gutter);

/// Each triangle's UV area is its projected area at the atlas's density, but for rounding, and is not mirrored.
void expect_one_density(const Surface& surface, const Atlas& atlas);

} // namespace vkbake::test
