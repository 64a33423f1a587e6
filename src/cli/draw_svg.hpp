// Drawings → pictures. The only user of librsvg.
#pragma once

#include <string>

#include "vkbake/image.hpp"

namespace vkbake::cli {

/// The whole drawing, `width` · `height` texels, on white where it draws nothing. Values are encoded (sRGB) and in
/// [0,1], as write_image takes them for a PNG. What the drawing refers to outside itself is not read; CSS variables are
/// not known. Throws Error{output} where it cannot be drawn.
[[nodiscard]] Image draw_svg(const std::string& svg, int width, int height);

} // namespace vkbake::cli
