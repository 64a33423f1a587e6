#include "make_scenes/solid.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "make_scenes/turn.hpp"
#include "vkbake/error.hpp"

namespace vkbake::scenes {
namespace {

double volume(const Solid& solid) {
    double sum = 0.0;
    for (const Triangle& t : solid.triangles) {
        const auto& p = solid.points;
        sum += glm::dot(p[t.corners[0]], glm::cross(p[t.corners[1]], p[t.corners[2]]));
    }
    return sum / 6.0;
}

void turn_over(Solid& solid) {
    for (Triangle& t : solid.triangles) {
        std::swap(t.corners[1], t.corners[2]);
    }
}

using EdgeFilter = std::function<bool(std::uint32_t, std::uint32_t)>;

struct Edge {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    double square_length = 0.0;
};

bool is_on_rim(const Solid& solid, std::uint32_t a, std::uint32_t b) {
    return std::none_of(solid.triangles.begin(), solid.triangles.end(), [&](const Triangle& t) {
        const auto& c = t.corners;
        return (c[0] == b && c[1] == a) || (c[1] == b && c[2] == a) || (c[2] == b && c[0] == a);
    });
}

Edge longest_edge(const Solid& solid, const EdgeFilter& may_split) {
    Edge best;
    for (const Triangle& t : solid.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t.corners[k];
            const std::uint32_t b = t.corners[(k + 1) % 3];
            const glm::dvec3 along = solid.points[b] - solid.points[a];
            const double square_length = glm::dot(along, along);
            if (square_length > best.square_length && may_split(a, b)) {
                best = {a, b, square_length};
            }
        }
    }
    return best;
}

void split(Solid& solid, const Edge& edge) {
    const auto middle = static_cast<std::uint32_t>(solid.points.size());
    solid.points.push_back(0.5 * (solid.points[edge.a] + solid.points[edge.b]));
    const std::size_t before = solid.triangles.size();
    for (std::size_t i = 0; i < before; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = solid.triangles[i].corners[k];
            const std::uint32_t b = solid.triangles[i].corners[(k + 1) % 3];
            if ((a == edge.a && b == edge.b) || (a == edge.b && b == edge.a)) {
                Triangle second = solid.triangles[i];
                solid.triangles[i].corners[(k + 1) % 3] = middle;
                second.corners[k] = middle;
                solid.triangles.push_back(second);
                break;
            }
        }
    }
}

} // namespace

void Model::add(const Model& other, const glm::dmat4& placement) {
    for (const Solid& solid : other.solids) {
        solids.push_back(moved(solid, placement));
    }
}

std::size_t Model::triangle_count() const {
    std::size_t count = 0;
    for (const Solid& solid : solids) {
        count += solid.triangles.size();
    }
    return count;
}

Solid facing_outward(Solid solid) {
    if (volume(solid) < 0.0) {
        turn_over(solid);
    }
    return solid;
}

Solid moved(Solid solid, const glm::dmat4& placement) {
    for (glm::dvec3& point : solid.points) {
        point = glm::dvec3(placement * glm::dvec4(point, 1.0));
    }
    solid.grain = glm::dvec3(placement * glm::dvec4(solid.grain, 0.0));
    const glm::dvec3 x(placement[0]);
    const glm::dvec3 y(placement[1]);
    const glm::dvec3 z(placement[2]);
    if (glm::dot(glm::cross(x, y), z) < 0.0) {
        turn_over(solid);
    }
    return solid;
}

Solid moved(Solid solid, const glm::dvec3& offset) { return moved(std::move(solid), shifted(offset)); }

Solid painted(Solid solid, Paint paint) {
    for (Triangle& t : solid.triangles) {
        t.paint = paint;
    }
    return solid;
}

Solid grained(Solid solid, const glm::dvec3& grain) {
    solid.grain = grain;
    return solid;
}

glm::dmat4 about_x(double turns) {
    const glm::dvec2 c = on_circle(turns);
    return {{1, 0, 0, 0}, {0, c.x, c.y, 0}, {0, -c.y, c.x, 0}, {0, 0, 0, 1}};
}

glm::dmat4 about_y(double turns) {
    const glm::dvec2 c = on_circle(turns);
    return {{c.x, 0, -c.y, 0}, {0, 1, 0, 0}, {c.y, 0, c.x, 0}, {0, 0, 0, 1}};
}

glm::dmat4 about_z(double turns) {
    const glm::dvec2 c = on_circle(turns);
    return {{c.x, c.y, 0, 0}, {-c.y, c.x, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
}

glm::dmat4 shifted(const glm::dvec3& offset) {
    glm::dmat4 matrix(1.0);
    matrix[3] = glm::dvec4(offset, 1.0);
    return matrix;
}

void refine_to(Solid& solid, std::size_t count) {
    while (solid.triangles.size() < count) {
        // An edge inside makes two triangles more; the last missing one can come from the rim alone.
        const bool one_missing = solid.triangles.size() + 1 == count;
        const Edge edge = longest_edge(
            solid, [&](std::uint32_t a, std::uint32_t b) { return !one_missing || is_on_rim(solid, a, b); });
        if (edge.square_length == 0.0) {
            break;
        }
        split(solid, edge);
    }
    if (solid.triangles.size() != count) {
        throw Error(ErrorKind::bake_failed, "make_scenes: a solid has " + std::to_string(solid.triangles.size()) +
                                                " triangles where " + std::to_string(count) +
                                                " were to be reached; choose other segment counts");
    }
}

void refine_model_to(Model& model, std::size_t solid_index, std::size_t count) {
    Solid& solid = model.solids.at(solid_index);
    const std::size_t others = model.triangle_count() - solid.triangles.size();
    if (others + solid.triangles.size() > count) {
        throw Error(ErrorKind::bake_failed, model.name + ": " + std::to_string(model.triangle_count()) +
                                                " triangles, more than the " + std::to_string(count) +
                                                " it is to have; choose lower segment counts");
    }
    refine_to(solid, count - others);
}

} // namespace vkbake::scenes
