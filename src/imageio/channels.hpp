// A file's named channels → the project's RGBA image with coverage.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "codec/codec.hpp"
#include "vkbake/image.hpp"

namespace vkbake {

/// Where in a file's channels the ones are that an image needs.
struct ChannelPlaces {
    std::array<std::size_t, 3> color{}; ///< red, green, blue; a grey file names one channel three times
    std::optional<std::size_t> alpha;
    std::optional<std::size_t> coverage;
};

/// By name: R, G, B, A, Y (grey), coverage, or the same after a layer's name and a point ("Combined.R"); the first
/// layer that has a colour. Where no name is known: the first three channels, or the first one, and a fourth for alpha.
[[nodiscard]] ChannelPlaces find_channels(const std::vector<std::string>& names);

enum class Transfer : unsigned char { linear, srgb }; ///< how the file's colours are encoded

/// Alpha is 1 where the file has none. Coverage is empty where the file has none.
[[nodiscard]] Image to_image(const Samples<float>& samples, Transfer transfer);

} // namespace vkbake
