// Making rays and asking nobody: what of a pass is not tracing.
#pragma once

#include <memory>

#include "bench/common/contender.hpp"

namespace vkbake::bench {

class RayMaking final : public Contender {
public:
    explicit RayMaking(const RaySet& rays) : m_rays(&rays), m_active(rays.blocks.size()) {}

    [[nodiscard]] std::string description() const override { return "making rays alone"; }
    [[nodiscard]] const RaySet& rays() const override { return *m_rays; }
    [[nodiscard]] Work ask() override {
        return [](std::size_t) {};
    }
    [[nodiscard]] Work make_and_ask() override {
        return [this, maker = std::make_shared<RayMaker>(*m_rays->source)](std::size_t tile) {
            maker->begin(m_rays->tiles[tile]);
            for (std::size_t b = 0; b < m_rays->blocks_a_tile; ++b) {
                m_active[tile * m_rays->blocks_a_tile + b] = maker->make(b).active;
            }
        };
    }
    [[nodiscard]] std::vector<BlockedRays> answers() override { return m_active; }

private:
    const RaySet* m_rays; ///< never null
    std::vector<BlockedRays> m_active;
};

} // namespace vkbake::bench
