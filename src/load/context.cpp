#include "load/context.hpp"

#include <algorithm>

#include "load/uri.hpp"
#include "vkbake/error.hpp"

namespace vkbake::gltf {

void Context::fail(const std::string& what, const std::string& to_do) const {
    throw Error(ErrorKind::bad_input, m_file + ": " + what + "; " + to_do);
}

void Context::fail(const std::string& what) const { fail(what, "export the scene again, or repair the file"); }

void Context::require_inside(const std::string& path, const std::string& where) const {
    if (!m_outside_files && leaves_folder(path)) {
        fail(quoted(path) + " (" + where + ") lies outside the scene's folder",
             "put it beside the scene, or allow it (--outside-files)");
    }
}

void Context::note(const std::string& line) {
    constexpr std::size_t most_notes = 100;
    if (std::find(m_notes.begin(), m_notes.end(), line) != m_notes.end()) {
        return;
    }
    if (m_notes.size() < most_notes) {
        m_notes.push_back(line);
    } else {
        ++m_dropped_notes;
    }
}

std::vector<std::string> Context::take_notes() {
    if (m_dropped_notes > 0) {
        m_notes.push_back("and " + std::to_string(m_dropped_notes) + " more notes like these");
        m_dropped_notes = 0;
    }
    return std::move(m_notes);
}

std::string printable(const std::string& text) {
    constexpr std::size_t longest = 60;
    std::string line = text.substr(0, longest);
    // A cut in the middle of a UTF-8 character would leave bytes that are no text.
    while (line.size() < text.size() && !line.empty() &&
           (static_cast<unsigned char>(text[line.size()]) & 0xC0U) == 0x80U) {
        line.pop_back();
    }
    for (char& c : line) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20U || byte == 0x7FU) {
            c = '?';
        }
    }
    return line.size() < text.size() ? line + "..." : line;
}

std::string quoted(const std::string& text) {
    std::string result(1, '"'); // not "\"" + …, where GCC 12 sees an overlapping copy that is none (its bug 105651)
    return result.append(printable(text)).append(1, '"');
}

std::string describe(const std::string& kind, std::size_t index, const std::string& name) {
    const std::string numbered = kind + ' ' + std::to_string(index);
    return name.empty() ? numbered : numbered + ' ' + quoted(name);
}

} // namespace vkbake::gltf
