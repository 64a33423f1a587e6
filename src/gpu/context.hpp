// A Vulkan device with one queue, and what the passes ask of it. Stages see no Vulkan header.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <typeindex>
#include <vector>

namespace vkbake::gpu {

class Commands;

struct Limits {
    int image_side = 0;                         ///< texels
    std::uint64_t storage_buffer_range = 0;     ///< bytes that one slot can see
    std::uint64_t heap_size = 0;                ///< bytes of the largest device-local heap
    std::uint32_t push_constant_bytes = 0;      ///< 128 or more
    std::uint32_t dispatch_groups = 0;          ///< in x; 65535 or more in every dimension
    std::uint32_t sub_pixel_precision_bits = 0; ///< to which vertices are snapped by the rasteriser
};

/// Made by open_device or adopt_device. Used by one thread at a time. Buffers, images and programs refer to it: it
/// outlives them. Where Vulkan fails (out of memory, device lost) every function here throws Error{bake_failed}.
class Context {
public:
    struct State;

    explicit Context(std::unique_ptr<State> state);
    ~Context();
    Context(Context&&) = delete;
    Context& operator=(Context&&) = delete;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    [[nodiscard]] const std::string& name() const; ///< device and driver
    [[nodiscard]] const Limits& limits() const;

    /// Records commands, submits them to the queue and waits until they are done and their writes can be seen by the
    /// host. Throws Error{bake_failed} with the validation layers' messages, if there are any since the last run. Not
    /// to be nested.
    void run(const std::function<void(Commands&)>& record);

    /// Whether a shader's float and double add and multiply round as the host's do, on a few thousand chosen operands.
    [[nodiscard]] bool arithmetic_is_exact();

    /// The validation layers' warnings and errors that no run has thrown yet; they are forgotten here.
    [[nodiscard]] std::vector<std::string> take_validation_messages();

    /// The context's own T: made as T(context) at the first call, kept as long as the context. For a stage's programs
    /// and small buffers, which are used page after page.
    template<class T>
    [[nodiscard]] T& kept() {
        std::shared_ptr<void>& slot = m_kept[typeid(T)];
        if (!slot) {
            slot = std::make_shared<T>(*this);
        }
        return *static_cast<T*>(slot.get());
    }

    [[nodiscard]] State& state() const { return *m_state; } ///< for src/gpu alone

private:
    std::unique_ptr<State> m_state;
    std::map<std::type_index, std::shared_ptr<void>> m_kept; ///< after the state: these use it until they are gone
};

} // namespace vkbake::gpu
