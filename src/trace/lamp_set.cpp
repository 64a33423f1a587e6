#include "trace/lamp_set.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include <glm/geometric.hpp>

#include "base/elementary.hpp"
#include "vkbake/error.hpp"

namespace vkbake {

namespace {

[[noreturn]] void refuse_lamp(const Lamp& lamp, const std::string& what) {
    throw Error(ErrorKind::bad_input, "lamp \"" + lamp.name + "\": " + what);
}

bool all_finite(const glm::dvec3& value) {
    return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

/// load_scene gives no other lamps; whoever makes a scene by hand may.
void check_lamp(const Lamp& lamp) {
    const auto require = [&](bool holds, const char* message) {
        if (!holds) {
            refuse_lamp(lamp, message);
        }
    };
    const glm::dvec3 light = lamp.intensity * lamp.color;
    require(all_finite(light) && lamp.intensity >= 0.0 && lamp.color.x >= 0.0 && lamp.color.y >= 0.0 &&
                lamp.color.z >= 0.0,
            "its colour or intensity is not finite, or below 0; give numbers of 0 or more");
    require(all_finite(lamp.position), "its position is not finite; give metres");
    require(std::abs(glm::dot(lamp.direction, lamp.direction) - 1.0) < 1e-6,
            "its direction is no unit vector; normalise it");
    require(lamp.inner_cone >= 0.0 && lamp.inner_cone <= lamp.outer_cone && lamp.outer_cone > 0.0 &&
                lamp.outer_cone <= std::numbers::pi / 2.0,
            "its cones are out of range; give 0 <= inner <= outer <= pi / 2");
    require(!lamp.range || *lamp.range > 0.0, "its range is not above 0; give metres, or none");
    require(lamp.angular_diameter >= 0.0 && lamp.angular_diameter <= 90.0,
            "its angular diameter is out of range; give 0 to 90 degrees");
    require(lamp.radius >= 0.0 && std::isfinite(lamp.radius), "its radius is out of range; give metres, 0 or more");
}

double cosine(double radians) { return sine_cosine_degrees(radians * (180.0 / std::numbers::pi)).cosine; }

ReadyLamp make_ready(const Lamp& lamp, const BakeFrame& frame, double unit) {
    const double scale = frame.scale();
    ReadyLamp ready{.kind = lamp.kind, .light = lamp.color * (lamp.intensity / std::numbers::pi / unit)};
    if (lamp.kind == LampKind::directional) {
        ready.axis = -glm::normalize(lamp.direction);
        ready.size = sine_cosine_degrees(0.5 * lamp.angular_diameter).sine;
        return ready;
    }
    ready.place = (lamp.position - frame.centre) * scale;
    ready.light *= scale * scale;
    ready.size = lamp.radius * scale;
    if (lamp.range) {
        ready.range = *lamp.range * scale;
    }
    if (lamp.kind == LampKind::spot) {
        ready.axis = glm::normalize(lamp.direction);
        const double outer = cosine(lamp.outer_cone);
        ready.cone_scale = 1.0 / std::max(0.001, cosine(lamp.inner_cone) - outer);
        ready.cone_offset = -outer * ready.cone_scale;
    }
    return ready;
}

/// What a texel may get of it at the most.
double greatest_light(const ReadyLamp& lamp) {
    const double distance = lamp.kind == LampKind::directional ? 1.0 : std::max(least_lamp_distance, lamp.size);
    return std::max({lamp.light.x, lamp.light.y, lamp.light.z}) / (distance * distance);
}

auto key_of(const ReadyLamp& lamp) {
    return std::tuple(lamp.kind, lamp.place.x, lamp.place.y, lamp.place.z, lamp.axis.x, lamp.axis.y, lamp.axis.z,
                      lamp.light.x, lamp.light.y, lamp.light.z, lamp.size, lamp.range, lamp.cone_scale,
                      lamp.cone_offset);
}

} // namespace

LampSet make_lamp_set(std::span<const Lamp> lamps, const BakeFrame& frame, double unit) {
    constexpr double greatest_result = 0.1 * std::numeric_limits<float>::max(); // ten such lamps may meet
    LampSet set{.count = lamps.size()};
    for (std::size_t number = 0; number < lamps.size(); ++number) {
        check_lamp(lamps[number]);
        ReadyLamp ready = make_ready(lamps[number], frame, unit);
        ready.number = number;
        if (!(greatest_light(ready) * unit < greatest_result)) {
            refuse_lamp(lamps[number], "its light beside it does not fit a float; lower its intensity");
        }
        if (ready.light != glm::dvec3(0.0)) {
            (lamps[number].is_soft() ? set.soft : set.hard).push_back(ready);
        }
    }
    for (std::vector<ReadyLamp>* some : {&set.hard, &set.soft}) {
        std::sort(some->begin(), some->end(),
                  [](const ReadyLamp& a, const ReadyLamp& b) { return key_of(a) < key_of(b); });
    }
    return set;
}

double attenuation(const ReadyLamp& lamp, double distance, const glm::dvec3& outwards) {
    if (lamp.kind == LampKind::directional) {
        return 1.0;
    }
    const double share = distance / lamp.range;
    const double square = share * share;
    const double in_range = std::max(1.0 - square * square, 0.0);
    if (lamp.kind == LampKind::point) {
        return in_range;
    }
    const double strength = std::clamp(glm::dot(lamp.axis, outwards) * lamp.cone_scale + lamp.cone_offset, 0.0, 1.0);
    return in_range * strength * strength;
}

} // namespace vkbake
