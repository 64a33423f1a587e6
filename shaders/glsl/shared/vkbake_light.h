// Evaluates what vkbake bakes beside light maps: for renderers. GLSL 4.50 and C++ with GLM; needs no other file.
//
// Spherical harmonics are real and orthonormal, without the sign (−1)^m, of directions in glTF's world axes, in the order
// (l, m) = (0,0) (1,−1) (1,0) (1,1) (2,−2) (2,−1) (2,0) (2,1) (2,2):
//
//     0.282095 · 1,  0.488603 · y z x,  1.092548 · xy yz,  0.315392 · (3z² − 1),  1.092548 · xz,  0.546274 · (x² − y²)
//
// A coefficient is ∫ L(ω) Y(ω) dω of the radiance that arrives (P. Sloan, Stupid Spherical Harmonics Tricks, GDC 2008).
// What the functions return is E/π, as a light map's texel: outgoing radiance = base colour × it. Normals are unit.
#ifndef VKBAKE_LIGHT_H
#define VKBAKE_LIGHT_H

#ifdef __cplusplus
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec3.hpp>
namespace vkbake::shared {
using glm::max;
using glm::min;
using glm::pow;
using glm::sqrt;
using glm::vec3;
#define VKBAKE_LIGHT_FUNCTION inline
#else
#define VKBAKE_LIGHT_FUNCTION
#endif

// By the bands l ≤ 1 alone: E/π = Σ A_l/π · L_lm Y_lm(n) with A_0 = π, A_1 = 2π/3 (R. Ramamoorthi, P. Hanrahan, An Efficient
// Representation for Irradiance Environment Maps, SIGGRAPH 2001). Light from one side leaves a negative lobe, which is cut off.
VKBAKE_LIGHT_FUNCTION vec3 vkbake_irradiance_sh1(vec3 sh0, vec3 sh1, vec3 sh2, vec3 sh3, vec3 normal) {
    return max(0.282094792f * sh0 + 0.325735008f * (sh1 * normal.y + sh2 * normal.z + sh3 * normal.x), vec3(0.0f));
}

// Of a light-map texel (E/π) and its four directional texels, the light for another normal, as a normal map gives it.
// `surface_normal`: the one that was baked, interpolated from the vertices.
//
// Where the light comes from decides, not how much there is: with V = ∫ L ω dω and U = ∫ L dω, r = |V| / U and d = V / |V|,
// light is taken to fall off as q^p, q = (1 + d·n) / 2. p = 4 r² is exact for light that is even all around (r = 0) and for an
// even hemisphere (r = 1/2), of which a tilted surface sees (1 + cos) / 2; p ends at 2.5, where lamps 30° to 60° off the surface's
// normal come out best at tilts of 30°. Never negative; where `normal` is the surface's it gives the light map's texel as it is.
// After G. Hazel, Reconstructing Diffuse Lighting from Spherical Harmonic Data, 2017, whose lobe has other aims.
VKBAKE_LIGHT_FUNCTION vec3 vkbake_directional_light(vec3 light, vec3 sh0, vec3 sh1, vec3 sh2, vec3 sh3, vec3 surface_normal,
                                                    vec3 normal) {
    vec3 tiny = vec3(1e-30f);
    vec3 size = sqrt(sh1 * sh1 + sh2 * sh2 + sh3 * sh3);
    vec3 r = min(0.577350269f * size / max(sh0, tiny), vec3(1.0f));
    vec3 half_over = 0.5f / max(size, tiny);
    vec3 q = 0.5f + half_over * (sh1 * normal.y + sh2 * normal.z + sh3 * normal.x);
    // All light comes from above the surface, so that this is 1/2 at least: noise and interpolation aside.
    vec3 q_surface = 0.5f + half_over * (sh1 * surface_normal.y + sh2 * surface_normal.z + sh3 * surface_normal.x);
    return light * pow(max(q, vec3(1e-4f)) / max(q_surface, vec3(0.5f)), min(4.0f * r * r, vec3(2.5f)));
}

// Of a light probe's nine coefficients (A_2 = π/4). Light from one side leaves a small negative lobe, which is cut off.
VKBAKE_LIGHT_FUNCTION vec3 vkbake_probe_light(vec3 sh[9], vec3 normal) {
    float x = normal.x;
    float y = normal.y;
    float z = normal.z;
    vec3 sum = 0.282094792f * sh[0] + 0.325735008f * (y * sh[1] + z * sh[2] + x * sh[3]);
    sum += 0.273137108f * (x * y * sh[4] + y * z * sh[5] + x * z * sh[7] + 0.5f * (x * x - y * y) * sh[8]);
    sum += 0.0788478924f * (3.0f * z * z - 1.0f) * sh[6];
    return max(sum, vec3(0.0f));
}

#undef VKBAKE_LIGHT_FUNCTION
#ifdef __cplusplus
} // namespace vkbake::shared
#endif
#endif
