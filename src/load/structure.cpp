#include "load/structure.hpp"

#include <array>
#include <string>

#include "load/fields.hpp"

namespace vkbake::gltf {

namespace {

class Checker {
public:
    Checker(Context& context, const Json& document) : m_context(context), m_document(document) {}

    void check() {
        each("samplers", "sampler", [&](const Fields& f) { check_sampler(f); });
        each("textures", "texture", [&](const Fields& f) { check_texture(f); });
        each("materials", "material", [&](const Fields& f) { check_material(f); });
        each("meshes", "mesh", [&](const Fields& f) { check_mesh(f); });
        each("cameras", "camera", [&](const Fields& f) { check_camera(f); });
        each("nodes", "node", [&](const Fields& f) { check_node(f); });
        each("scenes", "scene", [&](const Fields& f) { (void)f.indices("nodes", count("nodes")); });
        (void)Fields(m_context, m_document, "the document").index("scene", count("scenes"));
    }

private:
    [[nodiscard]] std::size_t count(const char* key) const { return root_array(m_context, m_document, key).size(); }

    template<typename Check>
    void each(const char* key, const char* kind, const Check& check) {
        for (std::size_t i = 0; i < count(key); ++i) {
            const Fields fields = element(m_context, m_document, key, kind, i);
            (void)fields.string("name");
            check(fields);
        }
    }

    static void check_sampler(const Fields& sampler) {
        for (const char* const key : {"wrapS", "wrapT"}) {
            const auto wrap = sampler.unsigned_integer(key).value_or(10497);
            if (wrap != 10497 && wrap != 33071 && wrap != 33648) {
                sampler.fail('"' + std::string(key) + "\" is none that glTF has");
            }
        }
    }

    void check_texture(const Fields& texture) const {
        (void)texture.index("source", count("images"));
        (void)texture.index("sampler", count("samplers"));
    }

    void check_texture_use(const Fields& parent, const char* key) const {
        const auto use = parent.object(key);
        if (use) {
            check_texture_fields(*use);
        }
    }

    void check_texture_fields(const Fields& use) const {
        (void)use.required_index("index", count("textures"));
        (void)use.index("texCoord", 1U << 16U);
        if (const auto transform = use.extension("KHR_texture_transform")) {
            (void)transform->numbers("offset", 2);
            (void)transform->number("rotation");
            (void)transform->numbers("scale", 2);
            (void)transform->index("texCoord", 1U << 16U);
        }
    }

    void check_material(const Fields& material) const {
        if (const auto pbr = material.object("pbrMetallicRoughness")) {
            (void)pbr->numbers("baseColorFactor", 4);
            check_texture_use(*pbr, "baseColorTexture");
        }
        (void)material.numbers("emissiveFactor", 3);
        check_texture_use(material, "emissiveTexture");
        check_texture_use(material, "occlusionTexture");
        const std::string mode = material.string("alphaMode").value_or("OPAQUE");
        if (mode != "OPAQUE" && mode != "MASK" && mode != "BLEND") {
            material.fail("\"alphaMode\" is \"" + printable(mode) + "\", which glTF does not have");
        }
        (void)material.number("alphaCutoff");
        (void)material.boolean("doubleSided", false);
        if (const auto strength = material.extension("KHR_materials_emissive_strength")) {
            (void)strength->number("emissiveStrength");
        }
        if (const auto diffuse = material.extension("KHR_materials_pbrSpecularGlossiness")) {
            (void)diffuse->numbers("diffuseFactor", 4);
            check_texture_use(*diffuse, "diffuseTexture");
        }
        if (const auto transmission = material.extension("KHR_materials_transmission")) {
            (void)transmission->number("transmissionFactor");
            check_texture_use(*transmission, "transmissionTexture");
        }
        if (const auto light_map = material.extension("MOZ_lightmap")) {
            check_texture_fields(*light_map);
            (void)light_map->number("intensity");
        }
    }

    void check_primitive(const Fields& primitive) const {
        const Fields attributes = primitive.required_object("attributes");
        if (attributes.json().empty()) {
            primitive.fail("\"attributes\" is empty");
        }
        for (const auto& [semantic, unused] : attributes.json().items()) {
            (void)attributes.index(semantic.c_str(), count("accessors"));
        }
        (void)primitive.index("indices", count("accessors"));
        (void)primitive.index("material", count("materials"));
        if (primitive.unsigned_integer("mode").value_or(4) > 6) {
            primitive.fail("\"mode\" is none that glTF has");
        }
    }

    void check_mesh(const Fields& mesh) const {
        const auto primitives = mesh.json().find("primitives");
        if (primitives == mesh.json().end() || !primitives->is_array()) {
            mesh.fail("\"primitives\" is missing, or not an array");
        }
        if (primitives->empty()) {
            m_context.note(mesh.where() + " has no primitives");
        }
        for (std::size_t i = 0; i < primitives->size(); ++i) {
            check_primitive({m_context, (*primitives)[i], mesh.where() + ", primitive " + std::to_string(i)});
        }
    }

    static void check_positive(const Fields& lens, const char* key) {
        const auto value = lens.number(key);
        if (!value || *value <= 0.0) {
            lens.fail('"' + std::string(key) + "\" is missing, or not positive");
        }
    }

    static void check_camera(const Fields& camera) {
        const std::string type = camera.required_string("type");
        if (type == "perspective") {
            const Fields lens = camera.required_object("perspective");
            check_positive(lens, "yfov");
            check_positive(lens, "znear");
        } else if (type == "orthographic") {
            const Fields lens = camera.required_object("orthographic");
            for (const char* const key : {"xmag", "ymag"}) {
                if (lens.number(key).value_or(0.0) == 0.0) {
                    lens.fail('"' + std::string(key) + "\" is missing, or 0");
                }
            }
            (void)lens.number("znear");
        } else {
            camera.fail("\"type\" is \"" + printable(type) + "\", which glTF does not have");
        }
    }

    void check_node(const Fields& node) const {
        (void)node.index("mesh", count("meshes"));
        (void)node.index("camera", count("cameras"));
        (void)node.index("skin", count("skins"));
        (void)node.indices("children", count("nodes"));
        const bool has_parts = node.has("translation") || node.has("rotation") || node.has("scale");
        (void)node.numbers("translation", 3);
        (void)node.numbers("scale", 3);
        if (const auto rotation = node.numbers("rotation", 4)) {
            if (*rotation == std::vector<double>(4, 0.0)) {
                node.fail("\"rotation\" is a quaternion of length 0");
            }
        }
        const auto matrix = node.numbers("matrix", 16);
        if (matrix && has_parts) {
            node.fail("it has a \"matrix\" and a translation, rotation or scale");
        }
        if (matrix && ((*matrix)[3] != 0.0 || (*matrix)[7] != 0.0 || (*matrix)[11] != 0.0 || (*matrix)[15] != 1.0)) {
            node.fail("the last row of its \"matrix\" is not 0 0 0 1");
        }
    }

    Context& m_context;
    const Json& m_document;
};

} // namespace

void check_structure(Context& context, const Json& document) { Checker(context, document).check(); }

} // namespace vkbake::gltf
