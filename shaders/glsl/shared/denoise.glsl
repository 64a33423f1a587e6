// What the denoising passes do alike. Everything is precise: the bits are those of correctly rounded additions and
// multiplications on every device.
#include "denoise.h"

layout(local_size_x = DENOISE_GROUP, local_size_y = DENOISE_GROUP) in;

layout(set = 0, binding = 0, rgba32ui) uniform readonly uimage2D colors; // a: the chart's number + 1, or 0
layout(set = 0, binding = 1, rgba32f) uniform readonly image2D places;   // position; variance
layout(set = 0, binding = 2, rgba32f) uniform readonly image2D facings;  // normal; luminance

layout(push_constant) uniform Constants { DenoiseConstants constants; };

struct Texel {
    ivec2 at;
    uint chart;
    vec4 place;
    vec4 facing;
};

Texel texel_at(ivec2 at) { return Texel(at, imageLoad(colors, at).a, imageLoad(places, at), imageLoad(facings, at)); }

bool outside(ivec2 at) { return at.x >= int(constants.width) || at.y >= int(constants.height); }

ivec2 low_corner(ivec2 at, int radius) { return max(at - radius, ivec2(0)); }
ivec2 high_corner(ivec2 at, int radius) {
    return min(at + radius, ivec2(constants.width, constants.height) - 1);
}

float dot_of(vec3 a, vec3 b) {
    precise float sum = (a.x * b.x + a.y * b.y) + a.z * b.z;
    return sum;
}

// Whether both lie on one smooth piece of surface.
bool alike(Texel a, Texel b) {
    precise vec3 step = b.place.xyz - a.place.xyz;
    precise vec3 normals = a.facing.xyz + b.facing.xyz;
    float rise = dot_of(normals, step);
    precise float square = rise * rise;
    precise float most = 4.0 * DENOISE_MOST_SLOPE * dot_of(step, step) + DENOISE_TINY;
    return a.chart == b.chart && dot_of(a.facing.xyz, b.facing.xyz) >= DENOISE_LEAST_COSINE && square <= most;
}

// 1 / x of additions and multiplications alone: Newton's iteration from a guess by the exponent.
float plain_reciprocal(float x) {
    precise float guess = uintBitsToFloat(0x7EF311C3u - floatBitsToUint(x));
    for (int i = 0; i < 4; ++i) {
        guess = guess * (2.0 - x * guess);
    }
    return guess;
}

// 1 / sqrt(x), likewise.
float plain_root_reciprocal(float x) {
    precise float guess = uintBitsToFloat(0x5F375A86u - (floatBitsToUint(x) >> 1));
    precise float half_x = 0.5 * x;
    for (int i = 0; i < 4; ++i) {
        guess = guess * (1.5 - (half_x * guess) * guess);
    }
    return guess;
}
