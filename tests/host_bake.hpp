// Scenes made by hand, and a bake of them without a device: the stages themselves, with the reference geometry image.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "atlas/make_atlas.hpp"
#include "geometry_image/reference.hpp"
#include "opacity.hpp"
#include "same_bits.hpp"
#include "surface/make_surface.hpp"
#include "trace/tracer.hpp"
#include "vkbake/error.hpp"
#include "vkbake/scene.hpp"

namespace vkbake::test {

struct HostBake {
    Surface surface;
    Atlas atlas;
    std::vector<GeometryImage> geometry;
    std::vector<LightMap> maps;
};

inline HostBake bake_on_host(const Scene& scene, const Sky& sky, const Settings& settings) {
    HostBake bake;
    bake.surface = make_surface(scene);
    bake.atlas = make_atlas(scene, bake.surface, settings);
    const std::optional<SurfaceOpacity> opacity = make_opacity(scene, bake.surface, settings);
    const Tracer tracer(bake.surface, sky, settings, scene.lamps, opacity ? &*opacity : nullptr);
    for (std::uint32_t page = 0; page < bake.atlas.pages.size(); ++page) {
        bake.geometry.push_back(reference_geometry_image(bake.surface, bake.atlas, page));
        bake.maps.push_back(tracer.trace(bake.geometry.back()));
    }
    return bake;
}

/// Every map's every bit, and how often rays were stopped.
inline bool same_light(const HostBake& a, const HostBake& b) {
    return std::ranges::equal(a.maps, b.maps, [](const LightMap& one, const LightMap& other) {
        return one.image.width == other.image.width && same_bits(one.image.texels, other.image.texels) &&
               same_bits(one.image.coverage, other.image.coverage) &&
               one.statistics.occluded_rays == other.statistics.occluded_rays;
    });
}

inline Sky constant_sky(const glm::vec3& radiance) { return {.source = ConstantSky{radiance}, .name = "constant"}; }

/// Few texels and rays, visibility: the quickest bake that shows where rays end.
inline Settings small_settings(int size = 32, std::uint32_t rays = 16) {
    Settings settings;
    settings.size = size;
    settings.rays = rays;
    settings.mode = Mode::ao;
    return settings;
}

inline std::uint32_t add_vertex(Primitive& primitive, const glm::vec3& position) {
    primitive.positions.push_back(position);
    return static_cast<std::uint32_t>(primitive.positions.size() - 1);
}

inline void add_quad(Primitive& primitive, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                     const glm::vec3& d) {
    const std::uint32_t first = add_vertex(primitive, a);
    for (const glm::vec3& corner : {b, c, d}) {
        add_vertex(primitive, corner);
    }
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) {
        primitive.indices.push_back(first + corner);
    }
}

/// In the plane y = height, facing up.
inline Primitive floor_of(float half, float height = 0.0F) {
    Primitive primitive;
    add_quad(primitive, {-half, height, half}, {half, height, half}, {half, height, -half}, {-half, height, -half});
    return primitive;
}

/// Facing outwards.
inline Primitive box_of(const glm::vec3& low, const glm::vec3& high) {
    Primitive box;
    const auto corner = [&](int index) {
        return glm::vec3((index & 1) != 0 ? high.x : low.x, (index & 2) != 0 ? high.y : low.y,
                         (index & 4) != 0 ? high.z : low.z);
    };
    constexpr int faces[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
    for (const auto& face : faces) {
        add_quad(box, corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3]));
    }
    return box;
}

/// A convex polyhedron with smooth normals: rings of latitude, every vertex on the sphere.
inline Primitive sphere_of(float radius, int rings = 12) {
    Primitive sphere;
    const int sides = 2 * rings;
    for (int ring = 0; ring <= rings; ++ring) {
        for (int side = 0; side < sides; ++side) {
            const double polar = std::numbers::pi * ring / rings;
            const double around = 2.0 * std::numbers::pi * side / sides;
            const glm::dvec3 unit(std::sin(polar) * std::cos(around), std::cos(polar),
                                  std::sin(polar) * std::sin(around));
            add_vertex(sphere, glm::vec3(static_cast<double>(radius) * unit));
            sphere.normals.emplace_back(unit);
        }
    }
    const auto at = [&](int ring, int side) { return static_cast<std::uint32_t>(ring * sides + side % sides); };
    for (int ring = 0; ring < rings; ++ring) {
        for (int side = 0; side < sides; ++side) {
            if (ring > 0) {
                sphere.indices.insert(sphere.indices.end(), {at(ring, side), at(ring, side + 1), at(ring + 1, side)});
            }
            if (ring + 1 < rings) {
                sphere.indices.insert(sphere.indices.end(),
                                      {at(ring, side + 1), at(ring + 1, side + 1), at(ring + 1, side)});
            }
        }
    }
    return sphere;
}

inline void add_object(Scene& scene, std::string name, Primitive primitive, const glm::dvec3& translation = {},
                       const glm::dmat3& linear = glm::dmat3(1.0)) {
    scene.meshes.push_back({name, {std::move(primitive)}, 0});
    Instance instance;
    instance.name = std::move(name);
    instance.mesh = static_cast<std::uint32_t>(scene.meshes.size() - 1);
    instance.linear = linear;
    instance.translation = translation;
    scene.instances.push_back(std::move(instance));
}

inline Scene scene_of(Primitive primitive, const glm::dvec3& translation = {},
                      const glm::dmat3& linear = glm::dmat3(1.0)) {
    Scene scene;
    scene.name = "made";
    add_object(scene, "thing", std::move(primitive), translation, linear);
    return scene;
}

/// Gives the first primitive of a mesh a material of its own.
inline void paint(Scene& scene, std::size_t mesh, const Material& material) {
    scene.materials.push_back(material);
    scene.meshes[mesh].primitives[0].material = static_cast<std::uint32_t>(scene.materials.size() - 1);
}

inline Scene painted_floor(const Material& material) {
    Scene scene = scene_of(floor_of(1.0F));
    paint(scene, 0, material);
    return scene;
}

inline glm::dmat3 odd_rotation() { return glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1.0, 2.0, 3.0))); }

/// A floor with a turned box, a mirrored and stretched sphere and a block that stands on it.
inline Scene furnished_scene() {
    Scene scene = scene_of(floor_of(4.0F));
    add_object(scene, "block", box_of({-0.5F, 0.0F, -0.5F}, {0.5F, 1.5F, 0.5F}), {1.5, 0.0, -1.25});
    add_object(scene, "turned", box_of({-0.3F, -0.4F, -0.5F}, {0.3F, 0.4F, 0.5F}), {-1.5, 1.25, 0.5}, odd_rotation());
    add_object(scene, "ball", sphere_of(0.75F, 5), {0.25, 1.0, 1.75}, glm::dmat3(-1, 0, 0, 0, 1.25, 0, 0, 0, 1));
    return scene;
}

inline void scale_scene(Scene& scene, double factor) {
    for (Instance& instance : scene.instances) {
        instance.linear *= factor;
        instance.translation *= factor;
    }
}

inline void move_scene(Scene& scene, const glm::dvec3& by) {
    for (Instance& instance : scene.instances) {
        instance.translation += by;
    }
}

/// The scene with the UVs of a bake as TEXCOORD_1: every triangle has vertices of its own.
inline Scene with_uvs_of(const Scene& scene, const HostBake& bake) {
    Scene result = scene;
    for (const SurfacePart& part : bake.surface.parts) {
        const std::uint32_t mesh = scene.instances[bake.surface.objects[part.object].instance].mesh;
        const Primitive& from = scene.meshes[mesh].primitives[part.primitive];
        Primitive to;
        for (std::size_t corner = 3 * std::size_t{part.first_triangle};
             corner < 3 * std::size_t{part.first_triangle + part.triangle_count}; ++corner) {
            to.indices.push_back(add_vertex(to, from.positions[bake.surface.vertices[corner]]));
            to.tex_coords[1].push_back(bake.atlas.uvs[corner]);
            if (!from.normals.empty()) {
                to.normals.push_back(from.normals[bake.surface.vertices[corner]]);
            }
        }
        // A mirrored instance's corners were turned; in the mesh they run as the file had them.
        if (glm::determinant(scene.instances[bake.surface.objects[part.object].instance].linear) < 0.0) {
            for (std::size_t first = 0; first < to.indices.size(); first += 3) {
                std::swap(to.indices[first + 1], to.indices[first + 2]);
            }
        }
        result.meshes[mesh].primitives[part.primitive] = std::move(to);
    }
    return result;
}

} // namespace vkbake::test
