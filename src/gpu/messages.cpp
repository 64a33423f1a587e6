#include "gpu/messages.hpp"

#include <cstdio>
#include <utility>

namespace vkbake::gpu {

Messages::~Messages() {
    for (const std::string& message : m_messages) {
        static_cast<void>(std::fprintf(stderr, "vkbake: validation: %s\n", message.c_str()));
    }
}

void Messages::add(std::string message) {
    const std::lock_guard lock(m_mutex);
    m_messages.push_back(std::move(message));
}

std::vector<std::string> Messages::take() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_messages, {});
}

} // namespace vkbake::gpu
