// The UVs of a bake: measured, and drawn.
#include "atlas/make_atlas.hpp"
#include "atlas/measure_uvs.hpp"
#include "base/boundary.hpp"
#include "base/random.hpp"
#include "surface/make_surface.hpp"
#include "vkbake/uv_report.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace vkbake {
namespace {

/// Triangles of a surface in texels.
class TexelSurface {
public:
    TexelSurface(const Surface& surface, const Atlas& atlas) : m_surface(surface), m_atlas(atlas) {
        for (const AtlasPage& page : atlas.pages) {
            m_page_sizes.emplace_back(page.width, page.height);
        }
    }

    [[nodiscard]] UvFiguresOfObject figures(std::string name, std::size_t first, std::size_t count) const {
        const UvFigures measured = measure_uvs({std::span(m_surface.positions).subspan(3 * first, 3 * count),
                                                std::span(m_atlas.uvs).subspan(3 * first, 3 * count),
                                                std::span(m_atlas.page).subspan(first, count), m_page_sizes});
        UvFiguresOfObject figures{.name = std::move(name),
                                  .triangles = count,
                                  .charts = measured.charts,
                                  .texels = measured.uv_area,
                                  .stretch = measured.stretch,
                                  .overlapping = measured.overlapping,
                                  .mirrored = measured.mirrored};
        std::vector<std::pair<double, double>> densities; // with the area
        double area = 0.0;
        for (std::size_t triangle = first; triangle < first + count; ++triangle) {
            const double own = area_of(triangle);
            if (own > 0.0) {
                densities.emplace_back(std::sqrt(texels_of(triangle) / own), own);
                area += own;
            }
        }
        std::sort(densities.begin(), densities.end());
        if (!densities.empty()) {
            figures.density_min = densities.front().first;
            figures.density_max = densities.back().first;
        }
        double below = 0.0;
        for (const auto& [density, own] : densities) {
            if (below <= 0.5 * area) {
                figures.density_median = density;
            }
            below += own;
        }
        return figures;
    }

private:
    /// m²
    [[nodiscard]] double area_of(std::size_t triangle) const {
        const glm::dvec3 a(m_surface.positions[3 * triangle]);
        const glm::dvec3 b(m_surface.positions[3 * triangle + 1]);
        const glm::dvec3 c(m_surface.positions[3 * triangle + 2]);
        const double metres = 1.0 / m_surface.frame.scale();
        return 0.5 * glm::length(glm::cross(b - a, c - a)) * metres * metres;
    }

    [[nodiscard]] double texels_of(std::size_t triangle) const {
        const glm::dvec2 e = glm::dvec2(m_atlas.uvs[3 * triangle + 1]) - glm::dvec2(m_atlas.uvs[3 * triangle]);
        const glm::dvec2 f = glm::dvec2(m_atlas.uvs[3 * triangle + 2]) - glm::dvec2(m_atlas.uvs[3 * triangle]);
        const glm::dvec2 page = m_page_sizes[m_atlas.page[triangle]];
        return 0.5 * std::abs(e.x * f.y - e.y * f.x) * page.x * page.y;
    }

    const Surface& m_surface;
    const Atlas& m_atlas;
    std::vector<glm::dvec2> m_page_sizes;
};

UvReport report_uvs(const Scene& scene, const Settings& settings) {
    const Surface surface = make_surface(scene);
    UvReport report{.atlas = make_atlas(scene, surface, settings)};
    const TexelSurface texels(surface, report.atlas);
    for (const SurfaceObject& object : surface.objects) {
        if (object.triangle_count > 0) {
            report.objects.push_back(texels.figures(object.name, object.first_triangle, object.triangle_count));
        }
    }
    report.all = texels.figures("", 0, surface.triangle_count());
    double pages = 0.0;
    for (const AtlasPage& page : report.atlas.pages) {
        pages += static_cast<double>(page.width) * page.height;
    }
    report.share = pages > 0.0 ? report.all.texels / pages : 0.0;
    return report;
}

/// Which chart holds each pixel's centre; `none` where none does.
constexpr std::uint32_t none = 0xFFFFFFFFU;

std::vector<std::uint32_t> chart_owners(const Atlas& atlas, std::uint32_t page) {
    const int width = atlas.pages[page].width;
    const int height = atlas.pages[page].height;
    std::vector<std::uint32_t> owners(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), none);
    for (std::size_t triangle = 0; triangle < atlas.page.size(); ++triangle) {
        if (atlas.page[triangle] != page) {
            continue;
        }
        glm::dvec2 t[3];
        glm::dvec2 low(1e9);
        glm::dvec2 high(-1e9);
        for (std::size_t c = 0; c < 3; ++c) {
            t[c] = glm::dvec2(atlas.uvs[3 * triangle + c]) * glm::dvec2(width, height);
            low = {std::min(low.x, t[c].x), std::min(low.y, t[c].y)};
            high = {std::max(high.x, t[c].x), std::max(high.y, t[c].y)};
        }
        const auto side = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
            return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
        };
        for (int y = static_cast<int>(low.y); y <= std::min(height - 1, static_cast<int>(high.y)); ++y) {
            for (int x = static_cast<int>(low.x); x <= std::min(width - 1, static_cast<int>(high.x)); ++x) {
                const glm::dvec2 p(x + 0.5, y + 0.5);
                const double a = side(t[0], t[1], p);
                const double b = side(t[1], t[2], p);
                const double c = side(t[2], t[0], p);
                if ((a <= 0.0 && b <= 0.0 && c <= 0.0) || (a >= 0.0 && b >= 0.0 && c >= 0.0)) {
                    owners[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(x)] = atlas.chart[triangle];
                }
            }
        }
    }
    return owners;
}

glm::vec3 chart_colour(std::uint32_t chart) {
    const std::uint64_t bits = mix64(chart + 1);
    const auto part = [&](unsigned shift) { return 0.35F + 0.55F * static_cast<float>(bits >> shift & 255U) / 255.0F; };
    return {part(0), part(8), part(16)};
}

Image draw_page(const Atlas& atlas, std::uint32_t page) {
    Image image{.width = atlas.pages.at(page).width, .height = atlas.pages.at(page).height};
    const std::vector<std::uint32_t> owners = chart_owners(atlas, page);
    image.texels.reserve(owners.size());
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::uint32_t owner = owners[image.index(x, y)];
            const auto differs = [&](int other_x, int other_y) {
                return other_x >= 0 && other_y >= 0 && other_x < image.width && other_y < image.height &&
                       owners[image.index(other_x, other_y)] != owner;
            };
            const bool outline =
                owner != none && (differs(x - 1, y) || differs(x + 1, y) || differs(x, y - 1) || differs(x, y + 1));
            const float shade = (x / 8 + y / 8) % 2 == 0 ? 1.0F : 0.8F;
            const glm::vec3 colour = owner == none ? glm::vec3(0.16F) : chart_colour(owner);
            image.texels.emplace_back(colour * (outline ? 0.45F : shade), 1.0F);
        }
    }
    return image;
}

} // namespace

UvReport inspect_uvs(const Scene& scene, const Settings& settings) {
    return at_boundary([&] { return report_uvs(scene, settings); });
}

Image draw_uvs(const Atlas& atlas, std::uint32_t page) {
    return at_boundary([&] { return draw_page(atlas, page); });
}

} // namespace vkbake
