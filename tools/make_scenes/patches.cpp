// From solids to vertices: the grid, the normals, the texture coordinates.
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

#include "make_scenes/document.hpp"
#include "make_scenes/textures.hpp"

namespace vkbake::scenes {
namespace {

// Points that different shapes meant to be the same become so, whatever their last bits.
glm::dvec3 on_grid(const glm::dvec3& p) {
    constexpr double steps = 16384.0;
    // + 0.0 makes −0 to 0: equal positions are to have equal bytes.
    return {std::nearbyint(p.x * steps) / steps + 0.0, std::nearbyint(p.y * steps) / steps + 0.0,
            std::nearbyint(p.z * steps) / steps + 0.0};
}

class SolidNormals {
public:
    explicit SolidNormals(const Solid& solid) : m_solid(&solid), m_around(solid.points.size()) {
        for (const glm::dvec3& p : solid.points) {
            m_points.push_back(on_grid(p));
        }
        for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
            const auto& c = solid.triangles[t].corners;
            const glm::dvec3 across = glm::cross(m_points[c[1]] - m_points[c[0]], m_points[c[2]] - m_points[c[0]]);
            m_faces.push_back(unit(across));
            for (const std::uint32_t corner : c) {
                m_around[corner].push_back(t);
            }
        }
    }

    [[nodiscard]] const glm::dvec3& point(std::uint32_t index) const { return m_points[index]; }
    [[nodiscard]] const glm::dvec3& face(std::size_t triangle) const { return m_faces[triangle]; }

    /// The mean of the faces around the corner that are not across a crease, weighted by the length of their cross
    /// product over both edges' lengths (the sine of their angle there): how a shape is cut into triangles matters
    /// little.
    [[nodiscard]] glm::dvec3 corner(std::size_t triangle, std::uint32_t point_index) const {
        glm::dvec3 sum(0.0);
        for (const std::size_t other : m_around[point_index]) {
            if (glm::dot(m_faces[other], m_faces[triangle]) >= m_solid->crease_cosine) {
                sum += sine_at(other, point_index) * m_faces[other];
            }
        }
        return unit(sum);
    }

private:
    [[nodiscard]] double sine_at(std::size_t triangle, std::uint32_t point_index) const {
        const auto& c = m_solid->triangles[triangle].corners;
        const std::size_t k = c[0] == point_index ? 0 : (c[1] == point_index ? 1 : 2);
        const glm::dvec3 a = unit(m_points[c[(k + 1) % 3]] - m_points[point_index]);
        const glm::dvec3 b = unit(m_points[c[(k + 2) % 3]] - m_points[point_index]);
        return glm::length(glm::cross(a, b));
    }

    const Solid* m_solid;
    std::vector<std::vector<std::size_t>> m_around;
    std::vector<glm::dvec3> m_points;
    std::vector<glm::dvec3> m_faces;
};

// Fibres run along v. On an end grain, where they meet the face head on, any direction will do.
glm::vec2 texture_coordinate(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& grain, double shift) {
    glm::dvec3 along = grain - glm::dot(grain, normal) * normal;
    if (glm::dot(along, along) < 0.01 * glm::dot(grain, grain)) {
        const glm::dvec3 other = std::fabs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
        along = other - glm::dot(other, normal) * normal;
    }
    const glm::dvec3 v = unit(along);
    const glm::dvec3 u = glm::cross(v, normal);
    return glm::vec2(glm::dot(point, u) + shift, shift - glm::dot(point, v)) / static_cast<float>(texture_metres);
}

using VertexKey = std::tuple<float, float, float, float, float, float, float, float>;

struct PatchInProgress {
    Patch patch;
    std::map<VertexKey, std::uint32_t> vertices;
};

void add_vertex(PatchInProgress& made, const glm::vec3& p, const glm::vec3& n, const glm::vec2& uv, bool textured) {
    const VertexKey key{p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y};
    const auto [found, is_new] =
        made.vertices.try_emplace(key, static_cast<std::uint32_t>(made.patch.positions.size()));
    if (is_new) {
        made.patch.positions.push_back(p);
        made.patch.normals.push_back(n);
        if (textured) {
            made.patch.tex_coords_0.push_back(uv);
        }
    }
    made.patch.indices.push_back(found->second);
}

} // namespace

std::vector<Patch> patches_of(const Model& model) {
    std::map<Paint, PatchInProgress> by_paint;
    for (std::size_t s = 0; s < model.solids.size(); ++s) {
        const Solid& solid = model.solids[s];
        const SolidNormals normals(solid);
        const double shift = random_of(static_cast<std::uint32_t>(s));
        for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
            const Triangle& triangle = solid.triangles[t];
            PatchInProgress& made = by_paint[triangle.paint];
            const bool textured = paint_info(triangle.paint).texture != Texture::none;
            for (const std::uint32_t corner : triangle.corners) {
                const glm::dvec3 point = normals.point(corner);
                const glm::vec2 uv =
                    textured ? texture_coordinate(point, normals.face(t), solid.grain, shift) : glm::vec2(0.0F);
                add_vertex(made, glm::vec3(point), glm::vec3(normals.corner(t, corner)), uv, textured);
            }
        }
    }
    std::vector<Patch> patches;
    for (auto& [paint, made] : by_paint) {
        made.patch.paint = paint;
        patches.push_back(std::move(made.patch));
    }
    return patches;
}

} // namespace vkbake::scenes
