// What surrounds each texel: the mean of the variances, the mean of the luminances, and its variance.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "denoise.glsl"

layout(set = 0, binding = 3, rgba32f) uniform writeonly image2D guides;

const float reciprocals[10] = DENOISE_RECIPROCALS;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (outside(at)) {
        return;
    }
    Texel texel = texel_at(at);
    precise vec3 guide = vec3(0.0);
    if (texel.chart != 0u) {
        precise float variance = 0.0;
        precise float mean = 0.0;
        int count = 0;
        ivec2 low = low_corner(at, DENOISE_GUIDE_RADIUS);
        ivec2 high = high_corner(at, DENOISE_GUIDE_RADIUS);
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                Texel other = texel_at(ivec2(x, y));
                if (alike(texel, other)) {
                    variance = variance + other.place.w;
                    mean = mean + other.facing.w;
                    ++count;
                }
            }
        }
        variance = variance * reciprocals[count];
        guide = vec3(variance, mean * reciprocals[count], variance * reciprocals[count]);
    }
    imageStore(guides, at, vec4(guide, 0.0));
}
