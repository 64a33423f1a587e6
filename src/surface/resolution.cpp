#include "surface/resolution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "surface/bake_frame.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

using Corners = std::array<glm::dvec3, 3>;

double longest_edge(const Corners& p) {
    return std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
}

double doubled_area(const Corners& p) { return glm::length(glm::cross(p[1] - p[0], p[2] - p[0])); }

std::string metres(double length) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%.3g m", length); // %g: no locale of ours sets another point
    return text.data();
}

/// "A, B and 3 more": the first few of many.
std::string listed(std::span<const std::string> names) {
    constexpr std::size_t named = 8;
    std::string line;
    for (std::size_t i = 0; i < std::min(names.size(), named); ++i) {
        line += (i > 0 ? ", " : "") + names[i];
    }
    if (names.size() > named) {
        line += " and " + std::to_string(names.size() - named) + " more";
    }
    return line;
}

/// What one object has before the frame rounds it, and what is left.
struct ObjectExtent {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
    std::uint64_t with_area = 0; ///< triangles
    std::uint64_t kept = 0;      ///< … that have area in the frame
    std::uint64_t small = 0;     ///< … that span fewer than 64 steps

    [[nodiscard]] double span() const {
        const glm::dvec3 size = high - low;
        return std::max({size.x, size.y, size.z});
    }
};

class Resolution {
public:
    Resolution(const Scene& scene, const Surface& surface)
        : m_scene(scene), m_surface(surface), m_step(frame_step / surface.frame.scale()) {}

    std::vector<std::string> check() {
        for (std::uint32_t index = 0; index < m_surface.objects.size(); ++index) {
            judge(m_surface.objects[index], measure(index));
        }
        std::vector<std::string> notes;
        if (!m_has_area) {
            notes.push_back(m_scene.name + ": no triangle has area, so there is nothing that light could fall on");
        }
        if (m_small > 0) {
            notes.push_back(std::to_string(m_small) + " triangles span fewer than 64 steps of the bake frame, " +
                            metres(resolved_steps * m_step) +
                            " in a scene of this size; their light is coarse: " + listed(m_with_small));
        }
        if (m_lost > 0) {
            notes.push_back(std::to_string(m_lost) + " triangles are thinner than the bake frame's step, " +
                            metres(m_step) + " in a scene of this size, and are left out: " + listed(m_with_lost));
        }
        return notes;
    }

private:
    [[nodiscard]] ObjectExtent measure(std::uint32_t index) const {
        const SurfaceObject& object = m_surface.objects[index];
        const Instance& instance = m_scene.instances[object.instance];
        const Mesh& mesh = m_scene.meshes[instance.mesh];
        ObjectExtent extent;
        const std::uint32_t end = object.first_triangle + object.triangle_count;
        for (std::uint32_t triangle = object.first_triangle; triangle < end; ++triangle) {
            const SurfacePart& part = m_surface.parts[m_surface.parts_of[triangle]];
            const std::vector<glm::vec3>& positions = mesh.primitives[part.primitive].positions;
            Corners corners{};
            for (std::size_t c = 0; c < 3; ++c) {
                corners[c] =
                    transform_vertex(instance.linear, positions[m_surface.vertices[3 * std::size_t{triangle} + c]]);
            }
            if (!(doubled_area(corners) > 0.0)) {
                continue; // nothing that could be lost
            }
            for (const glm::dvec3& corner : corners) {
                extent.low = glm::min(extent.low, corner);
                extent.high = glm::max(extent.high, corner);
            }
            ++extent.with_area;
            const bool kept = m_surface.geometric_normals[triangle] != glm::vec3(0.0F);
            extent.kept += kept ? 1 : 0;
            extent.small += kept && longest_edge(corners) < resolved_steps * m_step ? 1 : 0;
        }
        return extent;
    }

    void judge(const SurfaceObject& object, const ObjectExtent& extent) {
        if (extent.with_area == 0) {
            return;
        }
        m_has_area = true;
        if (extent.span() < resolved_steps * m_step || extent.kept == 0) {
            throw Error(ErrorKind::bad_input,
                        m_scene.name + ": object \"" + object.name + "\" spans " + metres(extent.span()) +
                            (extent.kept == 0 ? " and is thinner than a step" : ", fewer than 64 steps") +
                            " of the bake frame, which in a scene of " + metres(1.0 / m_surface.frame.scale()) +
                            " is " + metres(m_step) + "; bake it apart from what is so large or far");
        }
        if (extent.small > 0) {
            m_small += extent.small;
            m_with_small.push_back(object.name);
        }
        if (extent.kept < extent.with_area) {
            m_lost += extent.with_area - extent.kept;
            m_with_lost.push_back(object.name);
        }
    }

    const Scene& m_scene;
    const Surface& m_surface;
    double m_step;           ///< metres
    bool m_has_area = false; ///< any
    std::uint64_t m_small = 0;
    std::uint64_t m_lost = 0;
    std::vector<std::string> m_with_small;
    std::vector<std::string> m_with_lost;
};

} // namespace

std::vector<std::string> check_resolution(const Scene& scene, const Surface& surface) {
    return Resolution(scene, surface).check();
}

std::vector<std::string> note_small_texels(const Surface& surface, const Atlas& atlas) {
    std::vector<bool> small(surface.objects.size(), false);
    for (std::size_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
        const AtlasPage& page = atlas.pages[atlas.page[triangle]];
        Corners flat{};
        Corners corners{};
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::vec2 uv = atlas.uvs[3 * triangle + c];
            flat[c] = {static_cast<double>(uv.x) * page.width, static_cast<double>(uv.y) * page.height, 0.0};
            corners[c] = glm::dvec3(surface.positions[3 * triangle + c]);
        }
        const double texels = doubled_area(flat);
        const double area = doubled_area(corners);
        // Less than a texel says nothing of the texels' size: places in the map are rounded.
        if (texels > 2.0 && area > 0.0 && std::sqrt(area / texels) < resolved_steps * frame_step) {
            small[surface.parts[surface.parts_of[triangle]].object] = true;
        }
    }
    std::vector<std::string> names;
    for (std::size_t object = 0; object < small.size(); ++object) {
        if (small[object]) {
            names.push_back(surface.objects[object].name);
        }
    }
    if (names.empty()) {
        return {};
    }
    return {"texels are smaller than 64 steps of the bake frame, " +
            metres(resolved_steps * frame_step / surface.frame.scale()) +
            " in a scene of this size; finer detail than that is not resolved: " + listed(names)};
}

} // namespace vkbake
