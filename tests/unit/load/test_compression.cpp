// EXT_meshopt_compression and KHR_draco_mesh_compression, encoded here by the libraries' own encoders.
#include <cmath>
#include <random>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include "document_builder.hpp"

namespace vkbake::test {
namespace {

/// A bumpy grid of `side`² vertices.
struct Grid {
    explicit Grid(std::uint32_t side) {
        for (std::uint32_t y = 0; y < side; ++y) {
            for (std::uint32_t x = 0; x < side; ++x) {
                const auto fx = static_cast<float>(x);
                const auto fy = static_cast<float>(y);
                positions.insert(positions.end(), {fx * 0.5F, std::sin(fx * 0.7F) * std::cos(fy), fy * -0.25F});
                if (x + 1 < side && y + 1 < side) {
                    const std::uint32_t i = y * side + x;
                    indices.insert(indices.end(), {i, i + 1, i + side, i + 1, i + side + 1, i + side});
                }
            }
        }
    }
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
};

std::string encoded_vertices(const void* data, std::size_t count, std::size_t stride) {
    std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(count, stride));
    bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), data, count, stride));
    return raw(bytes);
}

std::string encoded_triangles(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
    std::vector<unsigned char> bytes(meshopt_encodeIndexBufferBound(indices.size(), vertices));
    bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), indices.data(), indices.size()));
    return raw(bytes);
}

std::string encoded_sequence(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
    std::vector<unsigned char> bytes(meshopt_encodeIndexSequenceBound(indices.size(), vertices));
    bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), indices.data(), indices.size()));
    return raw(bytes);
}

/// Turns a view of compressed bytes (in buffer 0) into one of the fallback buffer, as exporters write it.
void compress_view(DocumentBuilder& builder, std::size_t view, std::size_t stride, std::size_t count,
                   const std::string& mode, const std::string& filter = "NONE") {
    Json& json = builder.json["bufferViews"][view];
    const Json compressed = {{"buffer", 0},
                             {"byteOffset", json["byteOffset"]},
                             {"byteLength", json["byteLength"]},
                             {"byteStride", stride},
                             {"count", count},
                             {"mode", mode},
                             {"filter", filter}};
    json = {{"buffer", 1}, {"byteLength", stride * count}, {"extensions", {{"EXT_meshopt_compression", compressed}}}};
    if (mode == "ATTRIBUTES") {
        json["byteStride"] = stride;
    }
}

void require_meshopt(DocumentBuilder& builder) {
    builder.json["extensionsUsed"] = {"EXT_meshopt_compression", "KHR_mesh_quantization"};
    builder.json["extensionsRequired"] = {"EXT_meshopt_compression", "KHR_mesh_quantization"};
    builder.json["buffers"] =
        Json::array({{{"byteLength", builder.binary.size()}},
                     {{"byteLength", 1'000'000}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}});
}

void add_accessor(DocumentBuilder& builder, std::size_t view, int component, std::size_t count, const char* type,
                  bool normalized = false) {
    builder.json["accessors"].push_back({{"bufferView", view},
                                         {"componentType", component},
                                         {"count", count},
                                         {"type", type},
                                         {"normalized", normalized}});
}

/// The grid with positions, octahedral normals, exponential texture coordinates and indices in all three modes.
DocumentBuilder meshopt_document(const Grid& grid, const char* index_mode) {
    const std::size_t count = grid.positions.size() / 3;
    DocumentBuilder builder;
    const std::size_t positions = builder.add_view(encoded_vertices(grid.positions.data(), count, 12));
    compress_view(builder, positions, 12, count, "ATTRIBUTES");

    std::vector<float> directions;
    for (std::size_t i = 0; i < count; ++i) {
        const auto angle = static_cast<float>(i);
        directions.insert(directions.end(), {0.6F * std::cos(angle), 0.6F * std::sin(angle), 0.8F, 0.0F});
    }
    std::vector<std::int16_t> octahedral(4 * count);
    meshopt_encodeFilterOct(octahedral.data(), count, 8, 16, directions.data());
    const std::size_t normals = builder.add_view(encoded_vertices(octahedral.data(), count, 8));
    compress_view(builder, normals, 8, count, "ATTRIBUTES", "OCTAHEDRAL");

    std::vector<std::uint32_t> exponential(2 * count);
    std::vector<float> tex_coords;
    for (std::size_t i = 0; i < 2 * count; ++i) {
        tex_coords.push_back(static_cast<float>(i) / 1024.0F);
    }
    meshopt_encodeFilterExp(exponential.data(), count, 8, 24, tex_coords.data());
    const std::size_t uvs = builder.add_view(encoded_vertices(exponential.data(), count, 8));
    compress_view(builder, uvs, 8, count, "ATTRIBUTES", "EXPONENTIAL");

    const bool triangles = std::string(index_mode) == "TRIANGLES";
    const std::size_t indices =
        builder.add_view(triangles ? encoded_triangles(grid.indices, count) : encoded_sequence(grid.indices, count));
    compress_view(builder, indices, 2, grid.indices.size(), index_mode);

    add_accessor(builder, positions, 5126, count, "VEC3");
    add_accessor(builder, normals, 5122, count, "VEC3", true);
    add_accessor(builder, uvs, 5126, count, "VEC2");
    add_accessor(builder, indices, 5123, grid.indices.size(), "SCALAR");
    builder.add_mesh({{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}})["indices"] = 3;
    require_meshopt(builder);
    return builder;
}

/// The triangles' corners, each triangle turned so that its least corner comes first: encoders may turn and sort them.
std::vector<std::array<std::array<float, 3>, 3>> sorted_triangles(const std::vector<glm::vec3>& positions,
                                                                  const std::vector<std::uint32_t>& indices) {
    std::vector<std::array<std::array<float, 3>, 3>> triangles;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        std::array<std::array<float, 3>, 3> triangle{};
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::vec3& p = positions.at(indices[i + c]);
            triangle.at(c) = {p.x, p.y, p.z};
        }
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        triangles.push_back(triangle);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

std::vector<glm::vec3> vectors(const std::vector<float>& values) {
    std::vector<glm::vec3> result;
    for (std::size_t i = 0; i < values.size(); i += 3) {
        result.emplace_back(values[i], values[i + 1], values[i + 2]);
    }
    return result;
}

TEST(Meshopt, RoundTrip) {
    const Grid grid(20);
    for (const char* const mode : {"TRIANGLES", "INDICES"}) {
        const Scene scene = meshopt_document(grid, mode).load();
        const Primitive& primitive = scene.meshes.at(0).primitives.at(0);
        EXPECT_EQ(primitive.positions, vectors(grid.positions)); // lossless
        EXPECT_EQ(sorted_triangles(primitive.positions, primitive.indices),
                  sorted_triangles(vectors(grid.positions), grid.indices));
        ASSERT_EQ(primitive.normals.size(), primitive.positions.size());
        for (std::size_t i = 0; i < primitive.normals.size(); ++i) {
            const auto angle = static_cast<float>(i);
            EXPECT_NEAR(primitive.normals[i].x, 0.6F * std::cos(angle), 1e-3F);
            EXPECT_NEAR(primitive.normals[i].y, 0.6F * std::sin(angle), 1e-3F);
            EXPECT_NEAR(primitive.normals[i].z, 0.8F, 1e-3F);
            EXPECT_NEAR(primitive.tex_coords[0][i].y, static_cast<float>(2 * i + 1) / 1024.0F, 1e-6F);
        }
        const Json source = Json::parse(scene.source->json);
        EXPECT_EQ(source["extensionsRequired"], Json::array({"KHR_mesh_quantization"}));
        EXPECT_EQ(source.dump().find("EXT_meshopt_compression"), std::string::npos);
        EXPECT_EQ(source["buffers"].size(), 1U);
        // The compressed bytes are gone: 400 vertices × (12 + 8 + 8) bytes, 2166 indices of 2, and alignment.
        EXPECT_LT(scene.source->binary.size(), 400U * 28U + 2166U * 2U + 64U);
    }
}

TEST(Meshopt, FaultsAreRefused) {
    const Grid grid(8);
    const auto refused = [&](const auto& change, const std::string& part) {
        DocumentBuilder builder = meshopt_document(grid, "TRIANGLES");
        Json& view = builder.json["bufferViews"][0];
        change(view["extensions"]["EXT_meshopt_compression"], view, builder);
        expect_refused(builder, part);
    };
    refused([](Json& c, Json&, auto&) { c["mode"] = "ZIP"; }, "mode \"ZIP\" is unknown (bufferView 0)");
    refused([](Json& c, Json&, auto&) { c["filter"] = "QUATERNION"; }, "filter");
    refused([](Json& c, Json&, auto&) { c["byteStride"] = 6; }, "multiple of 4");
    refused([](Json& c, Json&, auto&) { c["buffer"] = 2; }, "\"buffer\" names number 2 of 2");
    refused([](Json& c, Json&, auto&) { c["buffer"] = 1; }, "has no data");
    refused([](Json& c, Json&, auto&) { c["byteLength"] = 1'000'000; }, "do not fit their buffer");
    refused([](Json& c, Json&, auto&) { c["byteLength"] = 40; }, "damaged");
    refused([](Json& c, Json&, auto&) { c["count"] = 65; }, "is not what the compression's count");
    refused([](Json& c, Json&, auto&) { c["count"] = 4'000'000'000U; }, "cannot come from");
    refused([](Json&, Json&, auto& b) { b.binary[0] = 0; }, "damaged");
    refused([](Json&, Json& v, auto&) { v.erase("extensions"); }, "has no data");
}

/// The grid as Draco encodes it, with attribute ids for positions and texture coordinates.
std::string draco_encoded(const Grid& grid, int method, int position_bits) {
    draco::TriangleSoupMeshBuilder soup;
    soup.Start(static_cast<int>(grid.indices.size() / 3));
    const int position = soup.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int uv = soup.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
    for (std::uint32_t face = 0; face < grid.indices.size() / 3; ++face) {
        std::array<const float*, 3> p{};
        std::array<std::array<float, 2>, 3> t{};
        for (std::size_t c = 0; c < 3; ++c) {
            p.at(c) = &grid.positions.at(std::size_t{3} * grid.indices.at(3 * face + c));
            t.at(c) = {p.at(c)[0] / 16.0F, p.at(c)[2] / 16.0F};
        }
        soup.SetAttributeValuesForFace(position, draco::FaceIndex(face), p[0], p[1], p[2]);
        soup.SetAttributeValuesForFace(uv, draco::FaceIndex(face), t[0].data(), t[1].data(), t[2].data());
    }
    const auto mesh = soup.Finalize();
    mesh->attribute(position)->set_unique_id(7);
    mesh->attribute(uv)->set_unique_id(3);
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, position_bits);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, 12);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    return {buffer.data(), buffer.size()};
}

DocumentBuilder draco_document(const Grid& grid, int method = draco::MESH_EDGEBREAKER_ENCODING) {
    const std::size_t count = grid.positions.size() / 3;
    DocumentBuilder builder;
    const std::size_t view = builder.add_view(draco_encoded(grid, method, 16));
    builder.json["accessors"] = Json::array(
        {{{"componentType", 5126}, {"count", count}, {"type", "VEC3"}, {"min", {0, 0, 0}}, {"max", {0, 0, 0}}},
         {{"componentType", 5126}, {"count", count}, {"type", "VEC2"}},
         {{"componentType", 5123}, {"count", grid.indices.size()}, {"type", "SCALAR"}}});
    Json& primitive = builder.add_mesh({{"POSITION", 0}, {"TEXCOORD_1", 1}});
    primitive["indices"] = 2;
    primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view},
                                                             {"attributes", {{"POSITION", 7}, {"TEXCOORD_1", 3}}}};
    builder.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    builder.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return builder;
}

TEST(Draco, RoundTrip) {
    const Grid grid(12);
    for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
        const Scene scene = draco_document(grid, method).load();
        const Primitive& primitive = scene.meshes.at(0).primitives.at(0);
        const auto expected = sorted_triangles(vectors(grid.positions), grid.indices);
        // 16 bits over an extent of 5.5 metres; half a step is 4.2e-5. Sorted by rounded values the order could differ,
        // so each triangle is looked for.
        ASSERT_EQ(primitive.indices.size(), grid.indices.size());
        const auto actual = sorted_triangles(primitive.positions, primitive.indices);
        for (const auto& triangle : expected) {
            double nearest = 1e9;
            for (const auto& other : actual) {
                for (std::size_t turn = 0; turn < 3; ++turn) {
                    double distance = 0.0;
                    for (std::size_t c = 0; c < 9; ++c) {
                        const double d = triangle.at(c / 3).at(c % 3) - other.at((c / 3 + turn) % 3).at(c % 3);
                        distance = std::max(distance, std::abs(d));
                    }
                    nearest = std::min(nearest, distance);
                }
            }
            EXPECT_LT(nearest, 5e-5);
        }
        ASSERT_EQ(primitive.tex_coords[1].size(), primitive.positions.size());
        for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
            EXPECT_NEAR(primitive.tex_coords[1][i].x, primitive.positions[i].x / 16.0F, 2e-4F);
        }
        const Json source = Json::parse(scene.source->json);
        EXPECT_EQ(source.dump().find("draco"), std::string::npos);
        EXPECT_NEAR(source["accessors"][0]["max"][0].get<float>(), 5.5F, 5e-5F);
        EXPECT_EQ(source["accessors"][2]["componentType"], 5123);
    }
}

TEST(Draco, PlainDataBesideItAreTaken) {
    const Grid grid(4);
    DocumentBuilder builder = draco_document(grid);
    builder.json.erase("extensionsRequired");
    Json& primitive = builder.json["meshes"][0]["primitives"][0];
    const std::vector<float> shifted(48, 9.0F);
    primitive["attributes"]["POSITION"] = builder.add(shifted, "VEC3");
    primitive["attributes"]["TEXCOORD_1"] = builder.add(std::vector<float>(32, 0.5F), "VEC2");
    primitive["indices"] = builder.add(grid.indices, "SCALAR");
    EXPECT_EQ(builder.load().meshes[0].primitives[0].positions[0], glm::vec3(9.0F));
}

TEST(Draco, PrimitivesMayShareAccessorsAndData) {
    const Grid grid(5);
    DocumentBuilder builder = draco_document(grid);
    Json& primitives = builder.json["meshes"][0]["primitives"];
    primitives.push_back(Json(primitives[0]));
    primitives.push_back(Json(primitives[0]));
    const std::size_t other = builder.add_view(draco_encoded(Grid(3), draco::MESH_EDGEBREAKER_ENCODING, 16));
    primitives[2]["extensions"]["KHR_draco_mesh_compression"]["bufferView"] = other;
    const Scene scene = builder.load();
    ASSERT_EQ(scene.meshes[0].primitives.size(), 3U);
    EXPECT_EQ(scene.meshes[0].primitives[0].positions, scene.meshes[0].primitives[1].positions);
    EXPECT_EQ(scene.meshes[0].primitives[1].indices.size(), grid.indices.size());
    EXPECT_EQ(scene.meshes[0].primitives[2].indices.size(), Grid(3).indices.size());
}

TEST(Draco, FaultsAreRefused) {
    const Grid grid(6);
    const auto refused = [&](const auto& change, const std::string& part) {
        DocumentBuilder builder = draco_document(grid);
        change(builder, builder.json["meshes"][0]["primitives"][0]);
        expect_refused(builder, part);
    };
    refused([](auto&, Json& p) { p["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 8; },
            "no attribute 8 (mesh 0, primitive 0)");
    refused([](auto&, Json& p) { p["extensions"]["KHR_draco_mesh_compression"]["bufferView"] = 5; },
            "\"bufferView\" names number 5");
    refused([](auto& b, Json&) { b.json["accessors"][0]["type"] = "VEC4"; }, "components");
    refused([](auto& b, Json&) { b.binary[0] = 'X'; }, "Draco data are damaged");
    refused([](auto& b, Json&) { b.binary[5] = 1; }, "version 1.2, not 2.2");
    // Behind the header of 11 bytes and the traversal's type: the counts of points and triangles, as varints.
    refused([](auto& b, Json&) { b.binary.replace(12, 10, "\xFF\xFF\xFF\xFF\x0F\xFF\xFF\xFF\xFF\x0F"); },
            "cannot come from");
    refused([](auto&, Json& p) { p["mode"] = 0; }, "no triangles");
}

TEST(Mutations, OfCompressedDocumentsEndInASceneOrARefusal) {
    const Grid grid(9);
    std::mt19937 random(2); // NOLINT(cert-msc51-cpp): the same mutations every time
    for (const DocumentBuilder& builder : {meshopt_document(grid, "TRIANGLES"), draco_document(grid)}) {
        std::size_t refused = 0;
        constexpr int rounds = 400;
        for (int round = 0; round < rounds; ++round) {
            DocumentBuilder mutant = builder;
            for (int flips = 0; flips <= round % 3; ++flips) {
                mutant.binary[random() % mutant.binary.size()] = static_cast<char>(random());
            }
            refused += refusal([&] { (void)mutant.load(); }).empty() ? 0 : 1;
        }
        EXPECT_GT(refused, 10U);
    }
}

} // namespace
} // namespace vkbake::test
