// Interleaved passes of all contenders.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bench/common/contender.hpp"

namespace vkbake::bench {

/// Wall time is what counts; on a machine that others use meanwhile, processor time gives the better ratios.
enum class PassClock { wall, cpu };

/// A contender in one kind of pass.
struct Entry {
    std::string who;
    Contender* contender = nullptr;
    Pass pass = Pass::ask;
    std::map<int, std::vector<double>> seconds; ///< by number of threads, one a repetition

    [[nodiscard]] double rays_per_second(int threads) const; ///< by the median
};

/// One pass of each to warm up, then `repeats` rounds; in each round every entry has a pass with each number of
/// threads. Rounds start at different entries, so that none always follows the same one.
void measure(std::vector<Entry>& entries, const std::vector<int>& threads, int repeats, PassClock clock);

/// Median over the rounds of a's rate to b's in the same round.
[[nodiscard]] double ratio(const Entry& a, const Entry& b, int threads);

/// Median over the rounds of the rate with many threads to that with few.
[[nodiscard]] double gain(const Entry& entry, int few_threads, int many_threads);

} // namespace vkbake::bench
