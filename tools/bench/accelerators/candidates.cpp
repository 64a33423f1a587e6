#include "bench/accelerators/candidates.hpp"

#include "bench/accelerators/octree.hpp"
#include "bench/accelerators/uniform_grid.hpp"
#include "bench/common/our_kernels.hpp"
#include "bvh/each_ray.hpp"
#include "bvh/triangle_list.hpp"

namespace vkbake::bench {
namespace {

/// One of the library's, asked by single rays or by blocks.
template<typename Kernel>
class LibraryCandidate final : public Candidate {
public:
    LibraryCandidate(const Surface& surface, const AcceleratorSettings& settings)
        : m_accelerator(surface.positions, surface.canonical_order, settings) {}

    [[nodiscard]] std::size_t bytes() const override { return m_accelerator.statistics().bytes; }
    [[nodiscard]] std::unique_ptr<Contender> contender(const RaySet& rays) const override {
        return std::make_unique<Kernel>(m_accelerator, rays);
    }

private:
    TriangleAccelerator m_accelerator;
};

/// What a ray is prepared by.
struct Numbering {
    explicit Numbering(const TriangleList& list, std::size_t triangles)
        : bounds(list.bounds), ranks(triangles, no_triangle) {
        for (std::uint32_t rank = 0; rank < list.numbers.size(); ++rank) {
            ranks[list.numbers[rank]] = rank;
        }
    }
    Box bounds;
    std::vector<std::uint32_t> ranks; ///< by the triangle's number
};

class AskerContender final : public BlockByBlock {
public:
    AskerContender(const RayAsker& asker, const Numbering& numbering, const RaySet& rays)
        : BlockByBlock(rays), m_asker(&asker), m_numbering(&numbering) {}
    [[nodiscard]] std::string description() const override { return "single rays"; }

private:
    [[nodiscard]] std::function<BlockedRays(const RayBlock&)> make_answer() const override {
        return [asker = m_asker, numbering = m_numbering](const RayBlock& block) {
            return ask_one_by_one(block, [&](const Ray& ray, std::size_t /*lane*/) {
                PreparedRay prepared(ray, numbering->bounds);
                prepared.ignored_rank =
                    ray.ignored_triangle == no_triangle ? no_triangle : numbering->ranks[ray.ignored_triangle];
                return prepared.valid && asker->occluded(prepared);
            });
        };
    }

    const RayAsker* m_asker;      ///< never null
    const Numbering* m_numbering; ///< never null
};

/// A grid or an octree.
template<typename Asker>
class SubdivisionCandidate final : public Candidate {
public:
    SubdivisionCandidate(const Surface& surface, const TriangleList& list)
        : m_numbering(list, surface.triangle_count()),
          m_asker(ListedTriangles(surface.positions, list).copy(), list.bounds) {}

    [[nodiscard]] std::size_t bytes() const override {
        return m_asker.bytes() + m_numbering.ranks.capacity() * sizeof(std::uint32_t);
    }
    [[nodiscard]] std::unique_ptr<Contender> contender(const RaySet& rays) const override {
        return std::make_unique<AskerContender>(m_asker, m_numbering, rays);
    }

private:
    Numbering m_numbering;
    Asker m_asker;
};

template<typename Kernel>
CandidateKind of_library(const std::string& name, const AcceleratorSettings& settings) {
    return {name, [settings](const Surface& surface) -> std::unique_ptr<Candidate> {
                return std::make_unique<LibraryCandidate<Kernel>>(surface, settings);
            }};
}

template<typename Asker>
CandidateKind of_subdivision(const std::string& name) {
    return {name, [](const Surface& surface) -> std::unique_ptr<Candidate> {
                return std::make_unique<SubdivisionCandidate<Asker>>(
                    surface, list_triangles(surface.positions, surface.canonical_order, 1));
            }};
}

} // namespace

std::vector<CandidateKind> all_candidates() {
    std::vector<CandidateKind> kinds;
    kinds.push_back(of_library<SingleRayKernel>("brute force", {.kind = Accelerator::brute, .threads = 1}));
    for (const int splits : {4, 8, 16, 32}) {
        kinds.push_back(
            of_library<SingleRayKernel>("flat clusters, K = " + std::to_string(splits),
                                        {.kind = Accelerator::clusters, .cluster_splits = splits, .threads = 1}));
    }
    kinds.push_back(of_subdivision<UniformGrid>("uniform grid"));
    kinds.push_back(of_subdivision<Octree>("octree"));
    kinds.push_back(of_library<SingleRayKernel>("our hierarchy, single rays", {.threads = 1}));
    kinds.push_back(of_library<BlockKernel>("our hierarchy, blocks", {.threads = 1}));
    return kinds;
}

} // namespace vkbake::bench
