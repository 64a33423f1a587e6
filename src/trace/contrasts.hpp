// How far a texel's estimate is from the truth, seen from its own samples.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace vkbake {

/// A texel's first 2^m samples are cut into eight *parts*, aligned blocks of 2^(m − 3): replicates that cost no ray and
/// no convergence, for all eight together are still one sequence.
///
/// Why that is enough. Let σ²(n) be the variance of the mean of an aligned block of n samples. Exchanging blocks by an
/// exclusive or of the sample's number is a digital shift, which a nested uniform scramble (Owen 1995) has absorbed: so
/// the two halves A and B of an aligned block of 2n samples are exchangeable, the differences between halves
/// ("contrasts", Haar's and Walsh's) are uncorrelated, and with M = (A + B) / 2
///
///     E ((A − B) / 2)² = (Var A − Cov(A, B)) / 2 = σ²(n) − σ²(2n).
///
/// Seven such squares, on three scales, so show how the variance falls, though the blocks are not independent (eight
/// independent scrambles would give the sum up: eight times fewer samples a net, 1.7 times the error). Where it falls
/// as σ²(2n) = ρ σ²(n), one of n₀ samples a half says σ²(N) = ρ^(log₂ (N / n₀)) / (1 − ρ) of its square; ρ is fitted
/// over a whole map.
inline constexpr std::size_t part_count = 8;
inline constexpr std::size_t contrast_count = part_count - 1; ///< degrees of freedom
inline constexpr std::uint32_t least_estimated_rays = 16;     ///< fewer have no parts to speak of

/// Student's t with contrast_count degrees of freedom: a 95 % interval is ± so many standard errors.
inline constexpr double interval_95 = 2.365;

/// Sample i of a texel's N ≥ 8 is of part i >> part_shift(N); those from the largest power of two on are of none.
[[nodiscard]] constexpr unsigned part_shift(std::uint32_t rays) {
    return static_cast<unsigned>(std::bit_width(rays)) - 4U;
}

/// Mean squares on the three scales, the finest (of 4 contrasts) first, then of 2, then of 1.
struct Contrasts {
    std::array<double, 3> squares{};

    Contrasts& operator+=(const Contrasts& other) {
        for (std::size_t scale = 0; scale < squares.size(); ++scale) {
            squares[scale] += other.squares[scale];
        }
        return *this;
    }
};

/// `sums`: of the eight parts; `rays`: N.
[[nodiscard]] Contrasts contrasts(const std::array<float, part_count>& sums, std::uint32_t rays);

/// ρ: how a map's variance falls from n samples to 2n.
class FallOfVariance {
public:
    void add(const Contrasts& of_a_texel);
    /// Between 2^(−2.2) and ½, the fall of independent samples; what scrambled nets have at a smooth border of light
    /// (2^(−1.5)) of a map that shows nothing.
    [[nodiscard]] double ratio() const;

private:
    double m_coarse = 0.0;
    double m_fine = 0.0;
};

// Both below are linear in the contrasts: of their sum over texels they give the sum of variances.

/// The variance of the mean of all N samples, from all seven contrasts, weighted alike.
[[nodiscard]] double variance(const Contrasts& contrasts, double ratio, std::uint32_t rays);

/// As above from the two coarsest scales, which say most about N: over a map, where noise averages out.
[[nodiscard]] double coarse_variance(const Contrasts& contrasts, double ratio, std::uint32_t rays);

} // namespace vkbake
