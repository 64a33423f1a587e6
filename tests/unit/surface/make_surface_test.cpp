#include "surface/make_surface.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "vkbake/error.hpp"

namespace vkbake {
namespace {

/// Triangles with random vertices, and a second instance that is turned, mirrored and stretched.
Scene random_scene(unsigned seed, int triangles = 50) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<float> uniform(-3.0F, 5.0F);
    Scene scene;
    scene.name = "random";
    Primitive primitive;
    for (int corner = 0; corner < 3 * triangles; ++corner) {
        primitive.positions.emplace_back(uniform(generator), uniform(generator), uniform(generator));
        primitive.indices.push_back(static_cast<std::uint32_t>(corner));
    }
    scene.meshes.push_back({"mesh", {primitive}, 0});
    Instance plain;
    plain.name = "plain";
    plain.translation = {10.5, -3.25, 0.75};
    Instance turned;
    turned.name = "turned";
    turned.linear = glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1, 2, 3)));
    turned.linear[1] *= -2.5;
    turned.translation = {-4.0, 20.125, 6.5};
    scene.instances = {plain, turned};
    return scene;
}

bool same_bits(const Surface& a, const Surface& b) {
    return a.positions == b.positions && a.normals == b.normals && a.geometric_normals == b.geometric_normals &&
           a.canonical_order == b.canonical_order;
}

Scene one_triangle(const glm::dmat3& linear) {
    Scene scene;
    Primitive primitive;
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    primitive.normals = {{0, 0, 1}, {0, 0, 1}, {1, 0, 1}};
    primitive.indices = {0, 1, 2};
    scene.meshes.push_back({"triangle", {primitive}, 0});
    Instance instance;
    instance.linear = linear;
    scene.instances.push_back(instance);
    return scene;
}

TEST(MakeSurface, PositionsAreTheWorldsWithinHalfALastPlace) {
    const Scene scene = random_scene(1);
    const Surface surface = make_surface(scene);
    ASSERT_EQ(surface.triangle_count(), 100U);
    double worst = 0.0;
    for (const SurfacePart& part : surface.parts) {
        const Instance& instance = scene.instances[surface.objects[part.object].instance];
        const Primitive& primitive = scene.meshes[instance.mesh].primitives[part.primitive];
        for (std::size_t corner = 3 * std::size_t{part.first_triangle};
             corner < 3 * std::size_t{part.first_triangle + part.triangle_count}; ++corner) {
            const glm::dvec3 world =
                instance.linear * glm::dvec3(primitive.positions[surface.vertices[corner]]) + instance.translation;
            const glm::dvec3 error =
                (surface.frame.to_world(surface.positions[corner]) - world) * surface.frame.scale();
            worst = std::max({worst, std::abs(error.x), std::abs(error.y), std::abs(error.z)});
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_LE(std::abs(surface.positions[corner][axis]), 0.51F);
            }
        }
    }
    EXPECT_LE(worst, std::ldexp(1.0, -25)); // half a last place of a float just above ½
    EXPECT_GT(worst, 0.0);
}

TEST(MakeSurface, KeepsItsBitsUnderPowersOfTwoAndGridMoves) {
    const Scene scene = random_scene(2);
    const Surface surface = make_surface(scene);
    for (const int exponent : {-40, -3, 1, 40}) {
        Scene scaled = scene;
        for (Instance& instance : scaled.instances) {
            instance.linear *= std::ldexp(1.0, exponent);
            instance.translation *= std::ldexp(1.0, exponent);
        }
        EXPECT_TRUE(same_bits(surface, make_surface(scaled))) << "scaled by 2^" << exponent;
    }
    for (const glm::dvec3& move : {glm::dvec3(0x1p20, -0x1p21, 0x1p22), glm::dvec3(-96.0, 0.0, 4.0)}) {
        Scene moved = scene;
        for (Instance& instance : moved.instances) {
            instance.translation += move;
        }
        EXPECT_TRUE(same_bits(surface, make_surface(moved))) << "moved by " << move.x;
    }
}

/// Sizes so near a power of two, or middles so near the border of two grid cells, that adding a translation to them
/// would round them across.
TEST(MakeSurface, KeepsItsBitsAtBordersThatAMoveWouldRoundAcross) {
    for (const double size : {1.0 + 0x1p-40, 1.0 - 0x1p-40, 41.0 / 64.0 + 0x1p-40, 41.0 / 64.0 - 0x1p-40}) {
        const Scene scene = one_triangle(glm::dmat3(size));
        const Surface surface = make_surface(scene);
        for (const glm::dvec3& move : {glm::dvec3(0x1p20, -0x1p21, 0x1p22), glm::dvec3(-0x1p22, 0x1p20, 4.0)}) {
            Scene moved = scene;
            moved.instances[0].translation += move;
            EXPECT_TRUE(same_bits(surface, make_surface(moved))) << size << " moved by " << move.x;
        }
    }
}

/// Of two nodes whose distance is rounded, while the middle of the scene lies on the border of two grid cells, 20.5/32.
TEST(MakeSurface, TheOrderOfNodesChangesNoFrame) {
    for (int thousandths = 1; thousandths <= 300; ++thousandths) {
        Scene scene = one_triangle(glm::dmat3(1.0));
        scene.instances.push_back(scene.instances[0]);
        scene.instances[0].translation = glm::dvec3(-0.001 * thousandths);
        scene.instances[1].translation = glm::dvec3(9.0 / 32.0 + 0.001 * thousandths);
        const BakeFrame frame = make_surface(scene).frame;
        std::swap(scene.instances[0], scene.instances[1]);
        ASSERT_EQ(make_surface(scene).frame.centre, frame.centre) << thousandths;
    }
}

TEST(MakeSurface, DoesNotDependOnHowTheFileWritesATriangle) {
    const Scene scene = random_scene(3);
    const Surface surface = make_surface(scene);
    Scene rewritten = scene;
    std::vector<std::uint32_t>& indices = rewritten.meshes[0].primitives[0].indices;
    for (std::size_t triangle = 0; triangle < indices.size() / 3; ++triangle) {
        const auto begin = indices.begin() + static_cast<std::ptrdiff_t>(3 * triangle);
        std::rotate(begin, begin + static_cast<std::ptrdiff_t>(triangle % 3), begin + 3);
    }
    EXPECT_TRUE(same_bits(surface, make_surface(rewritten)));

    std::swap(rewritten.instances[0], rewritten.instances[1]);
    const Surface swapped = make_surface(rewritten);
    ASSERT_EQ(swapped.triangle_count(), surface.triangle_count());
    for (std::size_t rank = 0; rank < surface.triangle_count(); ++rank) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            ASSERT_EQ(surface.positions[3 * std::size_t{surface.canonical_order[rank]} + corner],
                      swapped.positions[3 * std::size_t{swapped.canonical_order[rank]} + corner]);
        }
    }
}

TEST(MakeSurface, MirroredInstanceKeepsItsFront) {
    const Surface plain = make_surface(one_triangle(glm::dmat3(1.0)));
    EXPECT_EQ(plain.geometric_normals[0], glm::vec3(0, 0, 1));
    // Mirrored in x: the front still looks along +Z, and the corner normal (1, 0, 1) is mirrored with the surface.
    const Surface mirrored = make_surface(one_triangle(glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1)));
    EXPECT_EQ(mirrored.geometric_normals[0], glm::vec3(0, 0, 1));
    const float half = std::sqrt(0.5F);
    bool found = false;
    for (const glm::vec3& normal : mirrored.normals) {
        found = found || glm::all(glm::lessThan(glm::abs(normal - glm::vec3(-half, 0, half)), glm::vec3(1e-7F)));
    }
    EXPECT_TRUE(found);
    // Mirrored in z: the front looks along −Z.
    const Surface turned = make_surface(one_triangle(glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, -1)));
    EXPECT_EQ(turned.geometric_normals[0], glm::vec3(0, 0, -1));
    EXPECT_LT(turned.normals[0].z, 0.0F);
}

TEST(MakeSurface, NormalsFollowTheInverseTranspose) {
    // A plane through x + z = const, stretched 4 × along x: its normal (1, 0, 1) becomes (1/4, 0, 1), unit length.
    Scene scene = one_triangle(glm::dmat3(4, 0, 0, 0, 1, 0, 0, 0, 1));
    scene.meshes[0].primitives[0].normals.assign(3, {1, 0, 1});
    const Surface surface = make_surface(scene);
    const double length = std::sqrt(1.0 / 16.0 + 1.0);
    for (const glm::vec3& normal : surface.normals) {
        EXPECT_NEAR(normal.x, 0.25 / length, 1e-7);
        EXPECT_NEAR(normal.y, 0.0, 1e-7);
        EXPECT_NEAR(normal.z, 1.0 / length, 1e-7);
    }
}

TEST(MakeSurface, TrianglesWithoutAreaHaveNoNormal) {
    Scene scene = one_triangle(glm::dmat3(1.0));
    Primitive& primitive = scene.meshes[0].primitives[0];
    primitive.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0.1F, 0.2F, 0.3F}};
    primitive.normals.clear();
    primitive.indices = {0, 1, 2, 3, 3, 0};
    const Surface surface = make_surface(scene);
    EXPECT_EQ(surface.geometric_normals[0], glm::vec3(0.0F));
    EXPECT_EQ(surface.geometric_normals[1], glm::vec3(0.0F));
}

TEST(MakeSurface, NormalsThatAreNoneAreTheTriangles) {
    Scene scene = one_triangle(glm::dmat3(1.0));
    scene.meshes[0].primitives[0].normals = {{0, 0, 0}, {1, 0, 0}, {-0.0F, 0, 0}};
    const Surface surface = make_surface(scene);
    for (std::size_t corner = 0; corner < 3; ++corner) {
        EXPECT_EQ(surface.normals[corner], surface.vertices[corner] == 1 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1));
    }
}

/// Else bits would differ where numbers do not, and orders by them would not be total.
TEST(MakeSurface, NoZeroIsNegative) {
    Scene scene = one_triangle(glm::dmat3(1, 0, 0, 0, 1e-20, 0, 0, 0, 1));
    Primitive& primitive = scene.meshes[0].primitives[0];
    primitive.positions = {{-1.0F, -1e-38F, -0.0F}, {1.0F, -0.0F, -0.0F}, {0.0F, 1e-38F, -1.0F}, {0.0F, 0.0F, 1.0F}};
    primitive.normals.assign(4, {-0.0F, 1.0F, -0.0F});
    primitive.indices = {0, 1, 2, 1, 0, 3};
    scene.instances[0].translation = glm::dvec3(-0.0);
    const Surface surface = make_surface(scene);
    for (const auto* values : {&surface.positions, &surface.normals, &surface.geometric_normals}) {
        for (const glm::vec3& value : *values) {
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_FALSE(value[axis] == 0.0F && std::signbit(value[axis]));
            }
        }
    }
}

TEST(MakeSurface, NamesCanBeFileNames) {
    Scene scene = one_triangle(glm::dmat3(1.0));
    scene.instances.assign(4, scene.instances[0]);
    scene.instances[0].name = "a/b:ü";
    scene.instances[1].name = "A/B:Ü";
    scene.instances[2].name = "..";
    scene.instances[3].name = "";
    const Surface surface = make_surface(scene);
    ASSERT_EQ(surface.objects.size(), 4U);
    EXPECT_EQ(surface.objects[0].name, "a_b___");
    EXPECT_EQ(surface.objects[1].name, "A_B___-2");
    EXPECT_EQ(surface.objects[2].name, "object..");
    EXPECT_EQ(surface.objects[3].name, "triangle");
}

TEST(MakeSurface, EmptyScenesAndSinglePoints) {
    EXPECT_EQ(make_surface(Scene{}).triangle_count(), 0U);
    Scene point = one_triangle(glm::dmat3(1.0));
    point.meshes[0].primitives[0].indices = {1, 1, 1};
    const Surface surface = make_surface(point);
    EXPECT_EQ(surface.triangle_count(), 1U);
    // The frame's centre is on its grid: 2⁻⁶ of a unit where the box is a point.
    EXPECT_EQ(surface.frame.to_world(surface.positions[0]), glm::dvec3(1, 0, 0));
}

TEST(MakeSurface, RefusesWhatIsNotFiniteOrOutOfRangeByName) {
    const auto expect_refused = [](const Scene& scene, const std::string& part) {
        try {
            (void)make_surface(scene);
            ADD_FAILURE() << "taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::bad_input);
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    };
    Scene scene = one_triangle(glm::dmat3(1.0));
    scene.instances[0].name = "wrong";
    const Scene whole = scene;
    scene.meshes[0].primitives[0].indices[1] = 7;
    expect_refused(scene, "mesh \"triangle\": an index (7)");
    for (const float value : {std::nanf(""), INFINITY}) {
        scene = whole;
        scene.meshes[0].primitives[0].positions[1].y = value;
        expect_refused(scene, "node \"wrong\": a vertex or the transform is not finite");
        scene = whole;
        scene.instances[0].linear[1].z = static_cast<double>(value);
        expect_refused(scene, "node \"wrong\": a vertex or the transform is not finite");
        scene = whole;
        scene.instances[0].translation.x = static_cast<double>(value);
        expect_refused(scene, "node \"wrong\": its translation is not finite");
    }
    scene = whole;
    scene.instances[0].mesh = 1;
    expect_refused(scene, "node \"wrong\" refers to mesh 1");
}

} // namespace
} // namespace vkbake
