#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/luminance.hpp"
#include "base/percentile.hpp"
#include "vkbake/compare.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

struct LuminanceErrors {
    std::vector<double> distances; ///< absolute
    double truth = 0.0;            ///< sums over the texels
    double off = 0.0;
    double squares = 0.0;
    double own_squares = 0.0; ///< of the reference, as it estimates them

    void add(const LightMap& map, const LightMap& reference) {
        double mean = 0.0;
        double covered = 0.0;
        for (std::size_t texel = 0; texel < map.image.texels.size(); ++texel) {
            if (map.image.coverage[texel] <= 0.5F) {
                continue;
            }
            const double expected = luminance(glm::dvec3(reference.image.texels[texel]));
            const double distance = luminance(glm::dvec3(map.image.texels[texel])) - expected;
            mean += expected;
            covered += 1.0;
            off += distance;
            squares += distance * distance;
            distances.push_back(std::abs(distance));
        }
        truth += mean;
        if (reference.error && covered > 0.0) {
            const double error = reference.error->relative_rmse * mean / covered;
            own_squares += covered * error * error;
        }
    }
};

} // namespace

BakeError compare_bakes(const Bake& bake, const Bake& reference) {
    LuminanceErrors errors;
    for (std::size_t index = 0; index < bake.light_maps.size(); ++index) {
        const LightMap& map = bake.light_maps[index];
        if (index >= reference.light_maps.size() ||
            map.image.texels.size() != reference.light_maps[index].image.texels.size()) {
            throw Error(ErrorKind::usage, "comparison: the bakes have different maps; give two of one atlas");
        }
        errors.add(map, reference.light_maps[index]);
    }
    if (!(errors.truth > 0.0)) {
        throw Error(ErrorKind::usage, "comparison: the reference is black, so no error is relative to it");
    }
    const auto count = static_cast<double>(errors.distances.size());
    const double mean = errors.truth / count;
    BakeError result;
    result.relative_rmse = std::sqrt(std::max(errors.squares - errors.own_squares, 0.0) / count) / mean;
    result.bias = errors.off / count / mean;
    result.percentile_99 = percentile_99(errors.distances) / mean;
    result.maximum = std::ranges::max(errors.distances) / mean;
    return result;
}

} // namespace vkbake
