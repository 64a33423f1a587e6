#include "trace/sky_lookup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "vkbake/error.hpp"

namespace vkbake {

namespace {

[[noreturn]] void refuse(ErrorKind kind, const std::string& message) { throw Error(kind, "sky: " + message); }

void check_picture(const Image& image) {
    if (image.width < 1 || image.height < 1 ||
        image.texels.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
        refuse(ErrorKind::bad_input, "the picture has no texels or not as many as its size says; give a whole picture");
    }
}

void copy_inside(BorderedImages& to, int image, const Image& from) {
    for (int y = 0; y < from.height; ++y) {
        for (int x = 0; x < from.width; ++x) {
            to.at(image, x, y) = glm::vec3(from.texels[from.index(x, y)]);
        }
    }
}

/// The texel next to a face's border, on the face beyond it.
glm::vec3 texel_beyond(const CubeSky& sky, int face, double s, double t) {
    const CubePoint point = cube_point(cube_direction(face, s, t));
    const Image& image = sky.faces[static_cast<std::size_t>(point.face)];
    const auto texel = [&](double coordinate) {
        return std::clamp(static_cast<int>(coordinate * image.width), 0, image.width - 1);
    };
    return glm::vec3(image.texels[image.index(texel(point.s), texel(point.t))]);
}

/// Look-ups count a picture's floats in 32 bits.
void check_size(std::size_t images, const Image& image) {
    const auto ringed = [](int size) { return static_cast<std::size_t>(size) + 2; };
    constexpr auto most = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    if (3 * images * ringed(image.width) * ringed(image.height) > most) {
        refuse(ErrorKind::bad_input, "the picture has more than 700 million texels; give a smaller one");
    }
}

void add_face(BorderedImages& bordered, const CubeSky& sky, int face) {
    const Image& image = sky.faces[static_cast<std::size_t>(face)];
    const int size = image.width;
    copy_inside(bordered, face, image);
    // So little beyond the border that, seen from the centre, the place along it stays inside its texel.
    const double beyond = 1.0 / (8.0 * size);
    for (int i = 0; i < size; ++i) {
        const double along = (i + 0.5) / size;
        bordered.at(face, -1, i) = texel_beyond(sky, face, -beyond, along);
        bordered.at(face, size, i) = texel_beyond(sky, face, 1.0 + beyond, along);
        bordered.at(face, i, -1) = texel_beyond(sky, face, along, -beyond);
        bordered.at(face, i, size) = texel_beyond(sky, face, along, 1.0 + beyond);
    }
    for (const int x : {-1, size}) {
        for (const int y : {-1, size}) {
            const int inner_x = std::clamp(x, 0, size - 1);
            const int inner_y = std::clamp(y, 0, size - 1);
            const std::array<glm::vec3, 3> around{bordered.at(face, inner_x, inner_y), bordered.at(face, x, inner_y),
                                                  bordered.at(face, inner_x, y)};
            const glm::vec3 mean = (around[0] + around[1] + around[2]) / 3.0F;
            // It is no texel's own value: where these pack it does, so that it costs no picture its packing.
            const bool pack = std::ranges::all_of(around, [](const glm::vec3& v) { return packed_near(v) == v; });
            bordered.at(face, x, y) = pack ? packed_near(mean) : mean;
        }
    }
}

BorderedImages bordered_panorama(const Image& image) {
    check_picture(image);
    check_size(1, image);
    BorderedImages bordered(1, image.width, image.height);
    copy_inside(bordered, 0, image);
    wrap_around(bordered);
    return bordered;
}

BorderedImages bordered_cube(const CubeSky& sky) {
    for (const Image& face : sky.faces) {
        check_picture(face);
        if (face.width != face.height || face.width != sky.faces[0].width) {
            refuse(ErrorKind::bad_input,
                   "the faces of the cube are not square or not of one size; give six equal squares");
        }
    }
    check_size(6, sky.faces[0]);
    BorderedImages bordered(6, sky.faces[0].width, sky.faces[0].width);
    for (int face = 0; face < 6; ++face) {
        add_face(bordered, sky, face);
    }
    return bordered;
}

/// Throws where a value is no radiance: load_sky replaces such values, whoever makes a sky himself must not have them.
float greatest_value(const Image& image) {
    float greatest = 0.0F;
    std::uint64_t wrong = 0;
    for (const glm::vec4& texel : image.texels) {
        for (const float value : {texel.x, texel.y, texel.z}) {
            wrong += value >= 0.0F && value <= std::numeric_limits<float>::max() ? 0 : 1;
            greatest = std::max(greatest, value);
        }
    }
    if (wrong > 0) {
        refuse(ErrorKind::bad_input, std::to_string(wrong) + " values of the picture are NaN, negative or not finite; "
                                                             "replace them, or read it by load_sky, which does");
    }
    return greatest;
}

struct GreatestRadiance {
    float operator()(const ConstantSky& sky) const {
        return std::max({sky.radiance.x, sky.radiance.y, sky.radiance.z});
    }
    float operator()(const ClearSky& /*sky*/) const { return 8.0F; } // at the sun 7.3
    float operator()(const EquirectangularSky& sky) const { return greatest_value(sky.image); }
    float operator()(const CubeSky& sky) const {
        float greatest = 0.0F;
        for (const Image& face : sky.faces) {
            greatest = std::max(greatest, greatest_value(face));
        }
        return greatest;
    }
};

struct MakeLookup {
    SkyTurn turn;
    SkyLookup operator()(const ConstantSky& sky) const { return ConstantLookup{sky.radiance}; }
    SkyLookup operator()(const ClearSky& /*sky*/) const { return ClearSkyLookup{turn}; }
    SkyLookup operator()(const EquirectangularSky& sky) const {
        return EquirectangularLookup{turn, bordered_panorama(sky.image)};
    }
    SkyLookup operator()(const CubeSky& sky) const { return CubeLookup{turn, bordered_cube(sky)}; }
};

} // namespace

CubePoint cube_point(const glm::dvec3& direction) {
    const double x = direction.x;
    const double y = direction.y;
    const double z = direction.z;
    const double width = std::abs(x);
    const double height = std::abs(y);
    const double depth = std::abs(z);
    const auto place = [](int face, double sc, double tc, double major) {
        return CubePoint{face, 0.5 * (sc / major + 1.0), 0.5 * (tc / major + 1.0)};
    };
    if (depth >= width && depth >= height) {
        return z < 0.0 ? place(5, -x, -y, depth) : place(4, x, -y, depth);
    }
    if (height >= width) {
        return y < 0.0 ? place(3, x, -z, height) : place(2, x, z, height);
    }
    return x < 0.0 ? place(1, z, -y, width) : place(0, -z, -y, width);
}

glm::dvec3 cube_direction(int face, double s, double t) {
    const double sc = 2.0 * s - 1.0;
    const double tc = 2.0 * t - 1.0;
    switch (face) {
    case 0:
        return {1.0, -tc, -sc};
    case 1:
        return {-1.0, -tc, sc};
    case 2:
        return {sc, 1.0, tc};
    case 3:
        return {sc, -1.0, -tc};
    case 4:
        return {sc, -tc, 1.0};
    default:
        return {-sc, -tc, -1.0};
    }
}

SkyLookup make_sky_lookup(const Sky& sky) {
    if (!std::isfinite(sky.intensity) || sky.intensity < 0.0) {
        refuse(ErrorKind::usage,
               "the intensity is " + std::to_string(sky.intensity) + "; give a finite number, 0 or more");
    }
    if (!std::isfinite(sky.rotation_degrees)) {
        refuse(ErrorKind::usage, "the rotation is not a finite number; give degrees");
    }
    if (const auto* constant = std::get_if<ConstantSky>(&sky.source)) {
        for (const float value : {constant->radiance.x, constant->radiance.y, constant->radiance.z}) {
            if (!std::isfinite(value) || value < 0.0F) {
                refuse(ErrorKind::usage,
                       "a constant radiance is not a finite number, 0 or more; give three such numbers");
            }
        }
    }
    // A little below the greatest float: sums of the greatest value err by some units in the last place.
    constexpr double greatest_result = 0.999 * std::numeric_limits<float>::max();
    if (std::visit(GreatestRadiance{}, sky.source) * sky.intensity > greatest_result) {
        refuse(ErrorKind::bad_input,
               "its brightest value times the intensity does not fit a float; lower the intensity");
    }
    return std::visit(MakeLookup{SkyTurn(sky.rotation_degrees)}, sky.source);
}

} // namespace vkbake
