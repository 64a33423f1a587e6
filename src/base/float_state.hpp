// The floating-point environment that results depend on.
#pragma once

#include <cfenv>

namespace vkbake {

/// While it lives, this thread rounds to nearest and keeps denormals; then its state is as before.
class DefaultFloatState {
public:
    DefaultFloatState() {
        std::fegetenv(&m_saved);
        std::fesetenv(FE_DFL_ENV); // on x86 and Arm this also turns flush-to-zero off
    }
    ~DefaultFloatState() { std::fesetenv(&m_saved); }
    DefaultFloatState(const DefaultFloatState&) = delete;
    DefaultFloatState& operator=(const DefaultFloatState&) = delete;

private:
    std::fenv_t m_saved{};
};

} // namespace vkbake
