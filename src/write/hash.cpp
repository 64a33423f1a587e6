#include "write/hash.hpp"

#include <xxhash.h>

namespace vkbake {

std::string hash_of(std::span<const std::uint8_t> bytes) {
    XXH128_canonical_t canonical{};
    XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes.data(), bytes.size()));
    std::string digits;
    for (const unsigned char byte : canonical.digest) {
        static constexpr const char* symbols = "0123456789abcdef";
        digits += symbols[byte >> 4U];
        digits += symbols[byte & 15U];
    }
    return digits;
}

} // namespace vkbake
