#include "bench/common/allocation_meter.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace {

std::atomic<std::int64_t> held{0};
std::atomic<std::int64_t> most{0};
std::atomic<std::int64_t> calls{0};

void* take(std::size_t bytes, std::size_t alignment) {
    // aligned_alloc wants a multiple of the alignment; malloc's own is enough for the others.
    void* const memory = alignment <= alignof(std::max_align_t)
                             ? std::malloc(std::max<std::size_t>(bytes, 1))
                             : std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    const std::int64_t now = held += static_cast<std::int64_t>(malloc_usable_size(memory));
    std::int64_t peak = most;
    while (now > peak && !most.compare_exchange_weak(peak, now)) {
    }
    ++calls;
    return memory;
}

void give_back(void* memory) {
    if (memory != nullptr) {
        held -= static_cast<std::int64_t>(malloc_usable_size(memory));
        std::free(memory); // NOLINT(cppcoreguidelines-owning-memory): this is what operator delete is made of
    }
}

} // namespace

void* operator new(std::size_t bytes) { return take(bytes, 1); }
void* operator new[](std::size_t bytes) { return take(bytes, 1); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return take(bytes, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
    return take(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { give_back(memory); }
void operator delete[](void* memory) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t /*bytes*/) noexcept { give_back(memory); }
void operator delete[](void* memory, std::size_t /*bytes*/) noexcept { give_back(memory); }
void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept { give_back(memory); }
void operator delete[](void* memory, std::align_val_t /*alignment*/) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept {
    give_back(memory);
}
void operator delete[](void* memory, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept {
    give_back(memory);
}

namespace vkbake::bench {

Allocations allocations() { return {held, most, calls}; }

void reset_peak() { most = held.load(); }

} // namespace vkbake::bench
