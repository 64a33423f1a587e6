// What the passes of the preview and the CPU share.
#ifndef VKBAKE_SHARED_PREVIEW_H
#define VKBAKE_SHARED_PREVIEW_H

#ifdef __cplusplus
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace vkbake {
using glm::vec2;
using glm::vec4;
using uint = std::uint32_t;
#endif

// Floats a vertex: position 3, base UV 2, emissive UV 2, light UV 2, colour 4.
#define PREVIEW_VERTEX_FLOATS 13

// Floats of what a normal map needs of a vertex: normal 3, UV 2, tangent 4.
#define PREVIEW_RELIEF_FLOATS 9

// What a surface shows: its radiance; that of base_color as it is, without texture and vertex colour but for alpha, and
// without emission; or the light that falls on it, alpha 1.
#define PREVIEW_SHOW_ALL 0u
#define PREVIEW_SHOW_LIGHT_ONLY 1u
#define PREVIEW_SHOW_METERED 2u

// Side of a work group of the resolve pass.
#define PREVIEW_GROUP 8

// One draw: a material, and how eye space goes to the clip space of a tile of the picture.
struct PreviewConstants {
    vec4 base_color;
    vec4 emissive;    // a: alpha below which a fragment is dropped; below 0: none is
    vec4 ambient;     // what lights a surface without light map; a: factor of the light map, 0 where there is none
    vec2 clip_scale;  // clip.xy = scale · eye.xy + offset · clip.w
    vec2 clip_offset;
    vec4 depth;       // clip.z = x · eye.z + y; clip.w = z · eye.z + w
    vec4 orientation; // a unit quaternion that turns eye space into the world's axes
    uint show;        // one of PREVIEW_SHOW_…
    float normal_scale;
    uint unused_0;    // to a multiple of 16 bytes, which GLSL would add unasked
    uint unused_1;
};

struct ResolveConstants {
    uint width; // pixels of the tile
    uint height;
    uint samples; // along each side of a pixel
    float exposure; // factor
};

#ifdef __cplusplus
} // namespace vkbake
#endif
#endif
