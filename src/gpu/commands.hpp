// What a run records. One pass is one dispatch line and one barrier line.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

#include "gpu/programs.hpp"
#include "gpu/resources.hpp"

namespace vkbake::gpu {

/// The kinds of work between which a barrier stands. What the host wrote before a run is visible to all of it.
enum class Stage : std::uint8_t { compute, draw, copy };

/// Keeps what the image holds.
struct Load {};
using ClearColor = std::variant<Load, std::array<float, 4>, std::array<std::uint32_t, 4>>;

struct ColorTarget {
    const Image* image = nullptr;
    ClearColor clear = std::array<float, 4>{};
};

struct DepthTarget {
    const Image* image = nullptr;
    std::optional<float> clear = 1.0F; ///< none: keeps what the image holds
};

/// All images of one size.
struct Targets {
    std::vector<ColorTarget> colors = {};
    std::optional<DepthTarget> depth = {};
};

struct Region { ///< texels
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

struct Groups {
    std::uint32_t x = 1;
    std::uint32_t y = 1;
    std::uint32_t z = 1;
};

class Commands {
public:
    struct State;
    explicit Commands(State& state) : m_state(state) {}

    /// `resources` fill the program's slots in order, `constants` its push-constant block.
    void dispatch(const ComputeProgram& program, Groups groups, std::span<const Resource> resources,
                  std::span<const std::byte> constants = {});

    /// Draws made by `draws` go to `targets`; no other command may be recorded in it. The viewport is `region`, by
    /// default all.
    void render(const Targets& targets, const std::function<void()>& draws, std::optional<Region> region = {});

    void draw(const GraphicsProgram& program, std::uint32_t vertices, std::span<const Resource> resources,
              std::span<const std::byte> constants = {}, std::uint32_t first_vertex = 0, std::uint32_t instances = 1);

    /// All that was recorded of kind `before` happens before, and can be seen by, all of kind `after` that follows.
    void barrier(Stage before, Stage after);

    /// `bytes` 0: as much as the source has.
    void copy(const Buffer& source, const Buffer& target, std::size_t source_offset = 0, std::size_t target_offset = 0,
              std::size_t bytes = 0);
    /// Between a region of an image's largest level and rows without padding at `offset`, a multiple of 16.
    void copy(const Image& source, const Region& region, const Buffer& target, std::size_t offset = 0);
    void copy(const Buffer& source, std::size_t offset, const Image& target, const Region& region);

    void fill(const Buffer& target, std::uint32_t value);

    [[nodiscard]] State& state() const { return m_state; } ///< for src/gpu alone

private:
    State& m_state;
};

/// A push-constant block or other plain value as bytes.
template<class T>
requires std::is_trivially_copyable_v<T>
[[nodiscard]] std::span<const std::byte> bytes_of(const T& value) {
    return std::as_bytes(std::span<const T, 1>(&value, 1));
}

} // namespace vkbake::gpu
