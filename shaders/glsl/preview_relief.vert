// Vertices of surfaces whose normal map is lit by a directional light map.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "preview_vertex.glsl"

layout(set = 0, binding = 5, std430) readonly buffer Reliefs { float reliefs[]; };

layout(location = 4) out vec3 eye;
layout(location = 5) out vec3 normal;
layout(location = 6) out vec2 normal_uv;
layout(location = 7) out vec4 tangent;

vec3 triple(uint at) { return vec3(reliefs[at], reliefs[at + 1], reliefs[at + 2]); }

void main() {
    uint index = indices[gl_VertexIndex];
    uint first = index * PREVIEW_RELIEF_FLOATS;
    eye = put_vertex(index);
    normal = triple(first);
    normal_uv = triple(first + 3).xy;
    tangent = vec4(triple(first + 5), reliefs[first + 8]);
}
