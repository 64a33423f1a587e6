#include <algorithm>
#include <map>
#include <string>

#include "load/fields.hpp"
#include "load/files.hpp"
#include "load/layout.hpp"
#include "load/normalise.hpp"
#include "load/uri.hpp"

namespace vkbake::gltf {

namespace {

/// By the first bytes; empty where they are none that is known here.
std::string media_type_of(std::span<const std::byte> bytes) {
    const auto starts_with = [&](std::string_view signature, std::size_t offset = 0) {
        return bytes.size() >= offset + signature.size() &&
               std::equal(signature.begin(), signature.end(), bytes.begin() + static_cast<std::ptrdiff_t>(offset),
                          [](char c, std::byte b) { return static_cast<std::byte>(c) == b; });
    };
    if (starts_with("\x89PNG\r\n\x1A\n")) {
        return "image/png";
    }
    if (starts_with("\xFF\xD8\xFF")) {
        return "image/jpeg";
    }
    if (starts_with("RIFF") && starts_with("WEBP", 8)) {
        return "image/webp";
    }
    if (starts_with("\xABKTX 20\xBB\r\n\x1A\n")) {
        return "image/ktx2";
    }
    if (starts_with("DDS ")) {
        return "image/vnd-ms.dds";
    }
    return {};
}

std::string media_type_of_extension(const std::string& path) {
    const auto ends_with = [&](std::string_view extension) {
        return path.size() >= extension.size() &&
               std::equal(extension.rbegin(), extension.rend(), path.rbegin(), [](char wanted, char c) {
                   return wanted == (c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
               });
    };
    return ends_with(".jpg") || ends_with(".jpeg") ? "image/jpeg" : "image/png";
}

/// Embeds one document's images; files that several images name are read once.
class Embedder {
public:
    Embedder(Context& context, Document& document) : m_context(context), m_document(document) {}

    void embed(std::size_t index) {
        const Source source = find(index);
        const auto bytes = view_bytes(m_context, m_document, source.view);
        std::string media_type = media_type_of(bytes);
        if (media_type.empty()) {
            m_context.note(source.where + " is of no format that is known here");
            media_type = source.declared;
        } else if (!source.declared.empty() && media_type != source.declared) {
            m_context.note(source.where + " says it is " + printable(source.declared) + ", but is " + media_type);
        }
        Json& image = m_document.json["images"][index];
        image.erase("uri");
        image["bufferView"] = source.view;
        image["mimeType"] = media_type;
    }

private:
    struct Source {
        std::uint32_t view = 0;
        std::string declared; ///< media type, as the file claims it
        std::string where;
    };

    Source find(std::size_t index) {
        const Fields image = element(m_context, m_document.json, "images", "image", index);
        const auto uri = image.string("uri");
        const auto view = image.index("bufferView", root_array(m_context, m_document.json, "bufferViews").size());
        if (uri.has_value() == view.has_value()) {
            image.fail("exactly one of \"bufferView\" and \"uri\" must be there");
        }
        Source source{.declared = image.string("mimeType").value_or(""), .where = image.where()};
        if (view) {
            const BufferView bytes = read_view(m_context, m_document.json, *view);
            if (!m_document.buffers.at(bytes.buffer)) {
                image.fail("its bufferView " + std::to_string(*view) + " has no data");
            }
            source.view = plain_view(*view, bytes, source.where);
        } else if (is_data_uri(*uri)) {
            reserve_bytes(m_context, m_document, uri->size() / 4 * 3);
            auto data = decode_data_uri(*uri);
            if (!data || data->bytes.empty()) {
                image.fail("the data URI is malformed or empty");
            }
            if (source.declared.empty()) {
                source.declared = data->media_type;
            }
            source.view = append_view(m_document, std::move(data->bytes));
        } else {
            source.view = file_view(image, *uri, source);
        }
        return source;
    }

    /// A view of the same bytes without a stride, which an image must not have.
    std::uint32_t plain_view(std::uint32_t index, const BufferView& view, const std::string& where) {
        if (view.stride == 0) {
            return index;
        }
        m_context.note(where + " lies in a bufferView with a byteStride, against the glTF specification");
        Json plain = Json::object();
        plain["buffer"] = view.buffer;
        plain["byteOffset"] = view.offset;
        plain["byteLength"] = view.length;
        Json& views = m_document.json["bufferViews"];
        views.push_back(std::move(plain));
        return static_cast<std::uint32_t>(views.size() - 1);
    }

    std::uint32_t file_view(const Fields& image, const std::string& uri, Source& source) {
        const auto path = relative_path(uri);
        if (!path) {
            image.fail("the URI \"" + printable(uri) + "\" is not a path relative to the scene's folder");
        }
        m_context.require_inside(*path, image.where());
        if (source.declared.empty()) {
            source.declared = media_type_of_extension(*path);
        }
        const auto known = m_views_of_files.find(*path);
        if (known != m_views_of_files.end()) {
            return known->second;
        }
        const std::string what = quoted(*path) + " (" + image.where() + ")";
        const std::filesystem::path file = m_document.directory / *path;
        reserve_bytes(m_context, m_document, file_size(m_context, file, what));
        std::vector<std::byte> bytes = read_file(m_context, file, what);
        if (bytes.empty()) {
            m_context.fail(what + " is empty", "replace the image");
        }
        const std::uint32_t view = append_view(m_document, std::move(bytes));
        m_views_of_files.emplace(*path, view);
        return view;
    }

    Context& m_context;
    Document& m_document;
    std::map<std::string, std::uint32_t> m_views_of_files;
};

} // namespace

void embed_images(Context& context, Document& document) {
    Embedder embedder(context, document);
    const std::size_t count = root_array(context, document.json, "images").size();
    for (std::size_t i = 0; i < count; ++i) {
        embedder.embed(i);
    }
}

} // namespace vkbake::gltf
