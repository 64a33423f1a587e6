// Triangles and rays that tests of the accelerators share.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/random.hpp"
#include "bvh/accelerator.hpp"

namespace vkbake::test {

class Random {
public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}
    std::uint64_t bits() { return mix64(m_state += 0x9E3779B97F4A7C15ULL); }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }
    float between(float low, float high) { return low + (high - low) * (static_cast<float>(bits() >> 40U) * 0x1p-24F); }
    glm::vec3 point(float extent = 1.0F) {
        const float x = between(-extent, extent);
        const float y = between(-extent, extent);
        return {x, y, between(-extent, extent)};
    }
    glm::vec3 direction() {
        for (;;) {
            const glm::vec3 candidate = point();
            const float length = glm::length(candidate);
            if (length > 0.1F && length < 1.0F) {
                return candidate / length;
            }
        }
    }

private:
    std::uint64_t m_state;
};

struct Triangles {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> order;

    [[nodiscard]] std::size_t count() const { return order.size(); }
    [[nodiscard]] std::array<glm::vec3, 3> corners(std::size_t triangle) const {
        return {positions[3 * triangle], positions[3 * triangle + 1], positions[3 * triangle + 2]};
    }
};

inline bool less(const glm::vec3& a, const glm::vec3& b) {
    return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
}

/// Rotates corners and orders triangles as Surface promises.
inline Triangles make_triangles(std::string name, std::vector<glm::vec3> positions) {
    for (std::size_t first = 0; first < positions.size(); first += 3) {
        const auto begin = positions.begin() + static_cast<std::ptrdiff_t>(first);
        std::rotate(begin, std::min_element(begin, begin + 3, less), begin + 3);
    }
    std::vector<std::uint32_t> order(positions.size() / 3);
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::lexicographical_compare(&positions[3 * a], &positions[3 * a] + 3, &positions[3 * b],
                                            &positions[3 * b] + 3, less);
    });
    return {std::move(name), std::move(positions), std::move(order)};
}

inline std::vector<glm::vec3> soup_positions(std::size_t count, float size, std::uint64_t seed) {
    Random random(seed);
    std::vector<glm::vec3> positions;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 centre = random.point();
        for (int corner = 0; corner < 3; ++corner) {
            positions.push_back(centre + random.point(size));
        }
    }
    return positions;
}

inline Triangles soup(std::size_t count, float size, std::uint64_t seed) {
    return make_triangles("soup", soup_positions(count, size, seed));
}

/// Long, and so thin that their sheared area is of the order of rounding.
inline Triangles needles(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<glm::vec3> positions;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 from = random.point();
        const glm::vec3 to = random.point();
        positions.insert(positions.end(), {from, to, to + random.point(1e-6F)});
    }
    return make_triangles("needles", std::move(positions));
}

inline Triangles duplicates(std::size_t count, std::uint64_t seed) {
    const std::vector<glm::vec3> once = soup_positions(count, 0.3F, seed);
    std::vector<glm::vec3> positions = once;
    positions.insert(positions.end(), once.begin(), once.end());
    positions.insert(positions.end(), once.begin(), once.end());
    return make_triangles("duplicates", std::move(positions));
}

/// n × n quads in the plane where `axis` is `height`: boxes without thickness that touch each other.
inline Triangles sheet(int n, int axis, float height) {
    std::vector<glm::vec3> positions;
    const auto at = [&](int i, int j) {
        glm::vec3 p(height);
        p[(axis + 1) % 3] = 2.0F * static_cast<float>(i) / static_cast<float>(n) - 1.0F;
        p[(axis + 2) % 3] = 2.0F * static_cast<float>(j) / static_cast<float>(n) - 1.0F;
        return p;
    };
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            positions.insert(positions.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            positions.insert(positions.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return make_triangles("sheet", std::move(positions));
}

inline Triangles join(std::string name, const std::vector<Triangles>& parts) {
    std::vector<glm::vec3> positions;
    for (const Triangles& part : parts) {
        positions.insert(positions.end(), part.positions.begin(), part.positions.end());
    }
    return make_triangles(std::move(name), std::move(positions));
}

/// A closed mesh: an octahedron whose triangles are cut in four `levels` times, on the unit sphere.
inline Triangles sphere(int levels, float radius, const glm::vec3& centre) {
    std::vector<std::array<glm::vec3, 3>> faces;
    for (int octant = 0; octant < 8; ++octant) {
        const float x = (octant & 1) != 0 ? -1.0F : 1.0F;
        const float y = (octant & 2) != 0 ? -1.0F : 1.0F;
        const float z = (octant & 4) != 0 ? -1.0F : 1.0F;
        std::array<glm::vec3, 3> face{glm::vec3(x, 0, 0), glm::vec3(0, y, 0), glm::vec3(0, 0, z)};
        if (x * y * z < 0.0F) {
            std::swap(face[1], face[2]);
        }
        faces.push_back(face);
    }
    for (int level = 0; level < levels; ++level) {
        std::vector<std::array<glm::vec3, 3>> finer;
        for (const auto& [a, b, c] : faces) {
            // a + b and b + a have the same bits, so neighbours share their new corner
            const glm::vec3 ab = glm::normalize(a + b);
            const glm::vec3 bc = glm::normalize(b + c);
            const glm::vec3 ca = glm::normalize(c + a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        faces = std::move(finer);
    }
    std::vector<glm::vec3> positions;
    for (const auto& face : faces) {
        for (const glm::vec3& corner : face) {
            positions.push_back(centre + radius * corner);
        }
    }
    return make_triangles("sphere", std::move(positions));
}

/// A closed double cone of very thin triangles: two apexes, `count` corners on a rim.
inline Triangles needle_fan(int count) {
    const glm::vec3 top(0.03F, 0.9F, -0.02F);
    const glm::vec3 bottom(-0.01F, -0.9F, 0.04F);
    const auto rim = [&](int i) {
        const float angle = 6.2831853F * static_cast<float>(i % count) / static_cast<float>(count);
        return glm::vec3(0.8F * std::cos(angle), 0.1F * std::sin(3.0F * angle), 0.8F * std::sin(angle));
    };
    std::vector<glm::vec3> positions;
    for (int i = 0; i < count; ++i) {
        positions.insert(positions.end(), {top, rim(i + 1), rim(i)});
        positions.insert(positions.end(), {bottom, rim(i), rim(i + 1)});
    }
    return make_triangles("needle fan", std::move(positions));
}

/// A closed double cone whose rim is of pairs of corners so near each other that every second triangle is 10⁷ times as
/// long as wide.
inline Triangles needle_pairs(int pairs) {
    const glm::vec3 top(0.03F, 0.9F, -0.02F);
    const glm::vec3 bottom(-0.01F, -0.9F, 0.04F);
    const auto rim = [&](int i) {
        const double turn = static_cast<double>(i / 2 % pairs) / pairs;
        const float angle = static_cast<float>(6.283185307179586 * turn);
        glm::vec3 point(0.8F * std::cos(angle), 0.1F * std::sin(3.0F * angle), 0.8F * std::sin(angle));
        if (i % 2 != 0) { // one or two last places on
            point.x = std::nextafter(point.x, 2.0F);
            point.z = std::nextafter(point.z, 2.0F);
        }
        return point;
    };
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 2 * pairs; ++i) {
        positions.insert(positions.end(), {top, rim(i + 1), rim(i), bottom, rim(i), rim(i + 1)});
    }
    return make_triangles("needles 1:10^7", std::move(positions));
}

struct MappedSphere {
    Triangles triangles;
    glm::vec3 middle{0.0F};
};

/// Closed: the unit sphere after a random affine map that makes it some 1000 times thinner in one direction.
inline MappedSphere mapped_sphere(int levels, std::uint64_t seed) {
    Random random(seed);
    glm::mat3 map(0.0F);
    do {
        for (int column = 0; column < 3; ++column) {
            map[column] = random.point(0.5F) * (column == 2 ? 1e-3F : 1.0F);
        }
    } while (std::abs(glm::dot(glm::cross(map[0], map[1]), map[2])) < 5e-5F);
    const glm::vec3 middle = random.point(0.4F);
    std::vector<glm::vec3> positions = sphere(levels, 1.0F, glm::vec3(0.0F)).positions;
    for (glm::vec3& position : positions) {
        position = map * position + middle;
    }
    return {make_triangles("sphere, affine map " + std::to_string(seed), std::move(positions)), middle};
}

/// Closed, from −1 to 1; each face n × n squares.
inline Triangles cube(int n) {
    return join("cube", {sheet(n, 0, -1.0F), sheet(n, 0, 1.0F), sheet(n, 1, -1.0F), sheet(n, 1, 1.0F),
                         sheet(n, 2, -1.0F), sheet(n, 2, 1.0F)});
}

/// A corner, or a point of an edge as near to it as floats have one: what neighbours share.
inline glm::vec3 shared_point(Random& random, const Triangles& mesh) {
    const auto corners = mesh.corners(random.below(mesh.count()));
    const std::size_t first = random.below(3);
    const glm::vec3& a = corners[first];
    const glm::vec3& b = corners[(first + 1) % 3];
    switch (random.below(3)) {
    case 0:
        return a;
    case 1:
        return 0.5F * (a + b);
    default:
        return a + random.between(0.0F, 1.0F) * (b - a);
    }
}

inline TriangleAccelerator accelerate(const Triangles& triangles, Accelerator kind,
                                      TriangleTest test = TriangleTest::watertight, int threads = 0, int splits = 4) {
    return {triangles.positions, triangles.order, AcceleratorSettings{kind, test, splits, threads}};
}

} // namespace vkbake::test
