// Triangles put into a leaf.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bvh/hierarchy.hpp"

namespace vkbake {

class LeafBuilder {
public:
    LeafBuilder();

    /// False, and nothing is changed, where the triangle or its vertices find no room.
    bool add(const Triangle& triangle);
    [[nodiscard]] std::size_t count() const { return m_count; }
    [[nodiscard]] Leaf take(std::uint32_t first_place) const; ///< after at least one triangle

private:
    Leaf m_leaf{};
    std::size_t m_count = 0;
};

} // namespace vkbake
