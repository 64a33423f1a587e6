// JSON objects of a glTF document, read strictly: a value of the wrong type is refused, never taken for absent.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "load/context.hpp"

namespace vkbake::gltf {

/// One object of the document. All functions throw Error{bad_input} that names it; nullopt means the key is absent.
class Fields {
public:
    /// `where` names the object in messages, e.g. `accessor 3 "positions"`. Both references must outlive this.
    Fields(const Context& context, const Json& object, std::string where);

    /// Up to 2⁵³, beyond which JSON numbers lose their units.
    [[nodiscard]] std::optional<std::uint64_t> unsigned_integer(const char* key) const;
    [[nodiscard]] std::uint64_t required_unsigned_integer(const char* key) const;
    /// An index below `count`.
    [[nodiscard]] std::optional<std::uint32_t> index(const char* key, std::size_t count) const;
    [[nodiscard]] std::uint32_t required_index(const char* key, std::size_t count) const;
    /// An array of indices below `count`; absent: empty.
    [[nodiscard]] std::vector<std::uint32_t> indices(const char* key, std::size_t count) const;
    [[nodiscard]] std::optional<double> number(const char* key) const;
    /// Exactly `size` numbers.
    [[nodiscard]] std::optional<std::vector<double>> numbers(const char* key, std::size_t size) const;
    [[nodiscard]] bool boolean(const char* key, bool absent) const;
    [[nodiscard]] std::optional<std::string> string(const char* key) const;
    [[nodiscard]] std::string required_string(const char* key) const;
    /// An object inside this one.
    [[nodiscard]] std::optional<Fields> object(const char* key) const;
    [[nodiscard]] Fields required_object(const char* key) const;
    /// extensions[name]
    [[nodiscard]] std::optional<Fields> extension(const char* name) const;

    [[nodiscard]] bool has(const char* key) const { return m_object->contains(key); }
    [[nodiscard]] const Json& json() const { return *m_object; }
    [[nodiscard]] const std::string& where() const { return m_where; }
    /// Throws "FILE: what (WHERE); …".
    [[noreturn]] void fail(const std::string& what) const;

private:
    [[nodiscard]] const Json* find(const char* key) const;
    [[noreturn]] void missing(const char* key) const;

    const Context* m_context;
    const Json* m_object;
    std::string m_where;
};

/// The array `key` of the document; an empty one where it is absent. Throws where it is no array.
[[nodiscard]] const Json& root_array(const Context& context, const Json& document, const char* key);

/// Element `index` of it, named by `kind`, e.g. "accessor".
[[nodiscard]] Fields element(const Context& context, const Json& document, const char* key, const char* kind,
                             std::size_t index);

/// Removes extensions[name] of `object`, and `extensions` when nothing is left in it.
void drop_extension(Json& object, const char* name);

} // namespace vkbake::gltf
