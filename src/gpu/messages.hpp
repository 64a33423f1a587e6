// What the validation layers say.
#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace vkbake::gpu {

/// Collects messages from any thread. What nobody took is printed to stderr at the end, so that nothing that is said
/// while objects are destroyed is lost.
class Messages {
public:
    Messages() = default;
    ~Messages();
    Messages(const Messages&) = delete;
    Messages& operator=(const Messages&) = delete;

    void add(std::string message);
    [[nodiscard]] std::vector<std::string> take();

private:
    std::mutex m_mutex;
    std::vector<std::string> m_messages;
};

} // namespace vkbake::gpu
