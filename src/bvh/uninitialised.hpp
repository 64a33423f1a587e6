// Vectors that are not written before they are filled.
#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace vkbake {

/// Leaves trivial values as they are where std::allocator would zero them: what is large is filled by many threads, and
/// nobody need go over it first.
template<typename Value>
struct UninitialisedAllocator : std::allocator<Value> {
    template<typename Other>
    struct rebind { // NOLINT(readability-identifier-naming): the standard's name
        using other = UninitialisedAllocator<Other>;
    };
    template<typename Other>
    void construct(Other* place) {
        ::new (static_cast<void*>(place)) Other;
    }
    template<typename Other, typename... Arguments>
    void construct(Other* place, Arguments&&... arguments) {
        ::new (static_cast<void*>(place)) Other(std::forward<Arguments>(arguments)...);
    }
};

template<typename Value>
using UninitialisedVector = std::vector<Value, UninitialisedAllocator<Value>>;

} // namespace vkbake
