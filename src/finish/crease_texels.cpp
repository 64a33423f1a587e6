#include "finish/crease_texels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "base/parallel.hpp"
#include "finish/covered_area.hpp"
#include "finish/shading_sides.hpp"

namespace vkbake {

namespace {

constexpr std::uint32_t no_side = std::numeric_limits<std::uint32_t>::max();

/// Of a texel's square, what lies on a triangle.
struct Piece {
    std::uint32_t texel = 0;
    std::uint32_t side = 0;
    std::uint64_t area = 0; ///< whole parts, so that sums do not depend on their order
};

constexpr double area_parts = 0x1p40;

class CreaseFinder {
public:
    CreaseFinder(const Surface& surface, const Atlas& atlas, const GeometryImage& geometry, std::uint32_t page)
        : m_surface(surface), m_atlas(atlas), m_geometry(geometry), m_page(page) {}

    [[nodiscard]] std::vector<CreaseTexel> run() {
        const auto turns = [&](std::size_t a, std::size_t b) {
            return glm::dot(m_geometry.shading_normal[a], m_geometry.shading_normal[b]) < crease_cosine;
        };
        if (!mark_where(turns)) {
            return {};
        }
        const std::vector<std::uint32_t> triangles = marked_triangles();
        const std::vector<std::uint32_t> sides = shading_sides(m_surface, m_atlas, triangles);
        m_side.assign(m_surface.triangle_count(), no_side);
        for (std::size_t place = 0; place < triangles.size(); ++place) {
            m_side[triangles[place]] = sides[place];
        }
        const auto other_side = [&](std::size_t a, std::size_t b) {
            return side_at(a) != no_side && side_at(b) != no_side && side_at(a) != side_at(b);
        };
        return mark_where(other_side) ? crease_texels(marked_pieces(triangles)) : std::vector<CreaseTexel>();
    }

private:
    [[nodiscard]] std::uint32_t side_at(std::size_t texel) const { return m_side[m_geometry.triangle[texel]]; }

    [[nodiscard]] bool same_chart(std::size_t a, std::size_t b) const {
        const std::uint32_t one = m_geometry.triangle[a];
        const std::uint32_t other = m_geometry.triangle[b];
        return one != GeometryImage::empty && other != GeometryImage::empty &&
               m_atlas.chart[one] == m_atlas.chart[other];
    }

    /// Calls look(texel, place) for the texels around (x, y), place being that in 3 × 3.
    template<typename Look>
    void for_each_around(int x, int y, const Look& look) const {
        for (int place = 0; place < 9; ++place) {
            const int column = x + place % 3 - 1;
            const int row = y + place / 3 - 1;
            if (place != 4 && column >= 0 && column < m_geometry.width && row >= 0 && row < m_geometry.height) {
                look(index(column, row), static_cast<std::size_t>(place));
            }
        }
    }

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_geometry.width) + static_cast<std::size_t>(x);
    }

    /// Marks the texels that differ, as asked, from one of their chart around them; false where none does.
    template<typename Differ>
    [[nodiscard]] bool mark_where(const Differ& differ) {
        m_marks.assign(m_geometry.texel_count(), 0);
        parallel_ranges(static_cast<std::size_t>(m_geometry.height), 16, 0, [&](std::size_t begin, std::size_t end) {
            for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
                for (int x = 0; x < m_geometry.width; ++x) {
                    const std::size_t texel = index(x, y);
                    if (m_geometry.triangle[texel] == GeometryImage::empty) {
                        continue;
                    }
                    for_each_around(x, y, [&](std::size_t other, std::size_t) {
                        if (m_geometry.triangle[other] != m_geometry.triangle[texel] && same_chart(texel, other) &&
                            differ(texel, other)) {
                            m_marks[texel] = 1;
                        }
                    });
                }
            }
        });
        return std::ranges::find(m_marks, 1) != m_marks.end();
    }

    /// Of a triangle, in texels.
    [[nodiscard]] std::array<glm::dvec2, 3> corners_of(std::uint32_t triangle) const {
        std::array<glm::dvec2, 3> corners{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            corners[corner] = glm::dvec2(m_atlas.uvs[3 * std::size_t{triangle} + corner]) *
                              glm::dvec2(m_geometry.width, m_geometry.height);
        }
        return corners;
    }

    /// Calls look(x, y) for the marked texels of its chart that the triangle's box meets.
    template<typename Look>
    void for_each_marked(std::uint32_t triangle, const std::array<glm::dvec2, 3>& corners, const Look& look) const {
        const glm::dvec2 low = glm::floor(glm::min(glm::min(corners[0], corners[1]), corners[2]));
        const glm::dvec2 high = glm::ceil(glm::max(glm::max(corners[0], corners[1]), corners[2]));
        for (int y = static_cast<int>(low.y); y < static_cast<int>(high.y); ++y) {
            for (int x = static_cast<int>(low.x); x < static_cast<int>(high.x); ++x) {
                const std::size_t texel = index(x, y);
                if (m_marks[texel] != 0 && m_atlas.chart[m_geometry.triangle[texel]] == m_atlas.chart[triangle]) {
                    look(x, y);
                }
            }
        }
    }

    /// Those with a marked texel in their box, ascending.
    [[nodiscard]] std::vector<std::uint32_t> marked_triangles() const {
        std::vector<std::uint8_t> marked(m_surface.triangle_count(), 0);
        parallel_ranges(marked.size(), 1024, 0, [&](std::size_t begin, std::size_t end) {
            for (auto triangle = static_cast<std::uint32_t>(begin); triangle < end; ++triangle) {
                if (m_atlas.page[triangle] == m_page && m_surface.geometric_normals[triangle] != glm::vec3(0.0F)) {
                    for_each_marked(triangle, corners_of(triangle), [&](int, int) { marked[triangle] = 1; });
                }
            }
        });
        std::vector<std::uint32_t> triangles;
        for (std::uint32_t triangle = 0; triangle < marked.size(); ++triangle) {
            if (marked[triangle] != 0) {
                triangles.push_back(triangle);
            }
        }
        return triangles;
    }

    /// What the triangles cover of marked texels, by texels and sides, each pair once.
    [[nodiscard]] std::vector<Piece> marked_pieces(std::span<const std::uint32_t> triangles) const {
        std::vector<std::vector<Piece>> parts(worker_count(0));
        parallel_ranges_by_worker(triangles.size(), 256, 0,
                                  [&](std::size_t begin, std::size_t end, std::size_t worker) {
                                      for (const std::uint32_t triangle : triangles.subspan(begin, end - begin)) {
                                          add_pieces(triangle, parts[worker]);
                                      }
                                  });
        std::vector<Piece> pieces;
        for (std::vector<Piece>& part : parts) {
            pieces.insert(pieces.end(), part.begin(), part.end());
            part = {};
        }
        const auto name = [](const Piece& piece) { return std::pair(piece.texel, piece.side); };
        std::ranges::sort(pieces, {}, name);
        std::size_t count = 0;
        for (const Piece& piece : pieces) {
            if (count > 0 && name(pieces[count - 1]) == name(piece)) {
                pieces[count - 1].area += piece.area;
            } else {
                pieces[count++] = piece;
            }
        }
        pieces.resize(count);
        return pieces;
    }

    void add_pieces(std::uint32_t triangle, std::vector<Piece>& pieces) const {
        const std::array<glm::dvec2, 3> corners = corners_of(triangle);
        for_each_marked(triangle, corners, [&](int x, int y) {
            const glm::dvec2 texel(x, y);
            const double area = covered_area({corners[0] - texel, corners[1] - texel, corners[2] - texel});
            const auto parts = static_cast<std::uint64_t>(std::llround(std::min(area, 1.0) * area_parts));
            if (parts > 0) {
                pieces.push_back({static_cast<std::uint32_t>(index(x, y)), m_side[triangle], parts});
            }
        });
    }

    [[nodiscard]] std::vector<CreaseTexel> crease_texels(std::span<const Piece> pieces) const {
        std::vector<CreaseTexel> creases;
        while (!pieces.empty()) {
            const auto of_another =
                std::ranges::find_if(pieces, [&](const Piece& piece) { return piece.texel != pieces.front().texel; });
            const auto count = static_cast<std::size_t>(of_another - pieces.begin());
            const CreaseTexel crease = crease_texel(pieces.first(count));
            if (crease.shares[4] < CreaseTexel::whole) {
                creases.push_back(crease);
            }
            pieces = pieces.subspan(count);
        }
        return creases;
    }

    /// The places of the texels around whose points lie on that side: those beside it, else those at its corners.
    [[nodiscard]] std::vector<std::size_t> places_on(std::uint32_t side, std::uint32_t texel) const {
        const auto width = static_cast<std::uint32_t>(m_geometry.width);
        std::array<std::vector<std::size_t>, 2> places;
        for_each_around(static_cast<int>(texel % width), static_cast<int>(texel / width),
                        [&](std::size_t other, std::size_t place) {
                            if (same_chart(texel, other) && side_at(other) == side) {
                                places[1 - place % 2].push_back(place);
                            }
                        });
        return places[0].empty() ? places[1] : places[0];
    }

    /// `pieces`: all of one texel.
    [[nodiscard]] CreaseTexel crease_texel(std::span<const Piece> pieces) const {
        const std::uint32_t texel = pieces.front().texel;
        std::vector<std::pair<std::uint64_t, std::vector<std::size_t>>> sources; // areas, and where light is taken from
        std::uint64_t total = 0;
        for (const Piece& piece : pieces) {
            const bool own = piece.side == side_at(texel);
            std::vector<std::size_t> places = own ? std::vector<std::size_t>() : places_on(piece.side, texel);
            if (own || !places.empty()) {
                total += piece.area;
                sources.emplace_back(piece.area, std::move(places));
            }
        }
        CreaseTexel crease{.texel = texel};
        std::uint32_t given = 0;
        for (const auto& [area, places] : sources) {
            for (const std::size_t place : places) {
                const auto share = static_cast<std::uint16_t>(area * CreaseTexel::whole / total / places.size());
                crease.shares[place] = static_cast<std::uint16_t>(crease.shares[place] + share);
                given += share;
            }
        }
        crease.shares[4] = static_cast<std::uint16_t>(CreaseTexel::whole - given);
        return crease;
    }

    const Surface& m_surface;
    const Atlas& m_atlas;
    const GeometryImage& m_geometry;
    std::uint32_t m_page;
    std::vector<std::uint8_t> m_marks; ///< 1 a texel
    std::vector<std::uint32_t> m_side; ///< 1 a triangle, or no_side
};

} // namespace

std::vector<CreaseTexel> find_crease_texels(const Surface& surface, const Atlas& atlas, const GeometryImage& geometry,
                                            std::uint32_t page) {
    return CreaseFinder(surface, atlas, geometry, page).run();
}

} // namespace vkbake
