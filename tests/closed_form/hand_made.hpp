// Surfaces and geometry images made by hand, in the bake frame: no atlas, no device, no interpolation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "vkbake/geometry_image.hpp"
#include "vkbake/sky.hpp"
#include "vkbake/surface.hpp"

namespace vkbake::test {

/// Radiance 1 from everywhere.
inline Sky white_sky() { return {.source = ConstantSky{}, .name = "white"}; }

/// One texel of a hand-made geometry image.
struct SamplePoint {
    glm::vec3 position{0.0F};
    glm::vec3 shading_normal{0.0F};
    glm::vec3 geometric_normal{0.0F};
    std::uint32_t triangle = 0;
};

/// Collects triangles; fills what the tracer reads of a Surface.
class SurfaceMaker {
public:
    /// Corners counter-clockwise seen from the front. Returns the triangle's number.
    std::uint32_t add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        const glm::dvec3 normal = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
        const double length = glm::length(normal);
        const glm::vec3 front = length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0F);
        for (const glm::vec3& corner : {a, b, c}) {
            m_surface.positions.push_back(corner);
            m_surface.normals.push_back(front);
        }
        m_surface.geometric_normals.push_back(front);
        m_surface.parts_of.push_back(0);
        return static_cast<std::uint32_t>(m_surface.parts_of.size() - 1);
    }
    /// Two triangles, a b c and a c d.
    std::uint32_t add_quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
        const std::uint32_t first = add(a, b, c);
        add(a, c, d);
        return first;
    }
    /// The axis-aligned box [low, high]; faces look inwards or outwards. Returns the first of its 12 triangles.
    std::uint32_t add_box(const glm::vec3& low, const glm::vec3& high, bool inwards) {
        const auto corner = [&](int index) {
            return glm::vec3((index & 1) != 0 ? high.x : low.x, (index & 2) != 0 ? high.y : low.y,
                             (index & 4) != 0 ? high.z : low.z);
        };
        constexpr std::array<std::array<int, 4>, 6> outward_faces{
            {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}}};
        const auto first = static_cast<std::uint32_t>(m_surface.parts_of.size());
        for (const auto& face : outward_faces) {
            if (inwards) {
                add_quad(corner(face[3]), corner(face[2]), corner(face[1]), corner(face[0]));
            } else {
                add_quad(corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3]));
            }
        }
        return first;
    }
    [[nodiscard]] Surface finish(int exponent = 0) {
        m_surface.frame.exponent = exponent;
        m_surface.canonical_order.resize(m_surface.triangle_count());
        std::iota(m_surface.canonical_order.begin(), m_surface.canonical_order.end(), 0U);
        const auto key = [&](std::uint32_t triangle) {
            std::array<float, 9> values{};
            for (std::size_t corner = 0; corner < 3; ++corner) {
                for (int axis = 0; axis < 3; ++axis) {
                    values[3 * corner + static_cast<std::size_t>(axis)] =
                        m_surface.positions[3 * std::size_t{triangle} + corner][axis];
                }
            }
            return values;
        };
        std::stable_sort(m_surface.canonical_order.begin(), m_surface.canonical_order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        return m_surface;
    }

private:
    Surface m_surface;
};

/// The point with weights b0, b1, b2 of a triangle, seen from its front, shaded flat.
inline SamplePoint point_on(const Surface& surface, std::uint32_t triangle, const glm::dvec3& weights) {
    const std::size_t corner = std::size_t{3} * triangle;
    const glm::dvec3 position = weights.x * glm::dvec3(surface.positions[corner]) +
                                weights.y * glm::dvec3(surface.positions[corner + 1]) +
                                weights.z * glm::dvec3(surface.positions[corner + 2]);
    const glm::vec3 normal = surface.geometric_normals[triangle];
    return {glm::vec3(position), normal, normal, triangle};
}

/// A map of `width` columns that holds the points row after row; what is left of the last row is empty.
inline GeometryImage geometry_image(const std::vector<SamplePoint>& points, int width) {
    GeometryImage image;
    image.width = width;
    image.height = (static_cast<int>(points.size()) + width - 1) / width;
    const auto count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.triangle.assign(count, GeometryImage::empty);
    image.position = ZeroedArray<glm::vec3>(count);
    image.shading_normal = ZeroedArray<glm::vec3>(count);
    image.geometric_normal = ZeroedArray<glm::vec3>(count);
    for (std::size_t i = 0; i < points.size(); ++i) {
        image.triangle[i] = points[i].triangle;
        image.position[i] = points[i].position;
        image.shading_normal[i] = points[i].shading_normal;
        image.geometric_normal[i] = points[i].geometric_normal;
    }
    return image;
}

} // namespace vkbake::test
