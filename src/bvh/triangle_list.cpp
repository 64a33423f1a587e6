#include "bvh/triangle_list.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

// Differences of floats and products of two equal real numbers round alike in double, so exactly collinear corners give
// exactly zero (unless their exponents are more than 29 apart).
bool has_area(const Triangle& triangle) {
    const glm::dvec3 origin(triangle.corners[0]);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(triangle.corners[1]) - origin, glm::dvec3(triangle.corners[2]) - origin);
    return normal != glm::dvec3(0.0);
}

constexpr std::size_t ranks_a_range = 8192;

// Marks with no_triangle those without area, and bounds the others; those that are marked already are left out.
Box bounds_of_listed(std::span<const glm::vec3> positions, std::vector<std::uint32_t>& ranks, int threads) {
    std::vector<Box> by_worker(worker_count(threads));
    parallel_ranges_by_worker(
        ranks.size(), ranks_a_range, threads, [&](std::size_t begin, std::size_t end, std::size_t worker) {
            Box box;
            for (std::size_t number = begin; number < end; ++number) {
                if (ranks[number] == no_triangle) {
                    continue;
                }
                const Triangle triangle{{positions[3 * number], positions[3 * number + 1], positions[3 * number + 2]}};
                if (has_area(triangle)) {
                    box.add(triangle.bounds());
                } else {
                    ranks[number] = no_triangle;
                }
            }
            by_worker[worker].add(box);
        });
    Box bounds;
    for (const Box& box : by_worker) {
        bounds.add(box);
    }
    return bounds;
}

} // namespace

TriangleList list_triangles(std::span<const glm::vec3> positions, std::span<const std::uint32_t> canonical_order,
                            int threads) {
    const std::size_t count = positions.size() / 3;
    if (canonical_order.size() > count || std::ranges::any_of(canonical_order, [&](auto n) { return n >= count; })) {
        throw Error(ErrorKind::bake_failed,
                    "accelerator: the canonical order names a missing triangle, or one twice; report this");
    }
    TriangleList list;
    if (canonical_order.size() == count) {
        list.ranks.resize(count);
    } else {
        list.ranks.resize(count, no_triangle);
        for (const std::uint32_t number : canonical_order) {
            list.ranks[number] = 0;
        }
    }
    list.bounds = bounds_of_listed(positions, list.ranks, threads);
    list.numbers.reserve(canonical_order.size());
    for (const std::uint32_t number : canonical_order) {
        if (list.ranks[number] != no_triangle) {
            list.ranks[number] = static_cast<std::uint32_t>(list.numbers.size());
            list.numbers.push_back(number);
        }
    }
    return list;
}

std::vector<Triangle> ListedTriangles::copy() const {
    std::vector<Triangle> triangles;
    triangles.reserve(size());
    for (std::size_t rank = 0; rank < size(); ++rank) {
        triangles.push_back((*this)[rank]);
    }
    return triangles;
}

} // namespace vkbake
