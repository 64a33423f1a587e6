#include "make_scenes/files.hpp"

#include <iterator>
#include <utility>

namespace vkbake::scenes {

std::vector<File> make_files() {
    std::vector<File> files = make_object_files();
    for (std::vector<File>& more :
         std::vector<std::vector<File>>{make_chapter_files(), make_light_files(), make_test_files()}) {
        files.insert(files.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }
    return files;
}

} // namespace vkbake::scenes
