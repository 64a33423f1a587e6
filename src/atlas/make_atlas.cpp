#include "atlas/make_atlas.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "atlas/chart.hpp"
#include "atlas/density.hpp"
#include "atlas/grown_charts.hpp"
#include "atlas/kept_uvs.hpp"
#include "atlas/object_notes.hpp"
#include "atlas/place_charts.hpp"
#include "atlas/polypacks.hpp"
#include "base/parallel.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

constexpr std::uint32_t no_chart = std::numeric_limits<std::uint32_t>::max();

void check_settings(const Settings& settings) {
    const auto refuse = [](const std::string& what) { throw Error(ErrorKind::usage, what); };
    if (settings.size < 0 || settings.size > greatest_side) {
        refuse("size " + std::to_string(settings.size) + ": out of range; give 1 to 16384 texels, or 0 with a density");
    }
    if (settings.size == 0 && !settings.density) {
        refuse("size 0: only a density says how large a page must be; give one of the two");
    }
    if (settings.density && !(std::isfinite(*settings.density) && *settings.density > 0.0)) {
        refuse("density: must be finite and above 0; give texels a metre");
    }
    if (settings.gutter < 0 || settings.gutter > 64) {
        refuse("gutter " + std::to_string(settings.gutter) + ": out of range; give 0 to 64 texels");
    }
    if (!(settings.stretch >= 1.0001 && settings.stretch <= 2.0)) {
        refuse("stretch " + std::to_string(settings.stretch) + ": out of range; give 1.0001 to 2");
    }
    if (settings.max_pages < 1) {
        refuse("max pages " + std::to_string(settings.max_pages) + ": out of range; give 1 or more");
    }
}

double surface_area(const Surface& surface, std::uint32_t triangle) {
    const glm::vec3* const p = &surface.positions[3 * std::size_t{triangle}];
    const glm::dvec3 e = glm::dvec3(p[1]) - glm::dvec3(p[0]);
    const glm::dvec3 f = glm::dvec3(p[2]) - glm::dvec3(p[0]);
    const glm::dvec3 n(e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x);
    return 0.5 * std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
}

double flat_area(std::span<const glm::vec2> flat, std::uint32_t triangle) {
    const glm::dvec2 a(flat[3 * std::size_t{triangle}]);
    const glm::dvec2 b(flat[3 * std::size_t{triangle} + 1]);
    const glm::dvec2 c(flat[3 * std::size_t{triangle} + 2]);
    return 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

class AtlasMaker {
public:
    AtlasMaker(const Scene& scene, const Surface& surface, const Settings& settings)
        : m_scene(scene), m_surface(surface), m_settings(settings), m_flat(surface.positions.size()),
          m_rank(surface.triangle_count()), m_objects(surface.objects.size()) {
        m_atlas.uvs.resize(surface.positions.size());
        m_atlas.page.resize(surface.triangle_count(), 0);
        m_atlas.chart.resize(surface.triangle_count(), no_chart);
        for (std::uint32_t rank = 0; rank < surface.canonical_order.size(); ++rank) {
            const std::uint32_t triangle = surface.canonical_order[rank];
            m_rank[triangle] = rank;
            Object& object = m_objects[surface.parts[surface.parts_of[triangle]].object];
            object.triangles.push_back(triangle);
            object.area += surface_area(surface, triangle);
        }
        for (std::uint32_t index = 0; index < m_objects.size(); ++index) {
            m_area += m_objects[index].area;
            m_wanted_area += m_objects[index].area * std::pow(wanted_density(index), 2.0);
        }
    }

    Atlas run() {
        for (std::uint32_t object = 0; object < m_objects.size(); ++object) {
            if (!m_objects[object].triangles.empty()) {
                find_charts(object);
            }
        }
        parallel_ranges(m_objects.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t object = begin; object < end; ++object) {
                if (m_objects[object].kept) {
                    find_kept_charts(m_objects[object], wanted_density(static_cast<std::uint32_t>(object)));
                }
            }
        });
        if (m_settings.layout == Layout::object) {
            lay_out_objects();
        } else if (!keep_one_atlas()) {
            lay_out_scene();
        }
        number_charts();
        m_notes.write(m_atlas.notes);
        return std::move(m_atlas);
    }

private:
    struct Object {
        std::vector<std::uint32_t> triangles; ///< in canonical order
        std::vector<Chart> charts;            ///< those made; or one, what the object's kept UVs cover
        double area = 0.0;                    ///< in bake-frame units
        bool kept = false;
    };

    void find_charts(std::uint32_t index) {
        Object& object = m_objects[index];
        const std::string& name = m_surface.objects[index].name;
        if (m_settings.uv != UvSource::make) {
            const UvFaults& faults = faults_of_uvs(index);
            const std::optional<std::string>& fault = m_settings.uv == UvSource::trust ? faults.unusable : faults.any();
            object.kept = !fault;
            if (fault && m_settings.uv != UvSource::automatic) {
                const std::string trust = faults.unusable ? "" : ", trust it (--uv trust)";
                throw Error(ErrorKind::bad_input, mesh_and_object(index) + ": TEXCOORD_1 " + *fault + "; correct it" +
                                                      trust + ", or let UVs be made (--uv auto or make)");
            }
            const std::string but = faults.overlap ? ", though it " + *faults.overlap : "";
            m_notes.add(fault ? "light-map UVs made, as TEXCOORD_1 " + *fault : "TEXCOORD_1 kept" + but, name);
        }
        if (!object.kept) {
            object.charts = m_settings.charts == ChartMaker::grown
                                ? make_grown_charts(m_surface, object.triangles, growth_limits(index), m_flat)
                                : make_polypacks(m_surface, object.triangles, m_flat);
            for (Chart& chart : object.charts) {
                chart.scale *= wanted_density(index);
            }
            name_charts(object.charts.size(), [&](std::size_t i) { return std::span(object.charts[i].triangles); });
        }
    }

    void find_kept_charts(Object& object, double density) {
        const auto islands = uv_islands(m_flat, object.triangles);
        name_charts(islands.size(), [&](std::size_t i) { return std::span(islands[i]); });
        object.charts.push_back(bounded_chart(object.triangles, m_flat));
        double area = 0.0;
        double uv_area = 0.0;
        for (const std::uint32_t triangle : object.triangles) {
            area += surface_area(m_surface, triangle);
            uv_area += flat_area(m_flat, triangle);
        }
        // Without UV area there is no surface either (else the UVs would not do): a texel is enough.
        object.charts.front().scale = uv_area > 0.0 ? std::sqrt(area / uv_area) * density : 0.0;
    }

    [[nodiscard]] GrowthLimits growth_limits(std::uint32_t index) const {
        constexpr double used = 0.6;         // of a page, about
        constexpr double free_texels = 76.0; // around faces so small gutters take more
        const double wanted = wanted_density(index);
        // Bake-frame units' squares a texel.
        const double texel_area = m_settings.density
                                      ? std::pow(m_surface.frame.scale() / (*m_settings.density * wanted), 2.0)
                                  : m_settings.layout == Layout::object
                                      ? m_objects[index].area / (used * m_settings.size * m_settings.size)
                                      : m_wanted_area / (wanted * wanted * used * m_settings.size * m_settings.size);
        return {m_settings.stretch, 0.1 * std::sqrt(m_area), free_texels * texel_area};
    }

    /// Reads the object's UVs into m_flat. Instances of one mesh share the answer.
    const UvFaults& faults_of_uvs(std::uint32_t index) {
        const SurfaceObject& object = m_surface.objects[index];
        std::vector<std::uint32_t> triangles = m_objects[index].triangles;
        std::sort(triangles.begin(), triangles.end());
        const std::uint32_t mesh = m_scene.instances[object.instance].mesh;
        const auto known = m_faults.find(mesh);
        if (known == m_faults.end()) {
            return m_faults.emplace(mesh, read_light_map_uvs(m_scene, m_surface, triangles, m_flat)).first->second;
        }
        if (!known->second.unusable) {
            for (const std::uint32_t triangle : triangles) {
                const std::uint32_t primitive = m_surface.parts[m_surface.parts_of[triangle]].primitive;
                const auto& uvs = m_scene.meshes[mesh].primitives[primitive].tex_coords[1];
                for (std::size_t c = 0; c < 3; ++c) {
                    m_flat[3 * std::size_t{triangle} + c] = uvs[m_surface.vertices[3 * std::size_t{triangle} + c]];
                }
            }
        }
        return known->second;
    }

    [[nodiscard]] std::string mesh_and_object(std::uint32_t index) const {
        const SurfaceObject& object = m_surface.objects[index];
        return "mesh \"" + m_scene.meshes[m_scene.instances[object.instance].mesh].name + "\" (object " + object.name +
               ")";
    }

    [[nodiscard]] double wanted_density(std::uint32_t object) const {
        const std::uint32_t instance = m_surface.objects[object].instance;
        return instance < m_scene.instances.size() ? m_scene.instances[instance].density : 1.0;
    }

    /// In any order: number_charts gives them their numbers.
    void name_charts(std::size_t count, const auto& triangles_of) {
        const std::uint32_t first = m_chart_names.fetch_add(static_cast<std::uint32_t>(count));
        for (std::size_t i = 0; i < count; ++i) {
            for (const std::uint32_t triangle : triangles_of(i)) {
                m_atlas.chart[triangle] = first + static_cast<std::uint32_t>(i);
            }
        }
    }

    /// Numbers charts in the order of their first triangles, so that the numbers do not depend on the order of objects.
    void number_charts() {
        m_atlas.chart_count = m_chart_names;
        std::vector<std::uint32_t> numbers(m_atlas.chart_count, no_chart);
        std::uint32_t next = 0;
        for (const std::uint32_t triangle : m_surface.canonical_order) {
            std::uint32_t& number = numbers[m_atlas.chart[triangle]];
            number = number == no_chart ? next++ : number;
            m_atlas.chart[triangle] = number;
        }
    }

    void keep_uvs(const Object& object, std::uint32_t page) {
        for (const std::uint32_t triangle : object.triangles) {
            std::copy_n(m_flat.begin() + 3 * static_cast<std::ptrdiff_t>(triangle), 3,
                        m_atlas.uvs.begin() + 3 * static_cast<std::ptrdiff_t>(triangle));
            m_atlas.page[triangle] = page;
        }
        if (m_settings.density) {
            m_notes.add("density not used where UVs are kept in place", m_atlas.pages[page].name);
        }
    }

    void add_page(const std::string& name, int width, int height) { m_atlas.pages.push_back({name, width, height}); }

    /// A page that keeps its UVs has the size that was asked for, or that the density asks for.
    [[nodiscard]] int kept_side(const Object& object) const {
        if (m_settings.size > 0 || object.charts.empty()) {
            return m_settings.size;
        }
        const double texels = *m_settings.density / m_surface.frame.scale() * object.charts.front().scale;
        return static_cast<int>(std::clamp(std::ceil(texels), 1.0, double{greatest_side}));
    }

    /// Of those whose UVs have area.
    [[nodiscard]] bool any_mesh_twice() const {
        std::set<std::uint32_t> meshes;
        for (std::size_t index = 0; index < m_objects.size(); ++index) {
            const std::vector<Chart>& charts = m_objects[index].charts;
            if (!charts.empty() && charts.front().scale > 0.0 &&
                !meshes.insert(m_scene.instances[m_surface.objects[index].instance].mesh).second) {
                return true;
            }
        }
        return false;
    }

    /// Where the scene came as one atlas it stays as it is.
    bool keep_one_atlas() {
        for (const Object& object : m_objects) {
            if (!object.kept && !object.triangles.empty()) {
                return false;
            }
        }
        if (any_mesh_twice() ||
            (m_settings.uv != UvSource::trust && first_overlap(m_flat, m_surface.canonical_order))) {
            return false;
        }
        int side = 1;
        for (const Object& object : m_objects) {
            side = std::max(side, kept_side(object));
        }
        add_page("lightmap", side, side);
        for (const Object& object : m_objects) {
            if (!object.triangles.empty()) {
                keep_uvs(object, 0);
            }
        }
        return true;
    }

    void lay_out_scene() {
        std::vector<Chart> charts;
        for (Object& object : m_objects) {
            std::move(object.charts.begin(), object.charts.end(), std::back_inserter(charts));
        }
        const Packing packing = pack_charts(charts, m_settings.max_pages, "scene");
        for (std::uint32_t page = 0; page < packing.page_count; ++page) {
            add_page(packing.page_count == 1 ? "lightmap" : "lightmap-" + std::to_string(page), packing.width,
                     packing.height);
        }
        place(charts, packing, 0);
        m_atlas.density = packing.density * m_surface.frame.scale();
    }

    void lay_out_objects() {
        for (std::uint32_t index = 0; index < m_objects.size(); ++index) {
            Object& object = m_objects[index];
            if (object.triangles.empty()) {
                continue;
            }
            const auto page = static_cast<std::uint32_t>(m_atlas.pages.size());
            const std::string& name = m_surface.objects[index].name;
            if (object.kept) {
                add_page(name, kept_side(object), kept_side(object));
                keep_uvs(object, page);
                continue;
            }
            const Packing packing = pack_charts(object.charts, 1, "object " + name);
            add_page(name, packing.width, packing.height);
            place(object.charts, packing, page);
            const double density = packing.density * m_surface.frame.scale();
            m_atlas.density = m_atlas.density > 0.0 ? std::min(m_atlas.density, density) : density;
        }
    }

    /// Sorts the charts by geometry, so that equal sizes are placed in an order that no file decides.
    Packing pack_charts(std::vector<Chart>& charts, int max_pages, const std::string& where) const {
        std::sort(charts.begin(), charts.end(), [&](const Chart& a, const Chart& b) {
            return m_rank[a.triangles.front()] < m_rank[b.triangles.front()];
        });
        const ChartPacker packer(charts, m_flat);
        const PageSettings pages{m_settings.size, m_settings.size, m_settings.gutter, max_pages};
        std::optional<double> density;
        if (m_settings.density) {
            density = *m_settings.density / m_surface.frame.scale();
        }
        auto packing = !density              ? packer.densest(pages)
                       : m_settings.size > 0 ? packer.on_pages(*density, pages)
                                             : packer.least_page(*density, m_settings.gutter);
        if (packing) {
            return std::move(*packing);
        }
        const std::string what = where + ": " + std::to_string(charts.size()) + " charts do not fit ";
        if (m_settings.size == 0) {
            throw Error(ErrorKind::usage, what +
                                              "a page of 16384² texels at this density; ask for a lower one, or give a "
                                              "size and allow more pages");
        }
        const auto side = packer.side_that_fits(density, pages);
        throw Error(ErrorKind::usage,
                    what + std::to_string(max_pages) + (max_pages == 1 ? " page of " : " pages of ") +
                        std::to_string(m_settings.size) + "² texels" + (density ? " at this density" : "") + "; " +
                        (side ? "use --size " + std::to_string(*side)
                              : std::string("no size up to 16384 does: allow more pages, or ask for a lower density")));
    }

    void place(const std::vector<Chart>& charts, const Packing& packing, std::uint32_t first_page) {
        parallel_ranges(charts.size(), 16, 0, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Placement& placement = packing.placements[i];
                place_chart(charts[i], packing.layouts[i], placement, glm::ivec2(packing.width, packing.height), m_flat,
                            m_atlas.uvs);
                repair_rounding(charts[i], m_flat, m_atlas.uvs);
                for (const std::uint32_t triangle : charts[i].triangles) {
                    m_atlas.page[triangle] = first_page + placement.page;
                }
            }
        });
    }

    const Scene& m_scene;
    const Surface& m_surface;
    const Settings& m_settings;
    double m_area = 0.0;               ///< of the surface, in bake-frame units
    double m_wanted_area = 0.0;        ///< by the squares of the densities that objects want
    std::vector<glm::vec2> m_flat;     ///< 3 a triangle: see Chart
    std::vector<std::uint32_t> m_rank; ///< by triangle: its place in canonical order
    std::vector<Object> m_objects;
    std::map<std::uint32_t, UvFaults> m_faults; ///< by mesh
    ObjectNotes m_notes;
    std::atomic<std::uint32_t> m_chart_names = 0;
    Atlas m_atlas;
};

} // namespace

Atlas make_atlas(const Scene& scene, const Surface& surface, const Settings& settings) {
    check_settings(settings);
    if (surface.triangle_count() == 0) {
        return {};
    }
    return AtlasMaker(scene, surface, settings).run();
}

} // namespace vkbake
