// Triangles in the plane by the cells of a grid: which of them may overlap another.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec2.hpp>

namespace vkbake {

/// In double, as patches are laid out.
using PlaneTriangle = std::array<glm::dvec2, 3>;

/// Whether the triangles share more than a strip `slack` wide. Neither is mirrored.
[[nodiscard]] bool reach_into(const PlaneTriangle& first, const PlaneTriangle& second, double slack);

/// Triangles are added, never removed.
class PlaneGrid {
public:
    /// `cell`: side of the cells, > 0: best about as long as the triangles' sides.
    explicit PlaneGrid(double cell) : m_cell(cell) {}

    void add(const PlaneTriangle& triangle);

    /// Whether one of the triangles in the grid shares more with this one than a strip `slack` wide.
    [[nodiscard]] bool meets(const PlaneTriangle& triangle, double slack) const;

private:
    struct Cells {
        std::int64_t x_begin;
        std::int64_t x_end;
        std::int64_t y_begin;
        std::int64_t y_end;
        [[nodiscard]] bool many() const { return (x_end - x_begin) * (y_end - y_begin) > 64; }
    };
    struct Box {
        glm::dvec2 lower;
        glm::dvec2 upper;
    };
    static constexpr std::size_t few = 128; ///< up to so many triangles are kept without cells

    void enter(std::uint32_t index);
    [[nodiscard]] Cells cells_of(const Box& box) const;
    [[nodiscard]] static Box box_of(const PlaneTriangle& triangle);

    double m_cell;
    std::vector<PlaneTriangle> m_triangles;
    std::vector<Box> m_boxes;                                              ///< theirs
    std::vector<std::uint32_t> m_large;                                    ///< those that would lie in many cells
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_cells; ///< looked up only
};

} // namespace vkbake
