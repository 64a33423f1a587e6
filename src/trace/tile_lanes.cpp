#include "trace/tile_lanes.hpp"

#include <cstddef>

#include "base/texel_scramble.hpp"
#include "trace/ray_origin.hpp"
#include "trace/thesis_directions.hpp"

namespace vkbake {

namespace {

void set_lane(TileLanes::Rows& rows, std::size_t lane, const glm::vec3& value) {
    rows[0][lane] = value.x;
    rows[1][lane] = value.y;
    rows[2][lane] = value.z;
}

} // namespace

void set_lanes(const Surface& surface, const GeometryImage& geometry, const Settings& settings, const TexelTile& tile,
               TileLanes& lanes) {
    const auto width = static_cast<std::uint32_t>(geometry.width);
    const auto& positions = surface.positions;
    const auto scramble_of = [&](std::uint32_t texel) {
        return texel_scramble(settings.seed, texel % width, texel / width);
    };
    for (std::size_t lane = 0; lane < RayBlock::lanes; ++lane) {
        if (lane >= tile.count) { // as lane 0
            for (TileLanes::Rows* rows :
                 {&lanes.origin, &lanes.tangent, &lanes.bitangent, &lanes.normal, &lanes.geometric_normal}) {
                for (auto& row : *rows) {
                    row[lane] = row[0];
                }
            }
            lanes.triangle[lane] = lanes.triangle[0];
            lanes.scrambles.set(lane, scramble_of(tile.texels[0]));
            continue;
        }
        const std::uint32_t texel = tile.texels[lane];
        const glm::vec3& shading_normal = geometry.shading_normal[texel];
        const bool flat = geometry.geometric_normal[texel] == glm::vec3(0.0F);
        const glm::vec3& geometric_normal = flat ? shading_normal : geometry.geometric_normal[texel];
        const OrthonormalFrame frame =
            settings.sampler == Sampler::thesis ? thesis_frame(shading_normal) : orthonormal_frame(shading_normal);
        const std::size_t corner = std::size_t{3} * geometry.triangle[texel];
        set_lane(lanes.origin, lane,
                 ray_origin({positions[corner], positions[corner + 1], positions[corner + 2]}, geometry.position[texel],
                            geometric_normal));
        set_lane(lanes.tangent, lane, frame.tangent);
        set_lane(lanes.bitangent, lane, frame.bitangent);
        set_lane(lanes.normal, lane, frame.normal);
        set_lane(lanes.geometric_normal, lane, geometric_normal);
        lanes.triangle[lane] = geometry.triangle[texel];
        lanes.scrambles.set(lane, scramble_of(texel));
    }
    lanes.covered = static_cast<RayBlock::LaneBits>((1U << tile.count) - 1U);
}

} // namespace vkbake
