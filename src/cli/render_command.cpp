#include "bake_options.hpp"
#include "choice.hpp"
#include "command.hpp"
#include "interrupt.hpp"

#include <filesystem>
#include <memory>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "vkbake/vkbake.hpp"

namespace vkbake::cli {
namespace {

struct RenderOptions {
    std::string scene;
    std::string output;
    std::string device;
    std::vector<double> eye;
    std::vector<double> target;
    double field_of_view = 45.0;
    LoadSettings load;
    SkyOptions sky;
    RenderSettings settings;
};

/// The scene itself, or the only .glb in the folder that a bake wrote.
std::filesystem::path find_scene(const std::string& text) {
    std::error_code ignored; // what is no folder, or cannot be looked at, is load_scene's to judge
    if (!std::filesystem::is_directory(text, ignored)) {
        return text;
    }
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(text)) {
        if (entry.path().extension() == ".glb") {
            found.push_back(entry.path());
        }
    }
    if (found.size() != 1) {
        throw Error(ErrorKind::bad_input,
                    fmt::format("{}: holds {} .glb files; name the one to draw", text, found.size()));
    }
    return found.front();
}

/// A camera at `eye` that looks at `target`, upright.
Camera look_at(const glm::dvec3& eye, const glm::dvec3& target, double field_of_view_degrees) {
    Camera camera;
    camera.name = "command line";
    camera.position = eye;
    camera.vertical_field_of_view = field_of_view_degrees * std::numbers::pi / 180.0;
    const glm::dvec3 backward = eye - target;
    if (!(glm::length(backward) > 0.0)) {
        throw Error(ErrorKind::usage, "--eye and --look-at are the same point; move one of them");
    }
    const glm::dvec3 back = glm::normalize(backward);
    // Looking straight up or down, +Z stands in for +Y.
    const glm::dvec3 up = std::abs(back.y) > 0.9999 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(up, back));
    camera.orientation = glm::dmat3(right, glm::cross(back, right), back);
    return camera;
}

int run_render(RenderOptions options) {
    const std::filesystem::path file = find_scene(options.scene);
    if (options.output.empty()) {
        options.output = file.stem().string() + ".png";
    }
    if (!options.eye.empty()) {
        const glm::dvec3 eye(options.eye[0], options.eye[1], options.eye[2]);
        const glm::dvec3 target = options.target.empty()
                                      ? glm::dvec3(0.0)
                                      : glm::dvec3(options.target[0], options.target[1], options.target[2]);
        options.settings.view = look_at(eye, target, options.field_of_view);
    }
    const Scene scene = load_scene(file, options.load);
    const Image picture = render(scene, options.sky.load(), options.settings, open_device({.name = options.device}));
    write_image(options.output, picture, stopping());
    fmt::print("{}\n", options.output);
    return exit_done;
}

} // namespace

void add_render_command(CLI::App& app, Invocation& invocation) {
    const auto options = std::make_shared<RenderOptions>();
    CLI::App& command = *app.add_subcommand("render", "Draw a baked scene with its light maps");
    command.add_option("scene", options->scene, "What bake wrote: the .glb or its folder")
        ->required()
        ->type_name("BAKED");
    command.add_option("-o,--output", options->output, "The picture; without it, BAKED.png here")->type_name("FILE");
    add_load_options(command, options->load);
    add_sky_options(command, options->sky);
    command.add_option("--width", options->settings.width, "Pixels")
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    command.add_option("--height", options->settings.height, "Pixels")
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    command
        .add_option("--camera", options->settings.camera,
                    "One of the scene's cameras; without it, the first, or a view of it all")
        ->type_name("NAME");
    CLI::Option* eye = command.add_option("--eye", options->eye, "Look from here instead, metres")
                           ->delimiter(',')
                           ->expected(3)
                           ->type_name("X,Y,Z");
    command.add_option("--look-at", options->target, "Towards here")
        ->delimiter(',')
        ->expected(3)
        ->type_name("X,Y,Z")
        ->needs(eye);
    command.add_option("--field-of-view", options->field_of_view, "Of --eye, vertical, degrees")
        ->check(CLI::Range(1.0, 170.0))
        ->capture_default_str();
    command.add_flag("--light-only", options->settings.light_only, "The light maps on grey surfaces");
    command.add_flag("--checker", options->settings.checker, "A checker of the light maps' texels instead of light");
    add_choice(command, "--directional", options->settings.directional,
               "Draw normal maps, lit by the directional light maps that lie beside the scene");
    command.add_flag("--probes", options->settings.probes, "Light probes as white balls");
    command.add_option("--exposure", options->settings.exposure, "Stops")->capture_default_str();
    command.add_option("--device", options->device, "Part of the Vulkan device's name")->type_name("NAME");
    command.final_callback([options, &invocation] { invocation.run = [options] { return run_render(*options); }; });
}

} // namespace vkbake::cli
