// The one exception type that crosses the library's boundary.
#pragma once

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
/// `what()` is one line in the form "WHERE: WHAT; TO DO", without a final full stop or newline.
class Error : public std::runtime_error {
public:
    Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), m_kind(kind) {}
    [[nodiscard]] ErrorKind kind() const noexcept { return m_kind; }

private:
    ErrorKind m_kind;
};

} // namespace vkbake
