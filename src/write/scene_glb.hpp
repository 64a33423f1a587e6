// The scene with its light maps as one binary glTF file.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "vkbake/lightmap.hpp"
#include "vkbake/scene.hpp"
#include "write/display_map.hpp"

namespace vkbake {

struct SceneGlb {
    std::vector<std::uint8_t> bytes;
    std::vector<std::string> notes;
};

/// The source document, each baked instance with a mesh of its own: cut by page, light-map UVs as TEXCOORD_1 (floats),
/// all other attributes and morph targets with the bytes they had. Materials refer to the light maps by MOZ_lightmap
/// (other modes: visibility as occlusionTexture, which takes the place of one that was there) and by extras.vkbake.
/// Where a material reads a texture by TEXCOORD_1 and the light map's UVs are others, that set moves to the next free
/// one. Lamps that were baked stay in their nodes' extras alone (baked_lamps.hpp). Points, lines, cameras, skins,
/// animations and meshes outside the baked scene stay. Light maps of an earlier bake are replaced. `scene.source` is
/// there; `maps` has one entry a page. Throws Error{bad_input, usage, output}.
[[nodiscard]] SceneGlb make_scene_glb(const Scene& scene, const Bake& bake, std::span<const DisplayMap> maps);

} // namespace vkbake
