// Our accelerators as contenders.
#pragma once

#include <functional>

#include "bench/common/contender.hpp"
#include "bvh/accelerator.hpp"

namespace vkbake::bench {

/// Asks block after block. The rays must outlive it.
class BlockByBlock : public Contender {
public:
    explicit BlockByBlock(const RaySet& rays) : m_rays(&rays), m_answers(rays.blocks.size()) {}

    [[nodiscard]] const RaySet& rays() const override { return *m_rays; }
    [[nodiscard]] Work ask() override;
    [[nodiscard]] Work make_and_ask() override;
    [[nodiscard]] std::vector<BlockedRays> answers() override { return m_answers; }

private:
    using Answer = std::function<BlockedRays(const RayBlock&)>;
    /// Gives a block's answers; for one thread, and owns what that needs.
    [[nodiscard]] virtual Answer make_answer() const = 0;

    const RaySet* m_rays; ///< never null
    std::vector<BlockedRays> m_answers;
};

/// Asks whole blocks. The accelerator must outlive it.
class BlockKernel final : public BlockByBlock {
public:
    BlockKernel(const TriangleAccelerator& accelerator, const RaySet& rays)
        : BlockByBlock(rays), m_accelerator(&accelerator) {}
    [[nodiscard]] std::string description() const override { return "blocks"; }

private:
    [[nodiscard]] std::function<BlockedRays(const RayBlock&)> make_answer() const override;

    const TriangleAccelerator* m_accelerator; ///< never null
};

/// Asks one ray after the other. The accelerator must outlive it.
class SingleRayKernel final : public BlockByBlock {
public:
    SingleRayKernel(const TriangleAccelerator& accelerator, const RaySet& rays)
        : BlockByBlock(rays), m_accelerator(&accelerator) {}
    [[nodiscard]] std::string description() const override { return "single rays"; }

private:
    [[nodiscard]] std::function<BlockedRays(const RayBlock&)> make_answer() const override;

    const TriangleAccelerator* m_accelerator; ///< never null
};

} // namespace vkbake::bench
