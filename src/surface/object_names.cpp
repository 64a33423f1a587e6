#include "surface/object_names.hpp"

#include <cctype>
#include <unordered_set>

namespace vkbake {
namespace {

constexpr std::size_t longest_name = 80;

std::string file_name(const std::string& name) {
    std::string result;
    for (const char character : name.substr(0, longest_name)) {
        const auto byte = static_cast<unsigned char>(character);
        const bool kept = byte < 128 && (std::isalnum(byte) != 0 || byte == '-' || byte == '_' || byte == '.');
        result += kept ? character : '_';
    }
    if (result.empty() || result.front() == '.') {
        result.insert(0, "object");
    }
    return result;
}

std::string lower_case(std::string text) {
    for (char& character : text) {
        character = static_cast<char>(std::tolower(static_cast<unsigned char>(character)));
    }
    return text;
}

} // namespace

std::vector<std::string> unique_file_names(const std::vector<std::string>& names) {
    std::vector<std::string> result;
    std::unordered_set<std::string> taken;
    for (const std::string& name : names) {
        const std::string base = file_name(name);
        std::string candidate = base;
        for (int number = 2; !taken.insert(lower_case(candidate)).second; ++number) {
            candidate = base + "-" + std::to_string(number);
        }
        result.push_back(candidate);
    }
    return result;
}

} // namespace vkbake
