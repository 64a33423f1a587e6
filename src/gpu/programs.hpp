// Programs: embedded shaders with what they expect to be bound.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "gpu/resources.hpp"

namespace vkbake::gpu {

/// What a shader declares at `layout(set = 0, binding = i)`: slot i.
enum class Slot : std::uint8_t { storage_buffer, storage_image, sampled_image };

struct ComputeDescription {
    std::string_view shader = {}; ///< an embedded module's name, e.g. "dilate.comp"
    std::vector<Slot> slots = {};
    std::uint32_t constant_bytes = 0; ///< of the push-constant block, a multiple of 4
};

struct Program; // pipeline and layouts, for src/gpu alone

class ComputeProgram {
public:
    ComputeProgram(Context& context, const ComputeDescription& description);
    ~ComputeProgram();
    ComputeProgram(ComputeProgram&&) noexcept;
    ComputeProgram& operator=(ComputeProgram&&) noexcept;
    ComputeProgram(const ComputeProgram&) = delete;
    ComputeProgram& operator=(const ComputeProgram&) = delete;

    [[nodiscard]] const Program& program() const { return *m_program; }

private:
    std::unique_ptr<Program> m_program;
};

enum class DepthTest : std::uint8_t {
    none,    ///< neither tested nor written
    less,    ///< the nearer wins, of equal ones the first; written
    greater, ///< the same where depth is reversed: 1 is near
};

/// Draws triangle lists. There are no vertex attributes: vertex shaders read storage buffers by gl_VertexIndex.
struct GraphicsDescription {
    std::string_view vertex_shader = {};
    std::string_view fragment_shader = {};
    std::vector<Slot> slots = {};
    std::uint32_t constant_bytes = 0;
    std::vector<Format> colors = {}; ///< of the colour targets, by location
    bool depth_target = false;       ///< whether there is a d32 target
    DepthTest depth_test = DepthTest::none;
    bool cull_back = false; ///< drop triangles that are clockwise on the picture (y down)
    bool blend = false;     ///< over: rgb·a + target·(1 − a), in all colour targets
};

class GraphicsProgram {
public:
    GraphicsProgram(Context& context, const GraphicsDescription& description);
    ~GraphicsProgram();
    GraphicsProgram(GraphicsProgram&&) noexcept;
    GraphicsProgram& operator=(GraphicsProgram&&) noexcept;
    GraphicsProgram(const GraphicsProgram&) = delete;
    GraphicsProgram& operator=(const GraphicsProgram&) = delete;

    [[nodiscard]] const Program& program() const { return *m_program; }

private:
    std::unique_ptr<Program> m_program;
};

} // namespace vkbake::gpu
