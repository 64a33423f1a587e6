// What surfaces let through: the scene's textures decoded for the tracer.
#pragma once

#include <cstdint>
#include <optional>

#include "trace/surface_opacity.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/settings.hpp"

namespace vkbake {

/// None where the settings take every surface for opaque, or every surface is. The scene and the surface must outlive
/// it. Throws Error{bad_input} where a texture that it needs is damaged.
[[nodiscard]] std::optional<SurfaceOpacity> make_opacity(const Scene& scene, const Surface& surface,
                                                         const Settings& settings);

/// Bytes that make_opacity() takes of textures at the most, while it decodes them: from the images' headers.
[[nodiscard]] std::uint64_t opacity_bytes(const Scene& scene, const Settings& settings);

} // namespace vkbake
