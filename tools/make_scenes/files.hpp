// All the files that the program makes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace vkbake::scenes {

struct File {
    std::string path; ///< relative to the folder scenes/, with '/'
    std::vector<std::byte> bytes;
};

/// Every file of scenes/ that is made: the same bytes on every machine.
[[nodiscard]] std::vector<File> make_files();

// The kinds of them, in the order of make_files.
[[nodiscard]] std::vector<File> make_object_files();
[[nodiscard]] std::vector<File> make_chapter_files();
[[nodiscard]] std::vector<File> make_light_files();
[[nodiscard]] File make_pergola_file();
[[nodiscard]] std::vector<File> make_test_files();

/// Meshes of a million triangles: one curved everywhere, one of 100,000 islands.
[[nodiscard]] std::vector<File> make_unwrap_files();

/// Scenes that are large or many, for benchmarks alone: not checked in, and not all closed or free of crossings.
[[nodiscard]] std::vector<File> make_benchmark_files();

} // namespace vkbake::scenes
