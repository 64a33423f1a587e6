// Files that appear under their final name only when complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <span>

namespace vkbake {

/// Bytes that lie beside their final name, flushed to the disk, until `commit` renames them. What stood under that name
/// stays until then. The destructor removes what was not committed.
class StagedFile {
public:
    /// Makes the directories above `final_path` where they are missing. Throws Error{output}; then nothing is left
    /// behind but directories. `poll` is called between blocks of bytes; what it throws ends the writing likewise.
    StagedFile(std::filesystem::path final_path, std::span<const std::uint8_t> bytes,
               const std::function<void()>& poll = {});
    ~StagedFile();
    StagedFile(StagedFile&& other) noexcept;
    StagedFile& operator=(StagedFile&&) = delete;
    StagedFile(const StagedFile&) = delete;
    StagedFile& operator=(const StagedFile&) = delete;

    /// Once. Throws Error{output}.
    void commit();

    [[nodiscard]] const std::filesystem::path& final_path() const { return m_final; }

private:
    std::filesystem::path m_final;
    std::filesystem::path m_temporary; ///< empty once committed or moved from
};

/// Removes what killed runs left beside these files: StagedFiles of theirs that belong to no process that lives. For
/// who has put his own in place; what cannot be removed stays.
void remove_leftovers(const std::set<std::filesystem::path>& final_paths);

} // namespace vkbake
