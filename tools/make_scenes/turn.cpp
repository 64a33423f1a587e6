#include "make_scenes/turn.hpp"

#include <cmath>
#include <numbers>

namespace vkbake::scenes {

glm::dvec2 on_circle(double turns) {
    // Reduced to an eighth of a turn either side of a quarter: there the series need few terms.
    const double quarters = std::nearbyint(turns * 4.0);
    const double angle = (turns - quarters / 4.0) * 2.0 * std::numbers::pi;
    const double square = angle * angle;
    double cosine = 1.0;
    double sine = angle;
    double cosine_term = 1.0;
    double sine_term = angle;
    for (int k = 1; k <= 8; ++k) {
        cosine_term *= -square / ((2.0 * k - 1.0) * (2.0 * k));
        sine_term *= -square / ((2.0 * k) * (2.0 * k + 1.0));
        cosine += cosine_term;
        sine += sine_term;
    }
    switch (static_cast<long long>(quarters) & 3) {
    case 0:
        return {cosine, sine};
    case 1:
        return {-sine, cosine};
    case 2:
        return {-cosine, -sine};
    default:
        return {sine, -cosine};
    }
}

} // namespace vkbake::scenes
