// The flags that say what is baked: shared by `bake` and `inspect`.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "vkbake/settings.hpp"
#include "vkbake/sky.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake::cli {

struct SkyOptions {
    std::string source = "clear";
    double rotation_degrees = 0.0;
    double intensity = 1.0;

    /// Throws Error{bad_input} where it cannot be read.
    [[nodiscard]] Sky load() const;
};

/// `options` must outlive the parsing.
void add_load_options(CLI::App& app, LoadSettings& settings);
void add_sky_options(CLI::App& app, SkyOptions& options);
void add_atlas_options(CLI::App& app, Settings& settings);
void add_light_options(CLI::App& app, Settings& settings);

} // namespace vkbake::cli
