// Ray against triangle. The only place where hit or miss is decided.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "bvh/prepared_ray.hpp"
#include "bvh/triangle_list.hpp"

namespace vkbake {

struct TriangleHit {
    bool hit = false;
    bool back_side = false;
    float distance = 0.0F;
};

#include "bvh/edge_functions.inl"

/// Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (2013). Float edge functions reject; what they let pass,
/// and what they leave at 0, is computed again in double, where the products are exact. Double for all that passes, not
/// for the zeros alone as in the paper: hits are rare beside misses, and t is then as good as the sheared corners are,
/// on which PreparedRay's pad relies.
[[nodiscard]] inline TriangleHit test_watertight(const ShearedRay& ray, const Triangle& triangle) {
    const glm::vec3 a = triangle.corners[0] - ray.origin;
    const glm::vec3 b = triangle.corners[1] - ray.origin;
    const glm::vec3 c = triangle.corners[2] - ray.origin;
    const int x = ray.x_axis;
    const int y = ray.y_axis;
    const int z = ray.z_axis;
    const ShearedTriangle<float> sheared{shear(a[x], ray.shear_x, a[z]), shear(a[y], ray.shear_y, a[z]),
                                         shear(b[x], ray.shear_x, b[z]), shear(b[y], ray.shear_y, b[z]),
                                         shear(c[x], ray.shear_x, c[z]), shear(c[y], ray.shear_y, c[z])};
    const EdgeFunctions<float> coarse(sheared);
    if (!(std::min({coarse.u, coarse.v, coarse.w}) >= 0.0F || std::max({coarse.u, coarse.v, coarse.w}) <= 0.0F)) {
        return {};
    }
    const EdgeFunctions<double> edge({sheared.ax, sheared.ay, sheared.bx, sheared.by, sheared.cx, sheared.cy});
    const bool front = edge.u >= 0.0 && edge.v >= 0.0 && edge.w >= 0.0;
    const bool back = edge.u <= 0.0 && edge.v <= 0.0 && edge.w <= 0.0;
    const double determinant = edge.u + edge.v + edge.w;
    if (!(front || back) || determinant == 0.0) {
        return {};
    }
    const double scaled =
        edge.u * static_cast<double>(a[z]) + edge.v * static_cast<double>(b[z]) + edge.w * static_cast<double>(c[z]);
    const auto distance = static_cast<float>(scaled / (determinant * static_cast<double>(ray.direction[z])));
    return {distance > 0.0F && distance < ray.max_distance, back, distance};
}

/// Whether a triangle that test_watertight meets counts as a crossing (see Crossing): whether it would be met if the
/// ray ran by (ε, ε²), ε infinitely small, beside itself in the sheared plane. Corners are sheared there each by
/// itself, so triangles that share an edge see it alike, and of an edge function that is exactly 0 the displacement
/// alone decides: Edelsbrunner, Mücke, "Simulation of Simplicity" (1990); rasterizers' top-left rule is of the kind.
[[nodiscard]] inline bool counts(const ShearedRay& ray, const Triangle& triangle) {
    std::array<glm::dvec2, 3> corners{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::vec3 offset = triangle.corners[corner] - ray.origin;
        corners[corner] = {shear(offset[ray.x_axis], ray.shear_x, offset[ray.z_axis]),
                           shear(offset[ray.y_axis], ray.shear_y, offset[ray.z_axis])};
    }
    const auto left_of = [](const glm::dvec2& from, const glm::dvec2& to) {
        const double doubled_area = from.x * to.y - from.y * to.x; // of floats: the sign is exact
        const double beside = from.y != to.y ? from.y - to.y : to.x - from.x;
        return (doubled_area != 0.0 ? doubled_area : beside) > 0.0;
    };
    const bool first = left_of(corners[0], corners[1]);
    return left_of(corners[1], corners[2]) == first && left_of(corners[2], corners[0]) == first;
}

/// Möller, Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (1997), in the form of the thesis, §2.7.1: not
/// watertight. A hit must also lie in the triangle's own padded box, which refuses only what rounding invented (a
/// triangle seen edge-on may "meet" a ray far away from it), and by which no larger box can hide a hit.
[[nodiscard]] inline TriangleHit test_moller_trumbore(const PreparedRay& ray, const Triangle& triangle) {
    const glm::vec3 e1 = triangle.corners[0] - triangle.corners[2];
    const glm::vec3 e2 = triangle.corners[1] - triangle.corners[2];
    const glm::vec3 p = glm::cross(ray.direction, e2);
    const float determinant = glm::dot(p, e1);
    if (determinant == 0.0F) {
        return {};
    }
    const glm::vec3 to_origin = ray.origin - triangle.corners[2];
    const float u = glm::dot(p, to_origin) / determinant;
    if (!(u >= 0.0F && u <= 1.0F)) {
        return {};
    }
    const glm::vec3 q = glm::cross(to_origin, e1);
    const float v = glm::dot(q, ray.direction) / determinant;
    if (!(v >= 0.0F && u + v <= 1.0F)) {
        return {};
    }
    const float distance = glm::dot(q, e2) / determinant;
    const Interval own = pass(ray, triangle.bounds());
    const bool hit = distance > 0.0F && distance < ray.max_distance && own.entry <= distance && distance <= own.exit;
    return {hit, determinant < 0.0F, distance};
}

[[nodiscard]] inline TriangleHit test_triangle(TriangleTest test, const PreparedRay& ray, const Triangle& triangle) {
    return test == TriangleTest::watertight ? test_watertight(ray, triangle) : test_moller_trumbore(ray, triangle);
}

/// The nearest hit so far; of equal distances the one of least rank (see TriangleList).
struct NearestHit {
    float distance;
    std::uint32_t rank = 0;
    bool back_side = false;
    bool found = false;

    explicit NearestHit(const PreparedRay& ray) : distance(ray.max_distance) {}

    void offer(const TriangleHit& candidate, std::uint32_t candidate_rank) {
        const bool better =
            candidate.distance < distance || (found && candidate.distance == distance && candidate_rank < rank);
        if (candidate.hit && better) {
            *this = NearestHit(candidate, candidate_rank);
        }
    }

private:
    NearestHit(const TriangleHit& hit, std::uint32_t hit_rank)
        : distance(hit.distance), rank(hit_rank), back_side(hit.back_side), found(true) {}
};

} // namespace vkbake
