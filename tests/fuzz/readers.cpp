#include "fuzz/readers.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "imageio/decode.hpp"
#include "trace/sky_lookup.hpp"
#include "trace/sky_sum.hpp"
#include "vkbake/vkbake.hpp"
#include "write/manifest.hpp"

namespace vkbake::fuzz {
namespace {

/// One for the process, kept from call to call: a fuzzer makes thousands of calls a second.
class Folder {
public:
    Folder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "vkbake-fuzz-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) {
            throw std::runtime_error("no temporary folder");
        }
        m_path = pattern;
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

    // NOLINTNEXTLINE(modernize-use-nodiscard): called for what it does
    std::filesystem::path write(const char* name, std::span<const std::uint8_t> bytes) const {
        std::ofstream stream(m_path / name, std::ios::binary);
        stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return m_path / name;
    }

private:
    std::filesystem::path m_path;
};

/// `also`: a second kind of error that may be.
template<class Work>
void run(const Work& work, ErrorKind also = ErrorKind::bad_input) {
    try {
        work();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_input && error.kind() != also) {
            throw;
        }
    }
}

std::size_t triangle_count(const Scene& scene) {
    std::size_t count = 0;
    for (const Instance& instance : scene.instances) {
        for (const Primitive& primitive : scene.meshes.at(instance.mesh).primitives) {
            count += primitive.indices.size() / 3;
        }
    }
    return count;
}

} // namespace

void read_scene(std::span<const std::uint8_t> bytes) {
    static const Folder folder;
    Scene scene;
    run([&] { scene = load_scene(folder.write("scene.gltf", bytes)); }); // binary ones are told by their first bytes
    if (triangle_count(scene) <= 1000) {
        Settings settings;
        settings.size = 64;
        settings.max_pages = 4096;
        run([&] { (void)inspect(scene, settings); }, ErrorKind::usage); // its charts may not fit
    }
    for (const EncodedImage& image : scene.images) {
        run([&] { (void)decode_rgba8(image); });
    }
}

void read_manifest(std::span<const std::uint8_t> bytes) {
    static const Folder folder;
    (void)folder.write("map", {});
    (void)folder.write("manifest.json", bytes);
    run([&] { (void)vkbake::read_manifest(folder.path()); });
    run([&] { check_bake_of(folder.path(), "map"); });
}

void read_sky(std::span<const std::uint8_t> bytes) {
    static const Folder folder;
    run([&] {
        const SkyLookup sky = make_sky_lookup(load_sky(folder.write("sky", bytes).string()));
        (void)radiance(sky, {0.6F, 0.0F, 0.8F});
    });
}

} // namespace vkbake::fuzz
