// What is baked: meshes, their instances and materials. Made by load_scene, or by hand.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "vkbake/lamp.hpp"
#include "vkbake/light_probe.hpp"

namespace vkbake {

/// An image as its file holds it. Decoded only where something needs it.
struct EncodedImage {
    std::string name;
    std::string mime_type; ///< "image/png", "image/jpeg", …; empty: to be found from the bytes
    std::vector<std::byte> bytes;
};

enum class Wrap : std::uint8_t { repeat, clamp, mirror };
enum class Filter : std::uint8_t { linear, nearest };

/// A texture as a material uses it. uv' = offset + rotate(rotation) · (scale · uv)  (KHR_texture_transform).
struct TextureUse {
    std::uint32_t image = 0;     ///< index in Scene::images
    std::uint32_t tex_coord = 0; ///< which TEXCOORD_n
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    Filter filter = Filter::linear; ///< where a texel covers more than a pixel (glTF's magFilter)
    glm::vec2 offset{0.0F};
    float rotation = 0.0F; ///< radians, counter-clockwise in glTF's sense
    glm::vec2 scale{1.0F};
};

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// The light map that a baked material refers to (MOZ_lightmap, extras.vkbake).
struct LightMapUse {
    TextureUse texture; ///< sRGB 8-bit; irradiance E = intensity × linear value
    float intensity = 1.0F;
    std::string linear_file; ///< the EXR with E/π, relative to the scene's file; empty: none named
    std::array<std::string, 4> directional_files; ///< of its directional light map, alike; empty: it has none
};

/// Tangent space: x and y of 2 · rgb − 1 are multiplied by `scale`. Linear.
struct NormalMapUse {
    TextureUse texture;
    float scale = 1.0F;
};

struct Material {
    std::string name;
    glm::vec4 base_color{1.0F}; ///< linear
    std::optional<TextureUse> base_color_texture;
    float metallic = 0.0F; ///< 0 … 1: of metal, which reflects nothing diffusely. (glTF's own default is 1.)
    std::optional<TextureUse> metallic_texture; ///< blue channel, linear: multiplies `metallic`
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5F; ///< MASK: from here on a point is opaque
    float transmission = 0.0F; ///< 0 … 1: of what does not reflect, the share that passes, coloured by the base colour
    std::optional<TextureUse> transmission_texture; ///< red channel, linear: multiplies `transmission`
    bool double_sided = false;
    glm::vec3 emissive{0.0F}; ///< linear
    std::optional<TextureUse> emissive_texture;
    std::optional<LightMapUse> light_map;
    std::optional<TextureUse> occlusion_texture; ///< where an `ao` bake is referenced, or a bent normal's length
    std::string bent_normal_file; ///< the EXR of a `bent-normal` bake, relative to the scene's file; empty: none named
    std::optional<NormalMapUse> normal_map;
};

/// Triangles of one material, in the mesh's own space (metres, +Y up).
struct Primitive {
    std::vector<glm::vec3> positions; ///< one a vertex, finite
    std::vector<glm::vec3> normals;   ///< one a vertex, any length but 0; empty: flat normals
    std::vector<glm::vec4> tangents;  ///< along the normal map's u; w: ±1, so that up in it is w · normal × tangent.
                                      ///< Read where a directional light map needs them; empty: u and v tell
    std::array<std::vector<glm::vec2>, 4> tex_coords; ///< TEXCOORD_0 … 3; empty where absent, otherwise one a vertex
    std::vector<glm::vec4> colors;                    ///< COLOR_0, linear; empty where absent
    std::vector<std::uint32_t> indices; ///< three a triangle, counter-clockwise seen from the front; < positions.size()
    std::optional<std::uint32_t> material; ///< index in Scene::materials; absent: glTF's default material
    std::uint32_t source_primitive = 0; ///< index among the source mesh's primitives (some are skipped: points, lines)
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives; ///< may be empty
    std::uint32_t source_mesh = 0;     ///< index in the source document's meshes
};

/// A mesh put into the world: world = linear · v + translation, composed in double precision over all parent nodes.
struct Instance {
    std::string name;       ///< the node's name, or "node N"; not unique
    std::uint32_t mesh = 0; ///< index in Scene::meshes
    glm::dmat3 linear{1.0}; ///< rotation, scale, shear; a negative determinant turns the winding
    glm::dvec3 translation{0.0};
    double density = 1.0; ///< light-map texels along a metre, as a multiple of what other objects get; finite, > 0
    std::uint32_t source_node = 0; ///< index in the source document's nodes
};

/// A perspective (or orthographic) camera. Looks along its −Z, +Y up.
struct Camera {
    std::string name;
    glm::dmat3 orientation{1.0}; ///< columns: right, up, backward; orthonormal
    glm::dvec3 position{0.0};
    double vertical_field_of_view = 0.8; ///< radians; 0 for an orthographic camera
    double vertical_extent = 0.0;        ///< metres, orthographic only: the height of the view
    double near_plane = 0.01;            ///< metres
};

/// The source document made plain: one buffer, no compression, no sparse accessor, every image embedded.
/// It is what write_bake puts the light maps into, so that nothing of the source is lost.
struct SourceDocument {
    std::string json; ///< glTF 2.0 JSON, UTF-8; accessors and images point into `binary`
    std::vector<std::byte> binary;
};

struct Scene {
    std::string name; ///< the file's stem
    std::vector<Mesh> meshes;
    std::vector<Instance> instances; ///< in document order of the default scene's nodes, depth first
    std::vector<Material> materials;
    std::vector<EncodedImage> images;
    std::vector<Camera> cameras;
    std::vector<Lamp> lamps;        ///< in the instances' order of nodes
    std::vector<ProbePlace> probes; ///< in the same order
    std::vector<std::string> notes; ///< what was left out or looks odd, a line each
    std::optional<SourceDocument>
        source;            ///< absent for scenes made by hand: they can be baked, and written as images only
    std::string directory; ///< where the scene's file lies; empty for scenes made by hand
};

} // namespace vkbake
