#include "make_scenes/shapes.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

#include "make_scenes/turn.hpp"

namespace vkbake::scenes {
namespace {

std::vector<std::uint32_t> append(Solid& solid, const Ring& ring) {
    std::vector<std::uint32_t> indices;
    for (const glm::dvec3& point : ring) {
        indices.push_back(static_cast<std::uint32_t>(solid.points.size()));
        solid.points.push_back(point);
    }
    return indices;
}

void skin(Solid& solid, const std::vector<std::uint32_t>& from, const std::vector<std::uint32_t>& to, Paint paint) {
    const std::size_t n = std::max(from.size(), to.size());
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        if (from.size() == 1) {
            solid.triangles.push_back({{from[0], to[j], to[i]}, paint});
        } else if (to.size() == 1) {
            solid.triangles.push_back({{from[i], from[j], to[0]}, paint});
        } else {
            solid.triangles.push_back({{from[i], from[j], to[j]}, paint});
            solid.triangles.push_back({{from[i], to[j], to[i]}, paint});
        }
    }
}

// Closes a convex ring, seen counter-clockwise, by rungs.
void cap(Solid& solid, const std::vector<std::uint32_t>& ring, Paint paint) {
    std::size_t left = 1;
    std::size_t right = ring.size() - 1;
    solid.triangles.push_back({{ring[0], ring[left], ring[right]}, paint});
    while (left + 1 < right) {
        solid.triangles.push_back({{ring[left], ring[left + 1], ring[right]}, paint});
        ++left;
        if (left + 1 < right) {
            solid.triangles.push_back({{ring[left], ring[right - 1], ring[right]}, paint});
            --right;
        }
    }
}

Ring circle(double radius, double height, int segments) {
    if (radius == 0.0) {
        return {{0.0, height, 0.0}};
    }
    Ring ring;
    for (int k = 0; k < segments; ++k) {
        const glm::dvec2 c = on_circle(static_cast<double>(k) / segments);
        ring.emplace_back(radius * c.x, height, -radius * c.y);
    }
    return ring;
}

Ring rectangle(const glm::dvec2& low, const glm::dvec2& high, double z) {
    return {{low.x, low.y, z}, {high.x, low.y, z}, {high.x, high.y, z}, {low.x, high.y, z}};
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// Ear clipping; the polygon is counter-clockwise.
std::vector<std::array<std::uint32_t, 3>> triangulate(const std::vector<glm::dvec2>& polygon) {
    std::vector<std::uint32_t> left;
    for (std::uint32_t i = 0; i < polygon.size(); ++i) {
        left.push_back(i);
    }
    const auto is_ear = [&](std::size_t k) {
        const std::size_t n = left.size();
        const glm::dvec2 a = polygon[left[(k + n - 1) % n]];
        const glm::dvec2 b = polygon[left[k]];
        const glm::dvec2 c = polygon[left[(k + 1) % n]];
        if (cross(b - a, c - b) <= 0.0) {
            return false;
        }
        return std::none_of(left.begin(), left.end(), [&](std::uint32_t i) {
            const glm::dvec2 p = polygon[i];
            return p != a && p != b && p != c && cross(b - a, p - a) >= 0.0 && cross(c - b, p - b) >= 0.0 &&
                   cross(a - c, p - c) >= 0.0;
        });
    };
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::size_t k = 0;
    for (std::size_t tried = 0; left.size() > 2 && tried <= left.size(); ++tried) {
        const std::size_t n = left.size();
        k %= n;
        if (is_ear(k)) {
            triangles.push_back({left[(k + n - 1) % n], left[k], left[(k + 1) % n]});
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
            tried = 0;
        } else {
            ++k;
        }
    }
    return triangles;
}

} // namespace

Solid loft(const std::vector<Ring>& rings, Paint paint, Ends ends) {
    Solid solid;
    std::vector<std::vector<std::uint32_t>> indices;
    indices.reserve(rings.size());
    for (const Ring& ring : rings) {
        indices.push_back(append(solid, ring));
    }
    for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
        skin(solid, indices[r], indices[r + 1], paint);
    }
    if (ends == Ends::joined) {
        skin(solid, indices.back(), indices.front(), paint);
    } else {
        if (indices.front().size() > 1) {
            std::vector<std::uint32_t> reversed = indices.front();
            std::reverse(reversed.begin() + 1, reversed.end());
            cap(solid, reversed, paint);
        }
        if (indices.back().size() > 1) {
            cap(solid, indices.back(), paint);
        }
    }
    return facing_outward(std::move(solid));
}

Solid lathe(const Profile& profile, int segments, Paint paint, Ends ends) {
    std::vector<Ring> rings;
    for (const glm::dvec2& p : profile) {
        rings.push_back(circle(p.x, p.y, segments));
    }
    return loft(rings, paint, ends);
}

Solid cylinder(double radius, double height, int segments, Paint paint, double bevel) {
    if (bevel == 0.0) {
        return lathe({{radius, 0.0}, {radius, height}}, segments, paint);
    }
    return lathe({{radius - bevel, 0.0}, {radius, bevel}, {radius, height - bevel}, {radius - bevel, height}}, segments,
                 paint);
}

Solid box(const glm::dvec3& low, const glm::dvec3& high, Paint paint) {
    return loft({rectangle(low, high, low.z), rectangle(low, high, high.z)}, paint);
}

Solid bevelled_box(const glm::dvec3& low, const glm::dvec3& high, double bevel, Paint paint) {
    // Every corner of the box becomes three points, one on each of its faces.
    Solid solid;
    const std::array<glm::dvec3, 2> ends{low, high};
    const auto sign = [](int bit) { return bit == 0 ? 1.0 : -1.0; };
    const auto index = [](int x, int y, int z, int axis) {
        return static_cast<std::uint32_t>(((x * 2 + y) * 2 + z) * 3 + axis);
    };
    for (int corner = 0; corner < 8; ++corner) {
        const std::array<int, 3> bits{corner >> 2 & 1, corner >> 1 & 1, corner & 1};
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 point;
            for (int c = 0; c < 3; ++c) {
                const int bit = bits[static_cast<std::size_t>(c)];
                point[c] = ends[static_cast<std::size_t>(bit)][c] + (c == axis ? 0.0 : sign(bit) * bevel);
            }
            solid.points.push_back(point);
        }
    }
    // `handed` tells which order of corners faces outward: it turns with every coordinate that is mirrored.
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, bool handed) {
        solid.triangles.push_back({handed ? std::array{a, b, c} : std::array{a, c, b}, paint});
    };
    const auto quad = [&](std::array<std::uint32_t, 4> q, bool handed) {
        triangle(q[0], q[1], q[2], handed);
        triangle(q[0], q[2], q[3], handed);
    };
    const auto at = [&](int axis, int a, int b, int c, int face) {
        std::array<int, 3> bits{};
        bits[static_cast<std::size_t>(axis)] = a;
        bits[static_cast<std::size_t>((axis + 1) % 3)] = b;
        bits[static_cast<std::size_t>((axis + 2) % 3)] = c;
        return index(bits[0], bits[1], bits[2], face);
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            quad({at(axis, side, 0, 0, axis), at(axis, side, 1, 0, axis), at(axis, side, 1, 1, axis),
                  at(axis, side, 0, 1, axis)},
                 side == 1);
        }
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        for (int b = 0; b < 2; ++b) {
            for (int c = 0; c < 2; ++c) {
                quad({at(axis, 0, b, c, u), at(axis, 1, b, c, u), at(axis, 1, b, c, v), at(axis, 0, b, c, v)}, b != c);
            }
        }
    }
    for (int corner = 0; corner < 8; ++corner) {
        const int x = corner >> 2 & 1;
        const int y = corner >> 1 & 1;
        const int z = corner & 1;
        triangle(index(x, y, z, 0), index(x, y, z, 1), index(x, y, z, 2), (x + y + z) % 2 == 1);
    }
    return facing_outward(std::move(solid));
}

Solid front_bevelled_box(const glm::dvec3& low, const glm::dvec3& high, double bevel, Paint paint) {
    return loft({rectangle(low, high, low.z), rectangle(low, high, high.z - bevel),
                 rectangle(glm::dvec2(low) + bevel, glm::dvec2(high) - bevel, high.z)},
                paint);
}

Solid extrude(const std::vector<glm::dvec2>& polygon, double low_z, double high_z, Paint paint) {
    std::vector<glm::dvec2> outline = polygon;
    double area = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        area += cross(outline[i], outline[(i + 1) % outline.size()]);
    }
    if (area < 0.0) {
        std::reverse(outline.begin(), outline.end());
    }
    Solid solid;
    Ring low;
    Ring high;
    for (const glm::dvec2& p : outline) {
        low.emplace_back(p, low_z);
        high.emplace_back(p, high_z);
    }
    const auto low_indices = append(solid, low);
    const auto high_indices = append(solid, high);
    skin(solid, low_indices, high_indices, paint);
    for (const auto& t : triangulate(outline)) {
        solid.triangles.push_back({{low_indices[t[0]], low_indices[t[2]], low_indices[t[1]]}, paint});
        solid.triangles.push_back({{high_indices[t[0]], high_indices[t[1]], high_indices[t[2]]}, paint});
    }
    return facing_outward(std::move(solid));
}

Solid tube(const std::vector<glm::dvec3>& path, double radius, int sides, const glm::dvec3& sideways, Paint paint) {
    std::vector<Ring> rings;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const glm::dvec3 before = i > 0 ? unit(path[i] - path[i - 1]) : unit(path[1] - path[0]);
        const glm::dvec3 after = i + 1 < path.size() ? unit(path[i + 1] - path[i]) : before;
        const glm::dvec3 along = unit(before + after);
        const glm::dvec3 u = unit(glm::cross(sideways, along));
        const glm::dvec3 v = glm::cross(along, u);
        Ring ring;
        for (int k = 0; k < sides; ++k) {
            const glm::dvec2 c = on_circle((k + 0.5) / sides);
            ring.push_back(path[i] + radius * (c.x * u + c.y * v));
        }
        rings.push_back(std::move(ring));
    }
    Solid solid = loft(rings, paint);
    solid.grain = path.back() - path.front();
    return solid;
}

Solid torus(double radius, double thickness, int segments, int sides, Paint paint) {
    Profile profile;
    for (int k = 0; k < sides; ++k) {
        const glm::dvec2 c = on_circle((k + 0.5) / sides);
        profile.emplace_back(radius + thickness * c.x, thickness * c.y);
    }
    return lathe(profile, segments, paint, Ends::joined);
}

Solid sphere(double radius, int segments, int rings, Paint paint) {
    Profile profile{{0.0, -radius}};
    for (int k = 1; k < rings; ++k) {
        const glm::dvec2 c = on_circle(0.5 * k / rings - 0.25);
        profile.emplace_back(radius * c.x, radius * c.y);
    }
    profile.emplace_back(0.0, radius);
    return lathe(profile, segments, paint);
}

} // namespace vkbake::scenes
