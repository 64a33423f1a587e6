// manifest.json: what was baked, how, and which files belong to it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "vkbake/lightmap.hpp"

namespace vkbake {

struct WrittenFile {
    std::string file; ///< relative to the manifest's folder, '/' between folders
    std::uint64_t bytes = 0;
    std::string hash; ///< hash_of
};

/// A light map's file, in the order of Bake::light_maps.
struct WrittenMap {
    std::string file;
    std::string error_file;                     ///< of the texels' standard errors; empty where there are none
    std::string rays_file;                      ///< of the texels' sample counts; as above
    std::vector<std::string> directional_files; ///< of LightMap::directional
    double intensity = 1.0;                     ///< DisplayMap::intensity
    std::uint64_t changed_values = 0;           ///< EncodedFile::changed_values
};

/// All times, and what changes nothing but them, lie under "timing"; the rest is the same for each run of the same
/// bake.
[[nodiscard]] Json make_manifest(const std::string& scene, const Bake& bake, const std::string& command,
                                 std::span<const WrittenMap> maps, std::span<const WrittenFile> files,
                                 std::span<const std::string> notes);

/// Settings under the names of the command line's flags, without "threads".
[[nodiscard]] Json settings_json(const Settings& settings);

/// Size, coverage and statistics of one map; no times.
[[nodiscard]] Json counts_json(const LightMap& map);

/// Reads DIRECTORY/manifest.json and every file that it lists. Throws Error{bad_input} where one is missing, lies
/// outside the directory, or is not the one that was written.
[[nodiscard]] Json read_manifest(const std::filesystem::path& directory);

/// For who reads a scene that may be a bake's: where a manifest of this project lies beside it and lists `file`, all of
/// read_manifest's checks; else nothing. A run that was killed between two renames leaves files of two bakes.
void check_bake_of(const std::filesystem::path& directory, const std::string& file);

} // namespace vkbake
