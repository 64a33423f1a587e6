// One mesh of KHR_draco_mesh_compression. The only user of libdraco.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "load/fields.hpp"
#include "load/layout.hpp"

namespace vkbake::gltf {

/// Decoded from `compressed`. All functions throw Error{bad_input} that names the primitive `where`.
class DracoMesh {
public:
    /// Throws where the data are damaged, are no triangle mesh in the bitstream that glTF asks for (2.2), or claim more
    /// triangles or points than such data can hold.
    DracoMesh(const Fields& where, std::span<const std::byte> compressed);
    ~DracoMesh();
    DracoMesh(const DracoMesh&) = delete;
    DracoMesh& operator=(const DracoMesh&) = delete;

    [[nodiscard]] std::size_t point_count() const;
    [[nodiscard]] std::size_t triangle_count() const;

    /// The attribute of Draco's unique id `id`, a value of `type` for each point, vertices at multiples of 4 bytes.
    [[nodiscard]] std::vector<std::byte> attribute(std::uint32_t id, const ElementType& type) const;

    /// Three indices a triangle, of the component type asked for or, where that cannot hold them, of unsigned ints.
    [[nodiscard]] std::vector<std::byte> indices(int& component) const;

private:
    struct Data;
    Fields m_where;
    std::unique_ptr<Data> m_data;
};

} // namespace vkbake::gltf
