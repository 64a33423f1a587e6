// What of the light along a ray gets through the surfaces that are not opaque.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "bvh/accelerator.hpp"
#include "trace/byte_texture.hpp"
#include "vkbake/scene.hpp"
#include "vkbake/surface.hpp"

namespace vkbake {

/// Whether anything may get through what is made of the material, as far as factors tell. `vertex_alpha`: whether the
/// primitive has COLOR_0.
[[nodiscard]] bool lets_light_through(const Material& material, bool vertex_alpha);

/// As lets_light_through(), of a primitive of the scene.
[[nodiscard]] bool lets_light_through(const Scene& scene, const Primitive& primitive);

/// Red, green, blue and alpha of an image; those that nothing asks for are empty.
using OpacityImage = std::array<ByteTexture, 4>;

/// For each image of the scene the channels that SurfaceOpacity asks for: bit c for channel c.
[[nodiscard]] std::vector<std::uint8_t> opacity_channels(const Scene& scene);

/// What becomes of light that meets a point of a surface.
struct Passage {
    float coverage = 1.0F;         ///< 0 … 1: of the point, so much is there at all
    glm::vec3 transmittance{0.0F}; ///< what gets through, straight on
};

/// As glTF 2.0 has it (§3.9.4): alpha is base colour's factor · texture · COLOR_0; coverage is 1 (OPAQUE), 1 from
/// alphaCutoff on and 0 below it (MASK), or alpha (BLEND). Of what is covered KHR_materials_transmission lets
/// transmission · base colour · (1 − metallic) through: straight on, as through a sheet. Both sides alike.
/// Textures are looked up at full size, not at mip levels: what a renderer shows close by.
class SurfaceOpacity {
public:
    /// Scene and surface must outlive it. `images`: one an image of the scene, of the channels that opacity_channels()
    /// names.
    SurfaceOpacity(const Scene& scene, const Surface& surface, std::vector<OpacityImage> images);

    ~SurfaceOpacity() = default;
    SurfaceOpacity(SurfaceOpacity&&) noexcept = default;
    SurfaceOpacity& operator=(SurfaceOpacity&&) noexcept = default;
    SurfaceOpacity(const SurfaceOpacity&) = delete; // parts point into images
    SurfaceOpacity& operator=(const SurfaceOpacity&) = delete;

    // In the surface's canonical order. Triangles at which all look-ups would say the same are known beforehand:
    // through the others' part of the textures.

    /// Nothing gets through them, wherever they are met.
    [[nodiscard]] std::span<const std::uint32_t> opaque() const { return m_opaque; }
    /// Something may; it has to be looked up. Neither here nor there is what is not there at all: below its cutoff, or
    /// of alpha 0, everywhere.
    [[nodiscard]] std::span<const std::uint32_t> filtered() const { return m_filtered; }

    /// At a hit on one of the filtered().
    [[nodiscard]] Passage passage(const Ray& ray, const Hit& hit) const;

private:
    /// A texture as one primitive uses it.
    struct Layer {
        TextureSampler sampler;
        const OpacityImage* image;         ///< never null
        const std::vector<glm::vec2>* uvs; ///< null: (0, 0) everywhere
    };
    struct Part {
        const Primitive* primitive = nullptr; ///< never null
        const Material* material = nullptr;   ///< never null
        bool transmits = false;
        std::optional<Layer> color; ///< base colour and alpha
        std::optional<Layer> transmission;
        std::optional<Layer> metallic;
    };
    /// The corners' vertices in the primitive, and what each counts.
    struct Place {
        std::array<std::uint32_t, 3> vertices;
        glm::dvec3 weights;
    };
    class Sorter;

    [[nodiscard]] Place corners(std::uint32_t triangle) const; ///< with the weights of the first
    [[nodiscard]] Part make_part(const Primitive& primitive, const Material& material) const;
    [[nodiscard]] float value(const Layer& layer, std::size_t channel, const ByteValues& values,
                              const Place& place) const;
    [[nodiscard]] float alpha(const Part& part, const Place& place) const;
    [[nodiscard]] glm::vec3 transmitted(const Part& part, const Place& place) const;

    const Surface* m_surface; ///< never null
    std::vector<OpacityImage> m_images;
    ByteValues m_linear = linear_values();
    ByteValues m_srgb = srgb_values();
    std::vector<Part> m_parts;
    std::vector<std::uint32_t> m_part_of; ///< by the surface's part: in m_parts, or none
    std::vector<std::uint32_t> m_opaque;
    std::vector<std::uint32_t> m_filtered;
};

} // namespace vkbake
