// The plane of least squares through the light of the texels that differ from this one by no more than noise explains.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "denoise.glsl"

layout(set = 0, binding = 3, rgba32f) uniform readonly image2D guides;
layout(set = 0, binding = 4, rgba32f) uniform writeonly image2D fits;  // colour; variance, below 0: left alone
layout(set = 0, binding = 5, rgba32f) uniform writeonly image2D risks; // were the texels that count given; in full

bool indistinct(Texel a, Texel b, vec3 guide_a, vec3 guide_b, float more) {
    precise float apart = (b.facing.w - a.facing.w) - more;
    precise float means_apart = (guide_b.y - guide_a.y) - more * DENOISE_GUIDE_SHARE;
    precise float square = apart * apart;
    precise float square_of_means = means_apart * means_apart;
    precise float most = DENOISE_TEXEL_SIGMAS * (guide_a.x + guide_b.x) + DENOISE_TINY;
    precise float most_of_means = DENOISE_GUIDE_SIGMAS * (guide_a.z + guide_b.z) + DENOISE_TINY;
    return square <= most && square_of_means <= most_of_means;
}

// Sums that a plane is found from; vectors are (1, x, y) and (xx, xy, yy).
struct Moments {
    precise vec3 first;
    precise vec3 second;
};

const Moments no_moments = Moments(vec3(0.0), vec3(DENOISE_RIDGE, 0.0, DENOISE_RIDGE));

void add(inout Moments moments, vec2 off) {
    moments.first = moments.first + vec3(1.0, off);
    moments.second = moments.second + vec3(off.x * off.x, off.x * off.y, off.y * off.y);
}

// What the sums of values, of values times x, and times y count at offset (0, 0); by Cramer's rule.
vec3 cofactors(Moments moments) {
    precise float of_sum = moments.second.x * moments.second.z - moments.second.y * moments.second.y;
    precise float of_x = moments.second.y * moments.first.z - moments.first.y * moments.second.z;
    precise float of_y = moments.first.y * moments.second.y - moments.second.x * moments.first.z;
    return vec3(of_sum, of_x, of_y);
}

float reciprocal_determinant(Moments moments, vec3 of) {
    precise float determinant = (moments.first.x * of.x + moments.first.y * of.y) + moments.first.z * of.z;
    return plain_reciprocal(determinant);
}

float value_at_centre(Moments moments, vec3 sums) {
    vec3 of = cofactors(moments);
    precise float value = ((sums.x * of.x + sums.y * of.y) + sums.z * of.z) * reciprocal_determinant(moments, of);
    return value;
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (outside(at)) {
        return;
    }
    Texel texel = texel_at(at);
    vec3 guide = imageLoad(guides, at).xyz;
    precise vec4 fit = vec4(uintBitsToFloat(imageLoad(colors, at).rgb), -1.0);
    precise vec2 risk = vec2(texel.place.w);
    if (texel.chart != 0u && guide.x >= constants.good) {
        Moments light = no_moments;
        Moments brighter = no_moments;
        Moments darker = no_moments;
        precise vec3 color = vec3(0.0);
        precise vec3 color_x = vec3(0.0);
        precise vec3 color_y = vec3(0.0);
        precise vec3 bright_sums = vec3(0.0); // of luminance, times x, times y
        precise vec3 dark_sums = vec3(0.0);
        precise float variance = 0.0;
        precise float more = guide.x * plain_root_reciprocal(guide.x);
        ivec2 low = low_corner(at, DENOISE_FIT_RADIUS);
        ivec2 high = high_corner(at, DENOISE_FIT_RADIUS);
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                Texel other = texel_at(ivec2(x, y));
                if (!alike(texel, other)) {
                    continue;
                }
                vec3 other_guide = imageLoad(guides, other.at).xyz;
                vec2 off = vec2(other.at - at);
                float change = other.at == at ? more : 0.0;
                if (indistinct(texel, other, guide, other_guide, 0.0)) {
                    vec3 here = uintBitsToFloat(imageLoad(colors, other.at).rgb);
                    add(light, off);
                    color = color + here;
                    color_x = color_x + here * off.x;
                    color_y = color_y + here * off.y;
                    variance = variance + other.place.w;
                }
                if (indistinct(texel, other, guide, other_guide, more)) {
                    precise float value = other.facing.w + change;
                    add(brighter, off);
                    bright_sums = bright_sums + vec3(value, value * off.x, value * off.y);
                }
                if (indistinct(texel, other, guide, other_guide, -more)) {
                    precise float value = other.facing.w - change;
                    add(darker, off);
                    dark_sums = dark_sums + vec3(value, value * off.x, value * off.y);
                }
            }
        }
        vec3 of = cofactors(light);
        precise float reciprocal = reciprocal_determinant(light, of);
        precise vec3 fitted = ((color * of.x + color_x * of.y) + color_y * of.z) * reciprocal;
        fitted = max(fitted, vec3(0.0));
        precise float share = of.x * reciprocal;
        precise float off = dot_of(vec3(DENOISE_RED, DENOISE_GREEN, DENOISE_BLUE), fitted) - texel.facing.w;
        precise float rise = value_at_centre(brighter, bright_sums) - value_at_centre(darker, dark_sums);
        precise float full_share = rise * (0.5 * plain_reciprocal(more));
        precise float left = variance * plain_reciprocal(light.first.x) * share;
        risk = vec2(off * off - texel.place.w * (1.0 - 2.0 * share), off * off - texel.place.w * (1.0 - 2.0 * full_share));
        fit = vec4(fitted, left);
    }
    imageStore(fits, at, fit);
    imageStore(risks, at, vec4(risk, 0.0, 0.0));
}
