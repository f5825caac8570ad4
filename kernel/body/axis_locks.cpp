// SPDX-License-Identifier: MIT
#include "axis_locks.h"

#include "../base/limits.h"
#include "turning_laws.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool has_axis(unsigned axes, int axis) { return (axes >> axis & 1u) != 0; }
int locked_count(unsigned axes) { return static_cast<int>((axes & 1u) + (axes >> 1 & 1u) + (axes >> 2 & 1u)); }
/// The one axis that is free, or locked, of two that are not.
int only_axis(unsigned axes) { return has_axis(axes, 0) ? 0 : has_axis(axes, 1) ? 1 : 2; }

scalar along_axis(const Vector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
void set_along_axis(Vector& v, int axis, scalar value) { (axis == 0 ? v.x : axis == 1 ? v.y : v.z) = value; }
/// Of a symmetric matrix: an entry of the diagonal, and the one of the two axes across.
scalar& entry_on_axis(SymmetricMatrix& m, int axis) { return axis == 0 ? m.xx : axis == 1 ? m.yy : m.zz; }
scalar& entry_across_axis(SymmetricMatrix& m, int axis) { return axis == 0 ? m.yz : axis == 1 ? m.xz : m.xy; }

Vector row_of_axis(const Matrix& A, int axis) { return {along_axis(A.c0, axis), along_axis(A.c1, axis), along_axis(A.c2, axis)}; }
void set_row_of_axis(Matrix& A, int axis, const Vector& row) {
    set_along_axis(A.c0, axis, row.x);
    set_along_axis(A.c1, axis, row.y);
    set_along_axis(A.c2, axis, row.z);
}

/// Rows across an axis at right angles to its own and to each other; that of the axis keeps its bits.
void square_rows(Matrix& A, int axis) {
    const Vector along = row_of_axis(A, axis);
    Vector first = row_of_axis(A, (axis + 1) % 3);
    first = first - along * dot(along, first);
    first = first * (1 / sqrt(length_sq(first)));
    set_row_of_axis(A, (axis + 1) % 3, first);
    set_row_of_axis(A, (axis + 2) % 3, cross(along, first));
}

/// Turned about an axis of the world.
Matrix turned_about_axis(const Matrix& A, int axis, scalar angle) {
    if (angle == 0) return A;
    const SinCos of = sin_cos(clamp(angle, scalar(1000)));
    const Vector first = row_of_axis(A, (axis + 1) % 3), second = row_of_axis(A, (axis + 2) % 3);
    Matrix turned = A;
    set_row_of_axis(turned, (axis + 1) % 3, first * of.cos - second * of.sin);
    set_row_of_axis(turned, (axis + 2) % 3, first * of.sin + second * of.cos);
    square_rows(turned, axis);
    return turned;
}

/// Turned by a vector in world axes, to the fifth order of its angle.
Matrix turned_by_vector(const Matrix& A, const Vector& u) { return turned_about(A, u * (1 + length_sq(u) / 12)); }

/// A' = tilde(W(A) L) A, in parts that are as long as the spin of the moment lets them be: it is several times as large where the long axis of a
/// slender body comes into the plane of the free axes. Runge and Kutta's method on the rotation vector u of a part, of fourth order: what the return
/// of energy has to make up for, and cannot where no turn changes it, is of the fifth of the angle. Source: Munthe-Kaas 1998, dexp^-1 to its second
/// term.
Matrix turned_about_two(const Matrix& begin, const LockedInertia& inertia, const Vector& L, scalar h, scalar twice_energy) {
    Matrix A = begin;
    const scalar forth = h < 0 ? scalar(-1) : scalar(1);
    scalar left = h * forth;
    const auto rate = [&](const Vector& u) {
        const Vector omega = inertia.spin(turned_by_vector(A, u), L), x = cross(u, omega);
        return omega - x * scalar(0.5) + cross(u, x) * (scalar(1) / 12);
    };
    for (int parts_left = limits::locked_parts_max; parts_left > 0 && left > 0; --parts_left) {  // bound: limits::locked_parts_max
        const Vector k_1 = inertia.spin(A, L);
        const scalar part_sq = limits::locked_turn_of_part * limits::locked_turn_of_part, turn_sq = length_sq(k_1) * left * left;
        const scalar part = parts_left > 1 && turn_sq > part_sq ? left * sqrt(part_sq / turn_sq) : left, step = part * forth;
        const Vector k_2 = rate(k_1 * (step / 2)), k_3 = rate(k_2 * (step / 2)), k_4 = rate(k_3 * step);
        const Vector u = (k_1 + (k_2 + k_3) * scalar(2) + k_4) * (step / 6);
        A = turning::return_energy(inertia, turned_by_vector(A, u), L, twice_energy);
        left -= part;
    }
    return A;
}

}  // namespace

SymmetricMatrix inverse_inertia_of_free(const Matrix& A, const Vector& inv_I_body, unsigned axes) {
    if (axes == 0) return inverse_inertia_world(A, inv_I_body);
    SymmetricMatrix W = {};
    const scalar least = min(inv_I_body.x, min(inv_I_body.y, inv_I_body.z));
    if (axes == 7 || !(least > 0)) return W;
    const Vector n = {least / inv_I_body.x, least / inv_I_body.y, least / inv_I_body.z};  // moments over the largest
    SymmetricMatrix N = rotated_diagonal(A, n);
    if (locked_count(axes) == 2) {
        const int free = only_axis(~axes & 7u);
        entry_on_axis(W, free) = least / entry_on_axis(N, free);
        return W;
    }
    const int locked = only_axis(axes), i = (locked + 1) % 3, k = (locked + 2) % 3;
    const Vector a = row_of_axis(A, locked);
    const scalar inv_det = least / (n.y * n.z * (a.x * a.x) + n.x * n.z * (a.y * a.y) + n.x * n.y * (a.z * a.z));
    entry_on_axis(W, i) = entry_on_axis(N, k) * inv_det;
    entry_on_axis(W, k) = entry_on_axis(N, i) * inv_det;
    entry_across_axis(W, locked) = -entry_across_axis(N, locked) * inv_det;
    return W;
}

Vector LockedInertia::spin(const Matrix& A, const Vector& L) const {
    return axes == 0 ? spin_of(A, inv_I_body, L) : inverse_inertia_of_free(A, inv_I_body, axes) * L;
}

Vector LockedInertia::momentum(const Matrix& A, const Vector& omega) const {
    return angular_momentum_of_spin(A, {1 / inv_I_body.x, 1 / inv_I_body.y, 1 / inv_I_body.z}, omega);
}

Vector LockedInertia::slope(const Matrix& A, const Vector& omega, const Vector& L, scalar scale) const {
    return axes == 0 ? cross(omega, L * scale) : free_part(cross(omega, momentum(A, omega) * scale), axes);
}

LockedInertia locked_inertia_of(const BodyView& bodies, int slot, unsigned locks) {
    const RotationTile& tile = bodies.rotation[place_of(slot).tile];
    const int lane_i = place_of(slot).lane;
    return {lane_of(tile.inv_I_ratio, lane_i) * tile.inv_I_scale[lane_i], rotations_locked(locks)};
}

void hold_motion(const BodyView& bodies, int slot, unsigned locks) {
    const Place at = place_of(slot);
    if (bodies.translation != nullptr) {
        auto& v_CM = bodies.translation[at.tile].v_CM;
        set_lane(v_CM, at.lane, free_part(lane_of(v_CM, at.lane), translations_locked(locks)));
    }
    const LockedInertia inertia = locked_inertia_of(bodies, slot, locks);
    if (inertia.axes == 0 || !is_dynamic(bodies, slot)) return;
    auto& rows = bodies.rotation[at.tile].L;
    const Vector L = lane_of(rows, at.lane);
    if (inertia.axes == 7) return set_lane(rows, at.lane, Vector{});
    const Matrix A = lane_of(bodies.rotation[at.tile].A, at.lane);
    const Vector whole = inertia.momentum(A, inertia.spin(A, L)) + Vector{};  // -0 becomes +0: one value, one set of bits
    set_lane(rows, at.lane, free_part_or(L, whole, inertia.axes));
}

void hold_forces(const BodyView& bodies, int slot, unsigned locks, const Vector& gravity) {
    const Place at = place_of(slot);
    auto& tau_T = bodies.rotation[at.tile].tau_T;
    set_lane(tau_T, at.lane, free_part(lane_of(tau_T, at.lane), rotations_locked(locks)));
    if (bodies.translation == nullptr) return;
    TranslationTile& tile = bodies.translation[at.tile];
    const scalar inv_M = tile.inv_M[at.lane];
    if (!(inv_M > 0)) return;
    const Vector borne = gravity * (-1 / inv_M) + Vector{};
    set_lane(tile.F_T, at.lane, free_part_or(lane_of(tile.F_T, at.lane), borne, translations_locked(locks)));
}

Matrix turned_with_locks(const Matrix& A, const LockedInertia& inertia, const Vector& L, scalar h) {
    if (inertia.axes == 7) return A;
    const Vector omega = inertia.spin(A, L);
    if (locked_count(inertia.axes) == 2) {
        const int axis = only_axis(~inertia.axes & 7u);
        return turned_about_axis(A, axis, along_axis(omega, axis) * h);
    }
    if (omega.x == 0 && omega.y == 0 && omega.z == 0) return A;
    return turned_about_two(A, inertia, L, h, dot(L, omega));
}

Matrix hold_attitude(const Matrix& before, const Matrix& A, unsigned axes) {
    if (axes == 7) return before;
    if (locked_count(axes) != 2) return A;
    const int axis = only_axis(~axes & 7u);
    Matrix held = A;
    const Vector row = row_of_axis(before, axis), now = row_of_axis(A, axis);
    if (row.x == now.x && row.y == now.y && row.z == now.z) return A;
    set_row_of_axis(held, axis, row);
    square_rows(held, axis);
    return held;
}

} }  // namespace ingot
