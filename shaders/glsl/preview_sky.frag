// The sky behind the scene: its radiance has been looked up for every pixel.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "preview.h"

layout(set = 0, binding = 0) uniform sampler2D sky;

layout(push_constant) uniform Constants { ResolveConstants constants; };

layout(location = 0) out vec4 radiance;

void main() { radiance = vec4(texelFetch(sky, ivec2(gl_FragCoord.xy) / int(constants.samples), 0).rgb, 1.0); }
