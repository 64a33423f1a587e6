#include "load/fields.hpp"

#include <cmath>

namespace vkbake::gltf {

namespace {

/// Numbers that a step before wrote are signed in the library's eyes, whatever their value.
bool is_unsigned(const Json& value) {
    return value.is_number_unsigned() || (value.is_number_integer() && value.get<std::int64_t>() >= 0);
}

std::string name_of(const Json& object) {
    if (object.is_object()) {
        const auto name = object.find("name");
        if (name != object.end() && name->is_string()) {
            return name->get<std::string>();
        }
    }
    return {};
}

} // namespace

Fields::Fields(const Context& context, const Json& object, std::string where)
    : m_context(&context), m_object(&object), m_where(std::move(where)) {
    if (!object.is_object()) {
        fail("not a JSON object");
    }
}

void Fields::fail(const std::string& what) const { m_context->fail(what + " (" + m_where + ')'); }

void Fields::missing(const char* key) const { fail('"' + std::string(key) + "\" is missing"); }

const Json* Fields::find(const char* key) const {
    const auto found = m_object->find(key);
    return found == m_object->end() ? nullptr : &*found;
}

std::optional<std::uint64_t> Fields::unsigned_integer(const char* key) const {
    const Json* const value = find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    constexpr std::uint64_t largest = 1ULL << 53U;
    if (!is_unsigned(*value) || value->get<std::uint64_t>() > largest) {
        fail('"' + std::string(key) + "\" is not an integer of 0 or more");
    }
    return value->get<std::uint64_t>();
}

std::uint64_t Fields::required_unsigned_integer(const char* key) const {
    const auto value = unsigned_integer(key);
    if (!value) {
        missing(key);
    }
    return *value;
}

std::optional<std::uint32_t> Fields::index(const char* key, std::size_t count) const {
    const auto value = unsigned_integer(key);
    if (value && *value >= count) {
        fail('"' + std::string(key) + "\" names number " + std::to_string(*value) + " of " + std::to_string(count));
    }
    return value ? std::optional(static_cast<std::uint32_t>(*value)) : std::nullopt;
}

std::uint32_t Fields::required_index(const char* key, std::size_t count) const {
    const auto value = index(key, count);
    if (!value) {
        missing(key);
    }
    return *value;
}

std::vector<std::uint32_t> Fields::indices(const char* key, std::size_t count) const {
    const Json* const array = find(key);
    if (array == nullptr) {
        return {};
    }
    if (!array->is_array()) {
        fail('"' + std::string(key) + "\" is not an array");
    }
    std::vector<std::uint32_t> result;
    result.reserve(array->size());
    for (const Json& entry : *array) {
        if (!is_unsigned(entry) || entry.get<std::uint64_t>() >= count) {
            fail('"' + std::string(key) + "\" holds " + printable(entry.dump()) + ", which is none of the " +
                 std::to_string(count) + " there are");
        }
        result.push_back(entry.get<std::uint32_t>());
    }
    return result;
}

std::optional<double> Fields::number(const char* key) const {
    const Json* const value = find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    if (!value->is_number() || !std::isfinite(value->get<double>())) {
        fail('"' + std::string(key) + "\" is not a number");
    }
    return value->get<double>();
}

std::optional<std::vector<double>> Fields::numbers(const char* key, std::size_t size) const {
    const Json* const array = find(key);
    if (array == nullptr) {
        return std::nullopt;
    }
    const std::string wanted = '"' + std::string(key) + "\" is not an array of " + std::to_string(size) + " numbers";
    if (!array->is_array() || array->size() != size) {
        fail(wanted);
    }
    std::vector<double> result;
    result.reserve(size);
    for (const Json& entry : *array) {
        if (!entry.is_number() || !std::isfinite(entry.get<double>())) {
            fail(wanted);
        }
        result.push_back(entry.get<double>());
    }
    return result;
}

bool Fields::boolean(const char* key, bool absent) const {
    const Json* const value = find(key);
    if (value == nullptr) {
        return absent;
    }
    if (!value->is_boolean()) {
        fail('"' + std::string(key) + "\" is neither true nor false");
    }
    return value->get<bool>();
}

std::optional<std::string> Fields::string(const char* key) const {
    const Json* const value = find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    if (!value->is_string()) {
        fail('"' + std::string(key) + "\" is not a string");
    }
    return value->get<std::string>();
}

std::string Fields::required_string(const char* key) const {
    auto value = string(key);
    if (!value) {
        missing(key);
    }
    return *std::move(value);
}

std::optional<Fields> Fields::object(const char* key) const {
    const Json* const value = find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    if (!value->is_object()) {
        fail('"' + std::string(key) + "\" is not a JSON object");
    }
    return Fields(*m_context, *value, m_where);
}

Fields Fields::required_object(const char* key) const {
    auto value = object(key);
    if (!value) {
        missing(key);
    }
    return *std::move(value);
}

std::optional<Fields> Fields::extension(const char* name) const {
    const auto extensions = object("extensions");
    return extensions ? extensions->object(name) : std::nullopt;
}

const Json& root_array(const Context& context, const Json& document, const char* key) {
    static const Json empty = Json::array();
    const auto found = document.find(key);
    if (found == document.end()) {
        return empty;
    }
    if (!found->is_array()) {
        context.fail('"' + std::string(key) + "\" is not an array");
    }
    return *found;
}

Fields element(const Context& context, const Json& document, const char* key, const char* kind, std::size_t index) {
    const Json& array = root_array(context, document, key);
    const Json& object = array.at(index);
    return {context, object, describe(kind, index, name_of(object))};
}

void drop_extension(Json& object, const char* name) {
    const auto extensions = object.find("extensions");
    if (extensions == object.end()) {
        return;
    }
    extensions->erase(name);
    if (extensions->empty()) {
        object.erase("extensions");
    }
}

} // namespace vkbake::gltf
