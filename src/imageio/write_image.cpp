#include <algorithm>
#include <cctype>
#include <string>

#include "base/boundary.hpp"
#include "imageio/encode.hpp"
#include "imageio/staged_file.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake {
namespace {

ImageFormat format_of(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    if (extension == ".exr") {
        return ImageFormat::exr;
    }
    if (extension == ".hdr") {
        return ImageFormat::hdr;
    }
    if (extension == ".png") {
        return ImageFormat::png8;
    }
    throw Error(ErrorKind::output,
                file.string() + ": its name's ending says no format that can be written; use .exr, .hdr or .png");
}

} // namespace

void write_image(const std::filesystem::path& file, const Image& image, const Progress& progress) {
    at_boundary([&] {
        const Poll poll = [&] {
            if (progress && !progress({"write"})) {
                throw Error(ErrorKind::interrupted, "interrupted");
            }
        };
        StagedFile(file, encode_image(image, format_of(file), {}, poll).bytes, poll).commit();
    });
}

} // namespace vkbake
