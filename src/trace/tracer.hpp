// Geometry image → light map.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "trace/emitter_set.hpp"
#include "trace/known_light.hpp"
#include "trace/lamp_set.hpp"
#include "trace/sky_lookup.hpp"
#include "trace/sky_peaks.hpp"
#include "trace/surface_light.hpp"
#include "trace/surface_opacity.hpp"
#include "trace/visibility.hpp"
#include "vkbake/geometry_image.hpp"
#include "vkbake/lamp.hpp"
#include "vkbake/lightmap.hpp"
#include "vkbake/settings.hpp"
#include "vkbake/sky.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// How far one map is: the share of its work that is done, the rays traced so far, and the error estimated of it (0:
/// not known). Returns false to stop.
using TraceProgress = std::function<bool(double share, std::uint64_t rays, double error)>;

/// What a tracer was made for, for rays of other purposes than light maps. Holds while the tracer lives.
struct TracedScene {
    const Surface* surface = nullptr;
    const Visibility* visibility = nullptr;
    const Settings* settings = nullptr;
    const SkyLookup* sky = nullptr; ///< without its peaks, where these are sampled on their own
    const SkyPeaks* peaks = nullptr;
    const LampSet* lamps = nullptr; ///< null where there are none
    double intensity = 1.0;         ///< multiplies sky, peaks and lamps
};

struct GatherOptions {
    const EmitterSet* emitters = nullptr;  ///< of the light, for rays to seek as well; null: none. Sampler cosine only
    std::optional<KnownLight> before = {}; ///< what the map has already; absent: errors are not estimated
};

/// Takes noise out of a map: sets its light, its standard errors and its error. `variance`: of each texel's luminance
/// as its samples show it (0 where not baked), which LightMap::standard_error is made from.
using MapFilter = std::function<void(LightMap& map, const std::vector<float>& variance)>;

/// Holds what all maps of a bake share: the accelerators over the surface and the sky made ready for look-ups.
/// The surface must outlive it.
class Tracer {
public:
    /// `lamps`: asked for unless settings.lamps is off or the mode is ao; they are copied. `opacity`: of the same
    /// surface, and must outlive it; null where every triangle is taken for opaque. Throws Error{usage} for settings
    /// that contradict each other, Error{bad_input} for a sky or a lamp that cannot be.
    Tracer(const Surface& surface, const Sky& sky, const Settings& settings, std::span<const Lamp> lamps = {},
           const SurfaceOpacity* opacity = nullptr);
    ~Tracer();
    Tracer(Tracer&&) noexcept;
    Tracer& operator=(Tracer&&) noexcept;
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    /// What is to be said of how light is found, a line each.
    [[nodiscard]] std::vector<std::string> notes() const;

    /// The map's name is left empty. The bits of the image depend on nothing but the arguments. `progress` is called
    /// from the calling thread only. Throws Error{interrupted} where it returned false.
    /// `deadline`: when the rays are to end that Settings::seconds allows; absent, never.
    /// `filter`: where errors are estimated, is called with the traced map, which has no statistics yet. Where an error
    /// is asked for that is the filtered map's, so the filter is asked as soon as it may do, and maybe again after more
    /// rays; each time it gets the map as it was traced.
    [[nodiscard]] LightMap trace(const GeometryImage& geometry, const TraceProgress& progress = {},
                                 std::optional<std::chrono::steady_clock::time_point> deadline = {},
                                 const MapFilter& filter = {}) const;

    /// What surfaces send to the texels in place of the sky: E/π of one bounce, with rays of its own for each `bounce`
    /// (1, 2 …): Settings::bounce_rays, or where an error is asked for as many as that wants of all light. Sets the
    /// image, of the statistics bounce_rays and seconds, and, where errors are estimated, the texels' standard errors,
    /// of this light alone, and the map's error, of all. Else as trace().
    [[nodiscard]] LightMap gather(const GeometryImage& geometry, const SurfaceLight& light, std::uint32_t bounce,
                                  const GatherOptions& options = {}, const TraceProgress& progress = {}) const;

    /// Of what may be sought of `light`; absent where that needs no rays of its own.
    [[nodiscard]] std::optional<EmitterSet> find_emitters(const SurfaceLight& light) const;

    [[nodiscard]] TracedScene scene() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace vkbake
