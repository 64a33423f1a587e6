#include "bench/common/measure.hpp"

namespace vkbake::bench {
namespace {

double ray_count(const Entry& entry) { return static_cast<double>(entry.contender->rays().ray_count); }

double median_quotient(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> quotients;
    for (std::size_t round = 0; round < a.size(); ++round) {
        quotients.push_back(a[round] / b[round]);
    }
    return median(quotients);
}

} // namespace

double Entry::rays_per_second(int threads) const {
    return static_cast<double>(contender->rays().ray_count) / median(seconds.at(threads));
}

void measure(std::vector<Entry>& entries, const std::vector<int>& threads, int repeats, PassClock clock) {
    for (Entry& entry : entries) {
        (void)seconds_of(*entry.contender, entry.pass, 1);
    }
    for (std::size_t round = 0; round < static_cast<std::size_t>(repeats); ++round) {
        for (const int count : threads) {
            for (std::size_t i = 0; i < entries.size(); ++i) {
                Entry& entry = entries[(i + round) % entries.size()];
                const PassSeconds seconds = seconds_of(*entry.contender, entry.pass, count);
                entry.seconds[count].push_back(clock == PassClock::wall ? seconds.wall : seconds.cpu);
            }
        }
    }
}

double ratio(const Entry& a, const Entry& b, int threads) {
    return median_quotient(b.seconds.at(threads), a.seconds.at(threads)) * ray_count(a) / ray_count(b);
}

double gain(const Entry& entry, int few_threads, int many_threads) {
    return median_quotient(entry.seconds.at(few_threads), entry.seconds.at(many_threads));
}

} // namespace vkbake::bench
