// Parts of a hierarchy that are built by themselves, and how one is made of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "bvh/hierarchy.hpp"

namespace vkbake {

/// A list that grows without moving what it holds, and without room for more than a chunk to spare. What push_back()
/// adds is not initialised.
template<typename Value, std::size_t chunk_size>
class Chunks {
public:
    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] Value& operator[](std::size_t index) { return m_chunks[index / chunk_size][index % chunk_size]; }
    Value& push_back() {
        if (m_size % chunk_size == 0) {
            m_chunks.push_back(std::make_unique_for_overwrite<Value[]>(chunk_size)); // NOLINT(modernize-avoid-c-arrays)
        }
        return (*this)[m_size++];
    }
    void clear() {
        m_chunks.clear();
        m_size = 0;
    }

private:
    std::vector<std::unique_ptr<Value[]>> m_chunks; // NOLINT(modernize-avoid-c-arrays): not initialised
    std::size_t m_size = 0;
};

/// A subtree whose nodes and leaves are counted from 0, its root first. 0 as a child is none yet, or none at all.
struct HierarchyPart {
    /// The root of `part` is a child of this part's node.
    struct Below {
        std::uint32_t node;
        std::uint32_t lane;
        std::unique_ptr<HierarchyPart> part;
    };

    Chunks<WideNode, 16> nodes;
    std::vector<std::uint32_t> leaves; ///< the first place of each: leaves are written once their number is known
    std::vector<Below> below;
    std::size_t depth = 0; ///< of the deepest node of this part and those below, the whole tree's root being at 1
};

/// Puts the nodes of a part and of those below into the hierarchy, part after part, and writes the leaves, whose
/// triangles stand in hierarchy.ranks and have these corners (see LeafBuilder). The parts' nodes are freed as they are
/// copied. Throws Error{bad_input} for more than 2²⁷ leaves.
void join(HierarchyPart& root, const ListedTriangles& triangles, std::span<const std::uint16_t> corners,
          Hierarchy& hierarchy, int threads);

} // namespace vkbake
