// A scene's triangles as a camera sees them, ready for storage buffers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "preview/images.hpp"
#include "preview/relief.hpp"
#include "vkbake/scene.hpp"

namespace vkbake {

/// Texture coordinates are transformed already (KHR_texture_transform); 0 where a primitive has none.
struct PreviewVertex {
    glm::vec3 position; ///< eye space, metres: computed in double, so that a far-away scene loses no digits
    glm::vec2 base_uv;
    glm::vec2 emissive_uv;
    glm::vec2 light_uv;
    glm::vec4 color; ///< COLOR_0, linear
};

/// What fits a storage buffer's range.
struct PreviewChunk {
    std::vector<PreviewVertex> vertices;
    std::vector<PreviewRelief> reliefs; ///< one a vertex, or as many as the last one needs whose material has relief
    std::vector<std::uint32_t> indices; ///< into `vertices`, three a triangle
};

/// Consecutive indices of one material in one chunk.
struct PreviewDraw {
    std::uint32_t material = 0; ///< index in Scene::materials, or its size: glTF's default material
    std::uint32_t chunk = 0;
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
};

struct PreviewGeometry {
    std::vector<PreviewChunk> chunks;
    std::vector<PreviewDraw> draws; ///< OPAQUE and MASK by material, then BLEND
    std::size_t opaque_draws = 0;   ///< how many of the draws are not BLEND
    double near = 0.0;              ///< the depth, metres along the view, that no visible vertex is nearer than
    double far = 1.0;               ///< … or farther
};

/// What the light map's texture is for a material: MOZ_lightmap's, or its occlusion texture where `occlusion` asks for
/// those; null where it has none.
[[nodiscard]] const TextureUse* light_texture(const Material& material, bool occlusion);

/// All instances' triangles. BLEND ones are in the order of painting: primitives of instances by the middle of their
/// depths, farthest first, and so the triangles within each; what interpenetrates is not cut. A chunk has at most
/// `chunk_bytes` of vertices, and of indices. Vertices of materials that have a directional light map in `images` get
/// their relief; where they have no normals, each triangle has its own. Throws Error{bad_input} for indices that are
/// out of range.
[[nodiscard]] PreviewGeometry make_geometry(const Scene& scene, const Camera& camera, const PreviewImages& images,
                                            std::size_t chunk_bytes);

} // namespace vkbake
