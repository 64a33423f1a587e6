// One instruction set at a time.
#pragma once

#include <cstdint>

#include <hwy/highway.h>

namespace vkbake::test {

/// Restores the choice of instruction set at its end.
class OnlyTarget {
public:
    explicit OnlyTarget(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
    ~OnlyTarget() {
        hwy::SetSupportedTargetsForTest(0);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
    OnlyTarget(const OnlyTarget&) = delete;
    OnlyTarget& operator=(const OnlyTarget&) = delete;
};

/// Calls `body` once under each instruction set that this machine has; returns how many.
template<class Body>
int for_each_target(const Body& body) {
    int count = 0;
    for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
        const OnlyTarget only(targets & -targets);
        body();
        ++count;
    }
    return count;
}

} // namespace vkbake::test
