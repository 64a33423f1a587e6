#include "memory_plan.hpp"

#include <algorithm>
#include <string>

#include "base/machine_memory.hpp"
#include "opacity.hpp"
#include "probes.hpp"
#include "vkbake/error.hpp"

namespace vkbake {
namespace {

// From the arrays' sizes and from peaks of the resident set that tools/extremes/memory.sh measured (x86-64, glibc, Mesa
// 22.3.6), rounded up.

/// The program, its libraries and llvmpipe with the passes compiled; measured 203 MB.
constexpr std::uint64_t program_bytes = 256U << 20U;
/// Surface 104, atlas 32, and the greater of what makes the atlas and of what builds and keeps the accelerator;
/// measured 320 with a million triangles.
constexpr std::uint64_t triangle_bytes = 500;
/// RGBA as read is in `held`; RGB floats for look-ups.
constexpr std::uint64_t sky_texel_bytes = 12;
/// Of every map until all are written: RGBA and coverage 20, its 8-bit picture as PNG and in the .glb up to 9.
constexpr std::uint64_t map_texel_bytes = 29;
/// Of every map while bounces, or probes, are traced: albedo and emission 24, the light that leaves now and after the
/// next bounce 26.
constexpr std::uint64_t bounce_texel_bytes = 50;
/// Of every map with directions: four pictures of RGBA; while they are traced with bounces, what these sent 13.
constexpr std::uint64_t directional_texel_bytes = 64;
constexpr std::uint64_t sent_texel_bytes = 13;
/// Of the one map that is worked on: its geometry image 40 and tiles 9, or its file as it is encoded.
constexpr std::uint64_t work_texel_bytes = 52;
/// Where errors are estimated: standard error and rays of every map, and of the one that is worked on each texel's
/// samples and orders 100.
constexpr std::uint64_t estimated_map_texel_bytes = 8;
constexpr std::uint64_t estimated_work_texel_bytes = 100;
/// Of the one map that is denoised: each texel's variance, what the filter reads 48 and what it makes 20.
constexpr std::uint64_t denoised_work_texel_bytes = 72;
/// Of the tile of a map that the device works on: the geometry image's targets and what they are read back into.
constexpr std::uint64_t tile_texel_bytes = 76;
constexpr std::uint64_t tile_side = 2048;

std::uint64_t texels_of(std::uint64_t side) { return side * side; }

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

} // namespace

MemoryNeed memory_need(const Scene& scene, const Sky& sky, const Settings& settings,
                       std::optional<std::uint64_t> maps) {
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
    return {.held = bytes_of(scene) + sky_texels * sizeof(glm::vec4),
            .sky_texels = settings.mode == Mode::irradiance ? sky_texels : 0,
            .triangles = triangles,
            .opacity = opacity_bytes(scene, settings),
            .maps = maps.value_or(settings.layout == Layout::object ? objects : 1),
            .size = settings.size,
            .bounces = settings.bounces > 0 || has_probes(scene, settings),
            .directional = settings.directional == Switch::on,
            .estimated =
                settings.estimate_error || settings.target_error || settings.seconds || settings.denoise == Switch::on,
            .denoised = settings.denoise == Switch::on};
}

std::uint64_t peak_memory(const MemoryNeed& need) {
    const auto side = static_cast<std::uint64_t>(std::max(need.size, 1));
    const std::uint64_t estimates =
        need.estimated ? estimated_map_texel_bytes * need.maps + estimated_work_texel_bytes : 0;
    const std::uint64_t denoising = need.denoised ? denoised_work_texel_bytes : 0;
    const std::uint64_t directions =
        need.directional ? directional_texel_bytes + (need.bounces ? sent_texel_bytes : 0) : 0;
    return program_bytes + need.held + sky_texel_bytes * need.sky_texels + triangle_bytes * need.triangles +
           need.opacity +
           ((map_texel_bytes + (need.bounces ? bounce_texel_bytes : 0) + directions) * need.maps + work_texel_bytes +
            estimates + denoising) *
               texels_of(side) +
           tile_texel_bytes * texels_of(std::min(side, tile_side));
}

std::uint64_t memory_limit(const Settings& settings) {
    return settings.memory_limit.value_or(machine_memory() / 4 * 3);
}

void check_memory(const MemoryNeed& need, const Settings& settings) {
    const std::uint64_t limit = memory_limit(settings);
    const std::uint64_t peak = peak_memory(need);
    if (peak <= limit) {
        return;
    }
    const std::string maps = need.maps == 1 ? "a map" : std::to_string(need.maps) + " maps";
    const int size = largest_size(need, limit);
    std::string advice = "split the scene, or allow more (--memory-limit)";
    if (size > 0 && settings.density) {
        advice = "lower the density, or allow more (--memory-limit)";
    } else if (size > 0) {
        advice = "use --size " + std::to_string(size) + ", or allow more (--memory-limit)";
    }
    throw Error(ErrorKind::usage, "memory: " + std::to_string(need.triangles) + " triangles in " + maps + " of " +
                                      std::to_string(need.size) + "² texels take about " + bytes_text(peak) +
                                      ", and the limit is " + bytes_text(limit) + "; " + advice);
}

} // namespace vkbake
