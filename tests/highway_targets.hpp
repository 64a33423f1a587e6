// Every instruction set that the machine has, one after the other.
#pragma once

#include <functional>

#include <gtest/gtest.h>
#include <hwy/highway.h>

namespace vkbake::test {

/// Runs `work` with only one of Highway's targets to choose from; the first time with the least of them.
inline void for_every_target(const std::function<void()>& work) {
    hwy::SetSupportedTargetsForTest(0);
    for (long long rest = hwy::SupportedTargets() & HWY_TARGETS; rest != 0;) {
        long long worst = rest; // better targets have lower bits
        while ((worst & (worst - 1)) != 0) {
            worst &= worst - 1;
        }
        rest &= ~worst;
        SCOPED_TRACE(hwy::TargetName(worst));
        hwy::SetSupportedTargetsForTest(worst);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        work();
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

} // namespace vkbake::test
