// Pearson's test of counts against expected ones, for many tests at once.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>

namespace vkbake::test {

/// The share of a χ² distribution above `statistic`: the regularised upper incomplete gamma function Q(k/2, x/2), by
/// its series below k/2 + 1 and Lentz's continued fraction above (Press et al., Numerical Recipes, §6.2).
inline double chi_squared_tail(double statistic, double degrees) {
    const double a = degrees / 2.0;
    const double x = statistic / 2.0;
    const double factor = std::exp(-x + a * std::log(x) - std::lgamma(a));
    if (x < a + 1.0) {
        double term = 1.0 / a;
        double sum = term;
        for (int n = 1; n < 2000; ++n) {
            term *= x / (a + n);
            sum += term;
        }
        return 1.0 - sum * factor;
    }
    double b = x + 1.0 - a;
    double c = 1e300;
    double d = 1.0 / b;
    double h = d;
    for (int i = 1; i < 2000; ++i) {
        const double an = -i * (i - a);
        b += 2.0;
        d = 1.0 / (an * d + b);
        c = b + an / c;
        h *= d * c;
    }
    return factor * h;
}

/// The p-value of equally likely cells.
inline double uniform_p_value(std::span<const std::uint32_t> counts) {
    double total = 0.0;
    for (const std::uint32_t count : counts) {
        total += count;
    }
    const double expected = total / static_cast<double>(counts.size());
    double statistic = 0.0;
    for (const std::uint32_t count : counts) {
        statistic += (count - expected) * (count - expected) / expected;
    }
    return chi_squared_tail(statistic, static_cast<double>(counts.size() - 1));
}

/// Šidák's correction: the level of each of `tests` independent tests that together cry wolf with probability `level`.
inline double corrected_level(double level, int tests) { return 1.0 - std::pow(1.0 - level, 1.0 / tests); }

} // namespace vkbake::test
