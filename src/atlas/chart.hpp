// A connected piece of surface that lies flat in the map.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace vkbake {

/// Flat coordinates: two floats a corner, 3·t … 3·t + 2 for triangle t of the surface, v down; for a chart that was
/// made in bake-frame units, for kept UVs the UVs themselves.
struct Chart {
    std::vector<std::uint32_t> triangles; ///< in canonical order, at least one
    glm::dvec2 lower{0.0};                ///< the box of the flat coordinates
    glm::dvec2 upper{0.0};
    double scale = 1.0; ///< bake-frame units a flat unit, times the density wanted of it; ≥ 0

    /// Where the chart wants the texels' grid.
    enum class Fit : std::uint8_t {
        centred,  ///< the box in the middle of its texels
        anchored, ///< `anchor` on a texel's centre
        lower,    ///< the lower border on texel centres
        upper,    ///< the upper border
        both,     ///< both: the chart is stretched or shrunk by up to half a texel
    };
    Fit fit_u = Fit::centred;
    Fit fit_v = Fit::centred;
    glm::dvec2 anchor{0.0}; ///< a point inside a triangle of the chart
};

/// A chart of these triangles (at least one) with its box.
[[nodiscard]] Chart bounded_chart(std::vector<std::uint32_t> triangles, std::span<const glm::vec2> flat);

/// The charts of an object's triangles. `pieces`: each chart's triangles by their place in `triangles`, ascending;
/// `local_flat`: the flat coordinates in that numbering, which are written to `flat`.
[[nodiscard]] std::vector<Chart> charts_of(std::span<const std::vector<std::uint32_t>> pieces,
                                           std::span<const glm::vec2> local_flat,
                                           std::span<const std::uint32_t> triangles, std::span<glm::vec2> flat);

/// Sets how the chart wants to lie: borders that are straight (at least a quarter of the box's side lies along the
/// axis) want texel centres; else the middle of the largest triangle does.
void fit_to_texels(Chart& chart, std::span<const glm::vec2> flat);

struct TexelSize {
    int width = 0;  ///< texels, ≥ 1
    int height = 0; ///< texels, ≥ 1
};

/// A chart in the texels that it occupies, before turning: texel coordinates = flat · scale + offset. Every texel
/// square that it touches, rounding included, lies in [0, size).
struct ChartLayout {
    TexelSize size;
    glm::dvec2 scale{0.0};
    glm::dvec2 offset{0.0};
};

/// `density`: texels a bake-frame unit. A box that is at most half a texel long has one texel along it. A chart that is
/// not `centred` holds the centre of at least one texel.
[[nodiscard]] ChartLayout lay_out(const Chart& chart, std::span<const glm::vec2> flat, double density);

} // namespace vkbake
