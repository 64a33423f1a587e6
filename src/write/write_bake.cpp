#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "base/boundary.hpp"
#include "imageio/encode.hpp"
#include "imageio/staged_file.hpp"
#include "vkbake/vkbake.hpp"
#include "write/display_map.hpp"
#include "write/hash.hpp"
#include "write/manifest.hpp"
#include "write/probes_json.hpp"
#include "write/scene_glb.hpp"

namespace vkbake {
namespace {

struct FileFormat {
    ImageFormat format;
    const char* extension;
};

FileFormat file_format(LightMapFormat format) {
    switch (format) {
    case LightMapFormat::hdr:
        return {ImageFormat::hdr, ".hdr"};
    case LightMapFormat::png:
        return {ImageFormat::png16, ".png"};
    case LightMapFormat::exr:
        break;
    }
    return {ImageFormat::exr, ".exr"};
}

constexpr const char* value_attribute = "vkbake:value";

const char* value_name(Mode mode) {
    switch (mode) {
    case Mode::ao:
        return "visibility";
    case Mode::bent_normal:
        return "mean open direction x visibility, world axes";
    case Mode::irradiance:
        break;
    }
    return "irradiance / pi";
}

/// A vector in [−1, 1] as a PNG holds it.
Image around_half(const Image& image) {
    Image result = image;
    for (glm::vec4& texel : result.texels) {
        texel = glm::vec4(0.5F + 0.5F * glm::vec3(texel), texel.a);
    }
    return result;
}

/// What a light map's own file says about where its values come from: nothing that does not change them, so that the
/// bytes are the same for every accelerator, thread count and folder.
Attributes provenance(const Bake& bake, const std::string& name) {
    Attributes attributes{{"vkbake:version", version()},
                          {"vkbake:map", name},
                          {value_attribute, value_name(bake.settings.mode)},
                          {"vkbake:sky", bake.sky}};
    const Json settings = settings_json(bake.settings);
    for (const char* flag :
         {"mode", "ao-distance", "rays", "target-error", "time", "sampler", "triangle-test", "seed", "padding"}) {
        const Json& value = settings.at(flag);
        attributes.emplace_back(std::string("vkbake:") + flag,
                                value.is_string() ? value.get<std::string>() : value.dump());
    }
    if (bake.settings.ao_falloff != Falloff::none) {
        attributes.emplace_back("vkbake:ao-falloff", settings.at("ao-falloff").get<std::string>());
    }
    const auto any_map = [&](const auto& has) {
        return std::any_of(bake.light_maps.begin(), bake.light_maps.end(),
                           [&](const LightMap& map) { return has(map.statistics); });
    };
    if (any_map([](const LightMapStatistics& statistics) { return !statistics.lamps_reached.empty(); })) {
        attributes.emplace_back("vkbake:lamps", "on");
    }
    if (any_map([](const LightMapStatistics& statistics) { return statistics.peak_rays > 0; })) {
        attributes.emplace_back("vkbake:sun", "on");
    }
    return attributes;
}

/// As the light map's own, of another value.
Attributes provenance_of(const Bake& bake, const LightMap& map, const std::string& value) {
    Attributes attributes = provenance(bake, map.name);
    std::find_if(attributes.begin(), attributes.end(), [](const auto& entry) {
        return entry.first == value_attribute;
    })->second = value;
    return attributes;
}

/// LightMap::directional's.
std::vector<std::uint8_t> coefficient_exr(const Bake& bake, const LightMap& map, std::size_t index) {
    constexpr std::array<const char*, 4> basis{"0.282095", "0.488603 y", "0.488603 z", "0.488603 x"};
    Image image = map.directional[index];
    image.coverage = map.image.coverage;
    Attributes attributes =
        provenance_of(bake, map, std::string("radiance by the spherical harmonic ") + basis.at(index));
    attributes.emplace_back("vkbake:directional-rays", std::to_string(bake.settings.directional_rays));
    return encode_image(image, ImageFormat::exr, attributes).bytes;
}

/// A grey picture of one number a texel, with the map's coverage. Not padded: it is read, not sampled.
template<typename Value>
std::vector<std::uint8_t> one_value_exr(const Bake& bake, const LightMap& map, const std::string& what,
                                        const std::vector<Value>& values) {
    Image image{map.image.width, map.image.height, {}, map.image.coverage};
    image.texels.reserve(values.size());
    for (std::size_t texel = 0; texel < values.size(); ++texel) {
        image.texels.emplace_back(glm::vec3(static_cast<float>(values[texel])), map.image.coverage[texel]);
    }
    return encode_image(image, ImageFormat::exr, provenance_of(bake, map, what)).bytes;
}

/// A scene's name as a file's name.
std::string file_stem(const std::string& name) {
    std::string stem = name;
    std::replace_if(
        stem.begin(), stem.end(),
        [](char letter) { return letter == '/' || letter == '\\' || static_cast<unsigned char>(letter) < 0x20; }, '_');
    return stem.empty() || stem == "." || stem == ".." ? "scene" : stem;
}

void check(const Scene& scene, const Bake& bake, LightMapFormat format) {
    if (bake.settings.mode == Mode::bent_normal && format == LightMapFormat::hdr) {
        throw Error(ErrorKind::usage, "write: HDR files hold nothing below 0, and bent normals have such parts; choose "
                                      "the format exr or png");
    }
    const std::size_t triangles = bake.surface.triangle_count();
    if (bake.light_maps.size() != bake.atlas.pages.size() || bake.atlas.page.size() != triangles ||
        bake.atlas.uvs.size() != 3 * triangles || bake.surface.vertices.size() != 3 * triangles ||
        std::any_of(bake.atlas.page.begin(), bake.atlas.page.end(),
                    [&](std::uint32_t page) { return page >= bake.light_maps.size(); })) {
        throw Error(ErrorKind::usage, "write: the bake of \"" + scene.name +
                                          "\" has arrays that do not fit each other; give what bake returned");
    }
}

/// All files of one bake: each complete beside its name before the first takes its name.
class Output {
public:
    Output(std::filesystem::path directory, const Poll& poll) : m_directory(std::move(directory)), m_poll(poll) {}

    void stage(const std::string& file, std::span<const std::uint8_t> bytes) {
        m_staged.emplace_back(m_directory / file, bytes, m_poll);
        m_files.push_back({file, bytes.size(), hash_of(bytes)});
    }

    [[nodiscard]] const std::vector<WrittenFile>& files() const { return m_files; }

    std::vector<std::filesystem::path> commit() {
        std::vector<std::filesystem::path> paths;
        for (std::size_t index = 0; index < m_staged.size(); ++index) {
            m_staged[index].commit();
            paths.emplace_back(m_files[index].file);
        }
        std::set<std::filesystem::path> final_paths;
        for (const StagedFile& staged : m_staged) {
            final_paths.insert(staged.final_path());
        }
        remove_leftovers(final_paths);
        return paths;
    }

private:
    std::filesystem::path m_directory;
    const Poll& m_poll;
    std::vector<StagedFile> m_staged;
    std::vector<WrittenFile> m_files;
};

/// Asks the caller whether to go on.
class Asking {
public:
    Asking(const Progress& progress, std::size_t maps) : m_progress(progress), m_maps(static_cast<double>(maps)) {}

    void map_done() { ++m_done; }

    void operator()() {
        if (m_progress &&
            !m_progress({"write", m_done / (m_maps + 1.0)})) { // what comes after the maps counts as one more
            throw Error(ErrorKind::interrupted, "interrupted");
        }
    }

private:
    const Progress& m_progress;
    double m_maps;
    double m_done = 0.0;
};

/// The scene that was read must not be replaced by the baked one, unless it is a baked one itself.
void keep_source(const Scene& scene, const std::filesystem::path& file) {
    std::error_code ignored;
    const bool same_folder = !scene.directory.empty() &&
                             std::filesystem::equivalent(scene.directory, file.parent_path(), ignored) &&
                             std::filesystem::exists(file, ignored);
    if (same_folder && scene.source->json.find("\"vkbake ") == std::string::npos) {
        throw Error(ErrorKind::output,
                    file.string() + ": is the scene that is being baked; choose another output folder");
    }
}

std::vector<std::filesystem::path> write_files(const Scene& scene, const Bake& bake, const WriteSettings& settings,
                                               const Progress& progress) {
    const FileFormat format = file_format(settings.format);
    Asking asking(progress, bake.light_maps.size());
    const Poll poll = [&asking] { asking(); };
    Output output(settings.directory, poll);
    std::vector<WrittenMap> written;
    std::vector<DisplayMap> display;
    std::vector<std::string> notes = bake.notes;
    for (const LightMap& map : bake.light_maps) {
        const std::string file = "lightmaps/" + map.name + format.extension;
        std::optional<Image> shifted;
        if (bake.settings.mode == Mode::bent_normal && settings.format == LightMapFormat::png) {
            shifted = around_half(map.image);
        }
        const EncodedFile encoded =
            encode_image(shifted ? *shifted : map.image, format.format, provenance(bake, map.name), poll);
        output.stage(file, encoded.bytes);
        if (encoded.changed_values > 0) {
            notes.push_back(file + ": " + std::to_string(encoded.changed_values) +
                            " values are outside what the format holds and were clamped; EXR keeps them");
        }
        WrittenMap entry{.file = file, .changed_values = encoded.changed_values};
        if (bake.settings.estimate_error && map.error) {
            entry.error_file = "lightmaps/" + map.name + ".error.exr";
            entry.rays_file = "lightmaps/" + map.name + ".rays.exr";
            output.stage(entry.error_file, one_value_exr(bake, map, "standard error of luminance", map.standard_error));
            output.stage(entry.rays_file, one_value_exr(bake, map, "samples a texel", map.texel_rays));
        }
        for (std::size_t index = 0; index < map.directional.size(); ++index) {
            entry.directional_files.push_back("lightmaps/" + map.name + ".sh" + std::to_string(index) + ".exr");
            output.stage(entry.directional_files.back(), coefficient_exr(bake, map, index));
            asking();
        }
        DisplayMap picture;
        if (scene.source) {
            picture = make_display_map(map.name, map.image, bake.settings.mode, poll);
            picture.linear_file = file;
            picture.directional_files = entry.directional_files;
        }
        entry.intensity = picture.intensity;
        written.push_back(std::move(entry));
        display.push_back(std::move(picture));
        asking.map_done();
    }
    if (scene.source) {
        const std::string file = file_stem(scene.name) + ".glb";
        keep_source(scene, settings.directory / file);
        const SceneGlb glb = make_scene_glb(scene, bake, display);
        notes.insert(notes.end(), glb.notes.begin(), glb.notes.end());
        output.stage(file, glb.bytes);
    }
    if (!bake.probes.empty()) {
        const std::string text = probes_text(bake);
        output.stage("probes.json", std::vector<std::uint8_t>(text.begin(), text.end()));
    }
    const Json manifest = make_manifest(scene.name, bake, settings.command, written, output.files(), notes);
    const std::string text = manifest.dump(2) + "\n";
    output.stage("manifest.json", std::vector<std::uint8_t>(text.begin(), text.end()));
    return output.commit();
}

} // namespace

std::vector<std::filesystem::path> write_bake(const Scene& scene, const Bake& bake, const WriteSettings& settings,
                                              const Progress& progress) {
    return at_boundary([&] {
        check(scene, bake, settings.format);
        try {
            return write_files(scene, bake, settings, progress);
        } catch (const Json::exception& error) {
            throw Error(ErrorKind::output, std::string("write: ") + error.what() + "; use names in UTF-8");
        }
    });
}

} // namespace vkbake
