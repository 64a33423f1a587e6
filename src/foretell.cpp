#include "foretell.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

#include "base/random.hpp"
#include "geometry_image/reference.hpp"
#include "opacity.hpp"
#include "trace/cell_visibility.hpp"
#include "trace/contrasts.hpp"
#include "trace/known_light.hpp"
#include "trace/tracer.hpp"

namespace vkbake {

namespace {

constexpr int square_side = 8; // whole tiles
constexpr double wanted_texels = 12288.0;
constexpr double least_error = 0.03;      ///< that is traced for
constexpr double most_seconds = 2.0;      ///< where the settings give a time
constexpr std::uint32_t most_rays = 1024; ///< where they give a number

bool is_adaptive(const Settings& settings) { return settings.target_error || settings.seconds; }

/// As the bake's, for direct light alone, with its error where that can be told.
Settings pilot_settings(Settings settings) {
    settings.bounces = 0;
    settings.directional = Switch::off;
    settings.denoise = Switch::off;
    settings.probe_grid.reset();
    settings.rays = std::min(settings.rays, most_rays);
    if (settings.target_error) {
        settings.target_error = std::max(*settings.target_error, least_error);
    }
    settings.estimate_error = settings.sampler == Sampler::cosine && settings.mode != Mode::bent_normal &&
                              (is_adaptive(settings) || settings.rays >= least_estimated_rays);
    return settings;
}

/// As which power of its samples a map's rays grow: where answers are reused more and more of them take none.
double growth_of_rays(const LightMap& map) {
    if (map.statistics.spared_rays == 0) {
        return 1.0;
    }
    double traced = 0.0; // before any were spared
    double samples = 0.0;
    for (const std::uint32_t some : map.texel_rays) {
        traced += std::min(some, KnownCells::least_samples);
        samples += some;
    }
    const double rays = samples - static_cast<double>(map.statistics.spared_rays);
    return std::clamp(std::log(rays / traced) / std::log(samples / traced), 0.5, 1.0);
}

/// How many times the samples a map has will be taken for what is asked. `share`: of all texels those that were traced;
/// `growth`: growth_of_rays.
double more_samples(const LightMap& map, const Settings& settings, double share, double growth) {
    double factor = 1.0;
    if (settings.target_error && *settings.target_error < least_error) {
        factor = std::pow(*settings.target_error / map.error->relative_rmse, 1.0 / map.error->slope);
    } else if (!is_adaptive(settings)) {
        factor = static_cast<double>(settings.rays) / static_cast<double>(std::min(settings.rays, most_rays));
    }
    if (settings.seconds) {
        const double in_time = std::pow(*settings.seconds * share / map.statistics.seconds, 1.0 / growth);
        factor = settings.target_error ? std::min(factor, in_time) : std::max(in_time, 1.0);
    }
    return settings.sampler == Sampler::thesis ? 1.0 : factor;
}

/// Of all maps together.
class Total {
public:
    /// `texels`: that `map` stands for; of its samples and of its rays there will be so many times as many.
    void add(const LightMap& map, double texels, double more_samples, double more_rays) {
        const double scale = texels / static_cast<double>(map.statistics.covered_texels);
        const auto rays = static_cast<double>(map.statistics.rays);
        const auto sought = static_cast<double>(map.statistics.lamp_rays + map.statistics.peak_rays); // none is spared
        m_texels += texels;
        m_trace.rays += scale * (more_rays * rays + more_samples * sought);
        m_trace.seconds += scale * more_rays * map.statistics.seconds;
        if (const std::optional<KnownLight> known = known_light(map)) {
            m_light += texels * known->mean;
            m_squares += texels * known->variance * std::pow(more_samples, 2.0 * map.error->slope);
            m_told = true;
        }
    }

    /// `texels`: of all maps, as expected.
    [[nodiscard]] ForetoldTrace finish(double texels) const {
        const double scale = m_texels > 0.0 ? texels / m_texels : 0.0;
        ForetoldTrace trace{.rays = scale * m_trace.rays, .seconds = scale * m_trace.seconds};
        if (m_told && m_light > 0.0) {
            trace.error = std::sqrt(m_squares * m_texels) / m_light;
        }
        return trace;
    }

private:
    ForetoldTrace m_trace;
    double m_texels = 0.0;
    double m_light = 0.0;
    double m_squares = 0.0;
    bool m_told = false;
};

} // namespace

ForetoldTrace foretell_trace(const Scene& scene, const Surface& surface, const Atlas& atlas, const Settings& settings,
                             const Sky& sky, std::uint64_t covered_texels) {
    using Clock = std::chrono::steady_clock;
    const Settings pilot = pilot_settings(settings);
    const std::optional<SurfaceOpacity> opacity = make_opacity(scene, surface, pilot);
    const Tracer tracer(surface, sky, pilot, scene.lamps, opacity ? &*opacity : nullptr);
    const double wanted_share =
        std::min(wanted_texels / static_cast<double>(std::max<std::uint64_t>(covered_texels, 1)), 1.0);
    Total total;
    for (std::uint32_t page = 0; page < atlas.pages.size(); ++page) {
        const auto takes = [&](int x, int y) {
            const std::uint64_t place =
                (std::uint64_t{page} << 48U) + (static_cast<std::uint64_t>(y) << 24U) + static_cast<std::uint64_t>(x);
            return static_cast<double>(mix64(place) >> 11U) * 0x1p-53 < wanted_share;
        };
        const GeometryImage geometry = sampled_geometry_image(surface, atlas, page, square_side, takes);
        const auto texels =
            static_cast<double>(geometry.texel_count() -
                                static_cast<std::size_t>(std::ranges::count(geometry.triangle, GeometryImage::empty)));
        if (texels == 0.0) {
            continue;
        }
        std::optional<Clock::time_point> deadline;
        if (settings.seconds) {
            const double share = texels / static_cast<double>(covered_texels); // of the time, as of all texels
            const std::chrono::duration<double> seconds(std::min(most_seconds, share * *settings.seconds));
            deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(seconds);
        }
        const LightMap map = tracer.trace(geometry, {}, deadline);
        const double growth = growth_of_rays(map);
        const double factor = more_samples(map, settings, texels / static_cast<double>(covered_texels), growth);
        total.add(map, texels / wanted_share, factor, std::pow(factor, growth));
    }
    return total.finish(static_cast<double>(covered_texels));
}

} // namespace vkbake
