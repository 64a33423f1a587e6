#include "load/materials.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "vkbake/names.hpp"

namespace vkbake::gltf {

namespace {

Wrap to_wrap(int wrap) {
    if (wrap == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) {
        return Wrap::clamp;
    }
    return wrap == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirror : Wrap::repeat;
}

float number_or(const tinygltf::Value& object, const char* key, double absent) {
    return static_cast<float>(object.Has(key) ? object.Get(key).GetNumberAsDouble() : absent);
}

glm::vec2 pair_or(const tinygltf::Value& object, const char* key, glm::vec2 absent) {
    if (!object.Has(key)) {
        return absent;
    }
    const tinygltf::Value& pair = object.Get(key);
    return {static_cast<float>(pair.Get(0).GetNumberAsDouble()), static_cast<float>(pair.Get(1).GetNumberAsDouble())};
}

void apply_transform(TextureUse& use, const tinygltf::Value& transform) {
    use.offset = pair_or(transform, "offset", glm::vec2(0.0F));
    use.rotation = number_or(transform, "rotation", 0.0);
    use.scale = pair_or(transform, "scale", glm::vec2(1.0F));
    if (transform.Has("texCoord")) {
        use.tex_coord = static_cast<std::uint32_t>(transform.Get("texCoord").GetNumberAsInt());
    }
}

class MaterialMaker {
public:
    MaterialMaker(Context& context, const Model& model) : m_context(context), m_data(model.data) {}

    Material make(std::size_t index) {
        const tinygltf::Material& source = m_data.materials.at(index);
        m_where = describe("material", index, source.name);
        Material material;
        material.name = source.name;
        const auto& base = source.pbrMetallicRoughness.baseColorFactor;
        material.base_color = glm::vec4(glm::dvec4(base.at(0), base.at(1), base.at(2), base.at(3)));
        material.base_color_texture = texture_use(source.pbrMetallicRoughness.baseColorTexture);
        material.metallic = static_cast<float>(source.pbrMetallicRoughness.metallicFactor);
        material.metallic_texture = texture_use(source.pbrMetallicRoughness.metallicRoughnessTexture);
        if (const auto* const extension = find(source, "KHR_materials_pbrSpecularGlossiness")) {
            set_diffuse(*extension, material); // where both are given the extension holds
        }
        if (source.alphaMode == "MASK") {
            material.alpha_mode = AlphaMode::mask;
        } else if (source.alphaMode == "BLEND") {
            material.alpha_mode = AlphaMode::blend;
        }
        material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
        material.double_sided = source.doubleSided;
        if (const auto* const extension = find(source, "KHR_materials_transmission")) {
            material.transmission = number_or(*extension, "transmissionFactor", 0.0);
            if (extension->Has("transmissionTexture")) {
                material.transmission_texture = texture_use(extension->Get("transmissionTexture"));
            }
        }
        double strength = 1.0;
        if (const auto* const extension = find(source, "KHR_materials_emissive_strength")) {
            strength =
                extension->Has("emissiveStrength") ? extension->Get("emissiveStrength").GetNumberAsDouble() : 1.0;
        }
        const auto& emissive = source.emissiveFactor;
        material.emissive = glm::vec3(glm::dvec3(emissive.at(0), emissive.at(1), emissive.at(2)) * strength);
        material.emissive_texture = texture_use(source.emissiveTexture);
        material.occlusion_texture = texture_use(source.occlusionTexture);
        if (const auto normals = texture_use(source.normalTexture)) {
            material.normal_map = {*normals, static_cast<float>(source.normalTexture.scale)};
        }
        material.light_map = light_map(source);
        const tinygltf::Value mode = own(source, "mode");
        if (mode.IsString() && mode.Get<std::string>() == name_of(Mode::bent_normal)) {
            material.bent_normal_file = file_name(own(source, "lightMap"));
        }
        return material;
    }

private:
    static const tinygltf::Value* find(const tinygltf::Material& material, const char* extension) {
        const auto found = material.extensions.find(extension);
        return found == material.extensions.end() ? nullptr : &found->second;
    }

    std::optional<TextureUse> texture_use(int texture_index, int tex_coord) {
        if (texture_index < 0) {
            return std::nullopt;
        }
        const tinygltf::Texture& texture = m_data.textures.at(static_cast<std::size_t>(texture_index));
        if (texture.source < 0) {
            m_context.note(m_where + ": texture " + std::to_string(texture_index) +
                           " has no image in a format that is supported: ignored");
            return std::nullopt;
        }
        TextureUse use;
        use.image = static_cast<std::uint32_t>(texture.source);
        use.tex_coord = static_cast<std::uint32_t>(tex_coord);
        if (texture.sampler >= 0) {
            const tinygltf::Sampler& sampler = m_data.samplers.at(static_cast<std::size_t>(texture.sampler));
            use.wrap_u = to_wrap(sampler.wrapS);
            use.wrap_v = to_wrap(sampler.wrapT);
            use.filter = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ? Filter::nearest : Filter::linear;
        }
        return use;
    }

    template<typename TextureInfo>
    std::optional<TextureUse> texture_use(const TextureInfo& info) {
        auto use = texture_use(info.index, info.texCoord);
        const auto transform = info.extensions.find("KHR_texture_transform");
        if (use && transform != info.extensions.end()) {
            apply_transform(*use, transform->second);
        }
        return use;
    }

    std::optional<TextureUse> texture_use(const tinygltf::Value& info) {
        const int tex_coord = info.Has("texCoord") ? info.Get("texCoord").GetNumberAsInt() : 0;
        auto use = texture_use(info.Get("index").GetNumberAsInt(), tex_coord);
        if (use && info.Has("extensions") && info.Get("extensions").Has("KHR_texture_transform")) {
            apply_transform(*use, info.Get("extensions").Get("KHR_texture_transform"));
        }
        return use;
    }

    void set_diffuse(const tinygltf::Value& extension, Material& material) {
        material.metallic = 0.0F;
        material.metallic_texture.reset();
        material.base_color = glm::vec4(1.0F);
        if (extension.Has("diffuseFactor")) {
            const tinygltf::Value& factor = extension.Get("diffuseFactor");
            for (int channel = 0; channel < 4; ++channel) {
                material.base_color[channel] = static_cast<float>(factor.Get(channel).GetNumberAsDouble());
            }
        }
        material.base_color_texture =
            extension.Has("diffuseTexture") ? texture_use(extension.Get("diffuseTexture")) : std::nullopt;
    }

    std::optional<LightMapUse> light_map(const tinygltf::Material& source) {
        const tinygltf::Value* const extension = find(source, "MOZ_lightmap");
        if (extension == nullptr) {
            return std::nullopt;
        }
        const auto texture = texture_use(*extension);
        if (!texture) {
            return std::nullopt;
        }
        LightMapUse use{.texture = *texture,
                        .intensity = number_or(*extension, "intensity", 1.0),
                        .linear_file = file_name(own(source, "lightMap")),
                        .directional_files = {}};
        const tinygltf::Value directional = own(source, "directional");
        if (directional.IsArray() && directional.ArrayLen() == use.directional_files.size()) {
            for (std::size_t i = 0; i < use.directional_files.size(); ++i) {
                use.directional_files[i] = file_name(directional.Get(static_cast<int>(i)));
            }
        }
        return use;
    }

    /// extras.vkbake.KEY; null where it is absent.
    static tinygltf::Value own(const tinygltf::Material& source, const char* key) {
        const bool there = source.extras.Has("vkbake") && source.extras.Get("vkbake").Has(key);
        return there ? source.extras.Get("vkbake").Get(key) : tinygltf::Value();
    }

    /// The name of a file below the scene's folder; empty where `value` is no string.
    std::string file_name(const tinygltf::Value& value) {
        std::string name = value.IsString() ? value.Get<std::string>() : std::string();
        m_context.require_inside(name, m_where);
        return name;
    }

    Context& m_context;
    const tinygltf::Model& m_data;
    std::string m_where;
};

} // namespace

std::vector<Material> make_materials(Context& context, const Model& model) {
    MaterialMaker maker(context, model);
    std::vector<Material> materials;
    for (std::size_t i = 0; i < model.data.materials.size(); ++i) {
        materials.push_back(maker.make(i));
    }
    return materials;
}

std::vector<EncodedImage> make_images(const Model& model) {
    std::vector<EncodedImage> images;
    for (const tinygltf::Image& source : model.data.images) {
        const auto& view = model.data.bufferViews.at(static_cast<std::size_t>(source.bufferView));
        const auto bytes = model.binary.subspan(view.byteOffset, view.byteLength);
        images.push_back({.name = source.name, .mime_type = source.mimeType, .bytes = {bytes.begin(), bytes.end()}});
    }
    return images;
}

} // namespace vkbake::gltf
