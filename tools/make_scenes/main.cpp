// make_scenes FOLDER: writes every made scene into the folder (the checkout's scenes/).
// make_scenes --benchmarks FOLDER: writes the scenes of the benchmarks instead.
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string_view>

#include "make_scenes/files.hpp"

int main(int argument_count, char** arguments) {
    const bool benchmarks = argument_count == 3 && std::string_view(arguments[1]) == "--benchmarks";
    if (argument_count != 2 && !benchmarks) {
        std::cerr << "usage: make_scenes [--benchmarks] FOLDER\n";
        return 2;
    }
    try {
        const std::filesystem::path folder = arguments[argument_count - 1];
        const std::vector<vkbake::scenes::File> files =
            benchmarks ? vkbake::scenes::make_benchmark_files() : vkbake::scenes::make_files();
        for (const vkbake::scenes::File& file : files) {
            const std::filesystem::path path = folder / file.path;
            std::filesystem::create_directories(path.parent_path());
            std::ofstream stream(path, std::ios::binary);
            stream.write(reinterpret_cast<const char*>(file.bytes.data()),
                         static_cast<std::streamsize>(file.bytes.size()));
            stream.close();
            if (!stream) {
                std::cerr << path.string() << ": cannot be written; check that the folder is writable\n";
                return 5;
            }
        }
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return EXIT_SUCCESS;
}
