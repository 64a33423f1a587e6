// Surfaces that are lit by their light map alone.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "preview_surface.glsl"

void main() {
    vec4 textured = textured_color();
    vec3 emitted = emitted_light();
    if (textured.a < constants.emissive.a) {
        discard;
    }
    radiance = shaded(textured, emitted, baked_light());
}
