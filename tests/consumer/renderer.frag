// A stranger's shader: includes what is installed for renderers, and calls all of it.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "vkbake_light.h"

layout(set = 0, binding = 0) uniform sampler2D light_map;
layout(set = 0, binding = 1) uniform sampler2D directional[4];
layout(set = 0, binding = 2) uniform Probe { vec3 coefficients[9]; };

layout(location = 0) in vec2 uv;
layout(location = 1) in vec3 surface_normal;
layout(location = 2) in vec3 normal;
layout(location = 0) out vec4 color;

void main() {
    vec3 sh0 = texture(directional[0], uv).rgb;
    vec3 sh1 = texture(directional[1], uv).rgb;
    vec3 sh2 = texture(directional[2], uv).rgb;
    vec3 sh3 = texture(directional[3], uv).rgb;
    vec3 light = vkbake_directional_light(texture(light_map, uv).rgb, sh0, sh1, sh2, sh3, normalize(surface_normal),
                                          normalize(normal));
    light += vkbake_irradiance_sh1(sh0, sh1, sh2, sh3, normal) + vkbake_probe_light(coefficients, normal);
    color = vec4(light, 1.0);
}
