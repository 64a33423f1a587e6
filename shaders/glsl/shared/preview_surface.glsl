// What a surface sends to the eye: base colour × light + emission, linear.
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
vec3 bilinear(sampler2D map, vec2 uv) {
    ivec2 size = textureSize(map, 0);
    vec2 place = clamp(uv, 0.0, 1.0) * vec2(size) - 0.5;
    vec2 share = place - floor(place);
    ivec2 low = clamp(ivec2(floor(place)), ivec2(0), size - 1);
    ivec2 high = min(ivec2(floor(place)) + 1, size - 1);
    vec3 upper = mix(texelFetch(map, low, 0).rgb, texelFetch(map, ivec2(high.x, low.y), 0).rgb, share.x);
    vec3 lower = mix(texelFetch(map, ivec2(low.x, high.y), 0).rgb, texelFetch(map, high, 0).rgb, share.x);
    return mix(upper, lower, share.y);
}

vec4 textured_color() { return constants.base_color * color * texture(base_texture, base_uv); }

vec3 emitted_light() { return constants.emissive.rgb * texture(emissive_texture, emissive_uv).rgb; }

vec3 baked_light() {
    return constants.ambient.a > 0.0 ? constants.ambient.a * bilinear(light_map, light_uv) : constants.ambient.rgb;
}

vec4 shaded(vec4 textured, vec3 emitted, vec3 light) {
    if (constants.show == PREVIEW_SHOW_METERED) {
        return vec4(light, 1.0);
    }
    vec3 shown = constants.show == PREVIEW_SHOW_LIGHT_ONLY ? constants.base_color.rgb * light : textured.rgb * light + emitted;
    return vec4(shown, textured.a);
}
