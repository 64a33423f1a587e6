#include "atlas/cluster_triangles.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

namespace vkbake {

namespace {

constexpr double facet_cosine = 0.99999; // about ¼°

class Clustering {
public:
    Clustering(const ChartMesh& mesh, const std::vector<std::uint32_t>& component, double cone,
               std::vector<std::uint32_t>& cluster_of)
        : m_mesh(mesh), m_component(component), m_cone(cone), m_cluster_of(cluster_of) {}

    std::vector<Cluster> run() {
        clear();
        grow_the_rest();
        constexpr int rounds = 3;
        if (any_touch()) { // else each is a region between creases, and would grow as it has
            for (int round = 0; round < rounds; ++round) {
                begin_in_the_middle();
                grow();
                grow_the_rest();
            }
            straighten();
        }
        return gather();
    }

private:
    struct Step {
        double distance;
        std::uint32_t cluster;
        std::uint32_t triangle;

        bool operator<(const Step& other) const {
            return std::tie(other.distance, other.cluster, other.triangle) < std::tie(distance, cluster, triangle);
        }
    };

    void clear() {
        for (const std::uint32_t triangle : m_component) {
            m_cluster_of[triangle] = ChartMesh::none;
        }
    }

    [[nodiscard]] glm::dvec3 middle(std::uint32_t triangle) const {
        return (m_mesh.corner(3 * triangle) + m_mesh.corner(3 * triangle + 1) + m_mesh.corner(3 * triangle + 2)) / 3.0;
    }

    [[nodiscard]] double area(std::uint32_t triangle) const {
        const glm::dvec3 a = m_mesh.corner(3 * triangle);
        return 0.5 * glm::length(glm::cross(m_mesh.corner(3 * triangle + 1) - a, m_mesh.corner(3 * triangle + 2) - a));
    }

    /// The side across one over which a cluster may go on, or `none`.
    [[nodiscard]] std::uint32_t way_over(std::uint32_t side) const {
        return m_mesh.is_crease(side) ? ChartMesh::none : m_mesh.across[side];
    }

    /// Whether there are clusters that could have grown further but for others.
    [[nodiscard]] bool any_touch() const {
        return std::ranges::any_of(m_component, [&](std::uint32_t triangle) {
            for (std::uint32_t side = 3 * triangle; side < 3 * triangle + 3; ++side) {
                const std::uint32_t beyond = way_over(side);
                if (beyond != ChartMesh::none && m_cluster_of[beyond / 3] != m_cluster_of[triangle]) {
                    return true;
                }
            }
            return false;
        });
    }

    void begin(std::uint32_t cluster, std::uint32_t triangle) {
        m_axes.resize(std::max<std::size_t>(m_axes.size(), cluster + std::size_t{1}), glm::dvec3(0.0));
        m_open.push({0.0, cluster, triangle});
    }

    /// Clusters whose axis is known keep it; one that has begun anew turns with what it takes.
    void grow() {
        while (!m_open.empty()) {
            const Step step = m_open.top();
            m_open.pop();
            if (m_cluster_of[step.triangle] != ChartMesh::none || !faces_with(step.triangle, step.cluster)) {
                continue;
            }
            m_cluster_of[step.triangle] = step.cluster;
            if (step.cluster >= m_settled) {
                m_axes[step.cluster] += area(step.triangle) * m_mesh.normals[step.triangle];
            }
            for (std::uint32_t side = 3 * step.triangle; side < 3 * step.triangle + 3; ++side) {
                const std::uint32_t beyond = way_over(side);
                if (beyond != ChartMesh::none && m_cluster_of[beyond / 3] == ChartMesh::none) {
                    const double flatness = glm::dot(m_mesh.normals[step.triangle], m_mesh.normals[beyond / 3]);
                    const double way =
                        flatness >= facet_cosine ? 0.0 : glm::length(middle(beyond / 3) - middle(step.triangle));
                    m_open.push({step.distance + way, step.cluster, beyond / 3});
                }
            }
        }
    }

    [[nodiscard]] bool faces_with(std::uint32_t triangle, std::uint32_t cluster) const {
        const glm::dvec3& axis = m_axes[cluster];
        return glm::dot(m_mesh.normals[triangle], axis) >= m_cone * glm::length(axis);
    }

    /// New clusters, one after the other, for what none has taken.
    void grow_the_rest() {
        m_settled = m_axes.size();
        for (const std::uint32_t seed : m_component) {
            if (m_cluster_of[seed] == ChartMesh::none) {
                begin(static_cast<std::uint32_t>(m_axes.size()), seed);
                grow();
            }
        }
    }

    /// Each cluster begins anew where it has its centre, with the axis that it had in the mean; what is left of tiny
    /// ones is for their neighbours to take.
    void begin_in_the_middle() {
        struct Sum {
            glm::dvec3 centre{0.0};
            glm::dvec3 facing{0.0};
            double area = 0.0;
            double nearest = std::numeric_limits<double>::infinity();
            std::uint32_t middle = 0;
        };
        std::vector<Sum> sums(m_axes.size());
        for (const std::uint32_t triangle : m_component) {
            Sum& sum = sums[m_cluster_of[triangle]];
            sum.centre += area(triangle) * middle(triangle);
            sum.facing += area(triangle) * m_mesh.normals[triangle];
            sum.area += area(triangle);
        }
        for (const std::uint32_t triangle : m_component) {
            Sum& sum = sums[m_cluster_of[triangle]];
            const glm::dvec3 way = middle(triangle) - sum.centre / sum.area;
            const bool faces = glm::dot(m_mesh.normals[triangle], sum.facing) >= m_cone * glm::length(sum.facing);
            const double distance = faces ? glm::dot(way, way) : std::numeric_limits<double>::max();
            if (distance < sum.nearest) {
                sum.nearest = distance;
                sum.middle = triangle;
            }
        }
        double area = 0.0;
        for (const Sum& sum : sums) {
            area += sum.area;
        }
        constexpr double tiny = 0.05; // of what a cluster has in the mean
        clear();
        m_axes.clear();
        for (const Sum& sum : sums) {
            if (sum.area * static_cast<double>(sums.size()) >= tiny * area) {
                begin(static_cast<std::uint32_t>(m_axes.size()), sum.middle);
                m_axes.back() = sum.facing;
            }
        }
        m_settled = m_axes.size();
    }

    /// Triangles that stick out into another cluster go over to it.
    void straighten() {
        constexpr int passes = 3;
        for (int pass = 0; pass < passes; ++pass) {
            for (const std::uint32_t triangle : m_component) {
                std::uint32_t names[3];
                for (std::uint32_t c = 0; c < 3; ++c) {
                    const std::uint32_t beyond = way_over(3 * triangle + c);
                    names[c] = beyond == ChartMesh::none ? ChartMesh::none : m_cluster_of[beyond / 3];
                }
                const std::uint32_t own = m_cluster_of[triangle];
                for (std::uint32_t c = 0; c < 3; ++c) {
                    const std::uint32_t other = names[c];
                    if (other != ChartMesh::none && other != own && other == names[(c + 1) % 3] &&
                        glm::dot(m_mesh.normals[triangle], m_axes[other]) > 0.0) {
                        m_cluster_of[triangle] = other;
                        break;
                    }
                }
            }
        }
    }

    std::vector<Cluster> gather() {
        std::vector<Cluster> clusters(m_axes.size());
        for (const std::uint32_t triangle : m_component) {
            clusters[m_cluster_of[triangle]].push_back(triangle);
        }
        std::erase_if(clusters, [](const Cluster& cluster) { return cluster.empty(); });
        for (std::uint32_t name = 0; name < clusters.size(); ++name) {
            for (const std::uint32_t triangle : clusters[name]) {
                m_cluster_of[triangle] = name;
            }
        }
        return clusters;
    }

    const ChartMesh& m_mesh;
    const std::vector<std::uint32_t>& m_component;
    double m_cone;
    std::vector<std::uint32_t>& m_cluster_of;
    std::size_t m_settled = 0;      ///< clusters below have their axes
    std::vector<glm::dvec3> m_axes; ///< 1 a cluster, any length; none where it has nothing yet
    std::priority_queue<Step> m_open;
};

} // namespace

std::vector<Cluster> cluster_triangles(const ChartMesh& mesh, const std::vector<std::uint32_t>& component, double cone,
                                       std::vector<std::uint32_t>& cluster_of) {
    return Clustering(mesh, component, cone, cluster_of).run();
}

} // namespace vkbake
