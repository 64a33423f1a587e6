// The plain document as tinygltf's model. The only place that includes tinygltf.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <tiny_gltf.h>

#include "load/context.hpp"
#include "vkbake/scene.hpp"

namespace vkbake::gltf {

/// A checked, plain document and tinygltf's view of it. Buffers and images are left in `binary`.
struct Model {
    tinygltf::Model data;
    std::span<const std::byte> binary;
};

/// `source` must outlive the result. Throws Error{bad_input} with tinygltf's words where it refuses what was checked
/// before.
[[nodiscard]] Model make_model(const Context& context, const SourceDocument& source);

} // namespace vkbake::gltf
