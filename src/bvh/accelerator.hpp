// Triangles made ready for rays: which is hit first, and whether any is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "bvh/ray_block.hpp"
#include "vkbake/settings.hpp"

namespace vkbake {

/// The bounds of a direction's largest component: 1 / direction and every product with it stay finite and normal.
inline constexpr float least_direction = 0x1p-60F;
inline constexpr float greatest_direction = 0x1p60F;

/// Meets a triangle where 0 < t < max_distance, at origin + t · direction. The direction need not be a unit vector; its
/// largest component must lie in [2⁻⁶⁰, 2⁶⁰] in magnitude, the others may be anything finite (±0, denormal).
/// A ray that is not so, or has a component that is not finite, meets nothing.
struct Ray {
    glm::vec3 origin{0.0F};
    glm::vec3 direction{0.0F};
    float max_distance = std::numeric_limits<float>::infinity(); ///< in units of |direction|
    std::uint32_t ignored_triangle = no_triangle;                ///< never met, as numbered in the positions
};

struct Hit {
    std::uint32_t triangle = 0; ///< as numbered in the positions
    float distance = 0.0F;      ///< t, in units of |direction|
    bool back_side = false;     ///< the corners run clockwise as the ray sees them
};

/// A triangle on a ray's way.
struct Crossing {
    Hit hit;
    std::uint32_t rank = 0; ///< its place in the canonical order, among the triangles that have an area
    /// Where a ray passes exactly through an edge or a corner, every triangle that touches there is met. Those that
    /// count are the ones that a ray infinitely little beside it meets, always on the same side: so where triangles lie
    /// side by side one of them counts, and at a fold both or none. Watertight test only; otherwise all count.
    bool counts = true;
};

/// Is shown what a ray meets.
class CrossingFilter {
public:
    CrossingFilter() = default;
    CrossingFilter(const CrossingFilter&) = delete;
    CrossingFilter& operator=(const CrossingFilter&) = delete;

    /// Returns true where the ray ends there.
    [[nodiscard]] virtual bool ends(const Crossing& crossing) = 0;

protected:
    ~CrossingFilter() = default;
};

struct AcceleratorSettings {
    Accelerator kind = Accelerator::bvh;
    TriangleTest test = TriangleTest::watertight; ///< moller_trumbore: brute and clusters only
    int cluster_splits = 4;                       ///< parts an axis is cut into; 1 … 64
    int threads = 0;                              ///< workers of the build; 0: all. Never changes what is built
};

/// What a build gave, for reports and tests.
struct AcceleratorStatistics {
    std::size_t triangles = 0; ///< those that have an area: the others are dropped
    std::size_t clusters = 0;
    std::size_t nodes = 0;  ///< inner nodes of the hierarchy
    std::size_t leaves = 0; ///< leaves of the hierarchy
    std::size_t depth = 0;  ///< inner nodes on the longest way from the root to a leaf
    std::size_t bytes = 0;  ///< held while tracing
};

/// What one thread needs to ask blocks of rays, so that nothing is allocated meanwhile. Made by the accelerator that is
/// going to be asked, used by one thread at a time; what it holds changes how fast an answer comes, never which.
class BlockScratch {
public:
    BlockScratch() = default;
    explicit BlockScratch(std::size_t queue_capacity) : nodes(queue_capacity), rays(queue_capacity) {}

    std::vector<std::uint32_t> nodes; ///< of rays that wait: where
    std::vector<std::uint32_t> rays;  ///< which
};

/// A set of triangles that answers rays. With the same test every kind gives the same answer to every ray, bit for bit:
/// a box never hides a triangle that the test would hit. Triangles without area (their corners on a line) never block.
/// Both sides block. Rays may be asked from any number of threads; nothing is allocated while tracing.
class TriangleAccelerator {
public:
    /// `positions`: 3 a triangle, finite; they are copied. `canonical_order`: the triangles of the set, each once, in
    /// the order of Surface's; of hits at equal distance the first in this order wins. What is built depends on the
    /// triangles in this order only.
    /// Throws Error{usage} for settings that contradict each other or are out of range.
    TriangleAccelerator(std::span<const glm::vec3> positions, std::span<const std::uint32_t> canonical_order,
                        const AcceleratorSettings& settings);
    ~TriangleAccelerator();
    TriangleAccelerator(TriangleAccelerator&&) noexcept;
    TriangleAccelerator& operator=(TriangleAccelerator&&) noexcept;
    TriangleAccelerator(const TriangleAccelerator&) = delete;
    TriangleAccelerator& operator=(const TriangleAccelerator&) = delete;

    [[nodiscard]] bool occluded(const Ray& ray) const;              ///< whether anything is met
    [[nodiscard]] std::optional<Hit> nearest(const Ray& ray) const; ///< what is met first
    /// Shows the filter each triangle that is met, once, in an order not to be relied on, until it ends the ray.
    /// Returns whether it did.
    bool filter(const Ray& ray, CrossingFilter& filter) const;
    /// The same answers as occluded() gives to each ray that is active.
    [[nodiscard]] BlockedRays blocked(const RayBlock& block, BlockScratch& scratch) const;
    [[nodiscard]] BlockScratch make_scratch() const;
    [[nodiscard]] AcceleratorStatistics statistics() const;

private:
    struct State;
    std::unique_ptr<const State> m_state;
};

} // namespace vkbake
