#include "trace/contrasts.hpp"

#include <algorithm>
#include <cmath>

namespace vkbake {

namespace {

/// σ²(N) / σ²(n), n the largest power of two below N = (1 + s) n: the variance of a mean of two blocks of n and s n
/// samples, whose covariance is that of halves, (2ρ − 1) σ²(n), and of which the shorter one has σ²(n) / s^1.5 by
/// itself.
double beyond_power_of_two(double ratio, std::uint32_t rays) {
    const double share = static_cast<double>(rays) / static_cast<double>(std::bit_floor(rays)) - 1.0;
    return (1.0 + std::sqrt(share) + 2.0 * share * (2.0 * ratio - 1.0)) / ((1.0 + share) * (1.0 + share));
}

} // namespace

Contrasts contrasts(const std::array<float, part_count>& sums, std::uint32_t rays) {
    std::array<double, part_count> means{};
    const double samples_a_part = static_cast<double>(1U << part_shift(rays));
    for (std::size_t part = 0; part < part_count; ++part) {
        means[part] = static_cast<double>(sums[part]) / samples_a_part;
    }
    Contrasts result;
    std::size_t count = part_count;
    for (double& square : result.squares) {
        count /= 2;
        for (std::size_t pair = 0; pair < count; ++pair) {
            const double half = 0.5 * (means[2 * pair] - means[2 * pair + 1]);
            square += half * half / static_cast<double>(count);
            means[pair] = 0.5 * (means[2 * pair] + means[2 * pair + 1]);
        }
    }
    return result;
}

void FallOfVariance::add(const Contrasts& of_a_texel) {
    m_fine += of_a_texel.squares[0] + of_a_texel.squares[1];
    m_coarse += of_a_texel.squares[1] + of_a_texel.squares[2];
}

double FallOfVariance::ratio() const {
    constexpr double steepest = 0.21763764082403103; // 2^−2.2
    constexpr double usual = 0.35355339059327373;    // 2^−1.5
    return m_fine > 0.0 ? std::clamp(m_coarse / m_fine, steepest, 0.5) : usual;
}

double variance(const Contrasts& contrasts, double ratio, std::uint32_t rays) {
    const auto& squares = contrasts.squares;
    const double sum = 4.0 * squares[0] * ratio * ratio * ratio + 2.0 * squares[1] * ratio * ratio + squares[2] * ratio;
    return sum / (static_cast<double>(contrast_count) * (1.0 - ratio)) * beyond_power_of_two(ratio, rays);
}

double coarse_variance(const Contrasts& contrasts, double ratio, std::uint32_t rays) {
    const double sum = contrasts.squares[1] * ratio * ratio + contrasts.squares[2] * ratio;
    return 0.5 * sum / (1.0 - ratio) * beyond_power_of_two(ratio, rays);
}

} // namespace vkbake
