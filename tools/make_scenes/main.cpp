// make_scenes FOLDER: writes every made scene into the folder (the checkout's scenes/).
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "make_scenes/files.hpp"

int main(int argument_count, char** arguments) {
    if (argument_count != 2) {
        std::cerr << "usage: make_scenes FOLDER\n";
        return 2;
    }
    try {
        const std::filesystem::path folder = arguments[1];
        for (const vkbake::scenes::File& file : vkbake::scenes::make_files()) {
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
