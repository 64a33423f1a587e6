// vkbake: a glTF scene in, light maps and a glTF that uses them out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vkbake/compare.hpp"
#include "vkbake/device.hpp"
#include "vkbake/error.hpp"
#include "vkbake/inspect.hpp"
#include "vkbake/lightmap.hpp"
#include "vkbake/plan.hpp"
#include "vkbake/progress.hpp"
#include "vkbake/render.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/sky.hpp"
#include "vkbake/uv_report.hpp"

namespace vkbake {

/// "1.2.3"
[[nodiscard]] std::string version();

struct LoadSettings {
    /// Files that the scene refers to may lie outside its folder (by "..", never by an absolute path): for scenes that
    /// are trusted. Links are followed either way.
    bool outside_files = false;
};

/// Reads .gltf or .glb. Throws Error{bad_input} that names file, node, mesh or accessor.
[[nodiscard]] Scene load_scene(const std::filesystem::path& file, const LoadSettings& settings = {});

/// `text`: "clear", "R,G,B", an equirectangular .hdr/.exr, a cube map as a strip or cross (found from its aspect), or
/// six files in Vulkan's face order, separated by commas. Throws Error{bad_input}.
[[nodiscard]] Sky load_sky(const std::string& text);

/// Atlas, geometry image, trace, finish. The same input gives the same bytes (all but `seconds`).
[[nodiscard]] Bake bake(const Scene& scene, const Sky& sky, const Settings& settings, const Device& device,
                        const Progress& progress = {});

enum class LightMapFormat : std::uint8_t { exr, hdr, png };

struct WriteSettings {
    std::filesystem::path directory;
    LightMapFormat format = LightMapFormat::exr;
    std::string command; ///< kept in the manifest as provenance; may be empty
};

/// Writes lightmaps/NAME.exr, SCENE.glb (where the scene has a source), probes.json (where the bake has probes) and,
/// last, manifest.json; returns their paths,
/// relative to the directory, manifest last. Each appears under its name only when complete. `progress` is asked many
/// times a second until the first takes its name; where it returns false nothing has changed in the directory.
/// Throws Error{output}, Error{interrupted}.
std::vector<std::filesystem::path> write_bake(const Scene& scene, const Bake& bake, const WriteSettings& settings,
                                              const Progress& progress = {});

/// Loads what reads image files and writes HDR, up to half a second's work that else waits for the first such image. A
/// program may call it beside other work, from any thread, and so know early whether it is there. Throws
/// Error{bake_failed}.
void load_image_codec();

/// EXR, HDR, PNG or JPEG, told from the first bytes; 8-bit files are taken for sRGB and linearised. Throws
/// Error{bad_input}.
[[nodiscard]] Image read_image(const std::filesystem::path& file);

/// EXR and HDR: the values as they are (EXR with coverage); PNG: 8 bits, the values clamped to [0,1] and written as
/// they are (render's are encoded already). Written beside, then renamed. `progress` as write_bake's. Throws
/// Error{output}, Error{interrupted}.
void write_image(const std::filesystem::path& file, const Image& image, const Progress& progress = {});

} // namespace vkbake
