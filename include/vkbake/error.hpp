// The one exception type that crosses the library's boundary.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace vkbake {

/// What went wrong, as a caller distinguishes it. The values are the command line's exit statuses.
enum class ErrorKind {
    bake_failed = 1,   ///< the work itself failed: out of memory, device lost, a result that cannot be right
    usage = 2,         ///< a setting is out of range or contradicts another
    bad_input = 3,     ///< a scene, sky or image cannot be read or is not valid
    no_device = 4,     ///< no Vulkan device will do; the message says why each was refused
    output = 5,        ///< a result could not be written
    interrupted = 130, ///< the progress callback asked to stop
};

/// Thrown by every function of this library that can fail; nothing else is.
/// `what()` is one line in the form "WHERE: WHAT; TO DO", without a final full stop or newline, whatever names the
/// message was made of: control characters are shown as '?', and the middle of what is longer than 1000 bytes as "...".
class Error : public std::runtime_error {
public:
    Error(ErrorKind kind, const std::string& message) : std::runtime_error(one_line(message)), m_kind(kind) {}
    [[nodiscard]] ErrorKind kind() const noexcept { return m_kind; }

private:
    [[nodiscard]] static std::string one_line(const std::string& message) {
        constexpr std::size_t kept = 500; // bytes of either end
        std::string line = message;
        if (message.size() > 2 * kept) {
            // Characters of UTF-8 are left whole: what goes on one begins with the bits 10.
            const auto goes_on = [&](std::size_t at) {
                return (static_cast<unsigned char>(message[at]) & 0xC0U) == 0x80U;
            };
            std::size_t head = kept;
            std::size_t tail = message.size() - kept;
            while (head > 0 && goes_on(head)) {
                --head;
            }
            while (tail < message.size() && goes_on(tail)) {
                ++tail;
            }
            line = message.substr(0, head) + "..." + message.substr(tail);
        }
        for (char& letter : line) {
            const auto byte = static_cast<unsigned char>(letter);
            letter = byte < 0x20U || byte == 0x7FU ? '?' : letter;
        }
        return line;
    }

    ErrorKind m_kind;
};

} // namespace vkbake
