#include "atlas/grown_charts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "atlas/chart_mesh.hpp"
#include "atlas/cluster_triangles.hpp"
#include "atlas/fold_in.hpp"
#include "atlas/outline_proof.hpp"
#include "atlas/patches.hpp"
#include "atlas/sew.hpp"
#include "atlas/triangle_tree.hpp"
#include "base/parallel.hpp"

namespace vkbake {

namespace {

// About 45°: a cap of a sphere that wide stays within the default stretch. 26 … 72° gave suzanne and the bunny as few
// charts, but charts that fill a page less well, or are bent further.
constexpr double cone = 0.7;

using Pieces = std::vector<std::vector<std::uint32_t>>;

/// Triangles that hang together by sides, each set ascending; sets in the order of their first. Those without area are
/// left out.
Pieces components_of(const ChartMesh& mesh) {
    Pieces components;
    std::vector<bool> taken(mesh.triangle_count(), false);
    for (std::uint32_t seed = 0; seed < mesh.triangle_count(); ++seed) {
        if (taken[seed] || mesh.normals[seed] == glm::dvec3(0.0)) {
            continue;
        }
        taken[seed] = true;
        std::vector<std::uint32_t> component{seed};
        for (std::size_t next = 0; next < component.size(); ++next) {
            for (std::uint32_t side = 3 * component[next]; side < 3 * component[next] + 3; ++side) {
                const std::uint32_t beyond = mesh.across[side];
                if (beyond != ChartMesh::none && !taken[beyond / 3]) {
                    taken[beyond / 3] = true;
                    component.push_back(beyond / 3);
                }
            }
        }
        std::sort(component.begin(), component.end());
        components.push_back(std::move(component));
    }
    return components;
}

/// The unit vector (as a complex number) whose direction, up to quarter turns, most of the outline has.
glm::dvec2 outline_direction(const Patches& patches, const Patch& piece) {
    // Directions by quarter: bins over y / (x + y), which grows with the angle.
    constexpr std::size_t bins = 128;
    std::array<double, bins> lengths{};
    const auto for_each_side = [&](const auto& visit) {
        for (const std::uint32_t triangle : piece.triangles) {
            for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
                const std::uint32_t beyond = patches.mesh->across[side];
                const bool inner = beyond != ChartMesh::none &&
                                   patches.patch_of[beyond / 3] == patches.patch_of[triangle] &&
                                   patches.places[beyond] == patches.places[next_corner(side)];
                if (inner && !patches.mesh->is_crease(side)) {
                    continue;
                }
                glm::dvec2 along = patches.places[next_corner(side)] - patches.places[side];
                for (int quarter = 0; quarter < 3 && !(along.x > 0.0 && along.y >= 0.0); ++quarter) {
                    along = {along.y, -along.x};
                }
                constexpr double more = 4.0; // where texels mix two faces teeth are seen
                const double length = glm::length(along);
                if (length > 0.0) {
                    visit(along / length, inner ? more * length : length,
                          static_cast<std::size_t>(std::lround(along.y / (along.x + along.y) * bins)) % bins);
                }
            }
        }
    };
    for_each_side([&](const glm::dvec2&, double length, std::size_t bin) { lengths[bin] += length; });
    const auto best = static_cast<std::size_t>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
    // The longest side of that bin.
    glm::dvec2 direction(1.0, 0.0);
    double longest = 0.0;
    for_each_side([&](const glm::dvec2& along, double length, std::size_t bin) {
        if (bin == best && length > longest) {
            longest = length;
            direction = along;
        }
    });
    return direction;
}

class GrownCharts {
public:
    GrownCharts(const Surface& surface, std::span<const std::uint32_t> triangles, const GrowthLimits& limits)
        : m_mesh(make_chart_mesh(surface, triangles)), m_patches(m_mesh), m_flat(3 * triangles.size()) {
        // A small distortion's energy is twice what it adds to the L2 stretch.
        m_limits.mean_energy = 2.0 * (limits.stretch - 1.0);
        m_limits.triangle_energy = 25.0 * m_limits.mean_energy;
        m_limits.free_length = limits.free_length;
        m_limits.free_area = limits.free_area;
    }

    Pieces run() {
        const Pieces components = components_of(m_mesh);
        std::vector<std::vector<Patch>> patches = lay_out_clusters(components);
        parallel_ranges(components.size(), 8, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                grow_instead(components[i], patches[i]);
            }
        });
        merge(patches);
        Pieces charts = lay_straight(patches);
        fold_in(m_mesh.vertices, m_flat, charts);
        std::sort(charts.begin(), charts.end());
        return charts;
    }

    [[nodiscard]] const std::vector<glm::vec2>& flat() const { return m_flat; }

private:
    /// By component; those that could not be laid out within the limits have no area.
    std::vector<std::vector<Patch>> lay_out_clusters(const Pieces& components) {
        std::vector<std::vector<Patch>> patches(components.size());
        parallel_ranges(components.size(), 8, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                for (Cluster& cluster : cluster_triangles(m_mesh, components[i], cone, m_patches.patch_of)) {
                    patches[i].push_back({.triangles = std::move(cluster)});
                }
            }
        });
        const std::vector<Patch*> all = every(patches);
        parallel_ranges(all.size(), 8, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                if (!lay_out_patch(m_patches, *all[i], m_limits)) {
                    all[i]->area = 0.0;
                }
            }
        });
        return patches;
    }

    /// Twice: what a patch gained in measure by being relaxed it may spend on neighbours.
    void merge(std::vector<std::vector<Patch>>& patches) {
        std::vector<std::uint8_t> gained(patches.size(), 1);
        for (int pass = 0; pass < 2; ++pass) {
            relax(patches);
            parallel_ranges(patches.size(), 8, 0, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    if (gained[i] != 0) {
                        merge_patches(m_patches, patches[i], m_limits);
                    }
                }
            });
            gained = relax(patches);
        }
    }

    /// By component: whether one of its patches gained by it.
    std::vector<std::uint8_t> relax(std::vector<std::vector<Patch>>& patches) {
        const std::vector<Patch*> all = every(patches);
        std::vector<std::uint8_t> gained(all.size());
        parallel_ranges(all.size(), 8, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                gained[i] = relax_patch(m_patches, *all[i], m_limits) ? 1 : 0;
            }
        });
        std::vector<std::uint8_t> by_component(patches.size());
        std::size_t first = 0;
        for (std::size_t i = 0; i < patches.size(); ++i) {
            by_component[i] = std::any_of(&gained[first], &gained[first] + patches[i].size(),
                                          [](std::uint8_t own) { return own != 0; })
                                  ? 1
                                  : 0;
            first += patches[i].size();
        }
        return by_component;
    }

    /// Writes the flat coordinates. Rounding, and outlines that cross where no joint was looked at, may make triangles
    /// overlap: such patches are cut.
    Pieces lay_straight(std::vector<std::vector<Patch>>& patches) {
        std::vector<Patch*> all = every(patches);
        std::vector<std::uint8_t> sound(all.size());
        parallel_ranges(all.size(), 8, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                std::vector<std::uint32_t>& triangles = all[i]->triangles;
                lay_straight(*all[i]);
                std::sort(triangles.begin(), triangles.end());
                sound[i] = std::ranges::none_of(triangles, [&](std::uint32_t t) { return is_mirrored(t); }) &&
                           (outline_proves_no_overlap(m_flat, triangles) ||
                            !any_overlap(TriangleTree(m_flat, triangles), triangles));
            }
        });
        Pieces charts;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (sound[i] != 0) {
                charts.push_back(std::move(all[i]->triangles));
            } else {
                cut_overlaps(std::move(all[i]->triangles), charts);
            }
        }
        return charts;
    }

    static std::vector<Patch*> every(std::vector<std::vector<Patch>>& patches) {
        std::vector<Patch*> all;
        for (std::vector<Patch>& own : patches) {
            for (Patch& patch : own) {
                all.push_back(&patch);
            }
        }
        return all;
    }

    static bool any_overlap(const TriangleTree& tree, std::span<const std::uint32_t> triangles) {
        return std::ranges::any_of(triangles, [&](std::uint32_t triangle) { return tree.overlaps_any(triangle); });
    }

    /// Against the front, or of no area.
    [[nodiscard]] bool is_mirrored(std::uint32_t triangle) const { return orientation(laid(triangle)) >= 0; }

    /// What could not be laid out as a whole is laid out triangle by triangle.
    void grow_instead(const std::vector<std::uint32_t>& component, std::vector<Patch>& pieces) {
        std::vector<Patch> good;
        for (Patch& piece : pieces) {
            const std::uint32_t name = piece.area > 0.0 ? static_cast<std::uint32_t>(good.size()) : ChartMesh::none;
            for (const std::uint32_t triangle : piece.triangles) {
                m_patches.patch_of[triangle] = name;
            }
            if (piece.area > 0.0) {
                good.push_back(std::move(piece));
            }
        }
        if (good.size() < pieces.size()) {
            grow_patches(m_patches, component, m_limits, good);
        }
        pieces = std::move(good);
    }

    /// Writes the flat coordinates, v down.
    void lay_straight(const Patch& piece) {
        const glm::dvec2 direction = outline_direction(m_patches, piece);
        const glm::dvec2 origin = m_patches.places[3 * piece.triangles.front()];
        for (const std::uint32_t triangle : piece.triangles) {
            for (std::uint32_t place = 3 * triangle; place < 3 * triangle + 3; ++place) {
                const glm::dvec2 p = m_patches.places[place] - origin;
                m_flat[place] = {static_cast<float>(direction.x * p.x + direction.y * p.y),
                                 static_cast<float>(direction.y * p.x - direction.x * p.y)};
            }
        }
    }

    /// What is mirrored lies alone; the rest is grown again, from the least triangle, without what overlaps it.
    void cut_overlaps(std::vector<std::uint32_t> piece, Pieces& charts) {
        std::erase_if(piece, [&](std::uint32_t triangle) {
            const bool mirrored = is_mirrored(triangle);
            if (mirrored) {
                charts.push_back({triangle});
                lay_alone(triangle);
            }
            return mirrored;
        });
        if (piece.empty()) {
            return;
        }
        TriangleTree tree(m_flat, piece);
        if (!any_overlap(tree, piece)) {
            charts.push_back(std::move(piece));
            return;
        }
        for (const std::uint32_t triangle : piece) {
            m_patches.patch_of[triangle] = ChartMesh::none;
        }
        std::uint32_t group = 0;
        for (const std::uint32_t seed : piece) {
            if (m_patches.patch_of[seed] == ChartMesh::none) {
                charts.push_back(grow_apart(tree, seed, group++));
            }
        }
    }

    std::vector<std::uint32_t> grow_apart(TriangleTree& tree, std::uint32_t seed, std::uint32_t group) {
        std::vector<std::uint32_t> taken{seed};
        const auto take = [&](std::uint32_t triangle) {
            m_patches.patch_of[triangle] = 0;
            tree.mark(triangle, group);
        };
        take(seed);
        for (std::size_t next = 0; next < taken.size(); ++next) {
            for (std::uint32_t side = 3 * taken[next]; side < 3 * taken[next] + 3; ++side) {
                const std::uint32_t beyond = m_mesh.across[side];
                if (beyond != ChartMesh::none && m_patches.patch_of[beyond / 3] == ChartMesh::none &&
                    m_flat[beyond] == m_flat[next_corner(side)] && m_flat[next_corner(beyond)] == m_flat[side] &&
                    !tree.overlaps_group(beyond / 3, group)) {
                    taken.push_back(beyond / 3);
                    take(beyond / 3);
                }
            }
        }
        std::sort(taken.begin(), taken.end());
        return taken;
    }

    [[nodiscard]] FlatTriangle laid(std::uint32_t triangle) const {
        return {m_flat[3 * triangle], m_flat[3 * triangle + 1], m_flat[3 * triangle + 2]};
    }

    void lay_alone(std::uint32_t triangle) {
        const LaidTriangle own = lay_down(m_mesh, 3 * triangle);
        m_flat[3 * triangle] = {0.0F, 0.0F};
        m_flat[3 * triangle + 1] = {static_cast<float>(own.x1), 0.0F};
        m_flat[3 * triangle + 2] = {static_cast<float>(own.x2), static_cast<float>(-own.y2)};
    }

    ChartMesh m_mesh;
    Patches m_patches;
    PatchLimits m_limits;
    std::vector<glm::vec2> m_flat;
};

} // namespace

std::vector<Chart> make_grown_charts(const Surface& surface, std::span<const std::uint32_t> triangles,
                                     const GrowthLimits& limits, std::span<glm::vec2> flat) {
    GrownCharts growth(surface, triangles, limits);
    const Pieces pieces = growth.run();
    std::vector<Chart> charts = charts_of(pieces, growth.flat(), triangles, flat);
    parallel_ranges(charts.size(), 64, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            fit_to_texels(charts[i], flat);
        }
    });
    return charts;
}

} // namespace vkbake
