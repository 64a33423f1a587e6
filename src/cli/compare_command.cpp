#include "command.hpp"
#include "interrupt.hpp"
#include "text.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "vkbake/report.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake::cli {
namespace {

struct CompareOptions {
    std::string a;
    std::string b;
    std::string difference;
    std::optional<double> max_error;
    bool allow_partial = false;
    bool json = false;
};

/// Of the larger coverage, what both must share for a comparison to speak of the same map.
constexpr double least_shared_coverage = 0.95;

void print_comparison(const Comparison& comparison) {
    fmt::print("texels compared        {} (A covers {}, B covers {})\n", grouped(comparison.covered_both),
               grouped(comparison.covered_a), grouped(comparison.covered_b));
    if (comparison.not_finite > 0) {
        fmt::print("left out, not finite   {}\n", grouped(comparison.not_finite));
    }
    fmt::print("mean                   A {:.6g}, B {:.6g}\n", comparison.mean_a, comparison.mean_b);
    fmt::print("root-mean-square       {:.6g}\n", comparison.root_mean_square);
    fmt::print("relative               {:.6g} (root-mean-square / mean of A: what --max-error judges)\n",
               comparison.relative_root_mean_square);
    fmt::print("relative, luminance    {:.6g} (what --target-error asks for)\n", comparison.relative_luminance_rmse);
    fmt::print("maximum                {:.6g} at texel ({}, {})\n", comparison.maximum, comparison.maximum_x,
               comparison.maximum_y);
}

/// |a − b| scaled so that the largest difference is white: otherwise small errors could not be seen.
Image visible_difference(const Comparison& comparison) {
    Image picture = comparison.difference;
    const auto scale = comparison.maximum > 0.0 ? static_cast<float>(1.0 / comparison.maximum) : 0.0F;
    for (glm::vec4& texel : picture.texels) {
        texel = glm::vec4(glm::vec3(texel) * scale, 1.0F);
    }
    return picture;
}

int run_compare(const CompareOptions& options) {
    const Comparison comparison = compare(read_image(options.a), read_image(options.b));
    if (options.json) {
        fmt::print("{}\n", to_json(comparison));
    } else {
        print_comparison(comparison);
    }
    if (!options.difference.empty()) {
        write_image(options.difference,
                    options.difference.ends_with(".png") ? visible_difference(comparison) : comparison.difference,
                    stopping());
    }
    const auto larger = static_cast<double>(std::max(comparison.covered_a, comparison.covered_b));
    if (!options.allow_partial && static_cast<double>(comparison.covered_both) < least_shared_coverage * larger) {
        fmt::print(
            stderr,
            "vkbake: the images cover different texels: both cover {} of {}; give --allow-partial if that is meant\n",
            grouped(comparison.covered_both), grouped(std::max(comparison.covered_a, comparison.covered_b)));
        return exit_failed;
    }
    if (options.max_error && !(comparison.relative_root_mean_square <= *options.max_error)) {
        fmt::print(stderr, "vkbake: the relative error {:.6g} is above --max-error {:.6g}\n",
                   comparison.relative_root_mean_square, *options.max_error);
        return exit_failed;
    }
    return exit_done;
}

} // namespace

void add_compare_command(CLI::App& app, Invocation& invocation) {
    const auto options = std::make_shared<CompareOptions>();
    CLI::App& command = *app.add_subcommand("compare", "Measure the difference between two light maps or pictures");
    command.add_option("a", options->a, "The reference")->required()->type_name("A");
    command.add_option("b", options->b, "What is compared with it")->required()->type_name("B");
    command
        .add_option("--difference", options->difference,
                    "Write |a - b| to this image (.png: scaled so that the largest is white)")
        ->type_name("FILE");
    command
        .add_option("--max-error", options->max_error,
                    "Exit with 1 above this relative root-mean-square error of all channels")
        ->check(CLI::NonNegativeNumber);
    command.add_flag("--allow-partial", options->allow_partial, "Compare though the two cover different texels");
    command.add_flag("--json", options->json, "Print the figures as JSON");
    command.final_callback([options, &invocation] { invocation.run = [options] { return run_compare(*options); }; });
}

} // namespace vkbake::cli
