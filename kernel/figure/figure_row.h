// SPDX-License-Identifier: MIT
// What the solver knows of one body of a figure in a substep; of `lanes` bodies at once, where as many figures of one form are solved side by side.
#pragma once

#include "../base/if.h"
#include "../joint/joints.h"
#include "spatial.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Kinds of joints that a stage is compiled for: any, or for scenes that name hinges alone those, in a third less of code.
struct AnyKinds {
    static constexpr JointKind of(JointKind kind) { return kind; }
};
struct HingesAlone {
    static constexpr JointKind of(JointKind kind) { return kind == JointKind::none ? JointKind::none : JointKind::hinge; }
};

/// Whole rows, `width` bodies at once.
template <unsigned width_of_rows, class KindsOfJoints = AnyKinds>
struct AllLanes {
    static constexpr unsigned width = width_of_rows;
    using Kinds = KindsOfJoints;
    using T = If<width == 1, scalar, lane>;

    INGOT_INLINE T get(const scalar (&from)[width]) const {
        if constexpr (width == 1)
            return from[0];
        else
            return load(from);
    }
    INGOT_INLINE void put(scalar (&to)[width], T value) const {
        if constexpr (width == 1)
            to[0] = value;
        else
            store(to, value);
    }
};
/// One body of a row.
template <unsigned width_of_rows>
struct OneLane {
    static constexpr unsigned width = width_of_rows;
    using Kinds = AnyKinds;
    using T = scalar;
    int lane_i;

    INGOT_INLINE T get(const scalar (&from)[width]) const { return from[lane_i]; }
    INGOT_INLINE void put(scalar (&to)[width], T value) const { to[lane_i] = value; }
};

// The numbers of a row as `at` sees them: AllLanes or OneLane.
template <class At, class T = typename At::T>
INGOT_INLINE Vec3<T> read(const At& at, const scalar (&from)[3][At::width]) {
    return {at.get(from[0]), at.get(from[1]), at.get(from[2])};
}
template <class At, class T>
INGOT_INLINE void write(const At& at, scalar (&to)[3][At::width], const Vec3<T>& value) {
    at.put(to[0], value.x);
    at.put(to[1], value.y);
    at.put(to[2], value.z);
}
template <class At, class T = typename At::T>
INGOT_INLINE Sym3<T> read(const At& at, const scalar (&from)[6][At::width]) {
    return {at.get(from[0]), at.get(from[1]), at.get(from[2]), at.get(from[3]), at.get(from[4]), at.get(from[5])};
}
template <class At, class T>
INGOT_INLINE void write(const At& at, scalar (&to)[6][At::width], const Sym3<T>& value) {
    at.put(to[0], value.xx);
    at.put(to[1], value.yy);
    at.put(to[2], value.zz);
    at.put(to[3], value.xy);
    at.put(to[4], value.xz);
    at.put(to[5], value.yz);
}
template <class At, class T = typename At::T>
INGOT_INLINE Mat3<T> read(const At& at, const scalar (&from)[9][At::width]) {
    return {{at.get(from[0]), at.get(from[1]), at.get(from[2])},
            {at.get(from[3]), at.get(from[4]), at.get(from[5])},
            {at.get(from[6]), at.get(from[7]), at.get(from[8])}};
}
template <class At, class T>
INGOT_INLINE void write(const At& at, scalar (&to)[9][At::width], const Mat3<T>& value) {
    const Vec3<T> columns[3] = {value.c0, value.c1, value.c2};
    for (int i = 0; i < 3; ++i) {
        at.put(to[3 * i], columns[i].x);
        at.put(to[3 * i + 1], columns[i].y);
        at.put(to[3 * i + 2], columns[i].z);
    }
}

/// Numbers of six as rows keep them.
template <unsigned width>
struct SpatialRows {
    scalar w[3][width], v[3][width];
};
template <class At, class T = typename At::T>
INGOT_INLINE Spatial<T> read(const At& at, const SpatialRows<At::width>& from) {
    return {read(at, from.w), read(at, from.v)};
}
template <class At, class T>
INGOT_INLINE void write(const At& at, SpatialRows<At::width>& to, const Spatial<T>& value) {
    write(at, to.w, value.w);
    write(at, to.v, value.v);
}
template <unsigned width>
struct Spatial6Rows {
    scalar A[6][width], B[9][width], C[6][width];
};
template <class At, class T = typename At::T>
INGOT_INLINE Spatial6<T> read(const At& at, const Spatial6Rows<At::width>& from) {
    return {read(at, from.A), read(at, from.B), read(at, from.C)};
}
template <class At, class T>
INGOT_INLINE void write(const At& at, Spatial6Rows<At::width>& to, const Spatial6<T>& value) {
    write(at, to.A, value.A);
    write(at, to.B, value.B);
    write(at, to.C, value.C);
}

/// A body of a figure. Twists and impulses are taken at q, where its own joint is, the one towards the root, of a wheel on its axle; those of a
/// floating root at its centre of mass.
template <unsigned width>
struct FigureRow {
    // Of the body. Centre of mass, orientation and motion go along in the substeps.
    scalar r[3][width], A[9][width];         ///< m; body to world
    scalar v[3][width], L[3][width];         ///< m/s, kg m^2/s: as in the tiles
    scalar w[3][width];                      ///< rad/s, as the solve begins
    scalar M[width], I_body[3][width];       ///< kg, kg m^2
    scalar turn[3][width];                   ///< rad, in this substep, if nothing acted any more
    scalar turned[3][width];                 ///< rad, since the step began
    // Of its joint.
    scalar c[3][width];                      ///< m, from q to the centre of mass
    scalar d[3][width];                      ///< m, from q of the parent to q
    scalar arm_of_parent[3][width];          ///< m, from the parent's centre of mass to its side of the joint
    scalar axis[3][width], axis_of_parent[3][width];  ///< of the joint, as either side has it
    scalar j[3][width];                      ///< N s, that the joint gave to this body in the last substep
    // Its inertia with all that hangs on it; and, once factored, what is left of that where the joint is free.
    Spatial6Rows<width> inertia;             ///< of a ball joint A^-1, A^-1 B and C - B^T A^-1 B of it; of a floating root, of the last the inverse
    SpatialRows<width> pulled[3];            ///< inertia times each free direction, those before it taken out
    scalar inv_D[3][width];
    // Of the solve.
    SpatialRows<width> bias;                 ///< twist that the joint's locked directions still lack
    SpatialRows<width> impulse, sent;        ///< on it and what hangs on it; what it has handed to its parent of that
    scalar drive[3][width];                  ///< N m s, N s, along free directions
    SpatialRows<width> change;               ///< of its twist, by the solve
};
static_assert(sizeof(FigureRow<lanes>) == lanes * sizeof(FigureRow<1>));
static_assert(sizeof(Spatial6Rows<lanes>) == lanes * sizeof(Spatial6Rows<1>));

} }  // namespace ingot

#pragma GCC diagnostic pop
