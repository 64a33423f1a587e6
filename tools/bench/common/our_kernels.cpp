#include "bench/common/our_kernels.hpp"

#include <bit>
#include <memory>
#include <utility>

namespace vkbake::bench {
namespace {

BlockedRays ask_each(const TriangleAccelerator& accelerator, const RayBlock& block) {
    BlockedRays blocked{};
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        const auto& [x, y, z] = block.direction[stratum];
        unsigned bits = 0;
        for (unsigned left = block.active[stratum]; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            const Ray ray{{block.origin[0][lane], block.origin[1][lane], block.origin[2][lane]},
                          {x[lane], y[lane], z[lane]},
                          block.max_distance,
                          block.ignored_triangle[lane]};
            bits |= accelerator.occluded(ray) ? 1U << lane : 0U;
        }
        blocked[stratum] = static_cast<RayBlock::LaneBits>(bits);
    }
    return blocked;
}

/// `answer` gives a block's answers; it owns what a thread needs.
template<typename Answer>
Work asking(const RaySet& rays, std::vector<BlockedRays>& answers, Answer answer) {
    return [&rays, &answers, answer = std::move(answer)](std::size_t tile) {
        for (std::size_t block = tile * rays.blocks_a_tile; block < (tile + 1) * rays.blocks_a_tile; ++block) {
            answers[block] = answer(rays.blocks[block]);
        }
    };
}

template<typename Answer>
Work making_and_asking(const RaySet& rays, std::vector<BlockedRays>& answers, Answer answer) {
    return [&rays, &answers, answer = std::move(answer),
            maker = std::make_shared<RayMaker>(*rays.source)](std::size_t tile) {
        maker->begin(rays.tiles[tile]);
        for (std::size_t b = 0; b < rays.blocks_a_tile; ++b) {
            answers[tile * rays.blocks_a_tile + b] = answer(maker->make(b));
        }
    };
}

auto block_answer(const TriangleAccelerator& accelerator) {
    return [&accelerator, scratch = std::make_shared<BlockScratch>(accelerator.make_scratch())](const RayBlock& block) {
        return accelerator.blocked(block, *scratch);
    };
}

auto single_answer(const TriangleAccelerator& accelerator) {
    return [&accelerator](const RayBlock& block) { return ask_each(accelerator, block); };
}

} // namespace

BlockKernel::BlockKernel(const TriangleAccelerator& accelerator, const RaySet& rays)
    : m_accelerator(&accelerator), m_rays(&rays), m_answers(rays.blocks.size()) {}

Work BlockKernel::ask() { return asking(*m_rays, m_answers, block_answer(*m_accelerator)); }
Work BlockKernel::make_and_ask() { return making_and_asking(*m_rays, m_answers, block_answer(*m_accelerator)); }

SingleRayKernel::SingleRayKernel(const TriangleAccelerator& accelerator, const RaySet& rays)
    : m_accelerator(&accelerator), m_rays(&rays), m_answers(rays.blocks.size()) {}

Work SingleRayKernel::ask() { return asking(*m_rays, m_answers, single_answer(*m_accelerator)); }
Work SingleRayKernel::make_and_ask() { return making_and_asking(*m_rays, m_answers, single_answer(*m_accelerator)); }

} // namespace vkbake::bench
