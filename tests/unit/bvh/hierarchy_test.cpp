#include "bvh/hierarchy.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "bvh/split.hpp"
#include "highway_targets.hpp"
#include "unit/bvh/ray_scenes.hpp"

namespace vkbake {
namespace {

Box box_of(const WideNode& node, std::size_t lane) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = node.planes[static_cast<std::size_t>(axis)][lane];
        box.high[axis] = node.planes[static_cast<std::size_t>(axis) + 3][lane];
    }
    return box;
}

/// Walks the whole tree; counts each triangle, and checks that it lies in every box above it.
class Inspection {
public:
    Inspection(const Hierarchy& hierarchy, const ListedTriangles& triangles)
        : m_hierarchy(hierarchy), m_triangles(triangles), m_seen(triangles.size()) {
        if (!hierarchy.nodes.empty()) {
            Box all;
            all.low = glm::vec3(-std::numeric_limits<float>::infinity());
            all.high = -all.low;
            inspect_node(0, all, 1);
        }
    }

    [[nodiscard]] const std::vector<int>& seen() const { return m_seen; }
    [[nodiscard]] bool contained() const { return m_contained; }
    [[nodiscard]] std::size_t depth() const { return m_depth; }

private:
    void inspect_node(std::uint32_t index, const Box& above, std::size_t depth) {
        m_depth = std::max(m_depth, depth);
        const WideNode& node = m_hierarchy.nodes[index];
        for (std::size_t lane = 0; lane < node_width; ++lane) {
            const Box box = box_of(node, lane);
            if (box.empty()) {
                continue;
            }
            require(box, above);
            if ((node.children[lane] & leaf_bit) == 0) {
                inspect_node(node.children[lane], box, depth + 1);
            } else {
                inspect_leaf(node.children[lane], box);
            }
        }
    }

    void inspect_leaf(std::uint32_t child, const Box& above) {
        const Leaf& leaf = m_hierarchy.leaves[leaf_index(child)];
        for (std::size_t lane = 0; lane < triangles_of(child); ++lane) {
            const std::uint32_t place = leaf.first_place + static_cast<std::uint32_t>(lane);
            const std::uint32_t rank = m_hierarchy.ranks[place];
            ++m_seen[rank];
            const Triangle triangle = triangle_in(leaf, lane);
            m_contained =
                m_contained && triangle.corners == m_triangles[rank].corners && place_of(m_hierarchy, rank) == place;
            require(triangle.bounds(), above);
        }
    }

    void require(const Box& inner, Box outer) {
        const Box before = outer;
        outer.add(inner);
        m_contained = m_contained && outer.low == before.low && outer.high == before.high;
    }

    const Hierarchy& m_hierarchy;
    const ListedTriangles& m_triangles;
    std::vector<int> m_seen;
    bool m_contained = true;
    std::size_t m_depth = 0;
};

void expect_sound(const test::Triangles& given) {
    SCOPED_TRACE(given.name);
    const TriangleList list = list_triangles(given.positions, given.order, 0);
    const ListedTriangles triangles(given.positions, list);
    const Hierarchy hierarchy = build_hierarchy(triangles, 4, 0);
    const Inspection inspection(hierarchy, triangles);
    EXPECT_EQ(inspection.seen(), std::vector<int>(triangles.size(), 1));
    EXPECT_TRUE(inspection.contained());
    EXPECT_EQ(inspection.depth(), hierarchy.depth);
    EXPECT_LE(inspection.depth(), greatest_depth);
}

test::Triangles repeated(std::size_t count, const std::function<glm::vec3(std::size_t, int)>& corner) {
    std::vector<glm::vec3> positions;
    for (std::size_t i = 0; i < count; ++i) {
        for (int c = 0; c < 3; ++c) {
            positions.push_back(corner(i, c));
        }
    }
    return test::make_triangles("repeated", positions);
}

const std::array<glm::vec3, 3> shape{glm::vec3(-0.5F, 0.0F, 0.0F), glm::vec3(0.5F, 0.0F, 0.0F),
                                     glm::vec3(0.0F, 0.5F, 0.25F)};

TEST(Hierarchy, HoldsEveryTriangleOnceInsideItsBoxes) {
    expect_sound(test::soup(1, 0.5F, 1));
    expect_sound(test::soup(8, 0.5F, 1));
    expect_sound(test::soup(9, 0.5F, 1));
    expect_sound(test::soup(5000, 0.05F, 2));
    expect_sound(test::needles(500, 3));
    expect_sound(test::sheet(20, 1, 0.5F));
    expect_sound(test::sphere(4, 1.0F, glm::vec3(0.0F)));
}

TEST(Hierarchy, DegenerateInputNeitherRecursesAwayNorLosesTriangles) {
    const auto corner = [](int c) { return shape[static_cast<std::size_t>(c)]; };
    // identical; one box centre but many sizes; centres that fall off exponentially, so that each cut peels a few off
    expect_sound(repeated(10000, [&](std::size_t, int c) { return corner(c); }));
    expect_sound(repeated(10000, [&](std::size_t i, int c) {
        const float size = static_cast<float>(i + 1) / 10000.0F;
        return size * glm::vec3(corner(c).x, corner(c).y - 0.25F, corner(c).z - 0.125F);
    }));
    expect_sound(repeated(6000, [&](std::size_t i, int c) {
        const float size = std::ldexp(1.0F, -static_cast<int>(i % 120));
        return size * (corner(c) + glm::vec3(1.0F));
    }));
}

TEST(Hierarchy, AGroundSharesNoLeafWithWhatStandsOnIt) {
    // Eight small triangles over nine corners and the two of a ground beneath: they would find room in one leaf, which
    // every ray from the ground would then ask.
    std::vector<glm::vec3> positions;
    const auto add_quad = [&](float left, float front, float size, float height) {
        const auto corner = [&](float x, float z) { return glm::vec3(left + x * size, height, front + z * size); };
        positions.insert(positions.end(), {corner(0, 0), corner(1, 0), corner(1, 1)});
        positions.insert(positions.end(), {corner(0, 0), corner(1, 1), corner(0, 1)});
    };
    for (const float x : {0.0F, 0.01F}) {
        for (const float z : {0.0F, 0.01F}) {
            add_quad(x, z, 0.01F, 0.1F);
        }
    }
    add_quad(-1.0F, -1.0F, 2.0F, 0.0F);
    const test::Triangles given = test::make_triangles("table", positions);
    const TriangleList list = list_triangles(given.positions, given.order, 0);
    const Hierarchy hierarchy = build_hierarchy(ListedTriangles(given.positions, list), 1, 0);
    for (const Leaf& leaf : hierarchy.leaves) {
        const auto& heights = leaf.vertices[1];
        EXPECT_EQ(std::ranges::count(heights, heights[0]), static_cast<std::ptrdiff_t>(heights.size()));
    }
    EXPECT_EQ(hierarchy.leaves.size(), 2U);
}

TEST(Hierarchy, DoesNotDependOnThreads) {
    const test::Triangles soup = test::soup(20000, 0.05F, 4);
    const TriangleList list = list_triangles(soup.positions, soup.order, 0);
    const ListedTriangles triangles(soup.positions, list);
    const Hierarchy one = build_hierarchy(triangles, 2, 1);
    for (const int threads : {2, 0}) {
        const Hierarchy other = build_hierarchy(triangles, 2, threads);
        ASSERT_EQ(one.nodes.size(), other.nodes.size());
        ASSERT_EQ(one.leaves.size(), other.leaves.size());
        for (std::size_t i = 0; i < one.nodes.size(); ++i) {
            ASSERT_EQ(one.nodes[i].planes, other.nodes[i].planes);
            ASSERT_EQ(one.nodes[i].children, other.nodes[i].children);
        }
        for (std::size_t i = 0; i < one.leaves.size(); ++i) {
            ASSERT_EQ(one.leaves[i].vertices, other.leaves[i].vertices);
            ASSERT_EQ(one.leaves[i].corners, other.leaves[i].corners);
            ASSERT_EQ(one.leaves[i].first_place, other.leaves[i].first_place);
        }
        ASSERT_EQ(one.ranks, other.ranks);
    }
}

std::vector<BuildItem> items_at(const std::vector<float>& places) {
    std::vector<BuildItem> items;
    items.reserve(places.size());
    for (const float x : places) {
        items.push_back(
            {glm::vec3(x, 0.0F, 0.0F), glm::vec3(x + 0.5F, 1.0F, 1.0F), static_cast<std::uint32_t>(items.size()), 1});
    }
    return items;
}

TEST(Split, CutsBetweenTwoGroups) {
    // three boxes near 0, two near 100: any other cut has a box that spans the gap
    std::vector<BuildItem> items = items_at({100.0F, 0.0F, 101.0F, 1.0F, 2.0F});
    const Halves halves = split(items, 40);
    EXPECT_EQ(halves.first_count, 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT(items[i].low.x, 50.0F);
    }
    EXPECT_EQ(halves.first.low, glm::vec3(0.0F));
    EXPECT_EQ(halves.first.high, glm::vec3(2.5F, 1.0F, 1.0F));
    EXPECT_EQ(halves.second.low, glm::vec3(100.0F, 0.0F, 0.0F));
    EXPECT_EQ(halves.second.high, glm::vec3(101.5F, 1.0F, 1.0F));
}

TEST(Split, TakesTheMedianWhereDepthRunsOutOrCentresAreEqual) {
    std::vector<BuildItem> items = items_at({100.0F, 0.0F, 101.0F, 1.0F, 2.0F});
    EXPECT_EQ(split(items, 3).first_count, 2U);
    std::vector<BuildItem> equal = items_at(std::vector<float>(9, 1.0F));
    EXPECT_EQ(split(equal, 40).first_count, 4U);
}

TEST(Hierarchy, AnswersDoNotDependOnTheInstructionSet) {
    const test::Triangles triangles =
        test::join("", {test::soup(1000, 0.1F, 5), test::sphere(3, 0.7F, glm::vec3(0.0F))});
    const TriangleAccelerator accelerator = test::accelerate(triangles, Accelerator::bvh);
    const auto answers = [&] {
        std::vector<std::pair<std::uint32_t, float>> found;
        test::Random random(6);
        for (int i = 0; i < 5000; ++i) {
            const glm::vec3 origin = random.point();
            const glm::vec3 target = triangles.positions[random.below(triangles.positions.size())];
            const Ray ray{origin, i % 2 == 0 ? random.direction() : target - origin};
            const Hit hit = accelerator.nearest(ray).value_or(Hit{});
            found.emplace_back(hit.triangle, hit.distance);
            found.emplace_back(accelerator.occluded(ray), 0.0F);
        }
        return found;
    };
    const auto expected = answers();
    test::for_every_target([&] { EXPECT_EQ(answers(), expected); });
}

} // namespace
} // namespace vkbake
