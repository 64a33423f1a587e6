// Cuts a surface into round pieces that face one way.
#pragma once

#include <cstdint>
#include <vector>

#include "atlas/chart_mesh.hpp"

namespace vkbake {

/// Triangles that hang together by sides that are no creases, the first one that is least; ascending.
using Cluster = std::vector<std::uint32_t>;

/// Clusters of a component's triangles (ascending; those without area belong to none): a triangle's normal lies within
/// `cone` (a cosine) of its cluster's, and a cluster goes as far around its middle as its neighbours let it. Only
/// triangles that would stick out into another cluster go over to it if they face its way at all. Flat faces stay
/// whole. After Cohen-Steiner, Alliez, Desbrun, "Variational Shape Approximation" (2004): clusters grow from their
/// middles at the same time, a few times over. Writes `cluster_of` for the component's triangles: each one's place in
/// the result. Time: n log n.
[[nodiscard]] std::vector<Cluster> cluster_triangles(const ChartMesh& mesh, const std::vector<std::uint32_t>& component,
                                                     double cone, std::vector<std::uint32_t>& cluster_of);

} // namespace vkbake
