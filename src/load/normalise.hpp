// A document made plain, so that what reads it further on needs to know one way of storing things.
#pragma once

#include "load/context.hpp"
#include "load/document.hpp"
#include "vkbake/scene.hpp"

namespace vkbake::gltf {

/// Checks buffers, views and accessors; decodes EXT_meshopt_compression and KHR_draco_mesh_compression; writes sparse
/// accessors out; embeds images; merges all buffers into one. Indices of views, accessors and images stay what they
/// were; new ones come behind. Nothing else of the document changes. Throws Error{bad_input}.
[[nodiscard]] SourceDocument normalise(Context& context, Document document);

// Its steps, in order. Each leaves a valid document.

void decode_meshopt_views(Context& context, Document& document);
void decode_draco_primitives(Context& context, Document& document);
void write_out_sparse_accessors(Context& context, Document& document);
void embed_images(Context& context, Document& document);
/// Keeps the bytes that views refer to, each of them once.
[[nodiscard]] std::vector<std::byte> merge_buffers(Context& context, Document& document);

} // namespace vkbake::gltf
