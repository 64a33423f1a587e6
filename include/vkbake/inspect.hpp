// What a scene has, and what a bake of it would take.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "vkbake/plan.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/sky.hpp"

namespace vkbake {

struct Inspection {
    std::size_t meshes = 0;
    std::size_t instances = 0;
    std::size_t materials = 0;
    std::size_t images = 0;
    std::size_t cameras = 0;
    std::size_t lamps = 0;
    std::uint64_t triangles = 0; ///< over all instances
    double area = 0.0;           ///< square metres, over all instances
    glm::dvec3 box_low{0.0};     ///< metres
    glm::dvec3 box_high{0.0};
    std::size_t instances_with_uvs = 0;  ///< whose primitives all have TEXCOORD_1
    std::vector<std::string> light_maps; ///< that baked materials refer to
    // What a bake with the settings given would make
    std::uint32_t charts = 0;
    std::size_t pages = 0;
    double density = 0.0;             ///< texels per metre; 0 where all UVs are kept
    std::uint64_t covered_texels = 0; ///< estimate
    std::uint64_t rays = 0;           ///< estimate; of bounces, where an error is asked for, as if it were not; of a
                                      ///< denoised map, where one is, as if it were not denoised: the most it takes
    double trace_seconds = 0.0;     ///< of direct light on this machine, estimate from texels that were traced; 0 where
                                    ///< none were, as there is not the memory for it
    std::optional<double> error;    ///< of direct light, relative, likewise; absent where it is not estimated
    std::uint64_t memory = 0;       ///< bytes at the most, estimate
    std::uint64_t memory_limit = 0; ///< bytes that the settings, or by default the machine, allow
    std::vector<PlanEntry> plan;    ///< make_plan's
    std::vector<std::string> notes;
};

[[nodiscard]] Inspection inspect(const Scene& scene, const Settings& settings, const Sky& sky = {});

} // namespace vkbake
