// What the geometry image's pass is given. Read by C++ and GLSL.
//
// Texel coordinates are whole numbers of units, 2^k of them a texel, such that a page's side is at most 2^26 units: then
// a product of two differences is at most 2^52, cross and dot products are at most 2^53, and all of them are exact in a
// 64-bit float on every device.
#ifndef VKBAKE_SHARED_GEOMETRY_IMAGE_H
#define VKBAKE_SHARED_GEOMETRY_IMAGE_H

#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
namespace vkbake::shared {
using uint = std::uint32_t;
#endif

struct TexelTriangle {
    int x[3];               // corners, units from the page's upper left corner
    int y[3];
    float position[9];      // bake frame, by corner; no denormals: some devices take them for 0
    float normal[9];        // shading
    uint number;            // in Surface
    uint turned;            // bit i: edge i, from corner i to i + 1, begins at its other end, the lesser in (x, y)
    double inverse_area;    // 1 / cross(corner 1 − corner 0, corner 2 − corner 0); 0 where that is 0
    double inverse_x[3];    // 1 / Δx of each edge as it begins; 0 where that is 0
    double inverse_y[3];
    double inverse_square[3]; // 1 / (Δx² + Δy²)
};

struct TileConstants {
    int origin_x; // of the tile in its page, texels
    int origin_y;
    int width; // texels
    int height;
    int units;         // a texel, even
    float slack;       // texels by which boxes are wider than half a texel
    double depth_scale; // 1 / units²: squared distances, units², to depths below 1
};

#ifdef __cplusplus
static_assert(sizeof(TexelTriangle) == 184 && offsetof(TexelTriangle, number) == 96);
static_assert(offsetof(TexelTriangle, inverse_area) == 104 && offsetof(TexelTriangle, inverse_square) == 160);
static_assert(sizeof(TileConstants) == 32 && offsetof(TileConstants, depth_scale) == 24);
} // namespace vkbake::shared
#endif

#endif
