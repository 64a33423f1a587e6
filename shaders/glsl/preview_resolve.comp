// Radiance of all samples of a pixel → its display value: exposed, tone-mapped, averaged, sRGB-encoded.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "preview.h"

layout(local_size_x = PREVIEW_GROUP, local_size_y = PREVIEW_GROUP) in;

layout(set = 0, binding = 0, rgba32f) uniform readonly image2D radiance;
layout(set = 0, binding = 1, rgba32f) uniform writeonly image2D picture;

layout(push_constant) uniform Constants { ResolveConstants constants; };

// Khronos PBR Neutral (KhronosGroup/ToneMapping, 2024): colours up to 0.8 keep their hue and saturation, what is brighter
// is compressed and drawn towards white.
vec3 tone_mapped(vec3 color) {
    const float compression_start = 0.8 - 0.04;
    const float desaturation = 0.15;
    float least = min(color.r, min(color.g, color.b));
    color -= least < 0.08 ? least - 6.25 * least * least : 0.04; // the Fresnel reflection that a grey base colour adds
    float peak = max(color.r, max(color.g, color.b));
    if (peak < compression_start) {
        return color;
    }
    const float room = 1.0 - compression_start;
    float compressed = 1.0 - room * room / (peak + room - compression_start);
    float towards_white = 1.0 - 1.0 / (desaturation * (peak - compressed) + 1.0);
    return mix(color * (compressed / peak), vec3(compressed), towards_white);
}

vec3 srgb_encoded(vec3 linear) {
    vec3 curve = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(constants.width, constants.height)))) {
        return;
    }
    // Tone-mapped before the average: one blinding sample must not take the whole pixel.
    vec3 sum = vec3(0.0);
    int samples = int(constants.samples);
    for (int y = 0; y < samples; ++y) {
        for (int x = 0; x < samples; ++x) {
            vec3 color = imageLoad(radiance, pixel * samples + ivec2(x, y)).rgb * constants.exposure;
            color = mix(color, vec3(0.0), isnan(color)); // a map may hold NaN; it shows black
            sum += tone_mapped(clamp(color, 0.0, 1e6));
        }
    }
    vec3 mean = clamp(sum / float(samples * samples), 0.0, 1.0);
    imageStore(picture, pixel, vec4(srgb_encoded(mean), 1.0));
}
