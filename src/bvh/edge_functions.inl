// The part of the watertight test that runs for every triangle. No include guard and no namespace: it is included once
// for floats and once for each vector width (functions on vectors must be defined where their instruction set is
// chosen). T is float, double, or a vector with + − * that round as these do.

/// The corners of a triangle as seen along the ray, which is the origin of this plane.
template<class T>
struct ShearedTriangle {
    T ax, ay, bx, by, cx, cy;
};

/// A corner relative to the ray's origin, moved along z into the plane through that origin.
template<class T>
inline T shear(T offset, T slope, T depth) {
    return offset - slope * depth;
}

/// Twice the signed areas that the ray makes with each side. A sign is never wrong: rounding is monotone, so all that
/// it can do is turn a sign into 0. Two triangles that share a side get the same bits for it but for the sign.
template<class T>
struct EdgeFunctions {
    T u, v, w;

    explicit EdgeFunctions(const ShearedTriangle<T>& t)
        : u(t.cx * t.by - t.cy * t.bx), v(t.ax * t.cy - t.ay * t.cx), w(t.bx * t.ay - t.by * t.ax) {}
};
