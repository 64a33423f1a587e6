#include "lamp_notes.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>

namespace vkbake {

std::vector<std::string> note_lamps(const Scene& scene, const Bake& bake) {
    std::vector<std::uint64_t> reached;
    for (const LightMap& map : bake.light_maps) {
        const std::vector<std::uint64_t>& some = map.statistics.lamps_reached;
        reached.resize(std::max(reached.size(), some.size()), 0);
        std::transform(some.begin(), some.end(), reached.begin(), reached.begin(), std::plus<>());
    }
    std::vector<std::string> notes;
    for (std::size_t lamp = 0; lamp < std::min(reached.size(), scene.lamps.size()); ++lamp) {
        if (reached[lamp] == 0) {
            notes.push_back("lamp \"" + scene.lamps[lamp].name +
                            "\" lights nothing: it stands inside something, out of range or turned away, or is black");
        }
    }
    if (!reached.empty() && scene.source) {
        notes.emplace_back("the lamps are in the light maps: the written scene keeps them as extras.vkbake.bakedLight "
                           "alone, so that they do not light it twice");
    }
    return notes;
}

} // namespace vkbake
