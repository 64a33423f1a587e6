#include "imageio/load_codec.hpp"

#include <filesystem>
#include <string>

#include <dlfcn.h>

#include "vkbake/error.hpp"
#include "vkbake/vkbake.hpp"

namespace vkbake {
namespace {

constexpr const char* module_file = VKBAKE_CODEC_FILE;

/// The folder of the library or program that holds this code. Asked for by ourselves, as the address sanitizer calls
/// the loader in our place, and so a library's own search path does not count.
std::filesystem::path own_folder() {
    Dl_info info{};
    const auto* const address = reinterpret_cast<const void*>(&own_folder);
    return dladdr(address, &info) != 0 && info.dli_fname != nullptr
               ? std::filesystem::path(info.dli_fname).parent_path()
               : std::filesystem::path();
}

const Codec& load() {
    const std::filesystem::path beside = own_folder() / module_file;
    std::error_code ignored;
    void* module = nullptr;
    if (std::filesystem::exists(beside, ignored)) {
        module = dlopen(beside.c_str(), RTLD_LAZY | RTLD_LOCAL);
    } else {
        module = dlopen(module_file, RTLD_LAZY | RTLD_LOCAL);
    }
    void* const entry = module != nullptr ? dlsym(module, codec_entry) : nullptr;
    if (entry == nullptr) {
        const char* const reason = dlerror();
        throw Error(ErrorKind::bake_failed,
                    "reading and writing images: " + std::string(reason != nullptr ? reason : module_file) +
                        "; install vkbake's libraries together, and OpenImageIO");
    }
    return *reinterpret_cast<CodecEntry>(entry)();
}

} // namespace

const Codec& codec() {
    static const Codec& loaded = load();
    return loaded;
}

void load_image_codec() { (void)codec(); }

} // namespace vkbake
