#include "write/split_primitive.hpp"

#include <array>
#include <limits>
#include <map>
#include <utility>

#include "vkbake/error.hpp"

namespace vkbake {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

class PieceBuilder {
public:
    PieceBuilder(std::uint32_t page, std::size_t vertex_count) : m_newest(vertex_count, none) { m_piece.page = page; }

    void add_corner(std::uint32_t vertex, const glm::vec2& uv) {
        std::uint32_t copy = m_newest[vertex];
        while (copy != none && m_piece.uvs[copy] != uv) {
            copy = m_older[copy];
        }
        if (copy == none) {
            copy = static_cast<std::uint32_t>(m_piece.vertices.size());
            m_piece.vertices.push_back(vertex);
            m_piece.uvs.push_back(uv);
            m_older.push_back(std::exchange(m_newest[vertex], copy));
        }
        m_piece.indices.push_back(copy);
    }

    [[nodiscard]] PrimitivePiece take() { return std::move(m_piece); }

private:
    PrimitivePiece m_piece;
    std::vector<std::uint32_t> m_newest; // one a source vertex: its last copy; a vertex has few, so a chain will do
    std::vector<std::uint32_t> m_older;  // one a new vertex: the copy before it
};

/// Which of the surface triangle's corners each corner of the source triangle is. The surface rotates the corners and,
/// in mirrored instances, swaps two.
std::array<std::size_t, 3> match_corners(const Primitive& primitive, std::size_t source, const Surface& surface,
                                         std::size_t triangle) {
    for (const std::size_t step : {std::size_t{1}, std::size_t{2}}) {
        for (std::size_t first = 0; first < 3; ++first) {
            const std::array corners{first, (first + step) % 3, (first + 2 * step) % 3};
            bool same = true;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                same = same &&
                       surface.vertices[3 * triangle + corners.at(corner)] == primitive.indices[3 * source + corner];
            }
            if (same) {
                return corners;
            }
        }
    }
    throw Error(ErrorKind::usage, "write: triangle " + std::to_string(triangle) +
                                      " of the baked surface is none of the scene's; give the scene that was baked");
}

} // namespace

std::vector<PrimitivePiece> split_primitive(const Primitive& primitive, const Surface& surface, const SurfacePart& part,
                                            const Atlas& atlas) {
    std::map<std::uint32_t, PieceBuilder> builders;
    for (std::size_t source = 0; source < part.triangle_count; ++source) {
        const std::size_t triangle = part.first_triangle + source;
        const std::array<std::size_t, 3> corners = match_corners(primitive, source, surface, triangle);
        const std::uint32_t page = atlas.page[triangle];
        PieceBuilder& builder = builders.try_emplace(page, page, primitive.positions.size()).first->second;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            builder.add_corner(primitive.indices[3 * source + corner], atlas.uvs[3 * triangle + corners.at(corner)]);
        }
    }
    std::vector<PrimitivePiece> pieces;
    pieces.reserve(builders.size());
    for (auto& [page, builder] : builders) {
        pieces.push_back(builder.take());
    }
    return pieces;
}

} // namespace vkbake
