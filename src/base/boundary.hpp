// Where the library meets its caller.
#pragma once

#include <exception>
#include <new>
#include <utility>

#include "base/float_state.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

/// Runs a public function's work: with the default floating-point state, and so that nothing but Error leaves it.
template<typename Work>
auto at_boundary(Work&& work) -> decltype(std::forward<Work>(work)()) {
    const DefaultFloatState state;
    try {
        return std::forward<Work>(work)();
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::bake_failed, "out of memory; bake smaller maps or fewer objects at a time");
    } catch (const std::exception& error) {
        throw Error(ErrorKind::bake_failed, std::string("internal error: ") + error.what() + "; please report it");
    }
}

} // namespace vkbake
