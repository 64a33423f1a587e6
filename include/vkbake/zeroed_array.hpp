// Large arrays of which little may be used.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace vkbake {

/// A fixed number of plain values, all bits 0 at first. What is large comes from the system as pages that take memory
/// once they are written to; std::vector writes to all of them.
template<typename Value>
class ZeroedArray {
    static_assert(std::is_trivially_copyable_v<Value> && alignof(Value) <= alignof(std::max_align_t));

public:
    ZeroedArray() = default;
    /// Throws std::bad_alloc.
    explicit ZeroedArray(std::size_t size)
        : m_values(size == 0 ? nullptr : static_cast<Value*>(std::calloc(size, sizeof(Value)))), m_size(size) {
        if (size != 0 && m_values == nullptr) {
            throw std::bad_alloc();
        }
    }

    ZeroedArray(ZeroedArray&& other) noexcept
        : m_values(std::move(other.m_values)), m_size(std::exchange(other.m_size, 0)) {}
    ZeroedArray& operator=(ZeroedArray&& other) noexcept {
        m_values = std::move(other.m_values);
        m_size = std::exchange(other.m_size, 0);
        return *this;
    }
    /// A copy takes memory for all of its pages.
    ZeroedArray(const ZeroedArray& other) : ZeroedArray(other.m_size) {
        std::copy(other.begin(), other.end(), begin());
    }
    ZeroedArray& operator=(const ZeroedArray& other) {
        ZeroedArray copy(other);
        std::swap(m_values, copy.m_values);
        std::swap(m_size, copy.m_size);
        return *this;
    }
    ~ZeroedArray() = default;

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] bool empty() const { return m_size == 0; }
    [[nodiscard]] Value* data() { return m_values.get(); }
    [[nodiscard]] const Value* data() const { return m_values.get(); }
    [[nodiscard]] Value& operator[](std::size_t index) { return m_values.get()[index]; }
    [[nodiscard]] const Value& operator[](std::size_t index) const { return m_values.get()[index]; }
    [[nodiscard]] Value* begin() { return data(); }
    [[nodiscard]] Value* end() { return data() + m_size; }
    [[nodiscard]] const Value* begin() const { return data(); }
    [[nodiscard]] const Value* end() const { return data() + m_size; }

private:
    struct Free {
        // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): calloc's other half
        void operator()(Value* values) const { std::free(values); }
    };
    std::unique_ptr<Value, Free> m_values;
    std::size_t m_size = 0;
};

} // namespace vkbake
