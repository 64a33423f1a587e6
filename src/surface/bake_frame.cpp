#include "surface/bake_frame.hpp"

#include "vkbake/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace vkbake {
namespace {

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void include(const glm::dvec3& point) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], point[axis]);
            high[axis] = std::max(high[axis], point[axis]);
        }
    }
};

bool is_finite(const glm::dvec3& value) {
    return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

/// The box of linear · v over a mesh's vertices: no translation enters, so it does not depend on where the instance is.
std::optional<Box> untranslated_box(const Scene& scene, const Instance& instance) {
    std::optional<Box> box;
    for (const Primitive& primitive : scene.meshes.at(instance.mesh).primitives) {
        for (const std::uint32_t index : primitive.indices) {
            const glm::dvec3 position = transform_vertex(instance.linear, primitive.positions.at(index));
            if (!is_finite(position)) {
                throw Error(ErrorKind::bad_input, scene.name + ": node \"" + instance.name +
                                                      "\": a vertex or the transform is not finite; repair the scene");
            }
            if (!box) {
                box.emplace();
            }
            box->include(position);
        }
    }
    return box;
}

/// The least translation in lexicographic order: a reference that moves with the scene and does not depend on the
/// instances' order.
glm::dvec3 least_translation(const Scene& scene) {
    const auto key = [](const Instance& instance) {
        return std::make_tuple(instance.translation.x, instance.translation.y, instance.translation.z);
    };
    const auto least = std::min_element(scene.instances.begin(), scene.instances.end(),
                                        [&](const Instance& a, const Instance& b) { return key(a) < key(b); });
    return least->translation;
}

/// reference + offset, rounded to a multiple of `grid` (a power of two). The reference's whole steps are split off
/// first, exactly, so that a reference moved by whole steps moves the result by the same steps.
double round_to_grid(double reference, double offset, double grid) {
    const double steps = reference / grid;
    const double whole = std::floor(steps);
    return grid * (whole + std::floor((steps - whole) + offset / grid + 0.5));
}

/// Areas, the frame's scale, its square and their reciprocals are then normal doubles: no later step can overflow or
/// vanish. A single point has no size and any frame will do.
void check_range(const Scene& scene, double extent, const Box& box, const glm::dvec3& reference) {
    constexpr double largest = 0x1p300;
    constexpr double smallest = 0x1p-300;
    const auto refuse = [&](const std::string& what) { throw Error(ErrorKind::bad_input, scene.name + ": " + what); };
    if (!(extent <= largest)) {
        refuse("the scene is larger than 2^300 m; scale it down");
    }
    if (extent > 0.0 && extent < smallest) {
        refuse("the scene is smaller than 2^-300 m; scale it up");
    }
    for (int axis = 0; axis < 3; ++axis) {
        const double place =
            std::max(std::abs(reference[axis] + box.low[axis]), std::abs(reference[axis] + box.high[axis]));
        if (!(place <= 2.0 * largest)) {
            refuse("the scene lies farther than 2^300 m from the origin; move it there");
        }
    }
}

} // namespace

glm::dvec3 transform_vertex(const glm::dmat3& linear, const glm::vec3& vertex) {
    const glm::dvec3 v(vertex);
    return {linear[0].x * v.x + linear[1].x * v.y + linear[2].x * v.z,
            linear[0].y * v.x + linear[1].y * v.y + linear[2].y * v.z,
            linear[0].z * v.x + linear[1].z * v.y + linear[2].z * v.z};
}

double BakeFrame::scale() const { return std::ldexp(1.0, exponent); }

glm::dvec3 BakeFrame::to_world(const glm::vec3& position) const {
    return glm::dvec3(position) * std::ldexp(1.0, -exponent) + centre;
}

BakeFrame make_bake_frame(const Scene& scene) {
    if (scene.instances.empty()) {
        return {};
    }
    const glm::dvec3 reference = least_translation(scene);
    Box box;
    bool any = false;
    for (const Instance& instance : scene.instances) {
        if (!is_finite(instance.translation)) {
            throw Error(ErrorKind::bad_input, scene.name + ": node \"" + instance.name +
                                                  "\": its translation is not finite; repair the scene");
        }
        if (const std::optional<Box> own = untranslated_box(scene, instance)) {
            const glm::dvec3 offset = instance.translation - reference;
            box.include(own->low + offset);
            box.include(own->high + offset);
            any = true;
        }
    }
    if (!any) {
        return {};
    }
    const glm::dvec3 size = box.high - box.low;
    const double extent = std::max({size.x, size.y, size.z});
    check_range(scene, extent, box, reference);
    int size_exponent = 0; // of the least power of two that is not below the extent
    if (extent > 0.0) {
        const double mantissa = std::frexp(extent, &size_exponent);
        size_exponent -= mantissa == 0.5 ? 1 : 0;
    }
    // 2⁻⁶ of the size; |position| then stays below ½ + 2⁻⁷.
    const double grid = std::ldexp(1.0, size_exponent - 6);
    BakeFrame frame;
    frame.exponent = -size_exponent;
    for (int axis = 0; axis < 3; ++axis) {
        const double middle = box.low[axis] + 0.5 * size[axis];
        frame.centre[axis] = round_to_grid(reference[axis], middle, grid);
    }
    return frame;
}

} // namespace vkbake
