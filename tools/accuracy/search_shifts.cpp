// Finds the digital shifts of base/texel_scramble.hpp: those under which the errors of neighbouring texels cancel best.
//   vkbake_search_shifts [SEED [STEPS]]     (1 and 25000 gave those in use, in a minute)
//
// Two texels of one square have one nested scramble and shifts whose exclusive or is d. How their errors correlate
// follows exactly (as Owen 1997 derives the variance of one scrambled net, "Monte Carlo Variance of Scrambled Net
// Quadrature"): over pairs of samples, one of each, whose coordinates agree in the first l and m digits after the
// shift, sum the integrand's energy e(a, b) in Haar's wavelets of levels a and b, times 1 where a coordinate agrees in
// as many digits as the level has, −1 where it first differs in that level's digit, 0 where it differed before. The
// integrand is the edge of an occluder: a half-plane in any direction.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <fmt/format.h>

#include "base/random.hpp"
#include "base/sampling_sobol.hpp"
#include "base/texel_scramble.hpp"

namespace {

using namespace vkbake;

constexpr unsigned digits = 18; ///< of a shift; deeper ones part no two of 4096 samples
constexpr std::size_t places = std::size_t{1} << (2 * square_bits); ///< in a square
constexpr unsigned least_bits = 4;                                  ///< 16 samples a texel
constexpr unsigned most_bits = 12;                                  ///< to 4096
constexpr std::array<double, 3> filter_widths{0.7, 1.2, 2.4};       ///< standard deviations of Gaussians, in texels

using Shifts = std::array<DigitalShift, std::size_t{2} * square_bits>;
using Levels = std::array<std::array<double, digits + 1>, digits + 1>; ///< [in x][in y]

class Random {
public:
    explicit Random(std::uint64_t seed) : m_key(mix64(seed)) {}
    std::uint64_t below(std::uint64_t count) { return (mix64(++m_key) >> 32U) * count >> 32U; }
    double number() { return static_cast<double>(mix64(++m_key) >> 11U) * 0x1p-53; }

private:
    std::uint64_t m_key;
};

/// One step of Haar's transform along rows of `length`, in place: means first, then half differences.
void halve(double* values, std::size_t length, std::size_t stride) {
    std::vector<double> halves(length);
    for (std::size_t i = 0; i < length / 2; ++i) {
        const double left = values[2 * i * stride];
        const double right = values[(2 * i + 1) * stride];
        halves[i] = (left + right) / 2.0;
        halves[length / 2 + i] = (left - right) / 2.0;
    }
    for (std::size_t i = 0; i < length; ++i) {
        values[i * stride] = halves[i];
    }
}

unsigned level_of(std::size_t coefficient) { return static_cast<unsigned>(std::bit_width(coefficient)); }

/// The mean energy of half-planes, by level: measured on a picture of 2^known cells, carried on beyond by the law that
/// an edge has in small squares: half with each level of both, a quarter with each level of one.
Levels edge_energies(Random& random) {
    constexpr unsigned known = 10;
    constexpr std::size_t side = std::size_t{1} << known;
    constexpr int edges = 200;
    Levels energies{};
    std::vector<double> image(side * side);
    for (int edge = 0; edge < edges; ++edge) {
        const double angle = 6.283185307179586 * random.number();
        const double across = random.number() * side;
        const double down = random.number() * side;
        for (std::size_t i = 0; i < image.size(); ++i) {
            const std::size_t row = i / side;
            const double x = static_cast<double>(i % side) + 0.5 - across;
            const double y = static_cast<double>(row) + 0.5 - down;
            image[i] = std::min(1.0, std::max(0.0, 0.5 - x * std::cos(angle) - y * std::sin(angle)));
        }
        for (std::size_t length = side; length > 1; length /= 2) {
            for (std::size_t row = 0; row < side; ++row) {
                halve(&image[row * side], length, 1);
            }
        }
        for (std::size_t length = side; length > 1; length /= 2) {
            for (std::size_t column = 0; column < side; ++column) {
                halve(&image[column], length, side);
            }
        }
        for (std::size_t i = 1; i < image.size(); ++i) {
            const unsigned x = level_of(i % side);
            const unsigned y = level_of(i / side);
            const double area = std::exp2(-static_cast<double>((x > 0 ? x - 1 : 0) + (y > 0 ? y - 1 : 0)));
            energies[x][y] += image[i] * image[i] * area / edges;
        }
    }
    for (unsigned x = 0; x <= digits; ++x) {
        for (unsigned y = 0; y <= digits; ++y) {
            if (x > known || y > known) {
                energies[x][y] = x > 0 && y > 0 ? energies[x - 1][y - 1] / 2.0
                                                : (x > 0 ? energies[x - 1][0] : energies[0][y - 1]) / 4.0;
            }
        }
    }
    return energies;
}

unsigned agreeing_digits(std::uint32_t difference) {
    return std::min(digits, static_cast<unsigned>(std::countr_zero(difference)));
}

/// What a pair of samples adds, by the digits that they agree in.
Levels pair_values(const Levels& energies) {
    const auto sign = [](unsigned level, unsigned agreeing) {
        return level == 0 || agreeing >= level ? 1.0 : (agreeing + 1 == level ? -1.0 : 0.0);
    };
    Levels values{};
    for (unsigned in_x = 0; in_x <= digits; ++in_x) {
        for (unsigned in_y = 0; in_y <= digits; ++in_y) {
            for (unsigned x = 0; x <= digits; ++x) {
                for (unsigned y = 0; y <= digits; ++y) {
                    values[in_x][in_y] += energies[x][y] * sign(x, in_x) * sign(y, in_y);
                }
            }
        }
    }
    return values;
}

double covariance(const Levels& values, unsigned bits, const DigitalShift& difference) {
    double sum = 0.0;
    for (std::uint32_t index = 0; (index >> bits) == 0; ++index) {
        sum += values[agreeing_digits(index ^ difference.x)]
                     [agreeing_digits(sobol_dimension_1_reversed(index) ^ difference.y)];
    }
    return sum;
}

/// How much pairs of texels count whose places' exclusive or is the index: the mean, over the Gaussians, of what these
/// filters' squares give a pair of that distance, a texel with itself having 1.
std::array<double, places> pair_weights() {
    const auto along = [](std::size_t place, unsigned axis) {
        double coordinate = 0.0;
        for (unsigned bit = 0; bit < square_bits; ++bit) {
            coordinate += static_cast<double>(((place >> (2 * bit + axis)) & 1U) << bit);
        }
        return coordinate;
    };
    std::array<double, places> weights{};
    for (std::size_t one = 0; one < places; ++one) {
        for (std::size_t other = 0; other < places; ++other) {
            const double x = along(one, 0) - along(other, 0);
            const double y = along(one, 1) - along(other, 1);
            for (const double width : filter_widths) {
                weights[one ^ other] +=
                    std::exp(-(x * x + y * y) / (4.0 * width * width)) / (places * filter_widths.size());
            }
        }
    }
    return weights;
}

class Search {
public:
    explicit Search(std::uint64_t seed) : m_random(seed), m_values(pair_values(edge_energies(m_random))) {
        for (unsigned bits = least_bits; bits <= most_bits; ++bits) {
            m_variance[bits] = covariance(m_values, bits, {});
        }
        for (DigitalShift& shift : m_best) {
            shift = {static_cast<std::uint32_t>(m_random.below(1U << digits)),
                     static_cast<std::uint32_t>(m_random.below(1U << digits))};
        }
        m_least = mean_share(m_best);
    }

    /// The variance of filtered errors of 2^bits samples a texel, in shares of what independent texels have.
    [[nodiscard]] double share(const Shifts& shifts, unsigned bits) const {
        double sum = 1.0;
        for (std::size_t place = 1; place < places; ++place) {
            DigitalShift difference;
            for (std::size_t bit = 0; bit < shifts.size(); ++bit) {
                if (((place >> bit) & 1U) != 0) {
                    difference ^= shifts[bit];
                }
            }
            sum += m_weights[place] * covariance(m_values, bits, difference) / m_variance[bits];
        }
        return sum;
    }

    [[nodiscard]] double mean_share(const Shifts& shifts) const {
        double sum = 0.0;
        for (unsigned bits = least_bits; bits <= most_bits; ++bits) {
            sum += share(shifts, bits) / (most_bits - least_bits + 1);
        }
        return sum;
    }

    /// Simulated annealing by single digits, cold for the last quarter.
    void run(int steps) {
        Shifts current = m_best;
        double level = m_least;
        for (int step = 0; step < steps; ++step) {
            Shifts changed = current;
            for (std::uint64_t count = 1 + m_random.below(3); count > 0; --count) {
                DigitalShift& shift = changed[m_random.below(changed.size())];
                (m_random.below(2) == 0 ? shift.x : shift.y) ^= 1U << m_random.below(digits);
            }
            const double next = mean_share(changed);
            const double warmth = 0.005 * std::max(0.0, 1.0 - 4.0 / 3.0 * step / steps);
            if (next < level || (warmth > 0.0 && m_random.number() < std::exp((level - next) / warmth))) {
                current = changed;
                level = next;
            }
            if (level < m_least) {
                m_least = level;
                m_best = current;
            }
        }
    }

    [[nodiscard]] const Shifts& best() const { return m_best; }

private:
    Random m_random;
    Levels m_values;
    std::array<double, most_bits + 1> m_variance{};
    std::array<double, places> m_weights = pair_weights();
    Shifts m_best{};
    double m_least = 0.0;
};

void print(const Search& search, const Shifts& shifts) {
    for (const DigitalShift& shift : shifts) {
        fmt::print("    {{0x{:05X}U, 0x{:05X}U}},\n", shift.x, shift.y);
    }
    fmt::print("share of the variance of filtered independent texels, mean {:.3f}:", search.mean_share(shifts));
    for (unsigned bits = least_bits; bits <= most_bits; ++bits) {
        fmt::print(" {} samples {:.3f}", 1U << bits, search.share(shifts, bits));
    }
    fmt::print("\n");
}

} // namespace

int main(int argument_count, char** arguments) {
    const std::uint64_t seed = argument_count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int steps = argument_count > 2 ? std::atoi(arguments[2]) : 25000;
    Search search(seed);
    fmt::print("those in use:\n");
    print(search, square_shifts);
    search.run(steps);
    fmt::print("found with seed {} in {} steps:\n", seed, steps);
    print(search, search.best());
    return EXIT_SUCCESS;
}
