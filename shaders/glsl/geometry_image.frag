// One texel against one triangle: does the triangle meet the closed square, at which sample point, how far from the centre?
// Comparisons are of whole numbers and therefore exact; the rest is adds and multiplies that round correctly and nothing
// else (divisions were done on the host), so the bits are the same on every device. No interpolated value is used.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "geometry_image.h"

layout(std430, set = 0, binding = 0) readonly buffer Triangles { TexelTriangle triangles[]; };
layout(push_constant) uniform Constants { TileConstants tile; };

layout(location = 0) flat in uint slot;

layout(location = 0) out vec4 position;
layout(location = 1) out vec4 normal; // not of unit length: the host, whose square root is exact, sees to that
layout(location = 2) out uint number;

// Corners relative to the texel's centre, units.
dvec2 corners[3];

// Of the triangle's points that lie in the square, the one nearest the centre.
struct Sample {
    bool found;
    double distance; // squared, units²
    double b1;       // barycentric coordinates
    double b2;
};

double cross_product(dvec2 a, dvec2 b) {
    precise double result = a.x * b.y - a.y * b.x;
    return result;
}

double dot_product(dvec2 a, dvec2 b) {
    precise double result = a.x * b.x + a.y * b.y;
    return result;
}

// To 24 bits by Veltkamp's splitting, since a conversion's rounding is the device's affair; below floats' range to 0.
float rounded(double value) {
    precise double scaled = value * 536870913.0LF; // 2^29 + 1
    precise double excess = scaled - value;
    precise double head = scaled - excess;
    return abs(head) < 1.1754943508222875e-38LF ? 0.0 : float(head);
}

// Whether the edge from `a` by `d` meets the closed square of half side `h`: the axes that can separate them are x, y and
// the edge's normal.
bool meets_square(dvec2 a, dvec2 d, double h) {
    const dvec2 b = a + d;
    const double reach = h * (abs(d.x) + abs(d.y));
    return min(a.x, b.x) <= h && max(a.x, b.x) >= -h && min(a.y, b.y) <= h && max(a.y, b.y) >= -h &&
           abs(cross_product(d, a)) <= reach;
}

// Where along the edge its part inside the square is nearest the centre: the edge is clipped, then the centre's projection
// clamped to what remains. (The nearest point of the whole edge, kept if inside the square, loses texels.)
double nearest_parameter(dvec2 a, dvec2 d, double h, uint edge) {
    double low = 0.0LF;
    double high = 1.0LF;
    if (d.x != 0.0LF) { // then d.x > 0
        precise double enter = (-h - a.x) * triangles[slot].inverse_x[edge];
        precise double leave = (h - a.x) * triangles[slot].inverse_x[edge];
        low = enter > low ? enter : low;
        high = leave < high ? leave : high;
    }
    if (d.y != 0.0LF) {
        const double side = d.y > 0.0LF ? h : -h;
        precise double enter = (-side - a.y) * triangles[slot].inverse_y[edge];
        precise double leave = (side - a.y) * triangles[slot].inverse_y[edge];
        low = enter > low ? enter : low;
        high = leave < high ? leave : high;
    }
    precise double t = -dot_product(a, d) * triangles[slot].inverse_square[edge];
    t = t < high ? t : high;
    return t > low ? t : low;
}

double clamped(double value, double h) { return value > h ? h : (value < -h ? -h : value); }

// The nearest point of one edge. Edges begin at their lesser end, so that the two triangles at an edge find the same bits.
Sample nearest_on_edge(uint edge, double h) {
    const bool turned = (triangles[slot].turned >> edge & 1u) != 0u;
    const uint next = edge == 2u ? 0u : edge + 1u;
    const uint first = turned ? next : edge;
    const uint last = turned ? edge : next;
    const dvec2 a = corners[first];
    const dvec2 d = corners[last] - a;
    Sample result = Sample(false, 0.0LF, 0.0LF, 0.0LF);
    if (!meets_square(a, d, h)) {
        return result;
    }
    const double t = nearest_parameter(a, d, h, edge);
    precise double x = a.x + t * d.x;
    precise double y = a.y + t * d.y;
    const dvec2 point = dvec2(clamped(x, h), clamped(y, h));
    precise double rest = 1.0LF - t;
    result.found = true;
    result.distance = dot_product(point, point);
    result.b1 = first == 1u ? rest : (last == 1u ? t : 0.0LF);
    result.b2 = first == 2u ? rest : (last == 2u ? t : 0.0LF);
    return result;
}

float combined(float v0, float v1, float v2, double b1, double b2) {
    precise double first = b1 * (double(v1) - double(v0));
    precise double second = b2 * (double(v2) - double(v0));
    precise double sum = (double(v0) + first) + second;
    return rounded(sum);
}

vec3 combined(float v[9], double b1, double b2) {
    return vec3(combined(v[0], v[3], v[6], b1, b2), combined(v[1], v[4], v[7], b1, b2),
                combined(v[2], v[5], v[8], b1, b2));
}

void main() {
    const ivec2 texel = ivec2(tile.origin_x, tile.origin_y) + ivec2(gl_FragCoord.xy);
    const ivec2 centre = texel * tile.units + tile.units / 2;
    for (int i = 0; i < 3; ++i) {
        corners[i] = dvec2(ivec2(triangles[slot].x[i], triangles[slot].y[i]) - centre);
    }
    const double h = double(tile.units / 2);

    const double w0 = cross_product(corners[1], corners[2]);
    const double w1 = cross_product(corners[2], corners[0]);
    const double w2 = cross_product(corners[0], corners[1]);
    const bool front = w0 >= 0.0LF && w1 >= 0.0LF && w2 >= 0.0LF;
    const bool back = w0 <= 0.0LF && w1 <= 0.0LF && w2 <= 0.0LF;
    const double inverse_area = triangles[slot].inverse_area;

    Sample best = Sample(false, 0.0LF, 0.0LF, 0.0LF);
    if (inverse_area != 0.0LF && (front || back)) {
        precise double b1 = w1 * inverse_area;
        precise double b2 = w2 * inverse_area;
        best = Sample(true, 0.0LF, b1, b2);
        gl_FragDepth = 0.0;
    } else {
        for (uint edge = 0u; edge < 3u; ++edge) {
            const Sample candidate = nearest_on_edge(edge, h);
            if (candidate.found && (!best.found || candidate.distance < best.distance)) {
                best = candidate;
            }
        }
        if (!best.found) {
            discard;
        }
        // A triangle without area does not hold the centre even where it touches it: 2^-100 is behind 0.
        precise double depth = best.distance * tile.depth_scale;
        gl_FragDepth = max(rounded(depth), 7.888609052210118e-31);
    }
    position = vec4(combined(triangles[slot].position, best.b1, best.b2), 1.0);
    normal = vec4(combined(triangles[slot].normal, best.b1, best.b2), 0.0);
    number = triangles[slot].number;
}
