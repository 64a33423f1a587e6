#include "imageio/staged_file.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "vkbake/error.hpp"

namespace vkbake {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what, int number) {
    throw Error(ErrorKind::output, path.string() + ": " + what + ": " + std::generic_category().message(number) +
                                       "; check the path, the permissions and the space on the disk");
}

class Descriptor {
public:
    explicit Descriptor(int number) : m_number(number) {}
    ~Descriptor() {
        if (m_number >= 0) {
            ::close(m_number);
        }
    }
    Descriptor(Descriptor&&) = delete;
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(Descriptor&&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int number() const { return m_number; }
    // Some file systems tell of a full disk only here.
    [[nodiscard]] bool close() { return ::close(std::exchange(m_number, -1)) == 0; }

private:
    int m_number;
};

constexpr mode_t permissions = 0666; // less the process's umask
constexpr std::string_view partial_ending = ".partial";

/// A name that no other process and no earlier, killed run uses.
std::filesystem::path create_beside(const std::filesystem::path& path) {
    for (int attempt = 0;; ++attempt) {
        std::filesystem::path temporary = path;
        std::string ending = std::to_string(::getpid());
        ending.append(".").append(std::to_string(attempt)).append(partial_ending);
        temporary += '.';
        temporary += ending;
        const Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions));
        if (file.number() >= 0) {
            return temporary;
        }
        if (errno != EEXIST || attempt == 1000) {
            fail(path, "cannot be created", errno);
        }
    }
}

void fill(const std::filesystem::path& temporary, const std::filesystem::path& path,
          std::span<const std::uint8_t> bytes, const std::function<void()>& poll) {
    constexpr std::size_t block = std::size_t{16} << 20U; // a fraction of a second on a slow disk
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.number() < 0) {
        fail(path, "cannot be written", errno);
    }
    while (!bytes.empty()) {
        if (poll) {
            poll();
        }
        const ssize_t written = ::write(file.number(), bytes.data(), std::min(bytes.size(), block));
        if (written < 0 && errno != EINTR) {
            fail(path, "cannot be written", errno);
        }
        bytes = bytes.subspan(static_cast<std::size_t>(written > 0 ? written : 0));
        // Without this a crash soon after the rename may leave an empty file under the final name. Block by block, as
        // nothing can end the wait for a disk.
        if (::fsync(file.number()) != 0 && errno != EINVAL) {
            fail(path, "cannot be written", errno);
        }
    }
    if (!file.close()) {
        fail(path, "cannot be written", errno);
    }
}

/// Takes ".NUMBER" off the end of a name.
std::optional<int> take_number(std::string_view& name) {
    const std::size_t dot = name.find_last_of('.');
    int number = 0;
    if (dot == std::string_view::npos) {
        return std::nullopt;
    }
    const char* const end = name.data() + name.size();
    const auto [rest, error] = std::from_chars(name.data() + dot + 1, end, number);
    if (error != std::errc() || rest != end || number < 0) {
        return std::nullopt;
    }
    name.remove_suffix(name.size() - dot);
    return number;
}

/// Another user's too, which we may not signal. We have no such file left: one with our number is an earlier process's.
bool lives(int process) { return process != ::getpid() && (::kill(process, 0) == 0 || errno != ESRCH); }

/// What create_beside() named for a process that is gone: the final path.
std::optional<std::filesystem::path> final_path_of_leftover(const std::filesystem::path& file) {
    const std::string whole = file.filename().string();
    std::string_view name = whole;
    if (!name.ends_with(partial_ending)) {
        return std::nullopt;
    }
    name.remove_suffix(partial_ending.size());
    const std::optional<int> attempt = take_number(name);
    const std::optional<int> process = attempt ? take_number(name) : std::nullopt;
    if (!process || *process == 0 || lives(*process)) {
        return std::nullopt;
    }
    return file.parent_path() / name;
}

} // namespace

StagedFile::StagedFile(std::filesystem::path final_path, std::span<const std::uint8_t> bytes,
                       const std::function<void()>& poll)
    : m_final(std::move(final_path)) {
    std::error_code error;
    if (m_final.has_parent_path()) {
        std::filesystem::create_directories(m_final.parent_path(), error);
        if (error) {
            fail(m_final, "its folder cannot be made", error.value());
        }
    }
    m_temporary = create_beside(m_final);
    try {
        fill(m_temporary, m_final, bytes, poll);
    } catch (...) {
        std::filesystem::remove(m_temporary, error);
        throw;
    }
}

StagedFile::~StagedFile() {
    if (!m_temporary.empty()) {
        std::error_code ignored;
        std::filesystem::remove(m_temporary, ignored);
    }
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : m_final(std::move(other.m_final)), m_temporary(std::exchange(other.m_temporary, {})) {}

void StagedFile::commit() {
    std::error_code error;
    std::filesystem::rename(m_temporary, m_final, error);
    if (error) {
        fail(m_final, "cannot be put in place", error.value());
    }
    m_temporary.clear();
}

void remove_leftovers(const std::set<std::filesystem::path>& final_paths) {
    std::set<std::filesystem::path> folders;
    for (const std::filesystem::path& path : final_paths) {
        folders.insert(path.parent_path());
    }
    std::error_code error;
    for (const std::filesystem::path& folder : folders) {
        std::vector<std::filesystem::path> leftovers;
        // An iterator that has failed is at the end.
        std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, error);
        for (; entry != std::filesystem::directory_iterator(); entry.increment(error)) {
            const auto path = final_path_of_leftover(folder / entry->path().filename());
            if (path && final_paths.contains(*path) && entry->is_regular_file(error)) {
                leftovers.push_back(entry->path());
            }
        }
        for (const std::filesystem::path& leftover : leftovers) {
            std::filesystem::remove(leftover, error);
        }
    }
}

} // namespace vkbake
