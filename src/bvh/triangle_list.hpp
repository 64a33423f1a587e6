// The triangles an accelerator is built from.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "bvh/box.hpp"
#include "bvh/ray_block.hpp"

namespace vkbake {

struct Triangle {
    std::array<glm::vec3, 3> corners;

    [[nodiscard]] Box bounds() const {
        Box box;
        for (const glm::vec3& corner : corners) {
            box.add(corner);
        }
        return box;
    }
};

/// Some of the triangles that were given, in canonical order: of equal distances the least rank wins.
struct TriangleList {
    std::vector<std::uint32_t> numbers; ///< by rank: the triangle's number in the positions that were given
    std::vector<std::uint32_t> ranks;   ///< by number; no_triangle for those that were left out
    Box bounds;
};

/// Orders the triangles and leaves out those whose corners lie on one line: rounding could make them block, and they
/// have no area to block with. The order may name some of the triangles only; it names none twice. Throws
/// Error{bake_failed} where the order does not fit the positions.
[[nodiscard]] TriangleList list_triangles(std::span<const glm::vec3> positions,
                                          std::span<const std::uint32_t> canonical_order, int threads);

/// The triangles of a list, read from where their host holds them: nothing is copied, and both must outlive this.
class ListedTriangles {
public:
    ListedTriangles(std::span<const glm::vec3> positions, const TriangleList& list)
        : m_positions(positions), m_numbers(list.numbers), m_ranks(list.ranks) {}

    [[nodiscard]] std::size_t size() const { return m_numbers.size(); }
    /// By rank.
    [[nodiscard]] Triangle operator[](std::size_t rank) const { return at(m_numbers[rank]); }
    /// Has the memory fetched that operator[] is going to read.
    void prefetch(std::size_t rank) const {
        const glm::vec3* corners = &m_positions[3 * static_cast<std::size_t>(m_numbers[rank])];
        __builtin_prefetch(corners);
        __builtin_prefetch(corners + 2);
    }
    [[nodiscard]] std::vector<Triangle> copy() const;

    /// By number, as they lie in memory: where the order does not matter this is the fast one. Numbers are below
    /// end_number(); body(triangle, rank) is called for those that are listed.
    [[nodiscard]] std::size_t end_number() const { return m_ranks.size(); }
    template<typename Body>
    void each_by_number(std::size_t begin, std::size_t end, const Body& body) const {
        for (std::size_t number = begin; number < end; ++number) {
            if (m_ranks[number] != no_triangle) {
                body(at(number), m_ranks[number]);
            }
        }
    }

private:
    [[nodiscard]] Triangle at(std::size_t number) const {
        return {{m_positions[3 * number], m_positions[3 * number + 1], m_positions[3 * number + 2]}};
    }

    std::span<const glm::vec3> m_positions;
    std::span<const std::uint32_t> m_numbers;
    std::span<const std::uint32_t> m_ranks;
};

} // namespace vkbake
