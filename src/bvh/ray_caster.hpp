// What the kinds of accelerator have in common.
#pragma once

#include "bvh/accelerator.hpp"
#include "bvh/prepared_ray.hpp"
#include "bvh/triangle_test.hpp"

namespace vkbake {

/// Answers prepared, valid rays by ranks.
class RayCaster {
public:
    RayCaster() = default;
    virtual ~RayCaster() = default;
    RayCaster(const RayCaster&) = delete;
    RayCaster& operator=(const RayCaster&) = delete;

    [[nodiscard]] virtual bool occluded(const PreparedRay& ray) const = 0;
    [[nodiscard]] virtual NearestHit nearest(const PreparedRay& ray) const = 0;
    /// `triangles` is not set.
    [[nodiscard]] virtual AcceleratorStatistics statistics() const = 0;
};

} // namespace vkbake
