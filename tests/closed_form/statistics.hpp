// Estimates held against what they estimate.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace vkbake::test {

/// Mean, and the standard error of it as the scatter of independent estimates shows it.
struct MeanEstimate {
    double mean = 0.0;
    double standard_error = 0.0;
    double standard_deviation = 0.0; ///< of one estimate
};

inline MeanEstimate estimate_mean(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    const double mean = sum / count;
    double squares = 0.0;
    for (const double value : values) {
        squares += (value - mean) * (value - mean);
    }
    const double deviation = std::sqrt(squares / (count - 1.0));
    return {mean, deviation / std::sqrt(count), deviation};
}

/// A normal variable strays this many standard errors with probability 7e-6: over the some hundred comparisons of these
/// tests one fails by chance for one seed in a thousand.
inline constexpr double allowed_errors = 4.5;

} // namespace vkbake::test
