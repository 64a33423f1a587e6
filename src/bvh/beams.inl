// Bounds of many rays at once. No include guard: see row.inl, which must come first.
//
// All rays of a block run the same way along one axis; call it w, turned so that they run towards +w. Along u, and
// along v likewise, a ray is the line u = u₀ + m (w − w₀). With M the greatest slope, u − M w never rises along any
// ray, so for all of them u ≤ M w + C, C = max(u₀ − M w₀); with the least slope they are bounded from below. A box is
// passed by unless all of it lies beyond one of these four planes, or before all origins. The planes are moved outwards
// by the pad of PreparedRay, and by as much again for the roundings here.

struct BeamPlane {
    Row slope, offset;
};

/// The rays of each stratum: a lane a stratum.
struct StratumBeams {
    BeamPlane upper_u, lower_u, upper_v, lower_v;
};

/// All rays of the block.
struct BlockBeam {
    struct Plane {
        float slope = 0.0F, offset = 0.0F;
    };
    Plane upper_u, lower_u, upper_v, lower_v;
};

struct Beams {
    std::size_t w = 0, u = 0, v = 0;
    bool backwards = false; ///< w is turned
    float start = 0.0F;     ///< before the first origin
    StratumBeams strata;
    BlockBeam block;
};

// Directions that are nearly perpendicular to w would make a beam that bounds nothing.
constexpr float least_along_beam = 0x1p-5F;

HWY_INLINE Row alive_or(const BlockRays& rays, std::size_t stratum, const Row& row, float otherwise) {
    return select(mask_from_bits(rays.alive[stratum]), row, fill(otherwise));
}

/// Chooses w. False if no axis will do.
HWY_INLINE bool choose_axes(const RayBlock& block, const BlockRays& rays, Beams& beams) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    float best = least_along_beam;
    bool found = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Row low = fill(infinity);
        Row high = fill(-infinity);
        for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
            const Row along = load(block.direction[stratum][axis]);
            low = min(low, alive_or(rays, stratum, along, infinity));
            high = max(high, alive_or(rays, stratum, along, -infinity));
        }
        const float forwards = least_lane(low);
        const float backwards = -greatest_lane(high);
        if (std::max(forwards, backwards) > best && forwards < infinity) {
            best = std::max(forwards, backwards);
            beams.w = axis;
            beams.u = (axis + 1) % 3;
            beams.v = (axis + 2) % 3;
            beams.backwards = backwards > forwards;
            found = true;
        }
    }
    return found;
}

/// Where the rays that are alive start: along u or v, and along w.
struct Origins {
    Row across, along;
    RowMask lanes;

    HWY_INLINE float greatest_offset(float slope) const {
        const Row offset = negated_multiply_add(fill(slope), along, across);
        return greatest_lane(select(lanes, offset, fill(-std::numeric_limits<float>::infinity())));
    }
    HWY_INLINE float least_offset(float slope) const {
        const Row offset = negated_multiply_add(fill(slope), along, across);
        return least_lane(select(lanes, offset, fill(std::numeric_limits<float>::infinity())));
    }
};

/// Offsets for many slopes from those for two. As a function of the slope an upper plane's offset is the greatest of
/// linear ones, so it lies below its chord, and a lower plane's above: bounds at a sixteenth of the work.
HWY_INLINE Row chord(const Row& slope, float first, float first_offset, float last, float last_offset) {
    const float rise = last > first ? (last_offset - first_offset) / (last - first) : 0.0F;
    return multiply_add(slope - fill(first), fill(rise), fill(first_offset));
}

/// Along u or v, whose origins are `from`; `start` are the origins along w.
HWY_INLINE void make_planes(const RayBlock& block, const BlockRays& rays, const Beams& beams, std::size_t axis,
                            const Row& start, BeamPlane& upper, BeamPlane& lower, BlockBeam::Plane& block_upper,
                            BlockBeam::Plane& block_lower) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    using Rows = std::array<RayBlock::LaneRow, RayBlock::strata>;
    alignas(64) Rows greatest;
    alignas(64) Rows least;
    for (std::size_t s = 0; s < RayBlock::strata; ++s) {
        const Row slope = load(block.direction[s][axis]) * abs(load(rays.inverse[s][beams.w]));
        store(alive_or(rays, s, slope, -infinity), greatest[s]);
        store(alive_or(rays, s, slope, infinity), least[s]);
    }
    upper.slope = greatest_of_rows(greatest);
    lower.slope = least_of_rows(least);
    block_upper.slope = greatest_lane(upper.slope);
    block_lower.slope = least_lane(lower.slope);

    unsigned lanes = 0;
    unsigned strata = 0;
    for (std::size_t s = 0; s < RayBlock::strata; ++s) {
        lanes |= rays.alive[s];
        strata |= rays.alive[s] != 0 ? 1U << s : 0U;
    }
    const Origins origins{load(block.origin[axis]), start, mask_from_bits(lanes)};
    const RowMask used = mask_from_bits(strata);
    const float pad = 2.0F * rays.pad;
    const float least_upper = least_lane(select(used, upper.slope, fill(infinity)));
    const float greatest_lower = greatest_lane(select(used, lower.slope, fill(-infinity)));
    const float high = origins.greatest_offset(block_upper.slope);
    const float low = origins.least_offset(block_lower.slope);
    const auto widening = [&](const Row& slope) HWY_ATTR { return multiply_add(fill(pad), abs(slope), fill(pad)); };
    upper.offset = chord(upper.slope, least_upper, origins.greatest_offset(least_upper), block_upper.slope, high) +
                   widening(upper.slope);
    lower.offset = chord(lower.slope, block_lower.slope, low, greatest_lower, origins.least_offset(greatest_lower)) -
                   widening(lower.slope);
    block_upper.offset = high + pad * std::abs(block_upper.slope) + pad;
    block_lower.offset = low - pad * std::abs(block_lower.slope) - pad;
}

/// False where the rays have no axis in common.
HWY_INLINE bool make_beams(const RayBlock& block, const BlockRays& rays, Beams& beams) {
    if (!choose_axes(block, rays, beams)) {
        return false;
    }
    const Row along = load(block.origin[beams.w]);
    const Row start = beams.backwards ? fill(0.0F) - along : along;
    make_planes(block, rays, beams, beams.u, start, beams.strata.upper_u, beams.strata.lower_u, beams.block.upper_u,
                beams.block.lower_u);
    make_planes(block, rays, beams, beams.v, start, beams.strata.upper_v, beams.strata.lower_v, beams.block.upper_v,
                beams.block.lower_v);
    beams.start = least_lane(start) - 2.0F * rays.pad;
    return true;
}

/// The children that any ray of the block may pass.
HWY_INLINE unsigned children_in_beam(const WideNode& node, const Beams& beams) {
    const std::size_t near_row = beams.backwards ? beams.w + 3 : beams.w;
    const std::size_t far_row = beams.backwards ? beams.w : beams.w + 3;
    const float sign = beams.backwards ? -1.0F : 1.0F;
    // The plane's own w at the box's end that lets most through.
    const auto lets_through = [&](const BlockBeam::Plane& plane, bool upper, std::size_t box_row) HWY_ATTR {
        const bool far_end = (plane.slope >= 0.0F) == upper;
        const Row w = load(node.planes[far_end ? far_row : near_row]);
        const Row edge = multiply_add(fill(sign * plane.slope), w, fill(plane.offset));
        const Row box = load(node.planes[box_row]);
        return upper ? box <= edge : edge <= box;
    };
    const RowMask u =
        lets_through(beams.block.upper_u, true, beams.u) & lets_through(beams.block.lower_u, false, beams.u + 3);
    const RowMask v =
        lets_through(beams.block.upper_v, true, beams.v) & lets_through(beams.block.lower_v, false, beams.v + 3);
    const Row end = load(node.planes[far_row]);
    const RowMask ahead = beams.backwards ? end <= fill(-beams.start) : fill(beams.start) <= end;
    return (u & v & ahead).bits();
}

/// The strata some ray of which may pass the child's box.
HWY_INLINE unsigned strata_in_beam(const WideNode& node, std::size_t child, const Beams& beams) {
    const auto plane = [&](std::size_t row) { return node.planes[row][child]; };
    const Row near_end = fill(beams.backwards ? -plane(beams.w + 3) : plane(beams.w));
    const Row far_end = fill(beams.backwards ? -plane(beams.w) : plane(beams.w + 3));
    const auto below = [&](const BeamPlane& upper, std::size_t axis) HWY_ATTR {
        return fill(plane(axis)) <= max(upper.slope * near_end, upper.slope * far_end) + upper.offset;
    };
    const auto above = [&](const BeamPlane& lower, std::size_t axis) HWY_ATTR {
        return min(lower.slope * near_end, lower.slope * far_end) + lower.offset <= fill(plane(axis + 3));
    };
    return (below(beams.strata.upper_u, beams.u) & above(beams.strata.lower_u, beams.u) &
            below(beams.strata.upper_v, beams.v) & above(beams.strata.lower_v, beams.v))
        .bits();
}
