// A block's way through the hierarchy. No include guard: see row.inl, which must come first.
//
// Near the root whole strata go down together, as beams. Where too few rays are left in a box for that to pay, each
// goes on alone: it is put into a queue with the node, and queues are worked off in batches, in which no ray waits for
// another and the processor overlaps many of them.

class BlockTraversal {
public:
    HWY_INLINE BlockTraversal(const Hierarchy& hierarchy, const RayBlock& block, const IgnoredPlaces& ignored,
                              const Box& bounds, BlockScratch& scratch)
        : m_hierarchy(hierarchy), m_block(block), m_ignored(ignored), m_scratch(scratch) {
        prepare_rays(block, bounds, m_rays);
        m_asked = m_rays.alive;
    }

    void run() {
        if (make_beams(m_block, m_rays, m_beams)) {
            descend();
        } else {
            enqueue(0, m_rays.alive);
        }
        work_off_rays(1);
        work_off_leaves();
    }

    [[nodiscard]] BlockedRays blocked() const {
        BlockedRays blocked;
        for (std::size_t s = 0; s < RayBlock::strata; ++s) {
            blocked[s] = static_cast<RayBlock::LaneBits>(m_asked[s] & ~m_rays.alive[s]);
        }
        return blocked;
    }

private:
    using StratumRays = std::array<RayBlock::LaneBits, RayBlock::strata>;

    /// With fewer triangles than so many a ray they are tested together. Where a vector holds a whole leaf, single rays
    /// are cheaper. See docs/tracing.md.
    static constexpr std::size_t packet_gain = part_count == 1 ? 1 : 2;

    // A batch of rays, or the beams, may add so many to a batch that is not full.
    static constexpr std::size_t leaf_capacity =
        leaf_batch + std::max(ray_batch * node_width, RayBlock::rays) + node_width;

    struct Pending {
        std::uint32_t node;
        unsigned strata;
        float start;
    };

    // Beams.

    void descend() {
        unsigned strata = 0;
        for (std::size_t s = 0; s < RayBlock::strata; ++s) {
            strata |= m_rays.alive[s] != 0 ? 1U << s : 0U;
        }
        m_stack[0] = {0, strata, 0.0F};
        std::size_t size = 1;
        while (size > 0) {
            const Pending pending = m_stack[--size];
            const unsigned left = still_alive(pending.strata);
            if (left != 0) {
                size = descend_into(m_hierarchy.nodes[pending.node], left, size);
            }
        }
    }

    [[nodiscard]] unsigned still_alive(unsigned strata) const {
        unsigned left = 0;
        for (unsigned bits = strata; bits != 0; bits &= bits - 1) {
            const auto s = static_cast<std::size_t>(std::countr_zero(bits));
            left |= m_rays.alive[s] != 0 ? bits & -bits : 0U;
        }
        return left;
    }

    std::size_t descend_into(const WideNode& node, unsigned strata, std::size_t size) {
        const std::size_t base = size;
        for (unsigned bits = children_in_beam(node, m_beams); bits != 0; bits &= bits - 1) {
            const auto child = static_cast<std::size_t>(std::countr_zero(bits));
            unsigned inside = strata_in_beam(node, child, m_beams) & strata;
            if (inside == 0) {
                continue;
            }
            const std::uint32_t target = node.children[child];
            const bool leaf = (target & leaf_bit) != 0;
            StratumRays met;
            const std::size_t count = rays_in_box(node, child, inside, met);
            if (count == 0) {
                continue;
            }
            if (leaf) {
                visit_leaf(target, inside, met);
                continue;
            }
            if (count <= rays_for_queue) {
                enqueue(target, inside, met);
                continue;
            }
            const float start = m_beams.backwards ? -node.planes[m_beams.w + 3][child] : node.planes[m_beams.w][child];
            std::size_t place = size++;
            for (; place > base && m_stack[place - 1].start < start; --place) {
                m_stack[place] = m_stack[place - 1];
            }
            m_stack[place] = {target, inside, start};
        }
        return size;
    }

    /// The rays of these strata that pass the child's box; takes the strata out of which none does.
    HWY_INLINE std::size_t rays_in_box(const WideNode& node, std::size_t child, unsigned& strata, StratumRays& met) {
        std::array<Row, 6> planes;
        for (std::size_t row = 0; row < 6; ++row) {
            planes[row] = fill(node.planes[row][child]);
        }
        std::size_t count = 0;
        unsigned passing = 0;
        for (unsigned bits = strata; bits != 0; bits &= bits - 1) {
            const auto s = static_cast<std::size_t>(std::countr_zero(bits));
            Row entry = fill(0.0F);
            Row exit = fill(m_block.max_distance);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Row inverse = load(m_rays.inverse[s][axis]);
                const Row low = multiply_subtract(planes[axis], inverse, load(m_rays.offset[s][axis]));
                const Row high = multiply_subtract(planes[axis + 3], inverse, load(m_rays.offset[s][axis + 3]));
                entry = max(entry, min(low, high));
                exit = min(exit, max(low, high));
            }
            const unsigned lanes = (entry <= exit).bits() & m_rays.alive[s];
            met[s] = static_cast<RayBlock::LaneBits>(lanes);
            count += static_cast<std::size_t>(std::popcount(lanes));
            passing |= static_cast<unsigned>(lanes != 0) << s;
        }
        strata = passing;
        return count;
    }

    // Single rays: 16 · stratum + lane.

    void enqueue(std::uint32_t node, const StratumRays& met) { enqueue(node, 0xFFFFU, met); }
    void enqueue(std::uint32_t node, unsigned strata, const StratumRays& met) {
        for (; strata != 0; strata &= strata - 1) {
            const auto s = static_cast<std::uint32_t>(std::countr_zero(strata));
            fill_numbers(node, &m_scratch.nodes[m_ray_count]);
            m_ray_count += compress(lane_numbers, mask_from_bits(met[s]), &m_scratch.rays[m_ray_count], 16 * s);
        }
        work_off_rays(ray_batch);
    }

    [[nodiscard]] bool is_alive(std::uint32_t ray) const { return (m_rays.alive[ray / 16] >> (ray % 16) & 1U) != 0; }
    void block_ray(std::uint32_t ray) {
        m_rays.alive[ray / 16] = static_cast<RayBlock::LaneBits>(m_rays.alive[ray / 16] & ~(1U << (ray % 16)));
    }

    /// Until fewer than `enough` wait.
    void work_off_rays(std::size_t enough) {
        std::array<std::uint32_t, ray_batch> nodes; // NOLINT(cppcoreguidelines-pro-type-member-init): written below
        std::array<std::uint32_t, ray_batch> rays;  // NOLINT(cppcoreguidelines-pro-type-member-init): likewise
        while (m_ray_count >= enough) {
            const std::size_t count = std::min(m_ray_count, ray_batch);
            // Held here, so that they stay in registers whatever is stored meanwhile.
            Waiting waiting{m_scratch.nodes.data(), m_scratch.rays.data(), m_ray_count - count, m_leaf_count};
            // All of them, however few count: a copy whose size is known is four moves.
            std::memcpy(nodes.data(), waiting.nodes + waiting.ray_count, sizeof nodes);
            std::memcpy(rays.data(), waiting.rays + waiting.ray_count, sizeof rays);
            for (std::size_t i = 0; i < count; ++i) {
                fetch(&m_hierarchy.nodes[nodes[std::min(i + 3, count - 1)]], sizeof(WideNode));
                if (is_alive(rays[i])) {
                    visit_node(m_hierarchy.nodes[nodes[i]], rays[i], waiting);
                }
            }
            m_ray_count = waiting.ray_count;
            m_leaf_count = waiting.leaf_count;
            if (m_leaf_count >= leaf_batch) {
                work_off_leaves();
            }
        }
    }

    struct Waiting {
        std::uint32_t* nodes;
        std::uint32_t* rays;
        std::size_t ray_count;
        std::size_t leaf_count;
    };

    HWY_INLINE void visit_node(const WideNode& node, std::uint32_t ray, Waiting& waiting) {
        const std::size_t s = ray / 16;
        const std::size_t lane = ray % 16;
        const BoxRows& rows = box_rows_of(m_rays.course[s][lane]);
        Row entry = fill(0.0F);
        Row exit = fill(m_block.max_distance);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t near = rows.near[axis];
            const std::size_t far = rows.far[axis];
            const Row inverse = fill(m_rays.inverse[s][axis][lane]);
            entry = max(entry, multiply_subtract(load(node.planes[near]), inverse, fill(m_rays.offset[s][near][lane])));
            exit = min(exit, multiply_subtract(load(node.planes[far]), inverse, fill(m_rays.offset[s][far][lane])));
        }
        const RowMask met = entry <= exit;
        static_assert(leaf_bit == 0x80000000U);
        const RowMask leaves = with_top_bit(node.children);
        fill_numbers(ray, &waiting.rays[waiting.ray_count]);
        waiting.ray_count += compress(node.children, and_not(met, leaves), &waiting.nodes[waiting.ray_count]);
        fill_numbers(ray, &m_leaf_rays[waiting.leaf_count]);
        waiting.leaf_count += compress(node.children, met & leaves, &m_leaves[waiting.leaf_count]);
    }

    static HWY_INLINE void fetch(const void* data, std::size_t size) {
        for (std::size_t byte = 0; byte < size; byte += 64) {
            hwy::Prefetch(static_cast<const char*>(data) + byte);
        }
    }

    // Leaves.

    [[nodiscard]] HWY_INLINE const Leaf& leaf_at(std::uint32_t child) const {
        return m_hierarchy.leaves[leaf_index(child)];
    }

    void visit_leaf(std::uint32_t leaf, unsigned strata, const StratumRays& met) {
        const std::size_t triangles = triangles_of(leaf);
        for (; strata != 0; strata &= strata - 1) {
            const auto s = static_cast<std::uint32_t>(std::countr_zero(strata));
            const auto rays = static_cast<std::size_t>(std::popcount(met[s]));
            if (triangles < packet_gain * rays && one_axis(s, met[s])) {
                visit_leaf_together(leaf, s, met[s]);
                continue;
            }
            fill_numbers(leaf, &m_leaves[m_leaf_count]);
            m_leaf_count += compress(lane_numbers, mask_from_bits(met[s]), &m_leaf_rays[m_leaf_count], 16 * s);
        }
        if (m_leaf_count >= leaf_batch) {
            work_off_leaves();
        }
    }

    /// Whether the largest components of these rays are along one axis, and of one sign.
    [[nodiscard]] HWY_INLINE bool one_axis(std::size_t s, unsigned lanes) const {
        const auto& course = m_rays.course[s];
        const std::uint32_t first = course[static_cast<std::size_t>(std::countr_zero(lanes))];
        const std::uint32_t mask = 7U << course_axis_shift;
        return (differ(course, first, mask).bits() & lanes) == 0;
    }

    /// All triangles of a leaf, one after the other, against rays of a stratum that have one axis.
    void visit_leaf_together(std::uint32_t index, std::size_t s, unsigned lanes) {
        const Leaf& leaf = leaf_at(index);
        const auto& [axes, turn] = axes_of(m_rays.course[s][static_cast<std::size_t>(std::countr_zero(lanes))]);
        const Row sign = fill(turn);
        const LeafRays<part_count> rays{
            load(m_block.origin[axes.x]),        load(m_block.origin[axes.y]),    sign,
            sign * load(m_block.origin[axes.z]), load(m_rays.turned_shear[s][0]), load(m_rays.turned_shear[s][1]),
            load(m_rays.sure_depth[s]),          load(m_rays.futile_depth[s])};
        const LeafLimits<part_count> limits(m_rays.limited, m_rays.sure_sum);
        using Rows = std::array<RayBlock::LaneRow, leaf_vertices>;
        alignas(64) Rows x; // NOLINT(cppcoreguidelines-pro-type-member-init): zeroing costs more than the test
        alignas(64) Rows y; // NOLINT(cppcoreguidelines-pro-type-member-init): likewise
        alignas(64) Rows z; // NOLINT(cppcoreguidelines-pro-type-member-init): likewise
        for (std::size_t vertex = 0; vertex < leaf.vertex_count; ++vertex) {
            const LeafVertices<part_count> at(rays, fill(leaf.vertices[axes.x][vertex]),
                                              fill(leaf.vertices[axes.y][vertex]), fill(leaf.vertices[axes.z][vertex]));
            store(at.x, x[vertex]);
            store(at.y, y[vertex]);
            store(at.z, z[vertex]);
        }
        unsigned left = lanes;
        unsigned doubtful = 0; // triangles
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): read where doubtful only
        std::array<unsigned, leaf_width> doubts; // lanes
        for (std::size_t triangle = 0; triangle < triangles_of(index) && left != 0; ++triangle) {
            const std::size_t a = vertex_of(leaf, triangle, 0);
            const std::size_t b = vertex_of(leaf, triangle, 1);
            const std::size_t c = vertex_of(leaf, triangle, 2);
            const LeafAnswer<part_count> answer =
                test_corners<part_count>(rays, limits,
                                         {{load(x[a]), load(y[a]), load(x[b]), load(y[b]), load(x[c]), load(y[c])},
                                          load(z[a]),
                                          load(z[b]),
                                          load(z[c])});
            const RowMask others = unlike(m_ignored, leaf.first_place + static_cast<std::uint32_t>(triangle));
            left &= ~(answer.hit & others).bits();
            doubts[triangle] = (answer.doubt & others).bits();
            doubtful |= doubts[triangle] != 0 ? 1U << triangle : 0U;
        }
        for (; doubtful != 0; doubtful &= doubtful - 1) {
            const auto triangle = static_cast<std::size_t>(std::countr_zero(doubtful));
            for (unsigned bits = doubts[triangle] & left; bits != 0; bits &= bits - 1) {
                const auto lane = static_cast<std::uint32_t>(std::countr_zero(bits));
                const bool met = meets_any(static_cast<std::uint32_t>(16 * s) + lane, leaf, 1U << triangle);
                left &= met ? ~(1U << lane) : ~0U;
            }
        }
        m_rays.alive[s] = static_cast<RayBlock::LaneBits>(m_rays.alive[s] & ~(lanes & ~left));
    }

    // Without a branch on what a ray meets: it cannot be foretold, and the next rays need not wait for it. The one on
    // rays that have been blocked since they came here spares a fifth of the leaves.
    void work_off_leaves() {
        const LeafLimits<1> limits(m_rays.limited, m_rays.sure_sum); // held here: in registers whatever is stored
        const std::size_t count = m_leaf_count;
        std::size_t doubtful = 0;
        for (std::size_t i = 0; i < count; ++i) {
            fetch(&leaf_at(m_leaves[std::min(i + 3, count - 1)]), sizeof(Leaf));
            const std::uint32_t ray = m_leaf_rays[i];
            if (!is_alive(ray)) {
                continue;
            }
            const Leaf& leaf = leaf_at(m_leaves[i]);
            const LeafBits met = ask_leaf(m_leaves[i], ray, limits);
            const unsigned others = triangles_but(leaf, m_leaves[i], m_ignored[ray % 16]);
            const auto hit = static_cast<unsigned>((met.hit & others) != 0);
            const unsigned doubt = met.doubt & others;
            m_rays.alive[ray / 16] = static_cast<RayBlock::LaneBits>(m_rays.alive[ray / 16] & ~(hit << (ray % 16)));
            m_leaves[doubtful] = m_leaves[i];
            m_leaf_rays[doubtful] = ray;
            m_doubts[doubtful] = doubt;
            doubtful += static_cast<std::size_t>(doubt != 0) & ~std::size_t{hit};
        }
        m_leaf_count = 0;
        for (std::size_t i = 0; i < doubtful; ++i) {
            if (is_alive(m_leaf_rays[i]) && meets_any(m_leaf_rays[i], leaf_at(m_leaves[i]), m_doubts[i])) {
                block_ray(m_leaf_rays[i]);
            }
        }
    }

    [[nodiscard]] HWY_INLINE LeafBits ask_leaf(std::uint32_t child, std::uint32_t ray,
                                               const LeafLimits<1>& limits) const {
        const std::size_t s = ray / 16;
        const std::size_t lane = ray % 16;
        const auto& [axes, sign] = axes_of(m_rays.course[s][lane]);
        const LeafRays<1> rays{fill<1>(m_block.origin[axes.x][lane]),
                               fill<1>(m_block.origin[axes.y][lane]),
                               fill<1>(sign),
                               fill<1>(sign * m_block.origin[axes.z][lane]),
                               fill<1>(m_rays.turned_shear[s][0][lane]),
                               fill<1>(m_rays.turned_shear[s][1][lane]),
                               fill<1>(limits.limited ? m_rays.sure_depth[s][lane] : 0.0F),
                               fill<1>(limits.limited ? m_rays.futile_depth[s][lane] : 0.0F)};
        return test_leaf(rays, limits, axes, leaf_at(child), triangles_of(child));
    }

    /// Whether a ray meets any of these triangles of a leaf, asked in double.
    [[nodiscard]] HWY_NOINLINE bool meets_any(std::uint32_t ray, const Leaf& leaf, unsigned triangles) const {
        const std::size_t s = ray / 16;
        const std::size_t lane = ray % 16;
        const auto& [axes, sign] = axes_of(m_rays.course[s][lane]);
        const ShearedRay sheared(ray_of(m_block, s, lane), static_cast<int>(axes.x), static_cast<int>(axes.y),
                                 static_cast<int>(axes.z), sign * m_rays.turned_shear[s][0][lane],
                                 sign * m_rays.turned_shear[s][1][lane]);
        for (; triangles != 0; triangles &= triangles - 1) {
            const auto triangle = static_cast<std::size_t>(std::countr_zero(triangles));
            if (test_watertight(sheared, triangle_in(leaf, triangle)).hit) {
                return true;
            }
        }
        return false;
    }

    const Hierarchy& m_hierarchy;
    const RayBlock& m_block;
    alignas(64) IgnoredPlaces m_ignored;
    BlockScratch& m_scratch;
    BlockRays m_rays;
    StratumRays m_asked;
    Beams m_beams;
    std::array<Pending, stack_size> m_stack;
    std::size_t m_ray_count = 0;
    std::size_t m_leaf_count = 0;
    std::array<std::uint32_t, leaf_capacity> m_leaves;
    std::array<std::uint32_t, leaf_capacity> m_leaf_rays;
    std::array<std::uint32_t, leaf_capacity> m_doubts; ///< triangles, a bit each
};
