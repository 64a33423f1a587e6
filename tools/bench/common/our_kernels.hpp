// Our accelerators as contenders.
#pragma once

#include "bench/common/contender.hpp"
#include "bvh/accelerator.hpp"

namespace vkbake::bench {

/// Asks whole blocks. What it is made from must outlive it.
class BlockKernel final : public Contender {
public:
    BlockKernel(const TriangleAccelerator& accelerator, const RaySet& rays);

    [[nodiscard]] std::string description() const override { return "blocks"; }
    [[nodiscard]] const RaySet& rays() const override { return *m_rays; }
    [[nodiscard]] Work ask() override;
    [[nodiscard]] Work make_and_ask() override;
    [[nodiscard]] std::vector<BlockedRays> answers() override { return m_answers; }

private:
    const TriangleAccelerator* m_accelerator; ///< never null
    const RaySet* m_rays;                     ///< never null
    std::vector<BlockedRays> m_answers;
};

/// Asks one ray after the other. What it is made from must outlive it.
class SingleRayKernel final : public Contender {
public:
    SingleRayKernel(const TriangleAccelerator& accelerator, const RaySet& rays);

    [[nodiscard]] std::string description() const override { return "single rays"; }
    [[nodiscard]] const RaySet& rays() const override { return *m_rays; }
    [[nodiscard]] Work ask() override;
    [[nodiscard]] Work make_and_ask() override;
    [[nodiscard]] std::vector<BlockedRays> answers() override { return m_answers; }

private:
    const TriangleAccelerator* m_accelerator; ///< never null
    const RaySet* m_rays;                     ///< never null
    std::vector<BlockedRays> m_answers;
};

} // namespace vkbake::bench
