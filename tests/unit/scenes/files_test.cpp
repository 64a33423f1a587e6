// What the checked-in files are: made by the program as it is now, with the thesis's triangle counts, sound and closed.
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "glb.hpp"
#include "make_scenes/files.hpp"

namespace vkbake::test {
namespace {

const std::string scenes_folder = std::string(VKBAKE_SOURCE_DIR) + "/scenes/";

const std::vector<scenes::File>& made_files() {
    static const std::vector<scenes::File> files = scenes::make_files();
    return files;
}

std::string name_of(const testing::TestParamInfo<std::size_t>& info) {
    std::string name = made_files()[info.param].path;
    for (char& c : name) {
        c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    return name;
}

class MadeFile : public testing::TestWithParam<std::size_t> {
protected:
    [[nodiscard]] static const scenes::File& file() { return made_files()[GetParam()]; }
    [[nodiscard]] static std::string path() { return scenes_folder + file().path; }
    [[nodiscard]] static Glb glb() { return parse_glb(read_bytes(path())); }
};

INSTANTIATE_TEST_SUITE_P(Scenes, MadeFile, testing::Range<std::size_t>(0, made_files().size()), name_of);

using Point = std::tuple<float, float, float>;

Point point_of(const Corner& corner) { return {corner.position.x, corner.position.y, corner.position.z}; }

glm::dvec3 area_vector(const Face& face) {
    const glm::dvec3 a(face[0].position);
    return 0.5 * glm::cross(glm::dvec3(face[1].position) - a, glm::dvec3(face[2].position) - a);
}

// How many directed edges have no partner the other way, and how many are used by more than one triangle.
struct EdgeCount {
    std::size_t open = 0;
    std::size_t shared_by_more = 0;
};

EdgeCount count_edges(const std::vector<Face>& faces) {
    std::map<std::pair<Point, Point>, int> edges;
    for (const Face& face : faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++edges[{point_of(face[k]), point_of(face[(k + 1) % 3])}];
        }
    }
    EdgeCount count;
    for (const auto& [edge, uses] : edges) {
        count.open += edges.contains({edge.second, edge.first}) ? 0 : 1;
        count.shared_by_more += uses > 1 ? 1 : 0;
    }
    return count;
}

TEST_P(MadeFile, IsWhatTheProgramMakesNow) {
    const std::string checked_in = read_bytes(path());
    const std::string made(reinterpret_cast<const char*>(file().bytes.data()), file().bytes.size());
    // Not EXPECT_EQ: a difference of megabytes is of no use to a reader.
    EXPECT_TRUE(checked_in == made) << "run make_scenes scenes, look at the pictures, and check the files in";
    EXPECT_LT(checked_in.size(), 1000000U);
}

TEST_P(MadeFile, HasNoDegenerateOrRepeatedTriangle) {
    std::set<std::array<Point, 3>> seen;
    for (const Face& face : faces_of_scene(glb())) {
        std::array<Point, 3> corners{point_of(face[0]), point_of(face[1]), point_of(face[2])};
        std::sort(corners.begin(), corners.end());
        EXPECT_TRUE(seen.insert(corners).second) << "a triangle twice, at " << std::get<0>(corners[0]);
        EXPECT_GT(glm::length(area_vector(face)), 1e-7); // a tenth of a square millimetre
    }
}

TEST_P(MadeFile, NormalsAreUnitAndOnTheFrontSide) {
    for (const Face& face : faces_of_scene(glb())) {
        const glm::dvec3 geometric = glm::normalize(area_vector(face));
        for (const Corner& corner : face) {
            ASSERT_NEAR(glm::length(corner.normal), 1.0F, 1e-6F);
            ASSERT_GT(glm::dot(geometric, glm::dvec3(corner.normal)), 0.6);
        }
    }
}

/// Panes, leaves and cloth are thin: sheets by themselves, in meshes of their own.
bool is_of_sheets(const Glb& document, std::size_t mesh) {
    const Json& primitives = document.json.at("meshes").at(mesh).at("primitives");
    return std::all_of(primitives.begin(), primitives.end(), [&](const Json& primitive) {
        const Json& material = document.json.at("materials").at(primitive.at("material").get<std::size_t>());
        return material.contains("alphaMode") || material.contains("extensions");
    });
}

TEST_P(MadeFile, SolidsAreClosed) {
    // The plane is no solid, and the wall goes on into the ground.
    const bool is_open = file().path == "test/plane.glb" || file().path == "objects/wall.glb";
    const Glb document = glb();
    for (std::size_t mesh = 0; mesh < document.json.at("meshes").size(); ++mesh) {
        const EdgeCount edges = count_edges(faces_of_mesh(document, mesh));
        EXPECT_EQ(edges.shared_by_more, 0U);
        if (!is_open && !is_of_sheets(document, mesh)) {
            EXPECT_EQ(edges.open, 0U) << "mesh " << mesh;
        }
    }
}

TEST_P(MadeFile, HasTheMainCamera) {
    const Glb document = glb();
    std::size_t found = 0;
    for (const Json& node : document.json.at("nodes")) {
        if (node.at("name") == "main") {
            const Json& camera = document.json.at("cameras").at(node.at("camera").get<std::size_t>());
            EXPECT_EQ(camera.at("name"), "main");
            EXPECT_DOUBLE_EQ(camera.at("perspective").at("aspectRatio").get<double>(), 16.0 / 9.0);
            ++found;
        }
    }
    EXPECT_EQ(found, 1U);
}

TEST(Wall, IsOpenOnlyAtTheGround) {
    const std::vector<Face> faces = faces_of_mesh(parse_glb(read_bytes(scenes_folder + "objects/wall.glb")), 0);
    std::set<std::pair<Point, Point>> edges;
    for (const Face& face : faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            edges.insert({point_of(face[k]), point_of(face[(k + 1) % 3])});
        }
    }
    std::size_t open = 0;
    for (const auto& [from, to] : edges) {
        if (!edges.contains({to, from})) {
            EXPECT_EQ(std::get<1>(from), 0.0F);
            EXPECT_EQ(std::get<1>(to), 0.0F);
            ++open;
        }
    }
    EXPECT_EQ(open % 2, 1U) << "an odd number of triangles needs an odd rim";
}

struct ThesisObject {
    const char* stem;
    std::size_t triangles; ///< table 4.1
    glm::vec3 least_size;  ///< metres: what such a thing measures at least and at most
    glm::vec3 greatest_size;
};

TEST(ThesisObjects, HaveTheTriangleCountsOfTable41AndTheSizeOfTheRealThing) {
    const std::array<ThesisObject, 8> objects{{
        {"wall", 4999, {2, 1.5F, 0.1F}, {5, 2.5F, 0.6F}},
        {"cannon", 1350, {0.3F, 0.3F, 1.5F}, {1, 0.6F, 3}},
        {"fire-hydrant", 4634, {0.3F, 0.6F, 0.3F}, {0.8F, 1.2F, 0.8F}},
        {"storage-room", 1500, {3, 2.2F, 2.5F}, {8, 4, 8}},
        {"apartment", 504, {5, 2.3F, 5}, {12, 4, 12}},
        {"wheelbarrow", 1700, {0.5F, 0.5F, 1.2F}, {0.9F, 1, 2}},
        {"cannon-mount", 766, {0.5F, 0.4F, 1}, {1.2F, 0.9F, 2}},
        {"door", 5772, {1, 2, 0.1F}, {2.2F, 3, 0.6F}},
    }};
    for (const ThesisObject& object : objects) {
        const std::vector<Face> faces =
            faces_of_scene(parse_glb(read_bytes(scenes_folder + "objects/" + object.stem + ".glb")));
        EXPECT_EQ(faces.size(), object.triangles) << object.stem;
        glm::vec3 low(1e9F);
        glm::vec3 high(-1e9F);
        for (const Face& face : faces) {
            for (const Corner& corner : face) {
                low = glm::min(low, corner.position);
                high = glm::max(high, corner.position);
            }
        }
        const glm::vec3 size = high - low;
        for (int c = 0; c < 3; ++c) {
            EXPECT_GE(size[c], object.least_size[c]) << object.stem << ", axis " << c;
            EXPECT_LE(size[c], object.greatest_size[c]) << object.stem << ", axis " << c;
        }
    }
}

// Twice the area of the union of the boxes would be as good; a cube's charts are squares, so their boxes are they.
std::size_t count_overlapping_charts(const std::string& stem) {
    const std::vector<Face> faces = faces_of_scene(parse_glb(read_bytes(scenes_folder + "test/" + stem + ".glb")));
    std::vector<std::array<glm::vec2, 2>> charts;
    for (std::size_t f = 0; f < faces.size(); f += 2) {
        glm::vec2 low(2.0F);
        glm::vec2 high(-1.0F);
        for (const Corner& corner : faces[f]) {
            low = glm::min(low, corner.light_map_uv);
            high = glm::max(high, corner.light_map_uv);
        }
        EXPECT_TRUE(low.x >= 0.0F && low.y >= 0.0F && high.x <= 1.0F && high.y <= 1.0F);
        EXPECT_TRUE(low.x < high.x && low.y < high.y);
        charts.push_back({low, high});
    }
    std::size_t overlaps = 0;
    for (std::size_t a = 0; a < charts.size(); ++a) {
        for (std::size_t b = a + 1; b < charts.size(); ++b) {
            const glm::vec2 low = glm::max(charts[a][0], charts[b][0]);
            const glm::vec2 high = glm::min(charts[a][1], charts[b][1]);
            overlaps += low.x < high.x && low.y < high.y ? 1 : 0;
        }
    }
    return overlaps;
}

TEST(LightMapUvs, OfTheCubeAreApartAndOfTheOtherOverlap) {
    EXPECT_EQ(count_overlapping_charts("cube"), 0U);
    EXPECT_EQ(count_overlapping_charts("overlapping-uv"), 15U); // each of six with each other
}

} // namespace
} // namespace vkbake::test
