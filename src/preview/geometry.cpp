#include "preview/geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "base/texture_transform.hpp"
#include "preview/camera.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr std::uint32_t not_yet = std::numeric_limits<std::uint32_t>::max();

/// One primitive of one instance.
struct Piece {
    const Instance* instance = nullptr;
    const Primitive* primitive = nullptr;
    std::uint32_t material = 0;
    std::optional<ReliefTransform> relief = {}; ///< where the material has a normal map that is drawn
    std::vector<glm::dvec3> eye = {};           ///< its vertices in eye space
    std::vector<Triangle> triangles = {};       ///< in the order of drawing
};

const TextureUse* pointer_to(const std::optional<TextureUse>& use) { return use ? &*use : nullptr; }

glm::vec2 uv_of(const Primitive& primitive, const TextureUse* use, std::size_t vertex) {
    if (use == nullptr || use->tex_coord >= primitive.tex_coords.size()) {
        return glm::vec2(0.0F);
    }
    const std::vector<glm::vec2>& set = primitive.tex_coords[use->tex_coord];
    return vertex < set.size() ? glm::vec2(TextureTransform(*use)(set[vertex])) : glm::vec2(0.0F);
}

/// Of no particular length, in the mesh's space.
glm::dvec3 flat_normal(const Primitive& primitive, const Triangle& triangle) {
    const glm::dvec3 first(primitive.positions[triangle[0]]);
    return glm::cross(glm::dvec3(primitive.positions[triangle[1]]) - first,
                      glm::dvec3(primitive.positions[triangle[2]]) - first);
}

void make_ready(Piece& piece, const Camera& camera, const std::string& scene_name) {
    const Primitive& primitive = *piece.primitive;
    piece.eye.reserve(primitive.positions.size());
    for (const glm::vec3& position : primitive.positions) {
        piece.eye.push_back(
            to_eye(camera, piece.instance->linear * glm::dvec3(position) + piece.instance->translation));
    }
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const Triangle triangle{primitive.indices[i], primitive.indices[i + 1], primitive.indices[i + 2]};
        if (std::ranges::max(triangle) >= primitive.positions.size()) {
            throw Error(ErrorKind::bad_input,
                        scene_name + ": an index of node '" + piece.instance->name + "' is out of range; repair it");
        }
        piece.triangles.push_back(triangle);
    }
}

/// Farthest first; the order of the file where two are equally far.
void sort_triangles(Piece& piece) {
    const auto height = [&](const Triangle& triangle) {
        return piece.eye[triangle[0]].z + piece.eye[triangle[1]].z + piece.eye[triangle[2]].z;
    };
    std::ranges::stable_sort(piece.triangles, std::less{}, height);
}

double middle(const Piece& piece) {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    for (const glm::dvec3& eye : piece.eye) {
        low = std::min(low, eye.z);
        high = std::max(high, eye.z);
    }
    return 0.5 * low + 0.5 * high;
}

class Builder {
public:
    Builder(const Scene& scene, const PreviewImages& images, std::size_t chunk_bytes)
        : m_scene(scene), m_images(images),
          m_vertex_limit(std::max<std::size_t>(chunk_bytes / sizeof(PreviewVertex), 3)),
          m_index_limit(std::max<std::size_t>(chunk_bytes / sizeof(std::uint32_t), 3)) {}

    void add(const Piece& piece) {
        m_places.assign(piece.eye.size(), not_yet);
        const bool flat = piece.relief && piece.primitive->normals.empty();
        for (const Triangle& triangle : piece.triangles) {
            open_chunk_for_triangle();
            open_draw(piece.material);
            glm::dvec3 normal(0.0);
            if (flat) {
                normal = flat_normal(*piece.primitive, triangle);
                std::ranges::for_each(triangle, [&](std::uint32_t vertex) { m_places[vertex] = not_yet; });
            }
            for (const std::uint32_t vertex : triangle) {
                chunk().indices.push_back(place_of(piece, vertex, normal));
            }
            m_geometry.draws.back().index_count += 3;
        }
    }

    /// What comes after is BLEND: a new draw even where the material is the same.
    void end_opaque() { m_geometry.opaque_draws = m_geometry.draws.size(); }

    /// What lies behind the eye does not count. The factor keeps depth's range within a float's.
    PreviewGeometry finish(const Camera& camera) {
        m_geometry.far = m_farthest > 0.0 ? m_farthest * 1.001 : 1.0;
        m_geometry.near = std::max({camera.near_plane, 0.999 * m_nearest, m_geometry.far * 1e-6});
        m_geometry.far = std::max(m_geometry.far, m_geometry.near * 1.001);
        return std::move(m_geometry);
    }

private:
    PreviewChunk& chunk() { return m_geometry.chunks.back(); }

    void open_chunk_for_triangle() {
        if (m_geometry.chunks.empty() || chunk().vertices.size() + 3 > m_vertex_limit ||
            chunk().indices.size() + 3 > m_index_limit) {
            m_geometry.chunks.emplace_back();
            std::ranges::fill(m_places, not_yet);
        }
    }

    void open_draw(std::uint32_t material) {
        const auto in_chunk = static_cast<std::uint32_t>(m_geometry.chunks.size() - 1);
        std::vector<PreviewDraw>& draws = m_geometry.draws;
        if (draws.size() == m_geometry.opaque_draws || draws.back().material != material ||
            draws.back().chunk != in_chunk) {
            draws.push_back({material, in_chunk, static_cast<std::uint32_t>(chunk().indices.size()), 0});
        }
    }

    std::uint32_t place_of(const Piece& piece, std::uint32_t vertex, const glm::dvec3& flat) {
        if (m_places[vertex] == not_yet) {
            m_places[vertex] = static_cast<std::uint32_t>(chunk().vertices.size());
            m_nearest = std::min(m_nearest, -piece.eye[vertex].z);
            m_farthest = std::max(m_farthest, -piece.eye[vertex].z);
            const Primitive& primitive = *piece.primitive;
            const Material* const material =
                piece.material < m_scene.materials.size() ? &m_scene.materials[piece.material] : nullptr;
            PreviewVertex made{.position = glm::vec3(piece.eye[vertex]),
                               .base_uv = glm::vec2(0.0F),
                               .emissive_uv = glm::vec2(0.0F),
                               .light_uv = glm::vec2(0.0F),
                               .color = vertex < primitive.colors.size() ? primitive.colors[vertex] : glm::vec4(1.0F)};
            if (material != nullptr) {
                made.base_uv = uv_of(primitive, pointer_to(material->base_color_texture), vertex);
                made.emissive_uv = uv_of(primitive, pointer_to(material->emissive_texture), vertex);
                made.light_uv = uv_of(primitive, light_texture(*material, m_images.occlusion), vertex);
            }
            if (piece.relief) {
                const glm::vec2 uv = uv_of(primitive, &material->normal_map->texture, vertex);
                chunk().reliefs.resize(chunk().vertices.size()); // those before may have none
                chunk().reliefs.push_back(piece.relief->of(primitive, vertex, flat, uv));
            }
            chunk().vertices.push_back(made);
        }
        return m_places[vertex];
    }

    const Scene& m_scene;
    const PreviewImages& m_images;
    std::size_t m_vertex_limit;
    std::size_t m_index_limit;
    PreviewGeometry m_geometry;
    std::vector<std::uint32_t> m_places; ///< of the piece's vertices in the chunk
    double m_nearest = std::numeric_limits<double>::max();
    double m_farthest = std::numeric_limits<double>::lowest();
};

} // namespace

const TextureUse* light_texture(const Material& material, bool occlusion) {
    if (occlusion) {
        return pointer_to(material.occlusion_texture);
    }
    return material.light_map ? &material.light_map->texture : nullptr;
}

PreviewGeometry make_geometry(const Scene& scene, const Camera& camera, const PreviewImages& images,
                              std::size_t chunk_bytes) {
    std::vector<Piece> opaque;
    std::vector<Piece> blended;
    const auto default_material = static_cast<std::uint32_t>(scene.materials.size());
    for (const Instance& instance : scene.instances) {
        for (const Primitive& primitive : scene.meshes.at(instance.mesh).primitives) {
            const std::uint32_t material = std::min(primitive.material.value_or(default_material), default_material);
            const bool blends = material < default_material && scene.materials[material].alpha_mode == AlphaMode::blend;
            std::vector<Piece>& pieces = blends ? blended : opaque;
            pieces.push_back({.instance = &instance, .primitive = &primitive, .material = material});
            if (images.relief_of(material) != PreviewImages::none) {
                pieces.back().relief.emplace(instance, camera);
            }
            make_ready(pieces.back(), camera, scene.name);
        }
    }
    std::ranges::stable_sort(opaque, std::less{}, &Piece::material);
    std::ranges::for_each(blended, sort_triangles);
    std::ranges::stable_sort(blended, std::less{}, middle); // eye space looks along −Z: the least is the farthest

    Builder builder(scene, images, chunk_bytes);
    std::ranges::for_each(opaque, [&](const Piece& piece) { builder.add(piece); });
    builder.end_opaque();
    std::ranges::for_each(blended, [&](const Piece& piece) { builder.add(piece); });
    return builder.finish(camera);
}

} // namespace vkbake
