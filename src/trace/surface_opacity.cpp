#include "trace/surface_opacity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include <glm/common.hpp>

#include "trace/hit_point.hpp"

namespace vkbake {

namespace {

constexpr std::size_t red = 0;
constexpr std::size_t green = 1;
constexpr std::size_t blue = 2;
constexpr std::size_t alpha_channel = 3;
constexpr std::uint32_t all_opaque = 0xFFFFFFFFU;

const Material* material_of(const Scene& scene, const Primitive& primitive) {
    return primitive.material && *primitive.material < scene.materials.size() ? &scene.materials[*primitive.material]
                                                                              : nullptr;
}

bool may_transmit(const Material& material) {
    return material.transmission > 0.0F && (material.metallic < 1.0F || material.metallic_texture);
}

template<typename Value>
Value mixed(const Value& a, const Value& b, const Value& c, const glm::dvec3& weights) {
    return a + weights.y * (b - a) + weights.z * (c - a); // where all are the same, that to the bit
}

struct Range {
    float least = 1.0F;
    float greatest = 1.0F;
};

} // namespace

bool lets_light_through(const Material& material, bool vertex_alpha) {
    const bool varies = material.base_color_texture || vertex_alpha;
    switch (material.alpha_mode) {
    case AlphaMode::mask:
        if (material.alpha_cutoff > 0.0F && (varies || material.base_color.a < material.alpha_cutoff)) {
            return true;
        }
        break;
    case AlphaMode::blend:
        if (varies || material.base_color.a < 1.0F) {
            return true;
        }
        break;
    case AlphaMode::opaque:
        break;
    }
    return may_transmit(material);
}

bool lets_light_through(const Scene& scene, const Primitive& primitive) {
    const Material* const material = material_of(scene, primitive);
    return material != nullptr && lets_light_through(*material, !primitive.colors.empty());
}

std::vector<std::uint8_t> opacity_channels(const Scene& scene) {
    std::vector<std::uint8_t> channels(scene.images.size(), 0);
    const auto want = [&](const std::optional<TextureUse>& use, unsigned bits) {
        if (use && use->image < channels.size()) {
            channels[use->image] = static_cast<std::uint8_t>(channels[use->image] | bits);
        }
    };
    for (const Mesh& mesh : scene.meshes) {
        for (const Primitive& primitive : mesh.primitives) {
            if (!lets_light_through(scene, primitive)) {
                continue;
            }
            const Material& material = *material_of(scene, primitive);
            if (material.alpha_mode != AlphaMode::opaque) {
                want(material.base_color_texture, 1U << alpha_channel);
            }
            if (may_transmit(material)) {
                want(material.base_color_texture, 1U << red | 1U << green | 1U << blue);
                want(material.transmission_texture, 1U << red);
                want(material.metallic_texture, 1U << blue);
            }
        }
    }
    return channels;
}

/// Tells beforehand what look-ups on a triangle will say.
class SurfaceOpacity::Sorter {
public:
    enum class Kind : std::uint8_t { opaque, filtered, absent };

    explicit Sorter(const SurfaceOpacity& of) : m_of(of) {}

    [[nodiscard]] Kind kind(const Part& part, std::uint32_t triangle) {
        const Place place = m_of.corners(triangle);
        if (part.material->alpha_mode != AlphaMode::opaque) {
            const Range alpha = alpha_range(part, place);
            const bool mask = part.material->alpha_mode == AlphaMode::mask;
            const float full = mask ? part.material->alpha_cutoff : 1.0F;
            if (mask ? alpha.greatest < full : alpha.greatest <= 0.0F) {
                return Kind::absent;
            }
            if (alpha.least < full) {
                return Kind::filtered;
            }
        }
        return part.transmits && (!part.transmission || range(*part.transmission, red, place).greatest > 0.0F)
                   ? Kind::filtered
                   : Kind::opaque;
    }

private:
    [[nodiscard]] Range range(const Layer& layer, std::size_t channel, const Place& place) {
        const ByteTexture& texture = (*layer.image)[channel];
        constexpr double infinity = std::numeric_limits<double>::infinity();
        glm::dvec2 low(infinity);
        glm::dvec2 high(-infinity);
        for (const std::uint32_t vertex : place.vertices) {
            const glm::dvec2 at =
                layer.sampler.place(layer.uvs != nullptr ? glm::dvec2(layer.uvs->at(vertex)) : glm::dvec2(0.0));
            const bool known = std::isfinite(at.x) && std::isfinite(at.y);
            low = glm::min(low, known ? at : glm::dvec2(-infinity));
            high = glm::max(high, known ? at : glm::dvec2(infinity));
        }
        const TextureRanges& ranges = m_ranges.try_emplace(&texture, texture).first->second;
        const ByteRange bytes = ranges.within(layer.sampler, low, high);
        return {static_cast<float>(bytes.least) / 255.0F, static_cast<float>(bytes.greatest) / 255.0F};
    }

    [[nodiscard]] Range alpha_range(const Part& part, const Place& place) {
        const Range textured = part.color ? range(*part.color, alpha_channel, place) : Range{};
        const float factor = std::clamp(part.material->base_color.a, 0.0F, 1.0F);
        Range alpha{factor * textured.least, factor * textured.greatest};
        if (!part.primitive->colors.empty()) {
            const auto at = [&](std::size_t corner) {
                return std::max(part.primitive->colors.at(place.vertices.at(corner)).a, 0.0F);
            };
            const auto [least, greatest] = std::minmax({at(0), at(1), at(2)});
            // Interpolated, it may be rounded out of the corners' range unless these are the same.
            const float slack = least < greatest ? 0x1p-20F : 0.0F;
            alpha = {alpha.least * (least * (1.0F - slack)), alpha.greatest * (greatest * (1.0F + slack))};
        }
        return alpha;
    }

    const SurfaceOpacity& m_of;
    std::map<const ByteTexture*, TextureRanges> m_ranges;
};

SurfaceOpacity::SurfaceOpacity(const Scene& scene, const Surface& surface, std::vector<OpacityImage> images)
    : m_surface(&surface), m_images(std::move(images)) {
    for (const SurfacePart& part : surface.parts) {
        const std::uint32_t mesh = scene.instances.at(surface.objects.at(part.object).instance).mesh;
        const Primitive& primitive = scene.meshes.at(mesh).primitives.at(part.primitive);
        if (lets_light_through(scene, primitive)) {
            m_part_of.push_back(static_cast<std::uint32_t>(m_parts.size()));
            m_parts.push_back(make_part(primitive, *material_of(scene, primitive)));
        } else {
            m_part_of.push_back(all_opaque);
        }
    }
    Sorter sorter(*this);
    for (const std::uint32_t triangle : surface.canonical_order) {
        const std::uint32_t part = m_part_of[surface.parts_of[triangle]];
        const auto kind = part == all_opaque ? Sorter::Kind::opaque : sorter.kind(m_parts[part], triangle);
        if (kind != Sorter::Kind::absent) {
            (kind == Sorter::Kind::opaque ? m_opaque : m_filtered).push_back(triangle);
        }
    }
}

SurfaceOpacity::Part SurfaceOpacity::make_part(const Primitive& primitive, const Material& material) const {
    const auto layer = [&](const std::optional<TextureUse>& use, std::size_t channel) -> std::optional<Layer> {
        if (!use || use->image >= m_images.size() || m_images[use->image][channel].width == 0) {
            return std::nullopt;
        }
        const bool has_uvs =
            use->tex_coord < primitive.tex_coords.size() && !primitive.tex_coords[use->tex_coord].empty();
        return Layer{TextureSampler(*use), &m_images[use->image],
                     has_uvs ? &primitive.tex_coords[use->tex_coord] : nullptr};
    };
    const bool transmits = may_transmit(material);
    return {.primitive = &primitive,
            .material = &material,
            .transmits = transmits,
            .color = layer(material.base_color_texture, transmits ? red : alpha_channel),
            .transmission = transmits ? layer(material.transmission_texture, red) : std::nullopt,
            .metallic = transmits ? layer(material.metallic_texture, blue) : std::nullopt};
}

SurfaceOpacity::Place SurfaceOpacity::corners(std::uint32_t triangle) const {
    const std::size_t first = std::size_t{3} * triangle;
    return {{m_surface->vertices[first], m_surface->vertices[first + 1], m_surface->vertices[first + 2]},
            glm::dvec3(1.0, 0.0, 0.0)};
}

float SurfaceOpacity::value(const Layer& layer, std::size_t channel, const ByteValues& values,
                            const Place& place) const {
    glm::dvec2 uv(0.0);
    if (layer.uvs != nullptr) {
        const auto at = [&](std::size_t corner) { return glm::dvec2(layer.uvs->at(place.vertices.at(corner))); };
        uv = mixed(at(0), at(1), at(2), place.weights);
    }
    return layer.sampler.value((*layer.image)[channel], values, layer.sampler.place(uv));
}

float SurfaceOpacity::alpha(const Part& part, const Place& place) const {
    float alpha = std::clamp(part.material->base_color.a, 0.0F, 1.0F);
    if (part.color) {
        alpha *= value(*part.color, alpha_channel, m_linear, place);
    }
    if (!part.primitive->colors.empty()) {
        const auto at = [&](std::size_t corner) {
            return std::max(static_cast<double>(part.primitive->colors.at(place.vertices.at(corner)).a), 0.0);
        };
        alpha *= static_cast<float>(mixed(at(0), at(1), at(2), place.weights));
    }
    return alpha;
}

glm::vec3 SurfaceOpacity::transmitted(const Part& part, const Place& place) const {
    glm::vec3 color(part.material->base_color);
    if (part.color) {
        for (std::size_t channel = red; channel <= blue; ++channel) {
            color[static_cast<int>(channel)] *= value(*part.color, channel, m_srgb, place);
        }
    }
    if (!part.primitive->colors.empty()) {
        const auto at = [&](std::size_t corner) {
            return glm::dvec3(part.primitive->colors.at(place.vertices.at(corner)));
        };
        color *= glm::vec3(mixed(at(0), at(1), at(2), place.weights));
    }
    float share = part.material->transmission;
    if (part.transmission) {
        share *= value(*part.transmission, red, m_linear, place);
    }
    float metallic = part.material->metallic;
    if (part.metallic) {
        metallic *= value(*part.metallic, blue, m_linear, place);
    }
    return std::clamp(share, 0.0F, 1.0F) * (1.0F - std::clamp(metallic, 0.0F, 1.0F)) * glm::clamp(color, 0.0F, 1.0F);
}

Passage SurfaceOpacity::passage(const Ray& ray, const Hit& hit) const {
    const Part& part = m_parts[m_part_of[m_surface->parts_of[hit.triangle]]];
    Place place = corners(hit.triangle);
    place.weights = weights_at(*m_surface, ray, hit);
    Passage passage;
    if (part.material->alpha_mode == AlphaMode::mask) {
        passage.coverage = alpha(part, place) >= part.material->alpha_cutoff ? 1.0F : 0.0F;
    } else if (part.material->alpha_mode == AlphaMode::blend) {
        passage.coverage = std::min(alpha(part, place), 1.0F);
    }
    passage.transmittance = glm::vec3(1.0F - passage.coverage);
    if (part.transmits && passage.coverage > 0.0F) {
        passage.transmittance += passage.coverage * transmitted(part, place);
    }
    return passage;
}

} // namespace vkbake
