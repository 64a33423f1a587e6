// Who reports what: the file being loaded, its notes, and the one way to refuse it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace vkbake::gltf {

/// Carried through the loading of one file.
class Context {
public:
    /// `outside_files`: LoadSettings::outside_files.
    explicit Context(std::string file, bool outside_files = false)
        : m_file(std::move(file)), m_outside_files(outside_files) {}

    /// Throws Error{bad_input} "FILE: what; to_do".
    [[noreturn]] void fail(const std::string& what, const std::string& to_do) const;
    /// The same where the remedy is always the exporter's: the file breaks a rule of the glTF specification.
    [[noreturn]] void fail(const std::string& what) const;

    /// A line for Scene::notes. Equal lines are kept once; after the first hundred only their number is kept.
    void note(const std::string& line);
    [[nodiscard]] std::vector<std::string> take_notes();

    [[nodiscard]] const std::string& file() const { return m_file; }

    /// Throws where a relative path, which `where` names, leads out of the scene's folder and that was not asked for.
    void require_inside(const std::string& path, const std::string& where) const;

private:
    std::string m_file;
    bool m_outside_files;
    std::vector<std::string> m_notes;
    std::size_t m_dropped_notes = 0;
};

/// Text of a file, fit for one line of a message: control characters replaced, cut after 60 bytes.
[[nodiscard]] std::string printable(const std::string& text);

/// printable(text) between quotation marks.
[[nodiscard]] std::string quoted(const std::string& text);

/// `accessor 3 "positions"`, or `accessor 3` where the name is empty.
[[nodiscard]] std::string describe(const std::string& kind, std::size_t index, const std::string& name);

} // namespace vkbake::gltf
