#include "memory_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "base/machine_memory.hpp"
#include "geometry_image/texel_triangles.hpp"
#include "opacity.hpp"
#include "probes.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

// From the arrays' sizes and from peaks of the resident set that tools/extremes/memory.sh measured (x86-64, glibc, Mesa
// 22.3.6), rounded up.

/// The program, its libraries and llvmpipe with the passes compiled; measured 100 MB.
constexpr std::uint64_t program_bytes = 128U << 20U;
/// OpenImageIO's libraries, where images are read; measured 103 MB. HDR needs them too: when it is written, geometry
/// image and tiles are gone, which are more from maps of 1500² texels on.
constexpr std::uint64_t codec_bytes = 128U << 20U;
/// Surface 104, atlas 32, and the greater of what makes the atlas and of what builds and keeps the accelerator;
/// measured 320 with a million triangles.
constexpr std::uint64_t triangle_bytes = 500;
/// RGBA as read is in `held`; RGB floats for look-ups, until the map that rays look up is made of them, and that map.
constexpr std::uint64_t sky_texel_bytes = 16;
/// Of every map until all are written: RGBA and coverage.
constexpr std::uint64_t map_texel_bytes = 20;
/// Of what is touched of it: its 8-bit picture as PNG and in the .glb 9; and 24 of each texel on a crease, for which
/// one in six is taken.
constexpr std::uint64_t touched_map_texel_bytes = 13;
/// Of every map while bounces, or probes, are traced: albedo and emission 24, the light that leaves now and after the
/// next bounce 26.
constexpr std::uint64_t bounce_texel_bytes = 50;
/// Of every map with directions: four pictures of RGBA; while they are traced with bounces, what these sent 13.
constexpr std::uint64_t directional_texel_bytes = 64;
constexpr std::uint64_t sent_texel_bytes = 13;
/// Of the one map that is worked on: each texel's triangle; where it is copied, RGBA and coverage.
constexpr std::uint64_t work_texel_bytes = 4;
constexpr std::uint64_t copied_work_texel_bytes = 24;
/// Of it, with what is touched: its geometry image 40 and tiles 9, or its file as it is encoded.
constexpr std::uint64_t touched_work_texel_bytes = 52;
/// Where errors are estimated: standard error and rays of every map, and of the one that is worked on each covered
/// texel's samples and orders 100, and a sixteenth of what its tile's rays met 17.
constexpr std::uint64_t estimated_map_texel_bytes = 8;
constexpr std::uint64_t estimated_work_texel_bytes = 117;
/// Of the one map that is worked on, where bounces are estimated: standard error and rays of the bounce's own.
constexpr std::uint64_t estimated_bounce_texel_bytes = 8;
/// Of the one map that is denoised: each texel's variance, what the filter reads 48 and what it makes 20.
constexpr std::uint64_t denoised_work_texel_bytes = 72;
/// Of the tile of a map that the device works on: the geometry image's targets and what they are read back into.
constexpr std::uint64_t tile_texel_bytes = 76;
constexpr std::uint64_t tile_side = 2048;
/// Of the tile that is denoised, which comes later: seven images of RGBA and one of floats, three of them as they are
/// uploaded and two as they are read back.
constexpr std::uint64_t denoised_tile_texel_bytes = 184;
constexpr std::uint64_t denoised_tile_side = 1056; ///< its border with it

std::uint64_t texels_of(std::uint64_t side) { return side * side; }

std::uint64_t tile_bytes(const MemoryNeed& need, std::uint64_t side) {
    const std::uint64_t drawn = tile_texel_bytes * texels_of(std::min(side, tile_side));
    const std::uint64_t denoised = denoised_tile_texel_bytes * texels_of(std::min(side, denoised_tile_side));
    return need.denoised ? std::max(drawn, denoised) : drawn;
}

/// Texels whose values the system gives memory for together, at the most: geometry images have 12 bytes a texel and a
/// value, and pages are of up to 2 MiB.
constexpr std::uint64_t run_texels = 1U << 18U;

/// Of each page the share of texels that lie in runs which hold a texel that a triangle may cover, or next to one of
/// these.
std::vector<double> touched_shares(const Atlas& atlas) {
    std::vector<TexelGrid> grids;
    std::vector<std::vector<std::int64_t>> changes; // of each page and run: how many triangles begin less how many end
    for (const AtlasPage& page : atlas.pages) {
        grids.emplace_back(page);
        const std::uint64_t texels = static_cast<std::uint64_t>(page.width) * static_cast<std::uint64_t>(page.height);
        changes.emplace_back(texels / run_texels + 4, 0);
    }
    for (std::uint32_t triangle = 0; triangle < atlas.page.size(); ++triangle) {
        const TexelGrid& grid = grids.at(atlas.page[triangle]);
        const TexelBox box = texel_box(atlas, grid, triangle);
        if (box.x_begin >= box.x_end || box.y_begin >= box.y_end) {
            continue;
        }
        const auto run = [&](int x, int y) {
            return (static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(grid.width) +
                    static_cast<std::uint64_t>(x)) /
                   run_texels;
        };
        std::vector<std::int64_t>& change = changes[atlas.page[triangle]];
        // Of number i − 1 stands at i: from the run before the first to the run after the last.
        ++change[run(box.x_begin, box.y_begin)];
        --change[run(box.x_end - 1, box.y_end - 1) + 3];
    }
    std::vector<double> shares;
    for (std::size_t page = 0; page < changes.size(); ++page) {
        std::uint64_t touched = 0;
        std::int64_t triangles = 0;
        for (const std::int64_t change : changes[page]) {
            triangles += change;
            touched += triangles > 0 ? run_texels : 0;
        }
        const double texels = static_cast<double>(grids[page].width) * static_cast<double>(grids[page].height);
        shares.push_back(std::min(static_cast<double>(touched) / texels, 1.0));
    }
    return shares;
}

std::uint64_t share_of(double share, std::uint64_t texels) {
    return static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(texels)));
}

/// "812 MiB", "12.3 GiB"
std::string bytes_text(std::uint64_t bytes) {
    const std::uint64_t tenths = (bytes + (1ULL << 29U) / 10) * 10 >> 30U;
    return tenths < 10 ? std::to_string(bytes >> 20U) + " MiB"
                       : std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GiB";
}

/// The largest multiple of 16 up to need.size that fits; 0: none.
int largest_size(MemoryNeed need, std::uint64_t limit) {
    for (need.size = need.size / 16 * 16; need.size > 0 && peak_memory(need) > limit;) {
        need.size -= 16;
    }
    return need.size;
}

struct SkyTexels {
    std::uint64_t operator()(const EquirectangularSky& sky) const { return sky.image.texels.size(); }
    std::uint64_t operator()(const CubeSky& sky) const { return 6 * sky.faces[0].texels.size(); }
    template<class Formula>
    std::uint64_t operator()(const Formula& /*sky*/) const {
        return 0;
    }
};

template<class Value>
std::uint64_t bytes_of(const std::vector<Value>& values) {
    return values.capacity() * sizeof(Value);
}

std::uint64_t bytes_of(const Scene& scene) {
    std::uint64_t bytes = scene.source ? scene.source->json.capacity() + bytes_of(scene.source->binary) : 0;
    for (const EncodedImage& image : scene.images) {
        bytes += bytes_of(image.bytes);
    }
    for (const Mesh& mesh : scene.meshes) {
        for (const Primitive& primitive : mesh.primitives) {
            bytes += bytes_of(primitive.positions) + bytes_of(primitive.normals) + bytes_of(primitive.colors) +
                     bytes_of(primitive.indices);
            for (const auto& uvs : primitive.tex_coords) {
                bytes += bytes_of(uvs);
            }
        }
    }
    return bytes;
}

[[noreturn]] void refuse(const MemoryNeed& need, const Settings& settings) {
    const std::uint64_t limit = memory_limit(settings);
    const std::string maps = need.maps == 1 ? "a map" : std::to_string(need.maps) + " maps";
    const int size = largest_size(need, limit);
    std::string advice = "split the scene, or allow more (--memory-limit)";
    if (size > 0 && settings.density) {
        advice = "lower the density, or allow more (--memory-limit)";
    } else if (size > 0) {
        advice = "use --size " + std::to_string(size) + ", or allow more (--memory-limit)";
    }
    throw Error(ErrorKind::usage, "memory: " + std::to_string(need.triangles) + " triangles in " + maps + " of " +
                                      std::to_string(need.size) + "² texels take about " +
                                      bytes_text(peak_memory(need)) + ", and the limit is " + bytes_text(limit) + "; " +
                                      advice);
}

} // namespace

MemoryNeed memory_need(const Scene& scene, const Sky& sky, const Settings& settings, const Atlas* atlas) {
    std::uint64_t triangles = 0;
    std::uint64_t objects = 0;
    for (const Instance& instance : scene.instances) {
        const std::uint64_t before = triangles;
        for (std::size_t i = 0;
             instance.mesh < scene.meshes.size() && i < scene.meshes[instance.mesh].primitives.size(); ++i) {
            triangles += scene.meshes[instance.mesh].primitives[i].indices.size() / 3;
        }
        objects += triangles > before ? 1 : 0;
    }
    const std::uint64_t sky_texels = std::visit(SkyTexels(), sky.source);
    MemoryNeed need{.held = bytes_of(scene) + sky_texels * sizeof(glm::vec4),
                    .sky_texels = settings.mode == Mode::irradiance ? sky_texels : 0,
                    .images = sky_texels > 0 || !scene.images.empty(),
                    .triangles = triangles,
                    .opacity = opacity_bytes(scene, settings),
                    .maps = settings.layout == Layout::object ? objects : 1,
                    .size = settings.size,
                    .bounces = settings.bounces > 0 || has_probes(scene, settings),
                    .directional = settings.directional == Switch::on,
                    .estimated = settings.estimate_error || settings.target_error || settings.seconds ||
                                 settings.denoise == Switch::on || reuses_visibility(settings),
                    .denoised = settings.denoise == Switch::on};
    need.copied = need.bounces || need.directional || need.estimated || settings.mode == Mode::bent_normal;
    if (atlas != nullptr && !atlas->pages.empty()) {
        const std::vector<double> shares = touched_shares(*atlas);
        need.maps = shares.size();
        need.touched = std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size());
        need.most_touched = *std::max_element(shares.begin(), shares.end());
    }
    return need;
}

std::uint64_t peak_memory(const MemoryNeed& need) {
    const auto side = static_cast<std::uint64_t>(std::max(need.size, 1));
    const std::uint64_t texels = texels_of(side);
    const std::uint64_t every_map =
        map_texel_bytes + (need.bounces ? bounce_texel_bytes : 0) +
        (need.directional ? directional_texel_bytes + (need.bounces ? sent_texel_bytes : 0) : 0) +
        (need.estimated ? estimated_map_texel_bytes : 0);
    const std::uint64_t whole = (need.copied ? copied_work_texel_bytes : work_texel_bytes) +
                                (need.denoised ? denoised_work_texel_bytes : 0) +
                                (need.estimated && need.bounces ? estimated_bounce_texel_bytes : 0);
    const std::uint64_t touched = touched_work_texel_bytes -
                                  (need.copied ? copied_work_texel_bytes : work_texel_bytes) +
                                  (need.estimated ? estimated_work_texel_bytes : 0);
    return program_bytes + (need.images ? codec_bytes : 0) + need.held + sky_texel_bytes * need.sky_texels +
           triangle_bytes * need.triangles + need.opacity + (every_map * need.maps + whole) * texels +
           touched_map_texel_bytes * share_of(need.touched, need.maps * texels) +
           touched * share_of(need.most_touched, texels) + tile_bytes(need, side);
}

std::uint64_t memory_limit(const Settings& settings) {
    return settings.memory_limit.value_or(machine_memory() / 4 * 3);
}

void check_memory(const MemoryNeed& need, const Settings& settings) {
    if (peak_memory(need) > memory_limit(settings)) {
        refuse(need, settings);
    }
}

void check_least_memory(const MemoryNeed& need, const Settings& settings) {
    MemoryNeed least = need;
    least.touched = least.most_touched = 0.0;
    if (peak_memory(least) > memory_limit(settings)) {
        refuse(need, settings);
    }
}

} // namespace vkbake
