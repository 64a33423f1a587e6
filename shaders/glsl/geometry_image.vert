// A box around each triangle that holds the centre of every texel whose closed square the triangle meets. It may hold more:
// the fragment shader decides. A triangle whose corners are moved outward would lose texels of slivers; a box loses none.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "geometry_image.h"

layout(std430, set = 0, binding = 0) readonly buffer Triangles { TexelTriangle triangles[]; };
layout(push_constant) uniform Constants { TileConstants tile; };

layout(location = 0) flat out uint slot;

const float half_texel = 0.5;
const float half_diagonal = 0.7072;

// Of the corner, texels from the tile's corner. Rounded: `slack` makes up for it.
vec2 corner(uint triangle, int i) {
    const ivec2 origin = ivec2(tile.origin_x, tile.origin_y) * tile.units;
    return vec2(ivec2(triangles[triangle].x[i], triangles[triangle].y[i]) - origin) / float(tile.units);
}

void main() {
    slot = uint(gl_VertexIndex) / 6u;
    const vec2 a = corner(slot, 0);
    const vec2 b = corner(slot, 1);
    const vec2 c = corner(slot, 2);

    vec2 low = min(min(a, b), c) - (half_texel + tile.slack);
    vec2 high = max(max(a, b), c) + (half_texel + tile.slack);
    vec2 along = vec2(1.0, 0.0);

    // Along the longest edge the box of a slanted needle is smaller by far.
    vec2 longest = b - a;
    longest = dot(c - b, c - b) > dot(longest, longest) ? c - b : longest;
    longest = dot(a - c, a - c) > dot(longest, longest) ? a - c : longest;
    if (dot(longest, longest) > 1.0) {
        const vec2 u = normalize(longest);
        const mat2 turn = mat2(u.x, -u.y, u.y, u.x); // to coordinates along u and across
        const vec2 s = turn * a;
        const vec2 t = turn * b;
        const vec2 r = turn * c;
        const vec2 turned_low = min(min(s, t), r) - (half_diagonal + tile.slack);
        const vec2 turned_high = max(max(s, t), r) + (half_diagonal + tile.slack);
        const vec2 size = high - low;
        const vec2 turned_size = turned_high - turned_low;
        if (turned_size.x * turned_size.y < size.x * size.y) {
            low = turned_low;
            high = turned_high;
            along = u;
        }
    }

    const int k = gl_VertexIndex % 6;
    const vec2 place = vec2(k == 1 || k == 4 || k == 5 ? high.x : low.x, k == 2 || k == 3 || k == 5 ? high.y : low.y);
    const vec2 texel = place.x * along + place.y * vec2(-along.y, along.x);
    gl_Position = vec4(2.0 * texel / vec2(tile.width, tile.height) - 1.0, 0.0, 1.0);
}
