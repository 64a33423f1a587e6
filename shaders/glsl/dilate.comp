// One round of dilation: every texel of `source` goes to `target`; an empty one takes the average of its filled neighbours.
// Texels travel as bits, since a float load may quieten a NaN or flush a denormal.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "dilate.h"

layout(local_size_x = DILATE_GROUP, local_size_y = DILATE_GROUP) in;

layout(set = 0, binding = 0, rgba32ui) uniform readonly uimage2D source;
layout(set = 0, binding = 1, rgba32ui) uniform writeonly uimage2D target;
// 1 where the round before filled a texel, entry 0 standing for the state before the first.
layout(set = 0, binding = 2, std430) buffer Progress { uint filled[]; };

layout(push_constant) uniform Constants { DilateConstants constants; };

const float reciprocals[9] = DILATE_RECIPROCALS;
const uint exponent_mask = 0x7F800000u;

vec3 without_tiny(vec3 value) { return mix(value, vec3(0.0), lessThan(abs(value), vec3(DILATE_TINY))); }

// A neighbour that has a value, and one that can be averaged: not infinite, not NaN.
bool counts(uvec4 texel) {
    return (texel.a << 1) != 0u && all(notEqual(texel.rgb & exponent_mask, uvec3(exponent_mask)));
}

void main() {
    ivec2 size = ivec2(constants.width, constants.height);
    ivec2 place = ivec2(gl_GlobalInvocationID.xy);
    // After a round that filled nothing both images hold the same for good.
    if (any(greaterThanEqual(place, size)) || filled[constants.round] == 0u) {
        return;
    }
    uvec4 texel = imageLoad(source, place);
    if ((texel.a << 1) == 0u) {
        precise vec3 sum = vec3(0.0);
        vec3 least = vec3(3.40282347e38);
        vec3 largest = vec3(-3.40282347e38);
        int count = 0;
        ivec2 low = max(place - 1, ivec2(0));
        ivec2 high = min(place + 1, size - 1);
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                uvec4 neighbour = imageLoad(source, ivec2(x, y));
                if (counts(neighbour)) {
                    precise vec3 value = without_tiny(uintBitsToFloat(neighbour.rgb));
                    sum = without_tiny(sum + value);
                    least = min(least, value);
                    largest = max(largest, value);
                    ++count;
                }
            }
        }
        if (count > 0) {
            precise vec3 average = sum * reciprocals[count];
            texel = uvec4(floatBitsToUint(min(max(average, least), largest)), floatBitsToUint(1.0));
            atomicOr(filled[constants.round + 1u], 1u);
        }
    }
    imageStore(target, place, texel);
}
