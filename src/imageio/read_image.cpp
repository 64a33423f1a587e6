#include "base/boundary.hpp"
#include "imageio/channels.hpp"
#include "imageio/load_codec.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake {

Image read_image(const std::filesystem::path& file) {
    return at_boundary([&] {
        const auto samples = codec().read_floats(file);
        return to_image(samples, samples.eight_bit ? Transfer::srgb : Transfer::linear);
    });
}

} // namespace vkbake
