#include "load/draco_mesh.hpp"

#include <array>
#include <cstring>
#include <limits>
#include <string>

#include <draco/compression/decode.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

namespace vkbake::gltf {

namespace {

struct Counts {
    std::uint32_t triangles = 0;
    std::uint32_t points = 0;
};

/// The counts in the bitstream's head (Draco bitstream specification §§4.2, 8.1, 9.1). libdraco allocates by them
/// before it finds out whether there are data behind them.
Counts read_counts(const Fields& where, draco::DecoderBuffer buffer) {
    const auto require = [&](bool good) {
        if (!good) {
            where.fail("its Draco data are damaged");
        }
    };
    draco::DracoHeader header{};
    require(buffer.Decode(&header.draco_string, sizeof(header.draco_string)) && buffer.Decode(&header.version_major) &&
            buffer.Decode(&header.version_minor) && buffer.Decode(&header.encoder_type) &&
            buffer.Decode(&header.encoder_method) && buffer.Decode(&header.flags));
    if (header.version_major != 2 || header.version_minor != 2) {
        where.fail("its Draco bitstream is of version " + std::to_string(header.version_major) + '.' +
                   std::to_string(header.version_minor) + ", not 2.2");
    }
    if (header.encoder_type != draco::TRIANGULAR_MESH) {
        where.fail("its Draco data are no triangle mesh");
    }
    buffer.set_bitstream_version(
        static_cast<std::uint16_t>(DRACO_BITSTREAM_VERSION(header.version_major, header.version_minor)));
    if ((header.flags & METADATA_FLAG_MASK) != 0) {
        draco::GeometryMetadata metadata;
        require(draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata));
    }
    Counts counts;
    if (header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING) {
        require(draco::DecodeVarint(&counts.triangles, &buffer) && draco::DecodeVarint(&counts.points, &buffer));
    } else {
        std::uint8_t traversal = 0;
        require(buffer.Decode(&traversal) && draco::DecodeVarint(&counts.points, &buffer) &&
                draco::DecodeVarint(&counts.triangles, &buffer));
    }
    return counts;
}

/// A flat regular grid, the best case, takes about 0.03 bits a triangle.
void check_counts(const Fields& where, const Counts& counts, std::size_t size) {
    constexpr std::uint64_t most = 1ULL << 26U;
    const std::uint64_t plausible = std::min<std::uint64_t>(most, 65536 + 256 * static_cast<std::uint64_t>(size));
    if (counts.triangles > plausible || counts.points > 3 * plausible) {
        where.fail(std::to_string(counts.triangles) + " triangles of " + std::to_string(counts.points) +
                   " points cannot come from " + std::to_string(size) + " bytes of Draco data");
    }
}

template<typename Component>
void read_values(const Fields& where, const draco::PointAttribute& attribute, std::size_t points, std::uint32_t rows,
                 std::size_t stride, std::vector<std::byte>& result) {
    std::array<Component, 4> value{};
    for (std::size_t i = 0; i < points; ++i) {
        const auto index = attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(i)));
        if (index.value() >= attribute.size() ||
            !attribute.ConvertValue<Component>(index, static_cast<std::int8_t>(rows), value.data())) {
            where.fail("its Draco data are damaged");
        }
        std::memcpy(&result[i * stride], value.data(), rows * sizeof(Component));
    }
}

template<typename Component>
std::vector<std::byte> packed_indices(const draco::Mesh& mesh) {
    std::vector<std::byte> result(mesh.num_faces() * 3 * sizeof(Component));
    std::size_t position = 0;
    for (std::uint32_t face = 0; face < mesh.num_faces(); ++face) {
        for (const draco::PointIndex& point : mesh.face(draco::FaceIndex(face))) {
            const auto index = static_cast<Component>(point.value());
            std::memcpy(&result[position], &index, sizeof(index));
            position += sizeof(index);
        }
    }
    return result;
}

} // namespace

struct DracoMesh::Data {
    std::unique_ptr<draco::Mesh> mesh;
};

DracoMesh::DracoMesh(const Fields& where, std::span<const std::byte> compressed)
    : m_where(where), m_data(std::make_unique<Data>()) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(compressed.data()), compressed.size());
    check_counts(where, read_counts(where, buffer), compressed.size());
    auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) {
        where.fail("its Draco data are damaged: " + printable(decoded.status().error_msg_string()));
    }
    m_data->mesh = std::move(decoded).value();
    if (m_data->mesh->num_faces() == 0 || m_data->mesh->num_points() == 0) {
        where.fail("its Draco data hold no triangles");
    }
}

DracoMesh::~DracoMesh() = default;

std::size_t DracoMesh::point_count() const { return m_data->mesh->num_points(); }

std::size_t DracoMesh::triangle_count() const { return m_data->mesh->num_faces(); }

std::vector<std::byte> DracoMesh::attribute(std::uint32_t id, const ElementType& type) const {
    const draco::PointAttribute* const attribute = m_data->mesh->GetAttributeByUniqueId(id);
    if (attribute == nullptr) {
        m_where.fail("its Draco data have no attribute " + std::to_string(id));
    }
    if (type.columns != 1 || static_cast<std::uint8_t>(attribute->num_components()) != type.rows) {
        m_where.fail("attribute " + std::to_string(id) +
                     " of its Draco data has not as many components as its accessor");
    }
    const std::size_t stride = type.vertex_stride();
    std::vector<std::byte> result(point_count() * stride);
    visit_component(type.component, [&](auto component) {
        read_values<decltype(component)>(m_where, *attribute, point_count(), type.rows, stride, result);
    });
    return result;
}

std::vector<std::byte> DracoMesh::indices(int& component) const {
    // The largest value of a type is no index: glTF keeps it for primitive restart.
    const std::size_t points = point_count();
    if (component == unsigned_byte_type && points <= std::numeric_limits<std::uint8_t>::max()) {
        return packed_indices<std::uint8_t>(*m_data->mesh);
    }
    if (component == unsigned_short_type && points <= std::numeric_limits<std::uint16_t>::max()) {
        return packed_indices<std::uint16_t>(*m_data->mesh);
    }
    component = unsigned_int_type;
    return packed_indices<std::uint32_t>(*m_data->mesh);
}

} // namespace vkbake::gltf
