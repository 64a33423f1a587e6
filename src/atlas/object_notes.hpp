// What is to be said of objects, reason by reason.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace vkbake {

/// A line for each reason, with the names of the first few objects that it holds for.
class ObjectNotes {
public:
    void add(const std::string& reason, const std::string& object) { m_objects[reason].push_back(object); }

    void write(std::vector<std::string>& notes) const;

private:
    std::map<std::string, std::vector<std::string>> m_objects;
};

} // namespace vkbake
