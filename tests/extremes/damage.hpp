// Damaged files for the three readers: scenes, manifests, skies. Each ends in a value or in one Error.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/random.hpp"
#include "unit/write/small_scene.hpp"
#include "vkbake/vkbake.hpp"
#include "write/manifest.hpp"

namespace vkbake::test {

/// One to eight changes: a bit, a byte, a run of them, a number that lies at a limit, a cut.
inline std::string damaged(const std::string& whole, std::uint64_t seed) {
    std::uint64_t state = mix64(seed);
    const auto below = [&](std::size_t count) {
        state = mix64(state + 0x9E3779B97F4A7C15ULL);
        return static_cast<std::size_t>(state % std::max<std::size_t>(count, 1));
    };
    std::string bytes = whole;
    for (std::size_t change = below(8) + 1; change > 0 && !bytes.empty(); --change) {
        const std::size_t place = below(below(2) == 0 ? std::min<std::size_t>(bytes.size(), 256) : bytes.size());
        switch (below(6)) {
        case 0:
            bytes[place] = static_cast<char>(bytes[place] ^ static_cast<char>(1U << below(8)));
            break;
        case 1:
            bytes[place] = static_cast<char>(below(256));
            break;
        case 2: { // 4 bytes of a number at a limit
            constexpr std::uint32_t limits[] = {0U, 1U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU, 0x7F800000U, 0x10000U};
            const std::uint32_t value = limits[below(7)];
            for (std::size_t i = 0; i < 4 && place + i < bytes.size(); ++i) {
                bytes[place + i] = static_cast<char>((value >> (8 * i)) & 0xFFU);
            }
            break;
        }
        case 3: // digits become other digits, so that text stays text
            for (std::size_t i = place; i < std::min(place + 64, bytes.size()); ++i) {
                if (bytes[i] >= '0' && bytes[i] <= '9') {
                    bytes[i] = static_cast<char>('0' + below(10));
                    break;
                }
            }
            break;
        case 4:
            bytes.insert(place, bytes.substr(below(bytes.size()), below(32)));
            break;
        default:
            bytes.erase(place, below(16) == 0 ? std::string::npos : below(16));
        }
    }
    return bytes;
}

/// Whole files to begin with, and a folder to damage them in.
class Readers {
public:
    enum class Kind { scene, manifest, exr, hdr, png };
    static constexpr Kind kinds[] = {Kind::scene, Kind::manifest, Kind::exr, Kind::hdr, Kind::png};

    explicit Readers(std::filesystem::path folder) : m_folder(std::move(folder)) {
        (void)write_bake(make_scene(), make_bake(), {m_folder, LightMapFormat::exr, "whole"});
        Image sky{8, 4, {}, {}};
        for (int texel = 0; texel < 32; ++texel) {
            sky.texels.emplace_back(0.25F * static_cast<float>(texel % 4), 1.0F, 0.5F, 1.0F);
        }
        for (const char* const name : {"sky.exr", "sky.hdr", "sky.png"}) {
            write_image(m_folder / name, sky);
        }
        for (const Kind kind : kinds) {
            m_whole[static_cast<std::size_t>(kind)] = read(m_folder / name(kind));
        }
    }

    /// Returns whether it was read; throws what is not Error.
    bool read_damaged(Kind kind, std::uint64_t seed) {
        const std::filesystem::path place =
            kind == Kind::manifest ? m_folder / "manifest.json" : m_folder / (std::string("damaged-") + name(kind));
        std::ofstream(place, std::ios::binary) << damaged(m_whole[static_cast<std::size_t>(kind)], seed);
        try {
            switch (kind) {
            case Kind::scene:
                (void)load_scene(place);
                break;
            case Kind::manifest:
                (void)read_manifest(m_folder);
                check_bake_of(m_folder, "room.glb");
                break;
            default:
                (void)load_sky(place.string());
            }
            return true;
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::bad_input) {
                throw std::runtime_error(std::string("not bad input: ") + error.what());
            }
            return false;
        }
    }

    [[nodiscard]] static const char* name(Kind kind) {
        constexpr const char* names[] = {"room.glb", "manifest.json", "sky.exr", "sky.hdr", "sky.png"};
        return names[static_cast<std::size_t>(kind)];
    }

private:
    static std::string read(const std::filesystem::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    std::filesystem::path m_folder;
    std::array<std::string, 5> m_whole;
};

} // namespace vkbake::test
