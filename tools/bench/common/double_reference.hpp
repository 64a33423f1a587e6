// Occlusion in double precision by plain geometry, sharing no code with what it judges.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "bvh/accelerator.hpp"
#include "vkbake/surface.hpp"

namespace vkbake::bench {

/// How surely a ray meets a triangle: the length by which something would have to move for the answer to change, in
/// bake-frame units; negative where it misses. The least of: how far inside the outline the ray passes, how far behind
/// the origin the plane lies, how far before the ray's end.
struct Slack {
    double length = 0.0;
    std::uint32_t triangle = 0;
};

/// The surface must outlive it.
class DoubleReference {
public:
    explicit DoubleReference(const Surface& surface);

    /// By every triangle.
    [[nodiscard]] bool occluded_by_any(const Ray& ray) const;
    /// The same by a tree of padded boxes, for many rays.
    [[nodiscard]] bool occluded(const Ray& ray) const;
    /// The greatest slack of all triangles: of the surest hit, or of the nearest miss.
    [[nodiscard]] Slack surest(const Ray& ray) const;

private:
    struct Node {
        glm::dvec3 low{0.0};
        glm::dvec3 high{0.0};
        std::uint32_t begin = 0; ///< of m_order
        std::uint32_t end = 0;
        std::uint32_t right = 0; ///< the left child follows its parent; 0: a leaf
    };
    std::uint32_t split(std::uint32_t begin, std::uint32_t end);
    [[nodiscard]] bool meets(std::uint32_t triangle, const Ray& ray) const;
    [[nodiscard]] bool occluded_below(std::uint32_t node, const Ray& ray) const;
    [[nodiscard]] std::array<glm::dvec3, 3> corners(std::uint32_t triangle) const;

    const Surface* m_surface; ///< never null
    std::vector<std::uint32_t> m_order;
    std::vector<Node> m_nodes;
};

} // namespace vkbake::bench
