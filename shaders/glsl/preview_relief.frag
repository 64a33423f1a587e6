// Surfaces whose normal map is lit by a directional light map.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "preview_surface.glsl"
#include "vkbake_light.h"

layout(set = 0, binding = 6) uniform sampler2D map_sh0;
layout(set = 0, binding = 7) uniform sampler2D map_sh1;
layout(set = 0, binding = 8) uniform sampler2D map_sh2;
layout(set = 0, binding = 9) uniform sampler2D map_sh3;
layout(set = 0, binding = 10) uniform sampler2D normal_map;

layout(location = 4) in vec3 eye;
layout(location = 5) in vec3 normal;
layout(location = 6) in vec2 normal_uv;
layout(location = 7) in vec4 tangent;

// The normal map's, eye space. Where a scene brings no tangents, u's is found from how the place changes across the pixels;
// like that of MikkTSpace it is made square to the normal, and the other one square to both. Up in the map is where v falls.
vec3 bumped(vec3 surface_normal) {
    vec3 eye_x = dFdx(eye);
    vec3 eye_y = dFdy(eye);
    vec2 uv_x = dFdx(normal_uv);
    vec2 uv_y = dFdy(normal_uv);
    vec3 bump = 2.0 * texture(normal_map, normal_uv).xyz - 1.0;
    bump.xy *= constants.normal_scale;
    vec3 along = tangent.xyz;
    float handedness = tangent.w;
    if (handedness == 0.0) {
        float turn = uv_x.x * uv_y.y - uv_y.x * uv_x.y < 0.0 ? -1.0 : 1.0;
        along = turn * (eye_x * uv_y.y - eye_y * uv_x.y);
        vec3 down = turn * (eye_y * uv_x.x - eye_x * uv_y.x);
        handedness = dot(cross(surface_normal, along), down) > 0.0 ? -1.0 : 1.0;
    }
    along -= surface_normal * dot(surface_normal, along);
    float size = length(along);
    if (!(size > 0.0)) {
        return surface_normal; // no u, no direction
    }
    along /= size;
    return normalize(along * bump.x + handedness * cross(surface_normal, along) * bump.y + surface_normal * bump.z);
}

vec3 to_world(vec3 vector) {
    vec3 axis = constants.orientation.xyz;
    return vector + 2.0 * cross(axis, cross(axis, vector) + constants.orientation.w * vector);
}

void main() {
    vec4 textured = textured_color();
    vec3 emitted = emitted_light();
    vec3 surface_normal = normalize(normal);
    vec3 mapped_normal = bumped(surface_normal);
    if (textured.a < constants.emissive.a) {
        discard;
    }
    vec3 light = vkbake_directional_light(baked_light(), bilinear(map_sh0, light_uv), bilinear(map_sh1, light_uv),
                                          bilinear(map_sh2, light_uv), bilinear(map_sh3, light_uv),
                                          to_world(surface_normal), to_world(mapped_normal));
    radiance = shaded(textured, emitted, light);
}
