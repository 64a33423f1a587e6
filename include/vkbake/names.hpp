// One name for each choice, the same in flags, manifests, code and documentation.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "vkbake/settings.hpp"

namespace vkbake {

/// Specialised for each enum of settings.hpp: `values` lists every value once with its name.
template<typename Enum>
struct Names;

template<>
struct Names<Layout> {
    static constexpr std::array<std::pair<std::string_view, Layout>, 2> values{
        {{"atlas", Layout::atlas}, {"object", Layout::object}}};
};

template<>
struct Names<UvSource> {
    static constexpr std::array<std::pair<std::string_view, UvSource>, 4> values{{{"auto", UvSource::automatic},
                                                                                  {"keep", UvSource::keep},
                                                                                  {"trust", UvSource::trust},
                                                                                  {"make", UvSource::make}}};
};

template<>
struct Names<ChartMaker> {
    static constexpr std::array<std::pair<std::string_view, ChartMaker>, 2> values{
        {{"grown", ChartMaker::grown}, {"polypack", ChartMaker::polypack}}};
};

template<>
struct Names<Mode> {
    static constexpr std::array<std::pair<std::string_view, Mode>, 3> values{
        {{"irradiance", Mode::irradiance}, {"ao", Mode::ao}, {"bent-normal", Mode::bent_normal}}};
};

template<>
struct Names<Falloff> {
    static constexpr std::array<std::pair<std::string_view, Falloff>, 3> values{
        {{"none", Falloff::none}, {"linear", Falloff::linear}, {"square", Falloff::square}}};
};

template<>
struct Names<Switch> {
    static constexpr std::array<std::pair<std::string_view, Switch>, 2> values{
        {{"on", Switch::on}, {"off", Switch::off}}};
};

template<>
struct Names<Alpha> {
    static constexpr std::array<std::pair<std::string_view, Alpha>, 2> values{
        {{"traced", Alpha::traced}, {"opaque", Alpha::opaque}}};
};

template<>
struct Names<Sampler> {
    static constexpr std::array<std::pair<std::string_view, Sampler>, 4> values{{{"cosine", Sampler::cosine},
                                                                                 {"stratified", Sampler::stratified},
                                                                                 {"uniform", Sampler::uniform},
                                                                                 {"thesis", Sampler::thesis}}};
};

template<>
struct Names<Accelerator> {
    static constexpr std::array<std::pair<std::string_view, Accelerator>, 3> values{
        {{"bvh", Accelerator::bvh}, {"clusters", Accelerator::clusters}, {"brute", Accelerator::brute}}};
};

template<>
struct Names<TriangleTest> {
    static constexpr std::array<std::pair<std::string_view, TriangleTest>, 2> values{
        {{"watertight", TriangleTest::watertight}, {"moller-trumbore", TriangleTest::moller_trumbore}}};
};

/// The value's name; empty for a value that the enum does not have.
template<typename Enum>
[[nodiscard]] constexpr std::string_view name_of(Enum value) {
    for (const auto& [name, candidate] : Names<Enum>::values) {
        if (candidate == value) {
            return name;
        }
    }
    return {};
}

/// The value with that name, if there is one.
template<typename Enum>
[[nodiscard]] constexpr std::optional<Enum> value_named(std::string_view text) {
    for (const auto& [name, candidate] : Names<Enum>::values) {
        if (name == text) {
            return candidate;
        }
    }
    return std::nullopt;
}

} // namespace vkbake
