// Surfaces that emit so much more than the rest that rays are to seek them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "trace/surface_light.hpp"
#include "trace/surface_opacity.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Where light is sought from.
struct Receiver {
    glm::dvec3 place{0.0};
    glm::dvec3 normal{0.0}; ///< unit; 0 in the air, where light counts from all around
};

/// Triangles to which a choice leads by what they may send to a receiver: down a binary tree of boxes, at each node by
/// power, distance and a bound of both cosines (A. Conty Estevez, C. Kulla, Importance Sampling of Many Lights with
/// Adaptive Tree Splitting, 2018; the bounds are those of M. Pharr, W. Jakob, G. Humphreys, Physically Based Rendering,
/// 4th edition, 12.6.3). No index of a triangle decides anything.
///
/// What is sought is what is brighter than four times the mean over all opaque surfaces: a glowing room, whose light
/// every ray finds, has none of it. What is not sought, or lets light through, is met by chance, as what a texture
/// makes brighter than the triangle's mean is too: whoever joins both by their densities (multiple importance sampling)
/// has the right mean whatever the choice.
class EmitterSet {
public:
    /// `light`: of which counts what may be sought; it and the surface must outlive the set. `opacity`: null where all
    /// is opaque.
    EmitterSet(const Surface& surface, const SurfaceLight& light, const SurfaceOpacity* opacity);

    [[nodiscard]] bool empty() const { return m_nodes.empty(); }
    [[nodiscard]] std::size_t count() const { return m_triangles.size(); } ///< triangles

    struct Sample {
        glm::dvec3 point{0.0};
        glm::dvec3 normal{0.0}; ///< of the triangle, unit
        bool two_sided = false; ///< sends from its back too
        glm::vec3 radiance{0.0F};
        double density = 0.0; ///< over area
    };
    /// `u`, `v`: uniform in (0, 1). Points beside each other give points beside each other. Absent where nothing can
    /// reach the receiver.
    [[nodiscard]] std::optional<Sample> sample(const Receiver& receiver, double u, double v) const;
    /// Over area, of a point of a surface's triangle; 0 where none is sought.
    [[nodiscard]] double density(const Receiver& receiver, std::uint32_t triangle) const;
    /// Unit.
    [[nodiscard]] glm::dvec3 normal(std::uint32_t triangle) const;

private:
    struct Bounds {
        glm::dvec3 low{0.0};
        glm::dvec3 high{0.0};
        glm::dvec3 axis{0.0};   ///< of a cone that holds all normals, unit
        double cosine = 1.0;    ///< of the cone's half angle
        bool two_sided = false; ///< some
        double power = 0.0;
    };
    /// The first child stands behind its parent.
    struct Node {
        Bounds bounds;
        std::uint32_t second = 0;   ///< child; 0 in a leaf
        std::uint32_t triangle = 0; ///< of a leaf
    };
    struct Candidate {
        std::uint32_t triangle = 0;
        Bounds bounds;
    };

    [[nodiscard]] static Bounds join(const Bounds& a, const Bounds& b);
    /// `path`: the turns from the root, the first the lowest bit.
    void build(std::span<Candidate> candidates, std::uint64_t path, unsigned depth);
    [[nodiscard]] double importance(const Bounds& bounds, const Receiver& receiver) const;
    /// Of the first child.
    [[nodiscard]] std::optional<double> share_of_first(const Node& node, const Receiver& receiver) const;
    [[nodiscard]] double area(std::uint32_t triangle) const;

    const Surface* m_surface;    ///< never null
    const SurfaceLight* m_light; ///< never null
    std::vector<Node> m_nodes;
    struct Known {
        std::uint32_t triangle = 0;
        std::uint64_t path = 0;
    };
    std::vector<Known> m_triangles; ///< by number, for density() only
};

} // namespace vkbake
