// A scene in the device's memory, as the preview's shaders take it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "gpu/resources.hpp"
#include "preview.h"
#include "preview/geometry.hpp"
#include "preview/images.hpp"
#include "vkbake/scene.hpp"

namespace vkbake {

/// Refers to the scene and the images that it was made from.
class PreviewResources {
public:
    PreviewResources(gpu::Context& context, const Scene& scene, const PreviewImages& images, PreviewGeometry geometry);

    [[nodiscard]] const PreviewGeometry& geometry() const { return m_geometry; }
    /// mean_light of all light maps.
    [[nodiscard]] const glm::dvec3& mean() const { return m_mean; }
    /// Whether a draw has a normal map that its directional light map lights.
    [[nodiscard]] bool has_relief(const PreviewDraw& draw) const {
        return m_images.relief_of(draw.material) != PreviewImages::none;
    }

    /// In the order of the shaders' bindings: what all surfaces have, then what those with relief have too.
    [[nodiscard]] std::vector<gpu::Resource> bindings(const PreviewDraw& draw, bool relief) const;

    /// All but what is the same for every draw. `show`: one of PREVIEW_SHOW_….
    [[nodiscard]] PreviewConstants constants(const PreviewDraw& draw, std::uint32_t show) const;

private:
    [[nodiscard]] const Material* material_of(const PreviewDraw& draw) const;
    [[nodiscard]] std::uint32_t light_map_of(const PreviewDraw& draw) const;
    [[nodiscard]] gpu::Resource texture(const std::vector<std::optional<gpu::Image>>& textures,
                                        const std::optional<TextureUse>& use) const;

    const Scene& m_scene;
    const PreviewImages& m_images;
    PreviewGeometry m_geometry;
    gpu::Image m_white;
    gpu::Image m_black;
    std::vector<gpu::Buffer> m_vertices; ///< one a chunk
    std::vector<gpu::Buffer> m_indices;
    std::vector<std::optional<gpu::Buffer>> m_reliefs;
    std::vector<std::optional<gpu::Image>> m_textures; ///< one an image of the scene
    std::vector<std::optional<gpu::Image>> m_normal_maps;
    std::vector<gpu::Image> m_light_maps;
    std::vector<std::vector<gpu::Image>> m_directional_maps; ///< four each
    glm::dvec3 m_mean{0.0};
};

} // namespace vkbake
