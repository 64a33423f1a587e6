#include "atlas/outline_proof.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "atlas/predicates.hpp"
#include "base/disjoint_sets.hpp"
#include "base/random.hpp"

namespace vkbake {

namespace {

constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();

/// Finds numbers by a 64-bit key.
class KeyTable {
public:
    explicit KeyTable(std::size_t keys) : m_slots(std::bit_ceil(2 * keys + 2), {0, unknown}) {}

    /// The key's number; `number` where it had none.
    std::uint32_t enter(std::uint64_t key, std::uint32_t number) {
        Slot& slot = slot_of(key);
        if (slot.number == unknown) {
            slot = {key, number};
        }
        return slot.number;
    }

    /// `unknown` where the key has none.
    [[nodiscard]] std::uint32_t find(std::uint64_t key) { return slot_of(key).number; }

private:
    struct Slot {
        std::uint64_t key;
        std::uint32_t number;
    };

    Slot& slot_of(std::uint64_t key) {
        const std::size_t mask = m_slots.size() - 1;
        std::size_t at = mix64(key) & mask;
        while (m_slots[at].number != unknown && m_slots[at].key != key) {
            at = (at + 1) & mask;
        }
        return m_slots[at];
    }

    std::vector<Slot> m_slots;
};

class OutlineProof {
public:
    explicit OutlineProof(std::size_t triangles) : m_point_numbers(3 * triangles), m_side_numbers(3 * triangles) {
        m_points.reserve(triangles + 2);
        m_sides.reserve(3 * triangles);
    }

    bool run(std::span<const glm::vec2> corners, std::span<const std::uint32_t> triangles) {
        for (const std::uint32_t triangle : triangles) {
            if (!add({corners[3 * std::size_t{triangle}], corners[3 * std::size_t{triangle} + 1],
                      corners[3 * std::size_t{triangle} + 2]})) {
                return false;
            }
        }
        return find_outline() && goes_around_once() && outline_is_simple();
    }

private:
    struct Point {
        glm::vec2 at;
        int rounds = 0;              ///< how often the triangles here cross the direction of the x axis
        std::uint32_t in = unknown;  ///< the point before along the outline
        std::uint32_t out = unknown; ///< the point after
    };
    struct Side {
        std::uint32_t from;
        std::uint32_t to;
    };

    static std::uint64_t key_of(const Side& side) { return std::uint64_t{side.from} << 32U | side.to; }

    std::uint32_t number(const glm::vec2& corner) {
        const glm::vec2 at = corner + glm::vec2(0.0F); // −0 and 0 are one
        const std::uint64_t key =
            std::uint64_t{std::bit_cast<std::uint32_t>(at.x)} << 32U | std::bit_cast<std::uint32_t>(at.y);
        const std::uint32_t known = m_point_numbers.enter(key, static_cast<std::uint32_t>(m_points.size()));
        if (known == m_points.size()) {
            m_points.push_back({at});
        }
        return known;
    }

    /// Whether the direction from a point to another has an angle in [0, π).
    static bool is_upper(const glm::vec2& from, const glm::vec2& to) {
        return to.y > from.y || (to.y == from.y && to.x > from.x);
    }

    /// False where triangles turn differently, or the same side is there twice.
    bool add(FlatTriangle triangle) {
        const int turn = orientation(triangle);
        if (turn == 0) {
            return true;
        }
        if (m_turn != 0 && turn != m_turn) {
            return false;
        }
        m_turn = turn;
        if (turn < 0) {
            std::swap(triangle[1], triangle[2]);
        }
        const std::array<std::uint32_t, 3> own{number(triangle[0]), number(triangle[1]), number(triangle[2])};
        for (unsigned c = 0; c < 3; ++c) {
            const Side side{own[c], own[(c + 1) % 3]};
            const auto name = static_cast<std::uint32_t>(m_sides.size());
            if (m_side_numbers.enter(key_of(side), name) != name) {
                return false;
            }
            m_sides.push_back(side);
            // From the side that leaves the corner to the one that comes back, less than half a turn.
            m_points[own[c]].rounds +=
                !is_upper(triangle[c], triangle[(c + 1) % 3]) && is_upper(triangle[c], triangle[(c + 2) % 3]) ? 1 : 0;
        }
        return true;
    }

    /// False where triangles do not hang together, or the outline touches itself in a corner.
    bool find_outline() {
        DisjointSets sets(m_sides.size() / 3);
        std::size_t pieces = m_sides.size() / 3;
        for (std::uint32_t name = 0; name < m_sides.size(); ++name) {
            const Side& side = m_sides[name];
            const std::uint32_t beyond = m_side_numbers.find(key_of({side.to, side.from}));
            if (beyond == unknown) {
                if (m_points[side.from].out != unknown || m_points[side.to].in != unknown) {
                    return false;
                }
                m_points[side.from].out = side.to;
                m_points[side.to].in = side.from;
                m_outline.push_back(side);
            } else if (sets.find(name / 3) != sets.find(beyond / 3)) {
                sets.join(name / 3, beyond / 3);
                --pieces;
            }
        }
        return pieces <= 1;
    }

    /// Whether the triangles at each point go around it no more than once.
    [[nodiscard]] bool goes_around_once() const {
        return std::ranges::all_of(m_points, [&](const Point& point) {
            if (point.out == unknown) {
                return point.rounds == 1;
            }
            if (point.rounds == 0) {
                return true;
            }
            // From the side that leaves to the one that comes in, past the x axis, and not as far as it began.
            const glm::vec2& first = m_points[point.out].at;
            const glm::vec2& last = m_points[point.in].at;
            const bool first_upper = is_upper(point.at, first);
            const bool last_upper = is_upper(point.at, last);
            return point.rounds == 1 &&
                   (first_upper == last_upper ? orientation(point.at, last, first) > 0 : last_upper);
        });
    }

    /// Sides in the order of where they begin along the longer axis; those that overlap along it are compared.
    [[nodiscard]] bool outline_is_simple() {
        glm::vec2 lower(std::numeric_limits<float>::infinity());
        glm::vec2 upper = -lower;
        for (const Side& side : m_outline) {
            for (int axis = 0; axis < 2; ++axis) {
                lower[axis] = std::min(lower[axis], m_points[side.from].at[axis]);
                upper[axis] = std::max(upper[axis], m_points[side.from].at[axis]);
            }
        }
        const int axis = upper.x - lower.x >= upper.y - lower.y ? 0 : 1;
        struct Box {
            float begin, end;   ///< along the axis
            float lower, upper; ///< across
            Side side;
        };
        std::vector<Box> boxes;
        boxes.reserve(m_outline.size());
        for (const Side& side : m_outline) {
            const auto [begin, end] = std::minmax(m_points[side.from].at[axis], m_points[side.to].at[axis]);
            const auto [low, high] = std::minmax(m_points[side.from].at[1 - axis], m_points[side.to].at[1 - axis]);
            boxes.push_back({begin, end, low, high, side});
        }
        std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.begin < b.begin; });
        std::size_t steps = 1000 * (boxes.size() + 100); // more are no quick proof
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            for (std::size_t j = i + 1; j < boxes.size() && boxes[j].begin <= boxes[i].end; ++j) {
                if (--steps == 0 || (boxes[j].lower <= boxes[i].upper && boxes[i].lower <= boxes[j].upper &&
                                     !are_apart(boxes[i].side, boxes[j].side))) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Whether sides of the outline meet in nothing but the corner that follows one and begins the other.
    [[nodiscard]] bool are_apart(const Side& first, const Side& second) const {
        if (first.to == second.from || second.to == first.from) {
            const Side& before = first.to == second.from ? first : second;
            const Side& after = first.to == second.from ? second : first;
            return turn(before.from, before.to, after.to) != 0 || !lie_on_one_side(before.to, before.from, after.to);
        }
        const int from = turn(first.from, first.to, second.from);
        const int to = turn(first.from, first.to, second.to);
        return from * to > 0 || turn(second.from, second.to, first.from) * turn(second.from, second.to, first.to) > 0;
    }

    [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return orientation(m_points[a].at, m_points[b].at, m_points[c].at);
    }

    /// Of points on one line: whether a and b lie on the same side of the first.
    [[nodiscard]] bool lie_on_one_side(std::uint32_t first, std::uint32_t a, std::uint32_t b) const {
        return is_upper(m_points[first].at, m_points[a].at) == is_upper(m_points[first].at, m_points[b].at);
    }

    int m_turn = 0;
    KeyTable m_point_numbers;
    KeyTable m_side_numbers;
    std::vector<Point> m_points;
    std::vector<Side> m_sides;   ///< 3 a triangle, counter-clockwise
    std::vector<Side> m_outline; ///< of them, those that nothing hangs on by
};

} // namespace

bool outline_proves_no_overlap(std::span<const glm::vec2> corners, std::span<const std::uint32_t> triangles) {
    return OutlineProof(triangles.size()).run(corners, triangles);
}

} // namespace vkbake
