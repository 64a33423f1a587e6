// The accelerators that are compared and are not the library's.
#pragma once

#include <cstddef>

#include "bvh/prepared_ray.hpp"
#include "bvh/triangle_test.hpp"

namespace vkbake::bench {

/// How far a triangle reaches beyond its true place, at most: the triangle test may meet it this far off (see
/// PreparedRay), so the cells of a subdivision hold what comes this near to them. Bake frame, where no two points are
/// farther apart than 2 along an axis.
inline constexpr float reach_of_rounding = 0x1p-18F;

/// Answers prepared, valid rays.
class RayAsker {
public:
    RayAsker() = default;
    virtual ~RayAsker() = default;
    RayAsker(const RayAsker&) = delete;
    RayAsker& operator=(const RayAsker&) = delete;

    [[nodiscard]] virtual bool occluded(const PreparedRay& ray) const = 0;
    [[nodiscard]] virtual std::size_t bytes() const = 0;
};

/// Whether the triangle's box and its plane both come within reach of the box.
[[nodiscard]] bool touches(const Triangle& triangle, const Box& box);

} // namespace vkbake::bench
