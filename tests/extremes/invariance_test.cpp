// What may be done to a scene without changing its light: to the bit where the bake frame promises it, within a bound
// where it does not.
#include <cstdlib>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "amount.hpp"
#include "host_bake.hpp"

namespace vkbake::test {
namespace {

struct Job {
    Scene scene;
    Settings settings;
};

struct Operation {
    const char* name;
    std::function<void(Job&)> apply;
};

/// Lengths of the settings go with the scene.
Operation scaled(const char* name, int exponent) {
    return {name, [exponent](Job& job) {
                const double factor = std::ldexp(1.0, exponent);
                scale_scene(job.scene, factor);
                if (job.settings.ao_distance) {
                    *job.settings.ao_distance *= factor;
                }
                if (job.settings.density) {
                    *job.settings.density /= factor;
                }
            }};
}

Operation moved(const char* name, const glm::dvec3& by) {
    return {name, [by](Job& job) { move_scene(job.scene, by); }};
}

template<class Generator>
void renumber_vertices(Primitive& primitive, Generator& generator) {
    std::vector<std::uint32_t> place(primitive.positions.size());
    std::iota(place.begin(), place.end(), 0U);
    std::shuffle(place.begin(), place.end(), generator);
    const auto permute = [&](auto& values) {
        auto old = values;
        for (std::size_t i = 0; i < old.size(); ++i) {
            values[place[i]] = old[i];
        }
    };
    permute(primitive.positions);
    permute(primitive.normals);
    permute(primitive.tex_coords[1]);
    for (std::uint32_t& index : primitive.indices) {
        index = place[index];
    }
}

template<class Generator>
void shuffle_triangles(Primitive& primitive, Generator& generator) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::size_t first = 0; first < primitive.indices.size(); first += 3) {
        triangles.push_back({primitive.indices[first], primitive.indices[first + 1], primitive.indices[first + 2]});
        std::rotate(triangles.back().begin(), triangles.back().begin() + generator() % 3, triangles.back().end());
    }
    std::shuffle(triangles.begin(), triangles.end(), generator);
    primitive.indices.clear();
    for (const auto& triangle : triangles) {
        primitive.indices.insert(primitive.indices.end(), triangle.begin(), triangle.end());
    }
}

void reorder_meshes(Job& job) {
    std::mt19937 generator(3);
    for (Mesh& mesh : job.scene.meshes) {
        for (Primitive& primitive : mesh.primitives) {
            renumber_vertices(primitive, generator);
            shuffle_triangles(primitive, generator);
        }
    }
}

void reverse_nodes(Job& job) {
    std::reverse(job.scene.instances.begin(), job.scene.instances.end());
    std::reverse(job.scene.meshes.begin(), job.scene.meshes.end());
    for (Instance& instance : job.scene.instances) {
        instance.mesh = static_cast<std::uint32_t>(job.scene.meshes.size() - 1) - instance.mesh;
    }
}

/// Every mesh in two halves, each with a node of its own.
void split_nodes(Job& job) {
    Scene split = job.scene;
    split.meshes.clear();
    split.instances.clear();
    for (const Instance& instance : job.scene.instances) {
        for (const bool second : {false, true}) {
            Mesh mesh = job.scene.meshes[instance.mesh];
            std::vector<std::uint32_t>& indices = mesh.primitives[0].indices;
            const auto middle = indices.begin() + static_cast<std::ptrdiff_t>(indices.size() / 6 * 3);
            second ? indices.erase(indices.begin(), middle) : indices.erase(middle, indices.end());
            split.meshes.push_back(std::move(mesh));
            split.instances.push_back(instance);
            split.instances.back().mesh = static_cast<std::uint32_t>(split.meshes.size() - 1);
        }
    }
    job.scene = std::move(split);
}

void expect_same_bits(const Job& job, const std::vector<Operation>& operations) {
    const Sky sky{.source = ClearSky{}};
    const HostBake expected = bake_on_host(job.scene, sky, job.settings);
    ASSERT_GT(expected.maps.at(0).statistics.covered_texels, 200U);
    ASSERT_GT(expected.maps.at(0).statistics.occluded_rays, 200U);
    for (const Operation& operation : operations) {
        SCOPED_TRACE(operation.name);
        Job changed = job;
        operation.apply(changed);
        EXPECT_TRUE(same_light(expected, bake_on_host(changed.scene, sky, changed.settings)));
    }
}

const std::vector<Operation> powers_and_moves{scaled("2^-40", -40),
                                              scaled("2^-13", -13),
                                              scaled("2^1", 1),
                                              scaled("2^40", 40),
                                              moved("along the grid", {0x1p20, -0x1p21, 0x1p22}),
                                              moved("by one step", {0.25, 0.0, -0.25}),
                                              {"moved, then 2^-40", [](Job& job) {
                                                   move_scene(job.scene, {-0x1p20, 0x1p10, 0x1p22});
                                                   scaled("", -40).apply(job);
                                               }}};

TEST(Invariance, PowersOfTwoAndMovesKeepEveryBit) {
    expect_same_bits({furnished_scene(), small_settings()}, powers_and_moves);
}

TEST(Invariance, LengthsThatAreGivenGoWithTheScale) {
    Job job{furnished_scene(), small_settings()};
    job.settings.ao_distance = 0.75;
    job.settings.density = 2.5;
    expect_same_bits(job, powers_and_moves);
    job.settings.ao_distance.reset();
    job.settings.mode = Mode::irradiance;
    expect_same_bits(job, {scaled("2^-40", -40), scaled("2^40", 40)});
}

TEST(Invariance, TheOrderOfAFileKeepsEveryBit) {
    const Scene scene = furnished_scene();
    Job job{with_uvs_of(scene, bake_on_host(scene, {}, small_settings())), small_settings()};
    job.settings.uv = UvSource::keep;
    expect_same_bits(job, {{"vertices and triangles", reorder_meshes},
                           {"nodes and meshes", reverse_nodes},
                           {"nodes in halves", split_nodes},
                           {"all three", [](Job& changed) {
                                reorder_meshes(changed);
                                split_nodes(changed);
                                reverse_nodes(changed);
                            }}});
}

/// One mesh that two nodes show, and two meshes alike with a node each.
TEST(Invariance, SharingAMeshChangesNoBit) {
    Scene scene = scene_of(floor_of(4.0F));
    const Primitive sphere = sphere_of(0.75F, 4);
    add_object(scene, "first", sphere, {-1.25, 1.0, 0.5});
    add_object(scene, "second", sphere, {1.5, 1.25, -0.75}, odd_rotation());
    expect_same_bits({scene, small_settings()}, {{"shared", [](Job& job) {
                                                      job.scene.instances[2].mesh = 1;
                                                      job.scene.meshes.pop_back();
                                                  }}});
}

/// The light of each texel under skies of up to `brightest`, and the bound of what N rays say of it: with a texel's
/// samples independent of the other bake's, each share of N rays has a variance of at most 1/(4 N); so do the
/// differences 1/(2 N), and a texel's exceeds 6 deviations less than once in 3·10⁷ (Hoeffding: 2 exp(−18)).
void expect_within_the_interval(const HostBake& a, const HostBake& b, const Settings& settings,
                                double brightest = 1.0) {
    ASSERT_EQ(a.maps.size(), 1U);
    ASSERT_TRUE(same_bits(a.maps[0].image.coverage, b.maps[0].image.coverage));
    const double deviation = brightest * std::sqrt(0.5 / settings.rays);
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t texel = 0; texel < a.maps[0].image.texels.size(); ++texel) {
        const double difference =
            static_cast<double>(a.maps[0].image.texels[texel].x) - static_cast<double>(b.maps[0].image.texels[texel].x);
        ASSERT_LE(std::abs(difference), 6.0 * deviation) << texel;
        sum += difference;
        count += a.maps[0].image.coverage[texel] > 0.5F ? 1.0 : 0.0;
    }
    EXPECT_LE(std::abs(sum / count), 6.0 * deviation / std::sqrt(count));
}

TEST(Invariance, RotationsMirrorsAndOddMovesStayWithinTheInterval) {
    Settings settings = small_settings(32, amount(256, 64));
    // Grown charts lie on the texels' grid: centres on the edge of two faces, which either may have when all is
    // mirrored.
    settings.charts = ChartMaker::polypack;
    const Scene made = furnished_scene();
    const Scene scene = with_uvs_of(made, bake_on_host(made, {}, settings));
    settings.uv = UvSource::keep;
    const HostBake expected = bake_on_host(scene, {}, settings);
    const std::vector<std::pair<const char*, glm::dmat3>> turns{
        {"axes permuted", glm::dmat3(0, 1, 0, 0, 0, 1, 1, 0, 0)},
        {"mirrored in x", glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1)},
        {"turned by an odd angle", odd_rotation()}};
    for (const auto& [name, turn] : turns) {
        SCOPED_TRACE(name);
        Scene turned = scene;
        for (Instance& instance : turned.instances) {
            instance.linear = turn * instance.linear;
            instance.translation = turn * instance.translation;
        }
        expect_within_the_interval(expected, bake_on_host(turned, {}, settings), settings);
    }
    Scene far = scene;
    move_scene(far, glm::dvec3(1e7));
    const HostBake at_far = bake_on_host(far, {}, settings);
    move_scene(far, glm::dvec3(0.1));
    expect_within_the_interval(at_far, bake_on_host(far, {}, settings), settings);
    expect_within_the_interval(expected, at_far, settings);
}

/// A sky of two halves, bright towards +X and +Z: turned with the scene about +Y by an odd angle, or mirrored in x with
/// it (column i of the picture is then column 3/2 W − 1 − i), it gives the same light; alone it does not.
TEST(Invariance, ASkyThatTurnsWithTheSceneGivesTheSameLight) {
    constexpr int width = 32;
    const auto sky_of = [](bool mirrored, double degrees) {
        Image image{width, 2, {}, {}};
        for (int texel = 0; texel < 2 * width; ++texel) {
            const int column = mirrored ? (3 * width / 2 - 1 - texel % width) % width : texel % width;
            image.texels.emplace_back(glm::vec3(column >= width / 2 && column < 3 * width / 4 ? 2.0F : 0.25F), 1.0F);
        }
        return Sky{.source = EquirectangularSky{std::move(image)}, .rotation_degrees = degrees};
    };
    Settings settings = small_settings(32, amount(256, 64));
    settings.mode = Mode::irradiance;
    settings.sun = Switch::off;
    settings.charts = ChartMaker::polypack;
    const Scene made = furnished_scene();
    const Scene scene = with_uvs_of(made, bake_on_host(made, {}, settings));
    settings.uv = UvSource::keep;
    const HostBake expected = bake_on_host(scene, sky_of(false, 0.0), settings);
    const auto changed = [&](const glm::dmat3& map) {
        Scene result = scene;
        for (Instance& instance : result.instances) {
            instance.linear = map * instance.linear;
            instance.translation = map * instance.translation;
        }
        return result;
    };
    const double angle = glm::radians(37.0);
    const Scene turned =
        changed(glm::dmat3(std::cos(angle), 0, -std::sin(angle), 0, 1, 0, std::sin(angle), 0, std::cos(angle)));
    expect_within_the_interval(expected, bake_on_host(turned, sky_of(false, 37.0), settings), settings, 2.0);
    const Scene mirrored = changed(glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1));
    expect_within_the_interval(expected, bake_on_host(mirrored, sky_of(true, 0.0), settings), settings, 2.0);
}

/// Moved by what is no grid step, no vertex leaves its place in the world by more than a double's and a float's
/// rounding: half a last place of 10⁷ (2⁻³⁰) twice, and of the frame (2⁻²⁵ of its size, 16 m).
TEST(Invariance, AMoveByATenthAtTenThousandKilometresIsAMoveByATenth) {
    Scene scene = furnished_scene();
    move_scene(scene, glm::dvec3(1e7));
    const Surface before = make_surface(scene);
    move_scene(scene, glm::dvec3(0.1));
    const Surface after = make_surface(scene);
    const double bound = 2.0 * 0x1p-30 + 2.0 * 0x1p-25 * 16.0;
    for (std::size_t corner = 0; corner < before.positions.size(); ++corner) {
        const glm::dvec3 step =
            after.frame.to_world(after.positions[corner]) - before.frame.to_world(before.positions[corner]);
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_NEAR(step[axis], 0.1, bound);
        }
    }
}

} // namespace
} // namespace vkbake::test
