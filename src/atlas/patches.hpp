// Pieces of surface that are laid out flat, while charts are made of them.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "atlas/chart_mesh.hpp"

namespace vkbake {

/// Connected triangles. Where two of them lie across from each other and their corners lie in the same places, they
/// hang together there.
struct Patch {
    std::vector<std::uint32_t> triangles; ///< the first is the one that it grew from
    double area = 0.0;                    ///< in space
    double energy = 0.0;                  ///< Σ area · Distortion::energy()
    bool relaxed = false;                 ///< since it last grew
};

/// All patches of a mesh.
struct Patches {
    explicit Patches(const ChartMesh& of)
        : mesh(&of), places(of.vertices.size()), patch_of(of.triangle_count(), ChartMesh::none),
          local(of.triangle_count(), 0) {}

    const ChartMesh* mesh;
    std::vector<glm::dvec2>
        places; ///< 3 a triangle: its corners in its patch's plane, counter-clockwise from the front
    std::vector<std::uint32_t> patch_of; ///< 1 a triangle: index in its component's patches, `none` where in none
    std::vector<std::uint32_t> local;    ///< 1 a triangle: to note numbers down in
};

/// What a patch may become while it grows or is merged.
struct PatchLimits {
    double mean_energy = 0.0;     ///< of Distortion::energy(), over the area
    double triangle_energy = 0.0; ///< of any triangle
    double free_length = 0.0;     ///< up to this side of their box patches may be joined to any shape
    double free_area = 0.0;       ///< up to so much patches may be joined across a crease
};

/// Grows patches over a component's triangles (that hang together by sides, ascending) that are in none, and adds them
/// to `pieces`, never across a crease. A patch grows by the triangle that is nearest to where it began, in its own
/// plane, coplanar ones first; each new corner goes where the triangles around it would have it.
void grow_patches(Patches& patches, const std::vector<std::uint32_t>& component, const PatchLimits& limits,
                  std::vector<Patch>& pieces);

/// Joins a component's patches that are neighbours on the surface, those first that share most of their outlines,
/// across creases only small ones: one is moved rigidly until their common sides meet. Where that would make patches
/// overlap they stay apart. Where they do not fit rigidly, both are sewn together and relaxed as one, if they stay
/// within the limits.
void merge_patches(Patches& patches, std::vector<Patch>& pieces, const PatchLimits& limits);

} // namespace vkbake
