// The three readers of foreign files, fed with any bytes: by libFuzzer (tools/fuzz) and by the test of its corpus.
#pragma once

#include <cstdint>
#include <span>

namespace vkbake::fuzz {

/// Each returns where the bytes were read or refused with Error{bad_input}, and throws everything else.
void read_scene(std::span<const std::uint8_t> bytes); ///< load_scene; of small scenes also inspect and their images
void read_manifest(
    std::span<const std::uint8_t> bytes);           ///< read_manifest and check_bake_of, beside an empty file "map"
void read_sky(std::span<const std::uint8_t> bytes); ///< load_sky, and a look into it

} // namespace vkbake::fuzz
