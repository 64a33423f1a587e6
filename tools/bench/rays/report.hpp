// What came out, for people and for the results' folder.
#pragma once

#include <cstdio>

#include "base/json.hpp"
#include "bench/rays/contest.hpp"

namespace vkbake::bench {

void print_outcome(const Options& options, const Outcome& outcome, const Json& machine);
[[nodiscard]] Json to_json(const Options& options, const Outcome& outcome, const Json& machine);

} // namespace vkbake::bench
