#include "bench/atlas/xatlas_contender.hpp"

#include <memory>

#include <xatlas.h>

#include "atlas/edge_graph.hpp"
#include "vkbake/error.hpp"

namespace vkbake::bench {
namespace {

/// An object's triangles over welded vertices.
struct WeldedMesh {
    std::vector<glm::vec3> vertices;
    std::vector<std::uint32_t> indices;
};

WeldedMesh weld_object(const Surface& surface, const SurfaceObject& object) {
    const auto corners = std::span(surface.positions)
                             .subspan(3 * std::size_t{object.first_triangle}, 3 * std::size_t{object.triangle_count});
    WeldedMesh mesh{.indices = weld(corners)};
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
        mesh.vertices.resize(std::max<std::size_t>(mesh.vertices.size(), mesh.indices[corner] + std::size_t{1}));
        // In metres: what is less than its epsilon apart it takes for one point.
        mesh.vertices[mesh.indices[corner]] = corners[corner] / static_cast<float>(surface.frame.scale());
    }
    return mesh;
}

} // namespace

Unwrapped unwrap_by_xatlas(const Surface& surface, int size, int gutter) {
    std::vector<WeldedMesh> meshes;
    for (const SurfaceObject& object : surface.objects) {
        meshes.push_back(weld_object(surface, object));
    }
    const std::unique_ptr<xatlas::Atlas, void (*)(xatlas::Atlas*)> atlas(xatlas::Create(), xatlas::Destroy);
    const Stopwatch watch;
    for (const WeldedMesh& mesh : meshes) {
        xatlas::MeshDecl declaration;
        declaration.vertexPositionData = mesh.vertices.data();
        declaration.vertexPositionStride = sizeof(glm::vec3);
        declaration.vertexCount = static_cast<std::uint32_t>(mesh.vertices.size());
        declaration.indexData = mesh.indices.data();
        declaration.indexCount = static_cast<std::uint32_t>(mesh.indices.size());
        declaration.indexFormat = xatlas::IndexFormat::UInt32;
        if (const auto refusal = xatlas::AddMesh(atlas.get(), declaration); refusal != xatlas::AddMeshError::Success) {
            throw Error(ErrorKind::bake_failed, std::string("xatlas: ") + xatlas::StringForEnum(refusal));
        }
    }
    xatlas::ComputeCharts(atlas.get());
    xatlas::PackOptions options;
    options.padding = static_cast<std::uint32_t>(gutter);
    options.resolution = static_cast<std::uint32_t>(size);
    xatlas::PackCharts(atlas.get(), options);
    Unwrapped result;
    watch.read(result);
    result.density = atlas->texelsPerUnit; // a metre
    result.pages_area = static_cast<double>(atlas->width) * atlas->height * atlas->atlasCount;
    result.page_sizes.assign(std::max(1U, atlas->atlasCount), glm::dvec2(1.0)); // it gives texels
    result.uvs.resize(surface.positions.size());
    result.page.resize(surface.triangle_count());
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const xatlas::Mesh& mesh = atlas->meshes[m];
        for (std::size_t corner = 0; corner < mesh.indexCount; ++corner) {
            const xatlas::Vertex& vertex = mesh.vertexArray[mesh.indexArray[corner]];
            const std::size_t place = 3 * std::size_t{surface.objects[m].first_triangle} + corner;
            result.uvs[place] = {vertex.uv[0], vertex.uv[1]};
            result.page[place / 3] = static_cast<std::uint32_t>(std::max(vertex.atlasIndex, 0));
        }
    }
    return result;
}

} // namespace vkbake::bench
