#include "atlas/object_notes.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace vkbake {

void ObjectNotes::write(std::vector<std::string>& notes) const {
    constexpr std::size_t named = 8;
    for (const auto& [reason, objects] : m_objects) {
        std::string line = reason + ": ";
        for (std::size_t i = 0; i < std::min(objects.size(), named); ++i) {
            line += (i > 0 ? ", " : "") + objects[i];
        }
        if (objects.size() > named) {
            line += " and " + std::to_string(objects.size() - named) + " more";
        }
        notes.push_back(std::move(line));
    }
}

} // namespace vkbake
