// Vertices of surfaces that are lit by their light map alone.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "preview_vertex.glsl"

void main() { put_vertex(indices[gl_VertexIndex]); }
