#include "bench/common/our_kernels.hpp"

#include <memory>

#include "bvh/each_ray.hpp"

namespace vkbake::bench {

Work BlockByBlock::ask() {
    return [this, answer = make_answer()](std::size_t tile) {
        for (std::size_t block = tile * m_rays->blocks_a_tile; block < (tile + 1) * m_rays->blocks_a_tile; ++block) {
            m_answers[block] = answer(m_rays->blocks[block]);
        }
    };
}

Work BlockByBlock::make_and_ask() {
    return [this, answer = make_answer(), maker = std::make_shared<RayMaker>(*m_rays->source)](std::size_t tile) {
        maker->begin(m_rays->tiles[tile]);
        for (std::size_t b = 0; b < m_rays->blocks_a_tile; ++b) {
            m_answers[tile * m_rays->blocks_a_tile + b] = answer(maker->make(b));
        }
    };
}

std::function<BlockedRays(const RayBlock&)> BlockKernel::make_answer() const {
    return [accelerator = m_accelerator, scratch = std::make_shared<BlockScratch>(m_accelerator->make_scratch())](
               const RayBlock& block) { return accelerator->blocked(block, *scratch); };
}

std::function<BlockedRays(const RayBlock&)> SingleRayKernel::make_answer() const {
    return [accelerator = m_accelerator](const RayBlock& block) {
        return ask_one_by_one(block, [&](const Ray& ray, std::size_t /*lane*/) { return accelerator->occluded(ray); });
    };
}

} // namespace vkbake::bench
