// Nothing runs through anything else, and nothing lies in the same plane on top of it: such scenes bake dark lines that
// are the model's fault and not the baker's.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "glb.hpp"

namespace vkbake::test {
namespace {

struct Boxed {
    std::array<glm::dvec3, 3> p;
    glm::dvec3 low;
    glm::dvec3 high;
    glm::dvec3 normal;
};

std::vector<Boxed> boxed_faces(const std::string& file) {
    std::vector<Boxed> result;
    // One literal: GCC 12 gives a false -Warray-bounds on a string that two are added to.
    const std::string path = VKBAKE_SOURCE_DIR "/scenes/" + file;
    for (const Face& face : faces_of_scene(parse_glb(read_bytes(path)))) {
        Boxed b{{face[0].position, face[1].position, face[2].position}, {}, {}, {}};
        b.low = glm::min(b.p[0], glm::min(b.p[1], b.p[2]));
        b.high = glm::max(b.p[0], glm::max(b.p[1], b.p[2]));
        b.normal = glm::normalize(glm::cross(b.p[1] - b.p[0], b.p[2] - b.p[0]));
        result.push_back(b);
    }
    std::sort(result.begin(), result.end(), [](const Boxed& a, const Boxed& b) { return a.low.x < b.low.x; });
    return result;
}

bool share_a_corner(const Boxed& a, const Boxed& b) {
    return std::any_of(a.p.begin(), a.p.end(), [&](const glm::dvec3& p) {
        return std::any_of(b.p.begin(), b.p.end(), [&](const glm::dvec3& q) { return glm::distance(p, q) < 1e-7; });
    });
}

// Whether the edge from → to passes through the inside of the triangle.
bool pierces(const glm::dvec3& from, const glm::dvec3& to, const Boxed& t) {
    const double start = glm::dot(t.normal, from - t.p[0]);
    const double end = glm::dot(t.normal, to - t.p[0]);
    if (!((start > 1e-9 && end < -1e-9) || (start < -1e-9 && end > 1e-9))) {
        return false;
    }
    const glm::dvec3 hit = from + (to - from) * (start / (start - end));
    for (std::size_t k = 0; k < 3; ++k) {
        if (glm::dot(t.normal, glm::cross(t.p[(k + 1) % 3] - t.p[k], hit - t.p[k])) < 0.0) {
            return false;
        }
    }
    return true;
}

bool cross_each_other(const Boxed& a, const Boxed& b) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (pierces(a.p[k], a.p[(k + 1) % 3], b) || pierces(b.p[k], b.p[(k + 1) % 3], a)) {
            return true;
        }
    }
    return false;
}

// In one plane to a tenth of a millimetre, and overlapping there by more than an edge: no separating line among the
// edges.
bool coincide(const Boxed& a, const Boxed& b) {
    const double flatness = std::fabs(glm::dot(a.normal, b.normal));
    if (flatness < 0.99999 || std::fabs(glm::dot(a.normal, b.p[0] - a.p[0])) > 1e-4) {
        return false;
    }
    const auto separates = [](const Boxed& t, const Boxed& other) {
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 outward = glm::normalize(glm::cross(t.p[(k + 1) % 3] - t.p[k], t.normal));
            if (std::all_of(other.p.begin(), other.p.end(),
                            [&](const glm::dvec3& p) { return glm::dot(outward, p - t.p[k]) > -1e-5; })) {
                return true;
            }
        }
        return false;
    };
    return !separates(a, b) && !separates(b, a);
}

class Contact : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Scenes, Contact,
                         testing::Values("storage-room.glb", "four-cannons.glb", "objects/wall.glb",
                                         "objects/cannon.glb", "objects/fire-hydrant.glb", "objects/storage-room.glb",
                                         "objects/apartment.glb", "objects/wheelbarrow.glb", "objects/cannon-mount.glb",
                                         "objects/door.glb", "test/corner.glb", "test/closed-box.glb"));

TEST_P(Contact, NothingCrossesOrCoincides) {
    const std::vector<Boxed> faces = boxed_faces(GetParam());
    std::size_t faults = 0;
    const auto report = [&](const char* what, const Boxed& a, const Boxed& b) {
        const glm::dvec3 at = 0.5 * (glm::max(a.low, b.low) + glm::min(a.high, b.high));
        if (++faults <= 10) {
            ADD_FAILURE() << what << " near " << at.x << ' ' << at.y << ' ' << at.z;
        }
    };
    for (std::size_t i = 0; i < faces.size(); ++i) {
        for (std::size_t j = i + 1; j < faces.size() && faces[j].low.x <= faces[i].high.x + 1e-4; ++j) {
            const Boxed& a = faces[i];
            const Boxed& b = faces[j];
            const bool apart = a.low.y > b.high.y + 1e-4 || b.low.y > a.high.y + 1e-4 || a.low.z > b.high.z + 1e-4 ||
                               b.low.z > a.high.z + 1e-4;
            if (apart) {
                continue;
            }
            if (coincide(a, b)) {
                report("two faces coincide", a, b);
            } else if (!share_a_corner(a, b) && cross_each_other(a, b)) {
                report("two faces cross", a, b);
            }
        }
    }
    EXPECT_EQ(faults, 0U);
}

} // namespace
} // namespace vkbake::test
