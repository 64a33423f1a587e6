// What the fits around each texel are worth: the mean of their risks, or that the texel is to stay as it was.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "denoise.glsl"

layout(set = 0, binding = 3, rgba32f) uniform readonly image2D fits;
layout(set = 0, binding = 4, rgba32f) uniform readonly image2D risks;
layout(set = 0, binding = 5, r32f) uniform writeonly image2D chosen;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (outside(at)) {
        return;
    }
    Texel texel = texel_at(at);
    precise float result = DENOISE_ALONE;
    if (texel.chart != 0u && imageLoad(fits, at).a >= 0.0) {
        precise vec2 risk = vec2(0.0);
        precise float without = 0.0;
        precise float count = 0.0;
        ivec2 low = low_corner(at, DENOISE_RISK_RADIUS);
        ivec2 high = high_corner(at, DENOISE_RISK_RADIUS);
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                Texel other = texel_at(ivec2(x, y));
                if (alike(texel, other)) {
                    risk = risk + imageLoad(risks, other.at).rg;
                    without = without + other.place.w;
                    count = count + 1.0;
                }
            }
        }
        if (risk.x <= without) {
            result = risk.y * plain_reciprocal(count);
        }
    }
    imageStore(chosen, at, vec4(result, 0.0, 0.0, 0.0));
}
