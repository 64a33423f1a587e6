#include "make_scenes/soft_goods.hpp"

#include <algorithm>
#include <cmath>

#include "make_scenes/shapes.hpp"
#include "make_scenes/turn.hpp"

namespace vkbake::scenes {

Solid sheet(int columns, int rows, const std::function<glm::dvec3(double, double)>& surface, const glm::dvec3& across,
            double thickness, Paint paint) {
    Solid solid;
    const auto stride = static_cast<std::uint32_t>(columns) + 1;
    const auto side = stride * (static_cast<std::uint32_t>(rows) + 1);
    for (const double offset : {0.5, -0.5}) {
        for (int row = 0; row <= rows; ++row) {
            for (int column = 0; column <= columns; ++column) {
                solid.points.push_back(surface(static_cast<double>(column) / columns, static_cast<double>(row) / rows) +
                                       offset * thickness * across);
            }
        }
    }
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        solid.triangles.push_back({{a, b, c}, paint});
        solid.triangles.push_back({{a, c, d}, paint});
    };
    for (std::uint32_t row = 0; row + 1 < side / stride; ++row) {
        for (std::uint32_t column = 0; column + 1 < stride; ++column) {
            const std::uint32_t a = row * stride + column;
            quad(a, a + 1, a + stride + 1, a + stride);
            quad(side + a, side + a + stride, side + a + stride + 1, side + a + 1);
        }
    }
    const auto border = [&](std::uint32_t a, std::uint32_t b) { quad(a, side + a, side + b, b); };
    for (std::uint32_t column = 0; column + 1 < stride; ++column) {
        border(column, column + 1);
        border(side - 1 - column, side - 2 - column);
    }
    for (std::uint32_t row = 0; row + 1 < side / stride; ++row) {
        border((row + 1) * stride, row * stride);
        border((row + 1) * stride - 1, (row + 2) * stride - 1);
    }
    return facing_outward(std::move(solid));
}

Model make_curtain(double width, double height, Paint paint) {
    Model curtain{"curtain", {}};
    const double folds = std::max(3.0, std::nearbyint(width / 0.12));
    const auto cloth = [&](double u, double v) {
        const glm::dvec2 fold = on_circle(u * folds + 0.15 * v);
        const double depth = 0.02 + 0.02 * v;
        return glm::dvec3((u - 0.5) * width + 0.01 * v * fold.x, height - v * (height - 0.02), depth * fold.y);
    };
    curtain.add(sheet(static_cast<int>(folds) * 6, 16, cloth, {0, 0, 1}, 0.003, paint));
    curtain.add(moved(tube({{-0.5 * width - 0.05, height + 0.04, 0}, {0.5 * width + 0.05, height + 0.04, 0}}, 0.012, 10,
                           {0, 1, 0}, Paint::bronze),
                      glm::dvec3(0.0)));
    return curtain;
}

Model make_blanket(double width, double length, double drop, Paint paint) {
    Model blanket{"blanket", {}};
    const double whole = width + 2.0 * drop;
    const auto cloth = [&](double u, double v) {
        const double across = (u - 0.5) * whole;
        const double inside = std::clamp(across, -0.5 * width, 0.5 * width);
        const double below = std::abs(across - inside);
        const double wave = 0.008 * on_circle(3.0 * u + 2.0 * v).x + 0.006 * on_circle(5.0 * v - u).y;
        return glm::dvec3(inside + (across > inside ? 0.02 : (across < inside ? -0.02 : 0.0)) +
                              0.3 * wave * (below > 0.0 ? 1.0 : 0.0),
                          0.02 + wave - below, (v - 0.5) * length);
    };
    blanket.add(sheet(48, 40, cloth, {0, 1, 0}, 0.004, paint));
    return blanket;
}

Model make_cushion(const glm::dvec3& size, Paint paint) {
    Model cushion{"cushion", {}};
    Solid solid = sphere(1.0, 32, 16, paint);
    for (glm::dvec3& point : solid.points) {
        // Towards a box: a square root keeps the sign and pushes what is small outward.
        const auto swollen = [](double v) { return std::copysign(std::sqrt(std::abs(v)), v); };
        const double rim = std::max(std::abs(point.x), std::abs(point.z));
        point = glm::dvec3(0.5 * size.x * swollen(point.x), 0.5 * size.y * (point.y * (1.0 - 0.25 * rim)),
                           0.5 * size.z * swollen(point.z));
    }
    cushion.add(moved(std::move(solid), glm::dvec3(0, 0.5 * size.y + contact_gap, 0)));
    return cushion;
}

} // namespace vkbake::scenes
