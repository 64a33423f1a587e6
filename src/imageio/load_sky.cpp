#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/boundary.hpp"
#include "imageio/cube_layout.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake {
namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& what) {
    throw Error(ErrorKind::bad_input,
                "sky \"" + text + "\": " + what +
                    "; give clear, R,G,B, one image (equirectangular 2:1, cube strip 6:1 or 1:6, cube cross 4:3 or "
                    "3:4) or six square images in the order +X,-X,+Y,-Y,+Z,-Z");
}

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char letter : text) {
        if (letter == ',') {
            parts.emplace_back();
        } else {
            parts.back() += letter;
        }
    }
    return parts;
}

std::optional<float> to_number(std::string_view text) {
    while (!text.empty() && text.front() == ' ') {
        text.remove_prefix(1);
    }
    while (!text.empty() && text.back() == ' ') {
        text.remove_suffix(1);
    }
    float value = 0.0F;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = result.ec == std::errc() && result.ptr == text.data() + text.size();
    return whole ? std::optional(value) : std::nullopt;
}

std::optional<ConstantSky> to_constant(const std::string& text, const std::vector<std::string>& parts) {
    ConstantSky sky;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const std::optional<float> value = to_number(parts[channel]);
        if (!value) {
            return std::nullopt;
        }
        if (!std::isfinite(*value) || *value < 0.0F) {
            refuse(text, "radiance must be finite and not negative");
        }
        sky.radiance[static_cast<int>(channel)] = *value;
    }
    return sky;
}

/// Texels whose radiance was replaced, over all images of a sky.
struct Repairs {
    std::uint64_t not_a_number = 0;
    std::uint64_t negative = 0;
    std::uint64_t infinite = 0;
};

float largest_finite(const std::vector<Image*>& images) {
    float largest = 0.0F;
    for (const Image* image : images) {
        for (const glm::vec4& texel : image->texels) {
            for (int channel = 0; channel < 3; ++channel) {
                largest = std::isfinite(texel[channel]) ? std::max(largest, texel[channel]) : largest;
            }
        }
    }
    return largest;
}

float repaired(float value, float largest, Repairs& repairs) {
    if (std::isnan(value)) {
        ++repairs.not_a_number;
        return 0.0F;
    }
    if (value < 0.0F) {
        ++repairs.negative;
        return 0.0F;
    }
    if (std::isinf(value)) {
        ++repairs.infinite;
        return largest;
    }
    return value;
}

/// NaN and negative values → 0; infinite ones → the largest finite value that the sky has. Alpha means nothing in a sky
/// → 1.
void repair(const std::vector<Image*>& images, std::vector<std::string>& notes) {
    const float largest = largest_finite(images);
    Repairs repairs;
    for (Image* image : images) {
        image->coverage.clear();
        for (glm::vec4& texel : image->texels) {
            for (int channel = 0; channel < 3; ++channel) {
                texel[channel] = repaired(texel[channel], largest, repairs);
            }
            texel.w = 1.0F;
        }
    }
    const auto note = [&](std::uint64_t count, const std::string& what) {
        if (count > 0) {
            notes.push_back("sky: " + std::to_string(count) + " values " + what);
        }
    };
    note(repairs.not_a_number, "were NaN and were set to 0");
    note(repairs.negative, "were negative and were set to 0");
    note(repairs.infinite, "were infinite and were set to the largest finite one");
}

CubeSky read_six(const std::string& text, const std::vector<std::string>& files) {
    CubeSky sky;
    for (std::size_t face = 0; face < 6; ++face) {
        sky.faces.at(face) = read_image(files[face]);
        const Image& image = sky.faces.at(face);
        if (image.width != image.height || image.width != sky.faces[0].width) {
            refuse(text, files[face] + " has " + std::to_string(image.width) + " × " + std::to_string(image.height) +
                             " texels where all six must be square and of one size");
        }
    }
    return sky;
}

void read_one(Sky& sky, const std::string& file) {
    Image image = read_image(file);
    if (image.width == 2 * image.height) {
        sky.source = EquirectangularSky{std::move(image)};
    } else if (const auto layout = find_cube_layout(image.width, image.height)) {
        sky.source = CubeSky{cut_faces(image, *layout)};
    } else {
        refuse(file, "the image has " + std::to_string(image.width) + " × " + std::to_string(image.height) +
                         " texels, which is the shape of no kind of sky");
    }
}

Sky read_sky(const std::string& text) {
    Sky sky;
    sky.name = text;
    if (text == "clear") {
        return sky;
    }
    std::error_code ignored;
    const std::vector<std::string> parts = split(text);
    // A file may have commas in its name.
    if (parts.size() == 1 || std::filesystem::is_regular_file(text, ignored)) {
        read_one(sky, text);
    } else if (parts.size() == 6) {
        sky.source = read_six(text, parts);
    } else if (const auto constant = parts.size() == 3 ? to_constant(text, parts) : std::nullopt) {
        sky.source = *constant;
        return sky;
    } else {
        refuse(text, "it is neither a colour of three numbers nor a list of six files");
    }
    if (auto* equirectangular = std::get_if<EquirectangularSky>(&sky.source)) {
        repair({&equirectangular->image}, sky.notes);
    } else if (auto* cube = std::get_if<CubeSky>(&sky.source)) {
        std::vector<Image*> faces;
        for (Image& face : cube->faces) {
            faces.push_back(&face);
        }
        repair(faces, sky.notes);
    }
    return sky;
}

} // namespace

Sky load_sky(const std::string& text) {
    return at_boundary([&] { return read_sky(text); });
}

} // namespace vkbake
