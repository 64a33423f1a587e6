// What every subcommand is: options added to the application, and what runs when it was chosen.
#pragma once

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

namespace vkbake::cli {

/// One run of the program: what was typed, and the work that its subcommand stands for.
struct Invocation {
    std::string text;         ///< the command line's words, separated by blanks
    std::function<int()> run; ///< returns the exit status
};

/// Adds a subcommand; when it is chosen it sets invocation.run.
using AddCommand = void (*)(CLI::App& app, Invocation& invocation);

void add_bake_command(CLI::App& app, Invocation& invocation);
void add_inspect_command(CLI::App& app, Invocation& invocation);
void add_render_command(CLI::App& app, Invocation& invocation);
void add_compare_command(CLI::App& app, Invocation& invocation);
void add_tradeoff_command(CLI::App& app, Invocation& invocation);
void add_devices_command(CLI::App& app, Invocation& invocation);

/// The exit statuses beside those of ErrorKind.
constexpr int exit_done = 0;
constexpr int exit_failed = 1;

} // namespace vkbake::cli
