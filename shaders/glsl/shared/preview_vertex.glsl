// Vertices of the baked scene, fetched by index.
#include "preview.h"

layout(set = 0, binding = 0, std430) readonly buffer Vertices { float vertices[]; };
layout(set = 0, binding = 1, std430) readonly buffer Indices { uint indices[]; };

layout(push_constant) uniform Constants { PreviewConstants constants; };

layout(location = 0) out vec2 base_uv;
layout(location = 1) out vec2 emissive_uv;
layout(location = 2) out vec2 light_uv;
layout(location = 3) out vec4 color;

vec2 pair(uint at) { return vec2(vertices[at], vertices[at + 1]); }

// Returns the place in eye space.
vec3 put_vertex(uint index) {
    uint first = index * PREVIEW_VERTEX_FLOATS;
    vec3 eye = vec3(pair(first), vertices[first + 2]);
    base_uv = pair(first + 3);
    emissive_uv = pair(first + 5);
    light_uv = pair(first + 7);
    color = vec4(pair(first + 9), pair(first + 11));
    float w = constants.depth.z * eye.z + constants.depth.w;
    gl_Position = vec4(constants.clip_scale * eye.xy + constants.clip_offset * w,
                       constants.depth.x * eye.z + constants.depth.y, w);
    return eye;
}
