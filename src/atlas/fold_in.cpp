#include "atlas/fold_in.hpp"

#include <algorithm>
#include <utility>

namespace vkbake {

void fold_in(std::span<const std::uint32_t> vertices, std::span<glm::vec2> flat,
             std::vector<std::vector<std::uint32_t>>& charts) {
    constexpr std::uint32_t none = 0xFFFFFFFFU;
    std::vector<std::uint32_t> chart_of(vertices.size() / 3, none);
    std::size_t placed = 0;
    for (std::uint32_t chart = 0; chart < charts.size(); ++chart) {
        placed += charts[chart].size();
        for (const std::uint32_t triangle : charts[chart]) {
            chart_of[triangle] = chart;
        }
    }
    if (placed < chart_of.size()) {
        std::vector<std::uint32_t> corner_at(vertices.size(), none); // by vertex: the first corner there of a chart's
        std::uint32_t any_corner = none;
        for (std::uint32_t corner = 0; corner < vertices.size(); ++corner) {
            if (chart_of[corner / 3] != none) {
                corner_at[vertices[corner]] = std::min(corner_at[vertices[corner]], corner);
                any_corner = std::min(any_corner, corner);
            }
        }
        std::vector<std::uint32_t> homeless;
        for (std::uint32_t triangle = 0; triangle < chart_of.size(); ++triangle) {
            if (chart_of[triangle] != none) {
                continue;
            }
            std::uint32_t at = none;
            for (std::uint32_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
                at = std::min(at, corner_at[vertices[corner]]);
            }
            at = at == none ? any_corner : at;
            const glm::vec2 place = at == none ? glm::vec2(0.0F) : flat[at];
            std::fill_n(flat.begin() + 3 * static_cast<std::ptrdiff_t>(triangle), 3, place);
            if (at == none) {
                homeless.push_back(triangle);
            } else {
                charts[chart_of[at / 3]].push_back(triangle);
            }
        }
        if (!homeless.empty()) {
            charts.push_back(std::move(homeless));
        }
    }
    for (auto& chart : charts) {
        std::sort(chart.begin(), chart.end());
    }
}

} // namespace vkbake
