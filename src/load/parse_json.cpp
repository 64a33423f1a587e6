#include "load/parse_json.hpp"

#include <array>
#include <cstddef>
#include <string>

namespace vkbake::gltf {

namespace {

constexpr std::size_t deepest = 64;
constexpr std::size_t most_keys = 4096;

/// Before the parser sees the text: it counts brackets and colons outside strings, which is enough to bound what any
/// well-formed text costs; text that is not well-formed is the parser's to refuse.
void check_extent(const Context& context, std::string_view text) {
    std::array<std::size_t, deepest + 1> keys{}; // of the open object at each depth
    std::size_t depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') {
                ++i;
            } else if (c == '"') {
                in_string = false;
            }
        } else if (c == '"') {
            in_string = true;
        } else if (c == '{' || c == '[') {
            if (++depth > deepest) {
                context.fail("the JSON is nested more than " + std::to_string(deepest) + " deep");
            }
            keys.at(depth) = 0;
        } else if ((c == '}' || c == ']') && depth > 0) {
            --depth;
        } else if (c == ':' && ++keys.at(depth) > most_keys) {
            context.fail("a JSON object has more than " + std::to_string(most_keys) + " keys");
        }
    }
}

} // namespace

Json parse_json(const Context& context, std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) {
        context.fail("the JSON starts with a byte order mark", "save it as UTF-8 without one");
    }
    check_extent(context, text);
    Json document;
    try {
        document = Json::parse(text);
    } catch (const Json::exception& error) {
        // "[json.exception.parse_error.101] parse error at line 1, column 2: …" and then the offending bytes
        std::string message = error.what();
        const std::size_t start = message.find("] ");
        message = message.substr(start == std::string::npos ? 0 : start + 2);
        context.fail("the JSON cannot be read: " + printable(message.substr(0, message.find(':'))));
    }
    if (!document.is_object()) {
        context.fail("the JSON is not an object");
    }
    return document;
}

} // namespace vkbake::gltf
