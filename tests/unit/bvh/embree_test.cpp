// Embree's robust mode as an oracle that shares no code with this project. Built where Embree is installed.
#if defined(VKBAKE_HAS_EMBREE)

#include <memory>

#include <embree3/rtcore.h>
#include <gtest/gtest.h>

#include "amount.hpp"
#include "unit/bvh/double_reference.hpp"

namespace vkbake::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};

class Embree {
public:
    explicit Embree(const Triangles& triangles)
        : m_device(rtcNewDevice("threads=1")), m_scene(rtcNewScene(m_device.get())) {
        rtcSetSceneFlags(m_scene.get(), RTC_SCENE_FLAG_ROBUST);
        RTCGeometry geometry = rtcNewGeometry(m_device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), triangles.positions.size()));
        std::copy(triangles.positions.begin(), triangles.positions.end(), vertices);
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.count()));
        std::iota(indices, indices + triangles.positions.size(), 0U);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(m_scene.get(), geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(m_scene.get());
    }

    [[nodiscard]] bool occluded(const Ray& ray) const {
        RTCIntersectContext context{};
        rtcInitIntersectContext(&context);
        RTCRay query = convert(ray);
        rtcOccluded1(m_scene.get(), &context, &query);
        return query.tfar < 0.0F;
    }

    [[nodiscard]] std::optional<Hit> nearest(const Ray& ray) const {
        RTCIntersectContext context{};
        rtcInitIntersectContext(&context);
        RTCRayHit query{};
        query.ray = convert(ray);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(m_scene.get(), &context, &query);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
            return std::nullopt;
        }
        return Hit{query.hit.primID, query.ray.tfar, false};
    }

private:
    static RTCRay convert(const Ray& ray) {
        RTCRay query{};
        query.org_x = ray.origin.x;
        query.org_y = ray.origin.y;
        query.org_z = ray.origin.z;
        query.dir_x = ray.direction.x;
        query.dir_y = ray.direction.y;
        query.dir_z = ray.direction.z;
        query.tfar = ray.max_distance;
        query.mask = ~0U;
        return query;
    }

    std::unique_ptr<RTCDeviceTy, ReleaseDevice> m_device;
    std::unique_ptr<RTCSceneTy, ReleaseScene> m_scene;
};

// Embree's edge functions are off by a few roundings of the squared extent, so what moves an outline is that over the
// edge's length; the own test is off by a few roundings of the extent (see triangle_test_test.cpp).
struct Rounding {
    double shift;    ///< of the outline, as a distance
    double distance; ///< of t: a triangle that is seen edge-on moves it far
};

Rounding rounding_of(const Reference& reference, const std::array<glm::vec3, 3>& corners) {
    const double shortest = std::min({glm::length(glm::dvec3(corners[1]) - glm::dvec3(corners[0])),
                                      glm::length(glm::dvec3(corners[2]) - glm::dvec3(corners[1])),
                                      glm::length(glm::dvec3(corners[0]) - glm::dvec3(corners[2]))});
    const double shift = 0x1p-20 * reference.extent * std::max(1.0, reference.extent / shortest);
    return {shift, reference.steepness * shift};
}

bool may_differ(const Ray& ray, const std::array<glm::vec3, 3>& corners) {
    const Reference reference = refer(ray, corners);
    const Rounding rounding = rounding_of(reference, corners);
    return reference.margin <= rounding.shift ||
           (reference.inside && std::abs(reference.distance) <= rounding.distance);
}

// Explained: one found a triangle that the other did not, and that triangle's outline or the ray's origin is within
// rounding; or both hits lie within rounding of each other.
bool explained(const Ray& ray, const Triangles& triangles, const std::optional<Hit>& a, const std::optional<Hit>& b) {
    if (a && b && std::abs(a->distance - b->distance) <= 1e-5F * std::max(1.0F, a->distance)) {
        return true;
    }
    return (a && may_differ(ray, triangles.corners(a->triangle))) ||
           (b && may_differ(ray, triangles.corners(b->triangle)));
}

struct Outcome {
    int hits = 0;
    int differences = 0;
    int unexplained = 0;
};

Outcome compare(const Triangles& triangles, int rays, bool at_edges) {
    const Embree embree(triangles);
    const TriangleAccelerator accelerator = accelerate(triangles, Accelerator::bvh);
    Random random(41);
    Outcome outcome;
    for (int i = 0; i < rays; ++i) {
        Ray ray{random.point(), random.direction(), infinity};
        if (at_edges) {
            const auto corners = triangles.corners(random.below(triangles.count()));
            const float along = random.between(0.0F, 1.0F);
            ray.direction = corners[0] + along * (corners[1] - corners[0]) - ray.origin;
        }
        const std::optional<Hit> ours = accelerator.nearest(ray);
        const std::optional<Hit> theirs = embree.nearest(ray);
        outcome.hits += ours ? 1 : 0;
        const bool same = ours.has_value() == theirs.has_value() && (!ours || ours->triangle == theirs->triangle) &&
                          accelerator.occluded(ray) == embree.occluded(ray);
        if (!same) {
            ++outcome.differences;
            outcome.unexplained += explained(ray, triangles, ours, theirs) ? 0 : 1;
        } else if (ours) {
            const auto corners = triangles.corners(ours->triangle);
            const Reference reference = refer(ray, corners);
            EXPECT_NEAR(ours->distance, reference.distance, 0x1p-20 * reference.steepness * reference.extent);
            EXPECT_NEAR(ours->distance, theirs->distance, rounding_of(reference, corners).distance);
        }
    }
    return outcome;
}

TEST(Embree, RandomRaysAgree) {
    constexpr int rays = amount(150000, 15000);
    const Outcome outcome = compare(soup(2000, 0.1F, 42), rays, false);
    EXPECT_GT(outcome.hits, rays / 3);
    EXPECT_LE(outcome.differences, 5);
    EXPECT_EQ(outcome.unexplained, 0);
}

TEST(Embree, RaysAtEdgesDifferOnlyWithinRounding) {
    const Outcome outcome = compare(soup(2000, 0.1F, 43), 20000, true);
    EXPECT_GT(outcome.hits, 10000);
    EXPECT_GT(outcome.differences, 0); // else no ray came near enough to an edge to tell anything
    EXPECT_EQ(outcome.unexplained, 0);
}

TEST(Embree, RaysInsideAClosedMeshAgree) {
    const Outcome outcome = compare(sphere(4, 2.0F, {0.1F, 0.0F, -0.1F}), 50000, false);
    EXPECT_EQ(outcome.hits, 50000);
    EXPECT_EQ(outcome.unexplained, 0);
}

} // namespace
} // namespace vkbake::test

#endif
