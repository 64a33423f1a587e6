#include "material/surface_colors.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include <glm/common.hpp>

#include "base/barycentric.hpp"

namespace vkbake {

namespace {

const Primitive& primitive_of(const Scene& scene, const Surface& surface, const SurfacePart& part) {
    const SurfaceObject& object = surface.objects.at(part.object);
    return scene.meshes.at(scene.instances.at(object.instance).mesh).primitives.at(part.primitive);
}

/// One primitive's material at points of its triangles.
class Painter {
public:
    Painter(const Primitive& primitive, const Material& material, std::span<const ColorTexture> textures, Alpha alpha)
        : m_primitive(primitive), m_material(material), m_textures(textures),
          m_transmission(alpha == Alpha::traced ? material.transmission : 0.0F) {}

    /// At the point with the given weights of three vertices.
    [[nodiscard]] glm::vec3 albedo(const std::array<std::uint32_t, 3>& vertices, const glm::vec3& weights) const {
        glm::vec3 color = glm::vec3(m_material.base_color) * texture(m_material.base_color_texture, vertices, weights);
        if (!m_primitive.colors.empty()) {
            glm::vec3 mixed(0.0F);
            for (int corner = 0; corner < 3; ++corner) {
                mixed +=
                    weights[corner] * glm::vec3(m_primitive.colors.at(vertices.at(static_cast<std::size_t>(corner))));
            }
            color *= mixed;
        }
        const float metallic = m_material.metallic * texture(m_material.metallic_texture, vertices, weights).b;
        const float transmission = m_transmission > 0.0F
                                       ? m_transmission * texture(m_material.transmission_texture, vertices, weights).r
                                       : 0.0F;
        return glm::clamp(color, 0.0F, 1.0F) * (1.0F - std::clamp(metallic, 0.0F, 1.0F)) *
               (1.0F - std::clamp(transmission, 0.0F, 1.0F));
    }

    [[nodiscard]] glm::vec3 emission(const std::array<std::uint32_t, 3>& vertices, const glm::vec3& weights) const {
        return m_material.emissive * texture(m_material.emissive_texture, vertices, weights);
    }

private:
    [[nodiscard]] glm::vec3 texture(const std::optional<TextureUse>& use, const std::array<std::uint32_t, 3>& vertices,
                                    const glm::vec3& weights) const {
        if (!use || use->image >= m_textures.size() || m_textures[use->image].width == 0) {
            return glm::vec3(1.0F);
        }
        glm::vec2 uv(0.0F);
        if (use->tex_coord < m_primitive.tex_coords.size() && !m_primitive.tex_coords[use->tex_coord].empty()) {
            const std::vector<glm::vec2>& set = m_primitive.tex_coords[use->tex_coord];
            for (int corner = 0; corner < 3; ++corner) {
                uv += weights[corner] * set.at(vertices.at(static_cast<std::size_t>(corner)));
            }
        }
        return color_at(m_textures[use->image], *use, uv);
    }

    const Primitive& m_primitive;
    const Material& m_material;
    std::span<const ColorTexture> m_textures;
    float m_transmission; ///< what does not get through reflects
};

template<typename Property>
bool any_shown(const Scene& scene, const Property& property) {
    const Material absent;
    return std::ranges::any_of(scene.instances, [&](const Instance& instance) {
        return std::ranges::any_of(scene.meshes.at(instance.mesh).primitives, [&](const Primitive& primitive) {
            const bool known = primitive.material && *primitive.material < scene.materials.size();
            return property(known ? scene.materials[*primitive.material] : absent);
        });
    });
}

void want(std::vector<ColorUse>& uses, const std::optional<TextureUse>& texture, ColorUse use) {
    if (texture && texture->image < uses.size() && uses[texture->image] != ColorUse::color) {
        uses[texture->image] = use;
    }
}

} // namespace

bool reflects(const Material& material) {
    return std::max({material.base_color.r, material.base_color.g, material.base_color.b}) > 0.0F &&
           (material.metallic < 1.0F || material.metallic_texture);
}

bool emits(const Material& material) {
    return std::max({material.emissive.r, material.emissive.g, material.emissive.b}) > 0.0F;
}

bool reflects(const Scene& scene) {
    return any_shown(scene, [](const Material& material) { return reflects(material); });
}

bool emits(const Scene& scene) {
    return any_shown(scene, [](const Material& material) { return emits(material); });
}

std::vector<ColorUse> color_uses(const Scene& scene, Alpha alpha) {
    std::vector<ColorUse> uses(scene.images.size(), ColorUse::none);
    for (const Material& material : scene.materials) {
        if (reflects(material)) {
            want(uses, material.metallic_texture, ColorUse::linear);
            if (alpha == Alpha::traced && material.transmission > 0.0F) {
                want(uses, material.transmission_texture, ColorUse::linear);
            }
            want(uses, material.base_color_texture, ColorUse::color);
        }
        if (emits(material)) {
            want(uses, material.emissive_texture, ColorUse::color);
        }
    }
    return uses;
}

SurfaceColors make_surface_colors(const Scene& scene, const Surface& surface, const GeometryImage& geometry,
                                  std::span<const ColorTexture> textures, Alpha alpha) {
    const Material absent;
    std::vector<Painter> painters;
    painters.reserve(surface.parts.size());
    for (const SurfacePart& part : surface.parts) {
        const Primitive& primitive = primitive_of(scene, surface, part);
        const bool known = primitive.material && *primitive.material < scene.materials.size();
        painters.emplace_back(primitive, known ? scene.materials[*primitive.material] : absent, textures, alpha);
    }
    SurfaceColors colors;
    colors.albedo.assign(geometry.texel_count(), glm::vec3(0.0F));
    if (emits(scene)) {
        colors.emission.assign(geometry.texel_count(), glm::vec3(0.0F));
    }
    for (std::size_t texel = 0; texel < geometry.texel_count(); ++texel) {
        const std::uint32_t triangle = geometry.triangle[texel];
        if (triangle == GeometryImage::empty) {
            continue;
        }
        const std::size_t first = std::size_t{3} * triangle;
        const glm::vec3 weights(
            barycentric({surface.positions[first], surface.positions[first + 1], surface.positions[first + 2]},
                        glm::dvec3(geometry.position[texel])));
        const std::array<std::uint32_t, 3> vertices{surface.vertices[first], surface.vertices[first + 1],
                                                    surface.vertices[first + 2]};
        const Painter& painter = painters.at(surface.parts_of[triangle]);
        colors.albedo[texel] = painter.albedo(vertices, weights);
        if (!colors.emission.empty()) {
            colors.emission[texel] = painter.emission(vertices, weights);
        }
    }
    return colors;
}

} // namespace vkbake
