// What is computed once for the rays of a block. No include guard: see row.inl, which must come first.

/// See PreparedRay for what these are and why boxes are padded. Here a plane's distance is plane · inverse − offset,
/// rounded at most as often as there, and the pad is that of the block's largest extent.
struct BlockRays {
    using LaneRow = RayBlock::LaneRow;
    template<class T>
    using EachStratum = std::array<T, RayBlock::strata>;

    alignas(64) EachStratum<std::array<LaneRow, 3>> inverse;
    alignas(64) EachStratum<std::array<LaneRow, 6>> offset; ///< of the low planes of boxes, then of the high ones
    alignas(64) EachStratum<std::array<LaneRow, 2>> turned_shear;
    alignas(64) EachStratum<LaneRow> sure_depth;
    alignas(64) EachStratum<LaneRow> futile_depth;
    alignas(64) EachStratum<std::array<std::uint32_t, RayBlock::lanes>> course; ///< see below
    EachStratum<RayBlock::LaneBits> alive;                                      ///< valid and not yet blocked
    bool limited;                                                               ///< there is a greatest distance
    float pad;
    float sure_sum; ///< see test_corners
};

// A ray's course: a bit for each negative component of its direction, then twice the axis of the largest one, and one
// more where that is negative.
constexpr int course_axis_shift = 3;

// What a ray's course says, by tables: which way a ray runs cannot be foretold any better than what it meets.

/// The rows of a node's planes by which a ray enters boxes and by which it leaves them, axis by axis: one that runs
/// downwards enters by the high plane. Both stand here: to work one out from the other takes longer than to load it.
struct BoxRows {
    std::array<std::uint8_t, 3> near, far;
};
constexpr std::array<BoxRows, 8> box_rows_of_courses{{{{0, 1, 2}, {3, 4, 5}},
                                                      {{3, 1, 2}, {0, 4, 5}},
                                                      {{0, 4, 2}, {3, 1, 5}},
                                                      {{3, 4, 2}, {0, 1, 5}},
                                                      {{0, 1, 5}, {3, 4, 2}},
                                                      {{3, 1, 5}, {0, 4, 2}},
                                                      {{0, 4, 5}, {3, 1, 2}},
                                                      {{3, 4, 5}, {0, 1, 2}}}};
[[nodiscard]] HWY_INLINE const BoxRows& box_rows_of(std::uint32_t course) { return box_rows_of_courses[course & 7U]; }

/// The axes of ShearedRay, and the sign of the largest component.
struct CourseAxes {
    LeafAxes leaf;
    float sign;
};
constexpr std::array<CourseAxes, 6> axes_of_courses{{{{1, 2, 0}, 1.0F},
                                                     {{2, 1, 0}, -1.0F},
                                                     {{2, 0, 1}, 1.0F},
                                                     {{0, 2, 1}, -1.0F},
                                                     {{0, 1, 2}, 1.0F},
                                                     {{1, 0, 2}, -1.0F}}};
[[nodiscard]] HWY_INLINE const CourseAxes& axes_of(std::uint32_t course) {
    return axes_of_courses[course >> course_axis_shift];
}

HWY_INLINE void store_course(const Row* direction, const RowMask& along_x, const RowMask& along_y,
                             std::array<std::uint32_t, RayBlock::lanes>& course) {
    const hn::RebindToUnsigned<Lanes> lanes;
    for (std::size_t p = 0; p < part_count; ++p) {
        const auto sign = [&](std::size_t axis)
                              HWY_ATTR { return hn::ShiftRight<31>(hn::BitCast(lanes, direction[axis].part[p])); };
        const auto axis_bits = [&](std::uint32_t axis) HWY_ATTR {
            return hn::Or(hn::Set(lanes, 2 * axis << course_axis_shift), hn::ShiftLeft<course_axis_shift>(sign(axis)));
        };
        const auto axis =
            hn::IfThenElse(hn::RebindMask(lanes, along_x.part[p]), axis_bits(0),
                           hn::IfThenElse(hn::RebindMask(lanes, along_y.part[p]), axis_bits(1), axis_bits(2)));
        const auto signs = hn::Or(sign(0), hn::Or(hn::ShiftLeft<1>(sign(1)), hn::ShiftLeft<2>(sign(2))));
        hn::Store(hn::Or(signs, axis), lanes, course.data() + p * part_size);
    }
}

/// Greatest distance along an axis from an origin to anything, or from 0 to an origin.
HWY_INLINE float extent_of(const RayBlock& block, const Box& bounds) {
    Row extent = fill(0.0F);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<int>(axis);
        const Row origin = load(block.origin[axis]);
        extent =
            max(extent, max(abs(origin), max(abs(fill(bounds.low[a]) - origin), abs(fill(bounds.high[a]) - origin))));
    }
    return greatest_lane(extent);
}

HWY_INLINE void prepare_stratum(const RayBlock& block, std::size_t stratum, const std::array<Row, 3>& low_origin,
                                const std::array<Row, 3>& high_origin, BlockRays& rays) {
    const auto& direction = block.direction[stratum];
    const Row d[3] = {load(direction[0]), load(direction[1]), load(direction[2])}; // NOLINT(modernize-avoid-c-arrays)
    const Row x = abs(d[0]);
    const Row y = abs(d[1]);
    const Row z = abs(d[2]);
    const Row length = max(x, max(y, z));
    const RowMask along_x = x == length;
    const RowMask along_y = y == length;

    // What is not finite, or not in bounds, fails a comparison.
    const RowMask valid = (fill(least_direction) <= length) & (length <= fill(greatest_direction)) & (x <= length) &
                          (y <= length) & (z <= length);
    rays.alive[stratum] = static_cast<RayBlock::LaneBits>(valid.bits() & block.active[stratum]);

    const Row one = fill(1.0F);
    const Row least = length * fill(least_slope);
    Row inverse[3]; // NOLINT(modernize-avoid-c-arrays)
    for (std::size_t axis = 0; axis < 3; ++axis) {
        inverse[axis] = one / copy_sign(max(abs(d[axis]), least), d[axis]);
        store(inverse[axis], rays.inverse[stratum][axis]);
        store(low_origin[axis] * inverse[axis], rays.offset[stratum][axis]);
        store(high_origin[axis] * inverse[axis], rays.offset[stratum][axis + 3]);
    }

    // The axes of ShearedRay: next and last follow the largest in turn, and change places where that is negative.
    const Row largest = select(along_x, d[0], select(along_y, d[1], d[2]));
    const Row next = select(along_x, d[1], select(along_y, d[2], d[0]));
    const Row last = select(along_x, d[2], select(along_y, d[0], d[1]));
    const Row zero = fill(0.0F);
    const RowMask negative = largest < zero;
    const Row turned = abs(largest);
    const Row slope =
        abs(select(along_x, inverse[0],
                   select(along_y, inverse[1], inverse[2]))); // p · |1 / z| = sign · (p · (1 / z)), to the bit
    store(select(negative, last, next) * slope, rays.turned_shear[stratum][0]);
    store(select(negative, next, last) * slope, rays.turned_shear[stratum][1]);
    if (rays.limited) {
        const Row depth = fill(block.max_distance) * turned;
        store(depth * fill(nearly_one), rays.sure_depth[stratum]);
        store(depth * fill(just_over_one), rays.futile_depth[stratum]);
    }
    store_course(d, along_x, along_y, rays.course[stratum]);
}

HWY_INLINE void prepare_rays(const RayBlock& block, const Box& bounds, BlockRays& rays) {
    const float extent = extent_of(block, bounds);
    rays.pad = padding_of(extent);
    rays.sure_sum = sure_sum_of(extent);
    rays.limited = block.max_distance < std::numeric_limits<float>::infinity();
    std::array<Row, 3> low_origin;
    std::array<Row, 3> high_origin;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        low_origin[axis] = load(block.origin[axis]) + fill(rays.pad);
        high_origin[axis] = load(block.origin[axis]) - fill(rays.pad);
    }
    for (std::size_t stratum = 0; stratum < RayBlock::strata; ++stratum) {
        if (block.active[stratum] == 0) {
            rays.alive[stratum] = 0;
        } else {
            prepare_stratum(block, stratum, low_origin, high_origin, rays);
        }
    }
}
