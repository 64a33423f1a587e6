// The evaluation of the thesis (its table 4.1 and the times of its chapter 4), made again with this program.
//
// For each object: the thesis's own time, ours with its method (flat clusters, its sampler, its triangle test, one
// thread), with brute force (one thread), and by default (all threads); and the relative root-mean-square error of the
// thesis's method and of the default against a converged reference. Brute force and the reference take a sample of the
// texels, so does its method where the map is large: their times are those of their rays, scaled to all of them.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "atlas/make_atlas.hpp"
#include "base/random.hpp"
#include "geometry_image/draw.hpp"
#include "surface/make_surface.hpp"
#include "trace/tracer.hpp"
#include "vkbake/vkbake.hpp"

namespace {

using namespace vkbake;

struct Row {
    const char* name;
    const char* file;        ///< below the scenes' folder
    int triangles;           ///< of table 4.1; 0: not in it
    int size;                ///< side of an object's map; the thesis's where it names one
    const char* thesis_time; ///< minutes:seconds, or empty where it names none
};

constexpr Row rows[] = {
    {"wall", "objects/wall.glb", 4999, 256, "4:20"},
    {"fire hydrant", "objects/fire-hydrant.glb", 4634, 128, "1:00"},
    {"fire hydrant", "objects/fire-hydrant.glb", 4634, 256, "2:30"},
    {"fire hydrant", "objects/fire-hydrant.glb", 4634, 512, "11:00"},
    {"storage room", "objects/storage-room.glb", 1500, 512, "6:10"},
    {"four cannons", "four-cannons.glb", 0, 256, "23:30"},
    {"door", "objects/door.glb", 5772, 256, "4:00"},
    {"apartment", "objects/apartment.glb", 504, 512, "1:20"},
    {"wheelbarrow", "objects/wheelbarrow.glb", 1700, 512, "7:00"},
    {"cannon", "objects/cannon.glb", 1350, 256, ""},
    {"cannon mount", "objects/cannon-mount.glb", 766, 256, ""},
};

constexpr std::size_t reference_texels = 512;
constexpr std::uint32_t reference_rays = 65'536;
constexpr std::size_t brute_texels = 512;
constexpr std::size_t thesis_texels = 16'384;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The settings of the thesis: a map for each object, its clusters, sampler and triangle test, one thread.
Settings thesis_settings(int size) {
    Settings settings;
    settings.size = size;
    settings.layout = Layout::object;
    settings.charts = ChartMaker::polypack;
    settings.accelerator = Accelerator::clusters;
    settings.sampler = Sampler::thesis;
    settings.triangle_test = TriangleTest::moller_trumbore;
    settings.blend_creases = Switch::off;
    settings.threads = 1;
    return settings;
}

Settings default_settings(int size) {
    Settings settings;
    settings.size = size;
    settings.layout = Layout::object;
    settings.charts = ChartMaker::polypack; // the same texels as the thesis's method
    settings.blend_creases = Switch::off;   // and the same points of them
    return settings;
}

/// Keeps about `count` of the covered texels, spread by hash.
GeometryImage sample_texels(const GeometryImage& geometry, std::size_t count) {
    std::vector<std::pair<std::uint64_t, std::size_t>> covered;
    for (std::size_t texel = 0; texel < geometry.texel_count(); ++texel) {
        if (geometry.triangle[texel] != GeometryImage::empty) {
            covered.emplace_back(mix64(texel + 1), texel);
        }
    }
    std::sort(covered.begin(), covered.end());
    GeometryImage sample = geometry;
    for (std::size_t rank = count; rank < covered.size(); ++rank) {
        sample.triangle[covered[rank].second] = GeometryImage::empty;
    }
    return sample;
}

/// Sums for a relative root-mean-square error over several maps.
struct ErrorSum {
    double squares = 0.0;
    double reference = 0.0;
    std::size_t values = 0;

    void add(const Image& image, const Image& converged) {
        for (std::size_t texel = 0; texel < converged.texels.size(); ++texel) {
            for (int channel = 0; converged.coverage[texel] > 0.5F && channel < 3; ++channel) {
                const double difference =
                    double{image.texels[texel][channel]} - double{converged.texels[texel][channel]};
                squares += difference * difference;
                reference += double{converged.texels[texel][channel]};
                ++values;
            }
        }
    }
    [[nodiscard]] double relative() const {
        const auto count = static_cast<double>(std::max<std::size_t>(values, 1));
        return std::sqrt(squares / count) / std::max(reference / count, 1e-30);
    }
};

struct Figures {
    std::size_t triangles = 0;
    double thesis_seconds = 0.0;
    double brute_seconds = 0.0;
    double default_seconds = 0.0;
    double thesis_error = 0.0;
    double default_error = 0.0;
};

struct Timed {
    Bake bake;
    double seconds = 0.0;
};

Timed timed_bake(const Scene& scene, const Sky& sky, const Settings& settings, const Device& device) {
    const auto start = Clock::now();
    Timed timed{bake(scene, sky, settings, device), 0.0};
    timed.seconds = seconds_since(start);
    return timed;
}

struct Sampled {
    std::vector<LightMap> maps; ///< a page each
    double seconds = 0.0;       ///< scaled to all texels
};

/// Traces a sample of the texels, or all where there are no more than `count`.
Sampled trace_sample(const Surface& surface, const Sky& sky, const Settings& settings,
                     const std::vector<GeometryImage>& geometry, std::size_t count) {
    const Tracer tracer(surface, sky, settings);
    Sampled sampled;
    for (const GeometryImage& image : geometry) {
        const auto covered =
            static_cast<double>(std::count_if(image.triangle.begin(), image.triangle.end(),
                                              [](std::uint32_t triangle) { return triangle != GeometryImage::empty; }));
        const GeometryImage sample = sample_texels(image, count / geometry.size());
        const auto start = Clock::now();
        sampled.maps.push_back(tracer.trace(sample));
        const std::uint64_t traced = std::max<std::uint64_t>(sampled.maps.back().statistics.covered_texels, 1);
        sampled.seconds += seconds_since(start) * covered / static_cast<double>(traced);
    }
    return sampled;
}

Figures measure(const Row& row, const std::filesystem::path& scenes, const Sky& sky, const Device& device) {
    const Scene scene = load_scene(scenes / row.file);
    const Timed ours = timed_bake(scene, sky, default_settings(row.size), device);
    const Surface& surface = ours.bake.surface;

    std::vector<GeometryImage> geometry;
    for (std::uint32_t page = 0; page < ours.bake.atlas.pages.size(); ++page) {
        geometry.push_back(draw_geometry_image(device.context(), surface, ours.bake.atlas, page));
    }
    Figures figures;
    figures.triangles = surface.triangle_count();
    const Sampled thesis = trace_sample(surface, sky, thesis_settings(row.size), geometry, thesis_texels);
    Settings brute = thesis_settings(row.size);
    brute.accelerator = Accelerator::brute;
    figures.thesis_seconds = thesis.seconds;
    figures.default_seconds = ours.seconds;
    figures.brute_seconds = trace_sample(surface, sky, brute, geometry, brute_texels).seconds;

    Settings converged = default_settings(row.size);
    converged.rays = reference_rays;
    converged.seed = 1; // not the seed of what is measured
    const Tracer tracer(surface, sky, converged);
    ErrorSum thesis_error;
    ErrorSum default_error;
    for (std::size_t page = 0; page < geometry.size(); ++page) {
        const LightMap reference = tracer.trace(sample_texels(geometry[page], reference_texels / geometry.size()));
        thesis_error.add(thesis.maps[page].image, reference.image); // the reference's texels are among its own
        default_error.add(ours.bake.light_maps[page].image, reference.image);
    }
    figures.thesis_error = thesis_error.relative();
    figures.default_error = default_error.relative();
    return figures;
}

int print_table(const std::filesystem::path& scenes) {
    const Device device = open_device();
    const Sky sky = load_sky("clear");
    fmt::print("vkbake {}, {}; times in seconds, by default from surface to dilation; thesis: on an i3-9100F with a "
               "GTX 1050 Ti\nits method and brute force: tracing, of {} and {} texels, scaled to all\n",
               version(), device.name(), thesis_texels, brute_texels);
    fmt::print("errors: relative root-mean-square against {} rays a texel on {} texels\n\n", reference_rays,
               reference_texels);
    fmt::print("| object | triangles | map | thesis (its machine) | its method, 1 thread | brute, 1 thread | default | "
               "error of its method | error by default |\n|---|---|---|---|---|---|---|---|---|\n");
    for (const Row& row : rows) {
        const Figures figures = measure(row, scenes, sky, device);
        if (row.triangles != 0 && figures.triangles != static_cast<std::size_t>(row.triangles)) {
            fmt::print(stderr, "{}: {} triangles, table 4.1 has {}\n", row.file, figures.triangles, row.triangles);
            return 1;
        }
        fmt::print("| {} | {} | {}² | {} | {:.2f} | {:.1f} | {:.2f} | {:.2f} % | {:.2f} % |\n", row.name,
                   figures.triangles, row.size, *row.thesis_time == '\0' ? "none" : row.thesis_time,
                   figures.thesis_seconds, figures.brute_seconds, figures.default_seconds, 100.0 * figures.thesis_error,
                   100.0 * figures.default_error);
        std::fflush(stdout);
    }
    return 0;
}

} // namespace

int main(int argument_count, char** arguments) {
    try {
        return print_table(argument_count > 1 ? arguments[1] : "scenes");
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return static_cast<int>(error.kind());
    }
}
