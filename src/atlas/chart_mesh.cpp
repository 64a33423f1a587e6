#include "atlas/chart_mesh.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "base/random.hpp"

namespace vkbake {

namespace {

/// Numbers the corners' positions in the order in which they come.
class VertexTable {
public:
    explicit VertexTable(std::size_t corners) : m_slots(std::bit_ceil(2 * corners + 2), ChartMesh::none) {}

    std::uint32_t number(const glm::vec3& position, std::vector<glm::vec3>& points) {
        const glm::vec3 point = position + glm::vec3(0.0F); // −0 and 0 are one
        const std::uint64_t x = std::bit_cast<std::uint32_t>(point.x);
        const std::uint64_t y = std::bit_cast<std::uint32_t>(point.y);
        const std::uint64_t z = std::bit_cast<std::uint32_t>(point.z);
        const std::size_t mask = m_slots.size() - 1;
        for (std::size_t slot = mix64(x ^ mix64(y ^ (z << 32U))) & mask;; slot = (slot + 1) & mask) {
            std::uint32_t& vertex = m_slots[slot];
            if (vertex == ChartMesh::none) {
                vertex = static_cast<std::uint32_t>(points.size());
                points.push_back(point);
                return vertex;
            }
            if (points[vertex] == point) {
                return vertex;
            }
        }
    }

private:
    std::vector<std::uint32_t> m_slots;
};

/// `at`: the surface's corner of a corner of the mesh.
template<typename At>
bool is_crease(const ChartMesh& mesh, const Surface& surface, std::uint32_t side, const At& at) {
    const std::uint32_t beyond = mesh.across[side];
    if (beyond == ChartMesh::none) {
        return false;
    }
    const auto apart = [&](std::uint32_t a, std::uint32_t b) {
        return glm::dot(surface.normals[at(a)], surface.normals[at(b)]) < static_cast<float>(crease_cosine);
    };
    return surface.parts_of[at(side) / 3] != surface.parts_of[at(beyond) / 3] ||
           (glm::dot(mesh.normals[side / 3], mesh.normals[beyond / 3]) < crease_cosine &&
            (apart(side, next_corner(beyond)) || apart(next_corner(side), beyond)));
}

glm::dvec3 unit_normal(const ChartMesh& mesh, std::uint32_t triangle) {
    const glm::dvec3 a = mesh.corner(3 * triangle);
    const glm::dvec3 normal = glm::cross(mesh.corner(3 * triangle + 1) - a, mesh.corner(3 * triangle + 2) - a);
    const double length = glm::length(normal);
    return length > 0.0 ? normal / length : glm::dvec3(0.0);
}

/// Joins the sides that run between the same two vertices.
void pair_sides(ChartMesh& mesh, std::span<std::uint32_t> sides) {
    constexpr std::size_t most = 32; // more meet only where triangles lie on each other; all pairs are tried
    if (sides.size() < 2 || sides.size() > most) {
        return;
    }
    const auto goes_up = [&](std::uint32_t side) { return mesh.vertices[side] < mesh.vertices[next_corner(side)]; };
    if (sides.size() == 2) { // as nearly everywhere
        if (goes_up(sides[0]) != goes_up(sides[1])) {
            mesh.across[sides[0]] = sides[1];
            mesh.across[sides[1]] = sides[0];
        }
        return;
    }
    struct Pair {
        double flatness; ///< cosine between the normals
        std::uint32_t up;
        std::uint32_t down;
    };
    std::vector<Pair> pairs;
    for (const std::uint32_t up : sides) {
        for (const std::uint32_t down : sides) {
            if (goes_up(up) && !goes_up(down)) {
                pairs.push_back({glm::dot(mesh.normals[up / 3], mesh.normals[down / 3]), up, down});
            }
        }
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.flatness > b.flatness; });
    for (const Pair& pair : pairs) {
        if (mesh.across[pair.up] == ChartMesh::none && mesh.across[pair.down] == ChartMesh::none) {
            mesh.across[pair.up] = pair.down;
            mesh.across[pair.down] = pair.up;
        }
    }
}

void find_sides_across(ChartMesh& mesh) {
    // Sides by their lesser vertex, then by the greater.
    std::vector<std::uint32_t> first(mesh.points.size() + 1, 0);
    const auto joins = [&](std::uint32_t side) {
        return mesh.normals[side / 3] != glm::dvec3(0.0) && mesh.vertices[side] != mesh.vertices[next_corner(side)];
    };
    const auto ends = [&](std::uint32_t side) {
        return std::minmax(mesh.vertices[side], mesh.vertices[next_corner(side)]);
    };
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t side = 0; side < count; ++side) {
        first[ends(side).first + 1] += joins(side) ? 1U : 0U;
    }
    for (std::size_t vertex = 1; vertex < first.size(); ++vertex) {
        first[vertex] += first[vertex - 1];
    }
    std::vector<std::uint32_t> sides(first.back());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::uint32_t side = 0; side < count; ++side) {
        if (joins(side)) {
            sides[next[ends(side).first]++] = side;
        }
    }
    parallel_ranges(mesh.points.size(), 4096, 0, [&](std::size_t first_vertex, std::size_t past_vertex) {
        for (std::size_t vertex = first_vertex; vertex < past_vertex; ++vertex) {
            const auto begin = sides.begin() + first[vertex];
            const auto end = sides.begin() + first[vertex + 1];
            std::sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
                return std::pair(ends(a).second, a) < std::pair(ends(b).second, b);
            });
            for (auto at = begin; at != end;) {
                const auto past =
                    std::find_if(at, end, [&](std::uint32_t side) { return ends(side).second != ends(*at).second; });
                pair_sides(mesh, {at, past});
                at = past;
            }
        }
    });
}

} // namespace

ChartMesh make_chart_mesh(const Surface& surface, std::span<const std::uint32_t> triangles) {
    ChartMesh mesh;
    VertexTable table(3 * triangles.size());
    mesh.vertices.reserve(3 * triangles.size());
    mesh.across.assign(3 * triangles.size(), ChartMesh::none);
    for (const std::uint32_t triangle : triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            mesh.vertices.push_back(table.number(surface.positions[3 * std::size_t{triangle} + c], mesh.points));
        }
    }
    constexpr std::size_t grain = 4096;
    mesh.normals.resize(triangles.size());
    parallel_ranges(triangles.size(), grain, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t triangle = begin; triangle < end; ++triangle) {
            mesh.normals[triangle] = unit_normal(mesh, static_cast<std::uint32_t>(triangle));
        }
    });
    find_sides_across(mesh);
    const auto at = [&](std::uint32_t place) { return 3 * std::size_t{triangles[place / 3]} + place % 3; };
    mesh.creases.resize(mesh.across.size());
    parallel_ranges(mesh.across.size(), grain, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t side = begin; side < end; ++side) {
            mesh.creases[side] = is_crease(mesh, surface, static_cast<std::uint32_t>(side), at) ? 1 : 0;
        }
    });
    return mesh;
}

LaidTriangle lay_down(const ChartMesh& mesh, std::uint32_t side) {
    const glm::dvec3 a = mesh.corner(side);
    const glm::dvec3 along = mesh.corner(next_corner(side)) - a;
    const glm::dvec3 up = mesh.corner(last_corner(side)) - a;
    const double length = glm::length(along);
    return {length, glm::dot(along, up) / length, glm::length(glm::cross(along, up)) / length};
}

Distortion distortion(const LaidTriangle& triangle, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    const glm::dvec2 x = (b - a) / triangle.x1;
    const glm::dvec2 y = (c - a - x * triangle.x2) / triangle.y2;
    return {glm::dot(x, x) + glm::dot(y, y), x.x * y.y - x.y * y.x};
}

} // namespace vkbake
