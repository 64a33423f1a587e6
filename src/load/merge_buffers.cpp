#include <algorithm>
#include <map>
#include <string>

#include "load/fields.hpp"
#include "load/files.hpp"
#include "load/layout.hpp"
#include "load/normalise.hpp"

namespace vkbake::gltf {

namespace {

struct Range {
    std::uint64_t first = 0;
    std::uint64_t last = 0;  ///< one behind
    std::uint64_t moved = 0; ///< where it starts in the merged buffer
};

/// Unions of the views' ranges in one buffer. Views may overlap: copied one by one they could multiply the buffer's
/// size.
std::vector<Range> unite(std::vector<Range> ranges) {
    std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.first < b.first; });
    std::vector<Range> united;
    for (const Range& range : ranges) {
        if (!united.empty() && range.first <= united.back().last) {
            united.back().last = std::max(united.back().last, range.last);
        } else {
            united.push_back(range);
        }
    }
    return united;
}

} // namespace

std::vector<std::byte> merge_buffers(Context& context, Document& document) {
    const std::size_t view_count = root_array(context, document.json, "bufferViews").size();
    std::vector<BufferView> views;
    std::map<std::uint32_t, std::vector<Range>> ranges;
    for (std::size_t i = 0; i < view_count; ++i) {
        (void)view_bytes(context, document, i); // refuses a view of a buffer that has no data
        views.push_back(read_view(context, document.json, i));
        ranges[views.back().buffer].push_back(
            {.first = views.back().offset, .last = views.back().offset + views.back().length});
    }

    // Each range keeps its start modulo 16, and with it every alignment that an accessor may ask for.
    std::vector<std::byte> merged;
    for (auto& [index, used] : ranges) {
        used = unite(std::move(used));
        const std::vector<std::byte>& buffer = *document.buffers.at(index);
        for (Range& range : used) {
            range.moved = (merged.size() + 15) / 16 * 16 + range.first % 16;
            if (range.moved + (range.last - range.first) > largest_document) {
                context.fail("its data are larger than 4 GiB when decompressed", "split the scene");
            }
            merged.resize(range.moved);
            merged.insert(merged.end(), buffer.begin() + static_cast<std::ptrdiff_t>(range.first),
                          buffer.begin() + static_cast<std::ptrdiff_t>(range.last));
        }
        document.buffers.at(index)->clear();
        document.buffers.at(index)->shrink_to_fit();
    }

    for (std::size_t i = 0; i < view_count; ++i) {
        const std::vector<Range>& used = ranges.at(views[i].buffer);
        const auto range =
            std::prev(std::upper_bound(used.begin(), used.end(), views[i].offset,
                                       [](std::uint64_t offset, const Range& r) { return offset < r.first; }));
        Json& view = document.json["bufferViews"][i];
        view["buffer"] = 0;
        view["byteOffset"] = range->moved + (views[i].offset - range->first);
    }
    if (merged.empty()) {
        document.json.erase("buffers");
        return merged;
    }
    // What the first buffer says of itself beside its data (name, extras) is kept.
    Json buffer = document.json["buffers"][0];
    buffer.erase("uri");
    drop_extension(buffer, "EXT_meshopt_compression");
    buffer["byteLength"] = merged.size();
    document.json["buffers"] = Json::array({std::move(buffer)});
    return merged;
}

} // namespace vkbake::gltf
