// Outgoing radiance: base colour × light map + emission, linear.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "preview.h"

layout(set = 0, binding = 2) uniform sampler2D base_texture;
layout(set = 0, binding = 3) uniform sampler2D emissive_texture;
layout(set = 0, binding = 4) uniform sampler2D light_map;

layout(push_constant) uniform Constants { PreviewConstants constants; };

layout(location = 0) in vec2 base_uv;
layout(location = 1) in vec2 emissive_uv;
layout(location = 2) in vec2 light_uv;
layout(location = 3) in vec4 color;

layout(location = 0) out vec4 radiance;

// Bilinear between texel centres, held at the borders. By hand: not every device filters 32-bit floats, and those that do
// round the weights to 8 bits.
vec3 light_at(vec2 uv) {
    ivec2 size = textureSize(light_map, 0);
    vec2 place = clamp(uv, 0.0, 1.0) * vec2(size) - 0.5;
    vec2 share = place - floor(place);
    ivec2 low = clamp(ivec2(floor(place)), ivec2(0), size - 1);
    ivec2 high = min(ivec2(floor(place)) + 1, size - 1);
    vec3 upper = mix(texelFetch(light_map, low, 0).rgb, texelFetch(light_map, ivec2(high.x, low.y), 0).rgb, share.x);
    vec3 lower = mix(texelFetch(light_map, ivec2(low.x, high.y), 0).rgb, texelFetch(light_map, high, 0).rgb, share.x);
    return mix(upper, lower, share.y);
}

void main() {
    vec4 textured = constants.base_color * color * texture(base_texture, base_uv);
    vec3 emitted = constants.emissive.rgb * texture(emissive_texture, emissive_uv).rgb;
    if (textured.a < constants.emissive.a) {
        discard;
    }
    vec3 base = textured.rgb;
    if (constants.show == PREVIEW_SHOW_LIGHT_ONLY) {
        base = constants.base_color.rgb;
        emitted = vec3(0.0);
    }
    vec3 light = constants.ambient.rgb;
    if (constants.ambient.a > 0.0) {
        light = constants.ambient.a * light_at(light_uv);
    }
    radiance = constants.show == PREVIEW_SHOW_METERED ? vec4(light, 1.0) : vec4(base * light + emitted, textured.a);
}
