// Flags whose value is one of an enum's names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "vkbake/names.hpp"

namespace vkbake::cli {

/// `Target`: what an Enum can be assigned to.
template<typename Enum, typename Target>
CLI::Option* add_choice_of(CLI::App& app, const std::string& flag, Target& target, const std::string& help) {
    std::string choices;
    std::vector<std::string> names;
    for (const auto& [name, value] : Names<Enum>::values) {
        names.emplace_back(name);
        choices += (choices.empty() ? "" : "|") + std::string(name);
    }
    return app
        .add_option_function<std::string>(
            flag, [&target](const std::string& text) { target = value_named<Enum>(text).value(); }, help)
        ->check([names, choices](const std::string& text) {
            return std::find(names.begin(), names.end(), text) != names.end()
                       ? std::string()
                       : "\"" + text + "\" is not one of " + choices;
        })
        ->type_name(choices);
}

template<typename Enum>
CLI::Option* add_choice(CLI::App& app, const std::string& flag, Enum& target, const std::string& help) {
    return add_choice_of<Enum>(app, flag, target, help)->default_str(std::string(name_of(target)));
}

/// Without the flag the target stays as it is.
template<typename Enum>
CLI::Option* add_choice(CLI::App& app, const std::string& flag, std::optional<Enum>& target, const std::string& help) {
    return add_choice_of<Enum>(app, flag, target, help);
}

} // namespace vkbake::cli
