#include "command.hpp"
#include "interrupt.hpp"

#include <array>
#include <exception>

#include <fmt/format.h>

#include "vkbake/vkbake.hpp"

namespace {

using namespace vkbake;

constexpr std::array<cli::AddCommand, 6> commands{cli::add_bake_command,     cli::add_inspect_command,
                                                  cli::add_render_command,   cli::add_compare_command,
                                                  cli::add_tradeoff_command, cli::add_devices_command};

int parse_and_run(int argument_count, char** arguments) {
    CLI::App app("Light maps for glTF scenes: a scene in, light maps and a glTF that uses them out.", "vkbake");
    app.set_version_flag("--version", "vkbake " + version());
    app.require_subcommand(1);
    app.option_defaults()->take_last(); // so that a script can override its own defaults
    cli::Invocation invocation{.text = "vkbake", .run = {}};
    for (int argument = 1; argument < argument_count; ++argument) {
        invocation.text += std::string(" ") + arguments[argument];
    }
    for (const cli::AddCommand add : commands) {
        add(app, invocation);
    }
    try {
        app.parse(argument_count, arguments);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) { // --help, --version
            return app.exit(error);
        }
        fmt::print(stderr, "vkbake: {}; see vkbake --help\n", error.what());
        return static_cast<int>(ErrorKind::usage);
    }
    cli::end_on_interrupt();
    return invocation.run();
}

} // namespace

int main(int argument_count, char** arguments) {
    try {
        return parse_and_run(argument_count, arguments);
    } catch (const Error& error) {
        fmt::print(stderr, "vkbake: {}{}\n", error.what(),
                   error.kind() == ErrorKind::interrupted ? "; nothing was written" : "");
        return static_cast<int>(error.kind());
    } catch (const std::exception& error) {
        fmt::print(stderr, "vkbake: internal error: {}; please report it\n", error.what());
        return cli::exit_failed;
    }
}
