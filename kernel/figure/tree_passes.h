// SPDX-License-Identifier: MIT
// Impulses go up a tree, and changes of twists come down: what a whole figure answers to impulses on its bodies, exact, with a visit a body each way.
//
//     child b on parent a:  u_b = X u_a + bias + S dq       X u_a: twist_at(u_a, d);  S: free directions, dq: rates along them
//     M u_b = P_b + what the joint gives,  S . (M u_b - P_b) = drive
//
// so, a free direction s after the other, with the inertia M of b and of all that hangs on it:
//
//     pulled = M s;  D = s . pulled;  t = (s . P + drive) / D;  P' = P - pulled t;  M' = M - pulled pulled^T / D        (up)
//     sent to a: P' - M' bias;  inertia seen from a: X^T M' X
//     dq = t - pulled . u / D;  u += s dq                                                                              (down, in the other order)
//
// A ball joint has its three turns eliminated at once: A w + B v = P.w + drive; one after the other if it is driven. Drives that give way,
// drive = pull - R dq, have D + R for D.
// Sources: Featherstone 2008, chapter 7 (articulated-body inertia); in impulses Mirtich 1996. In maximal coordinates, with the gap as bias, Baraff,
// "Linear-time dynamics using Lagrange multipliers", SIGGRAPH 1996.
#pragma once

#include "figure_view.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Free directions of a joint that is no ball, twists of the child against its parent. Returns how many.
template <class At, class T = typename At::T>
INGOT_INLINE int free_directions(const At& at, const FigureRow<At::width>& row, JointKind kind, Spatial<T> (&s)[3]) {
    kind = At::Kinds::of(kind);
    const Vec3<T> none{};
    switch (kind) {
        case JointKind::hinge: s[0] = Spatial<T>{read(at, row.axis), none}; return 1;
        case JointKind::slider: s[0] = Spatial<T>{none, read(at, row.axis_of_parent)}; return 1;
        case JointKind::universal:
            s[0] = Spatial<T>{read(at, row.axis_of_parent), none};
            s[1] = Spatial<T>{read(at, row.axis), none};
            return 2;
        case JointKind::driven_ball:
            s[0] = Spatial<T>{Vec3<T>{splat<T>(1), none.y, none.z}, none};
            s[1] = Spatial<T>{Vec3<T>{none.x, splat<T>(1), none.z}, none};
            s[2] = Spatial<T>{Vec3<T>{none.x, none.y, splat<T>(1)}, none};
            return 3;
        default: break;
    }
    if (!is_wheel(kind)) return 0;
    const bool of_A = kind == JointKind::carriage;
    const Vec3<T> along = read(at, of_A ? row.axis : row.axis_of_parent);
    s[0] = Spatial<T>{read(at, of_A ? row.axis_of_parent : row.axis), none};
    s[1] = Spatial<T>{none, along};
    s[2] = Spatial<T>{along, none};
    return 3;
}

/// Of an impulse or a twist, without what is along free directions.
template <class At, class T = typename At::T>
INGOT_INLINE Spatial<T> locked_part(const At& at, const FigureRow<At::width>& row, JointKind kind, const Spatial<T>& f) {
    kind = At::Kinds::of(kind);
    switch (kind) {
        case JointKind::ball:
        case JointKind::driven_ball: return {Vec3<T>{}, f.v};
        case JointKind::hinge: {
            const Vec3<T> n = read(at, row.axis);
            return {f.w - n * dot(n, f.w), f.v};
        }
        case JointKind::slider: {
            const Vec3<T> n = read(at, row.axis_of_parent);
            return {f.w, f.v - n * dot(n, f.v)};
        }
        case JointKind::universal: {
            const Vec3<T> x = cross(read(at, row.axis_of_parent), read(at, row.axis));
            return {x * (dot(x, f.w) / length_sq(x)), f.v};
        }
        case JointKind::wheel:
        case JointKind::carriage: {
            const Vec3<T> along = read(at, kind == JointKind::carriage ? row.axis : row.axis_of_parent);
            const Vec3<T> x = cross(read(at, row.axis_of_parent), read(at, row.axis));
            return {x * (dot(x, f.w) / length_sq(x)), f.v - along * dot(along, f.v)};
        }
        default: return f;
    }
}

/// True of bodies whose turns are eliminated at once: at a ball joint, and roots of what floats.
inline bool turns_freely(JointKind kind) { return kind == JointKind::ball || kind == JointKind::none; }

// The free directions of hinges and of driven ball joints are turns, the latter about the axes of the world: there is nothing along v, so less is
// multiplied than for other kinds.

/// What goes on to the parent of an impulse on a child, and of drives, both taken at q of the child.
template <class At, class T = typename At::T>
INGOT_INLINE Spatial<T> impulse_through(const At& at, const FigureRow<At::width>& row, JointKind kind, Spatial<T> P, const Vec3<T>& drive) {
    kind = At::Kinds::of(kind);
    if (kind == JointKind::ball) return {-drive, P.v - transpose_times(read(at, row.inertia.B), P.w + drive)};
    if (kind == JointKind::hinge)
        return P - read(at, row.pulled[0]) * ((dot(read(at, row.axis), P.w) + drive.x) * at.get(row.inv_D[0]));
    if (kind == JointKind::driven_ball) {
        P = P - read(at, row.pulled[0]) * ((P.w.x + drive.x) * at.get(row.inv_D[0]));
        P = P - read(at, row.pulled[1]) * ((P.w.y + drive.y) * at.get(row.inv_D[1]));
        return P - read(at, row.pulled[2]) * ((P.w.z + drive.z) * at.get(row.inv_D[2]));
    }
    const T along[3] = {drive.x, drive.y, drive.z};
    Spatial<T> s[3];
    const int free = free_directions(at, row, kind, s);
    for (int i = 0; i < free; ++i)  // bound: 3
        P = P - read(at, row.pulled[i]) * ((dot(s[i], P) + along[i]) * at.get(row.inv_D[i]));
    return P;
}
/// What a child sends to its parent.
template <class At, class T = typename At::T>
INGOT_INLINE Spatial<T> impulse_to_send(const At& at, const FigureRow<At::width>& row, JointKind kind) {
    kind = At::Kinds::of(kind);
    const Spatial<T> through = impulse_through(at, row, kind, read(at, row.impulse), read(at, row.drive)), bias = read(at, row.bias);
    if (kind == JointKind::ball) return {through.w, through.v - read(at, row.inertia.C) * bias.v};
    return through - read(at, row.inertia) * bias;
}

/// The twist of a child whose joint would leave it u: with what P, on it and what hangs on it, and drives make of its free directions.
template <class At, class T = typename At::T>
INGOT_INLINE Spatial<T> twist_through(const At& at, const FigureRow<At::width>& row, JointKind kind, Spatial<T> u, Spatial<T> P,
                                      const Vec3<T>& drive) {
    kind = At::Kinds::of(kind);
    if (kind == JointKind::ball) return {read(at, row.inertia.A) * (P.w + drive) - read(at, row.inertia.B) * u.v, u.v};
    if (kind == JointKind::hinge) {
        const Vec3<T> n = read(at, row.axis);
        const T t = (dot(n, P.w) + drive.x) * at.get(row.inv_D[0]);
        return {u.w + n * (t - dot(read(at, row.pulled[0]), u) * at.get(row.inv_D[0])), u.v};
    }
    if (kind == JointKind::driven_ball) {
        const Spatial<T> x = read(at, row.pulled[0]), y = read(at, row.pulled[1]), z = read(at, row.pulled[2]);
        const T i_x = at.get(row.inv_D[0]), i_y = at.get(row.inv_D[1]), i_z = at.get(row.inv_D[2]);
        const T t_x = (P.w.x + drive.x) * i_x;
        P.w = P.w - x.w * t_x;
        const T t_y = (P.w.y + drive.y) * i_y, t_z = ((P.w.z - y.w.z * t_y) + drive.z) * i_z;
        u.w.z = u.w.z + (t_z - dot(z, u) * i_z);
        u.w.y = u.w.y + (t_y - dot(y, u) * i_y);
        u.w.x = u.w.x + (t_x - dot(x, u) * i_x);
        return u;
    }
    const T along[3] = {drive.x, drive.y, drive.z};
    Spatial<T> s[3];
    T t[3];
    const int free = free_directions(at, row, kind, s);
    for (int i = 0; i < free; ++i) {  // bound: 3
        t[i] = (dot(s[i], P) + along[i]) * at.get(row.inv_D[i]);
        P = P - read(at, row.pulled[i]) * t[i];
    }
    for (int i = free - 1; i >= 0; --i) u = u + s[i] * (t[i] - dot(read(at, row.pulled[i]), u) * at.get(row.inv_D[i]));  // bound: 3
    return u;
}
/// The change of a child's twist; of_parent: that of its parent, at the child's q.
template <class At, class T = typename At::T>
INGOT_INLINE Spatial<T> change_of_child(const At& at, const FigureRow<At::width>& row, JointKind kind, const Spatial<T>& of_parent) {
    return twist_through(at, row, kind, of_parent + read(at, row.bias), read(at, row.impulse), read(at, row.drive));
}

/// The change of the parent's twist, at q of the row; none of the ground's.
template <unsigned width, class Kinds, class At, class T = typename At::T>
INGOT_INLINE Spatial<T> change_of_parent(const FigureRows<width, Kinds>& rows, const At& at, int row_i) {
    const Index parent = rows.node(row_i).parent;
    return parent == no_node ? Spatial<T>{} : twist_at(read(at, rows[parent].change), read(at, rows[row_i].d));
}

/// Of the root of what floats: nothing holds it.
template <class At, class T = typename At::T>
INGOT_INLINE Spatial<T> twist_of_floating(const At& at, const FigureRow<At::width>& row) {
    const Spatial<T> P = read(at, row.impulse);
    const Spatial6<T> M = read(at, row.inertia);
    Spatial<T> u;
    u.v = M.C * (P.v - transpose_times(M.B, P.w));
    u.w = M.A * P.w - M.B * u.v;
    return u;
}

/// The whole way up: `impulse` of each body comes in, that of it and what hangs on it goes out. Rows of which
/// knows(row_i) is true hand on what they did the last time.
template <unsigned width, class Kinds, class Knows>
void pass_up(const FigureRows<width, Kinds>& rows, const Knows& knows) {
    for (int row_i = rows.count() - 1; row_i >= 0; --row_i) {  // bound: max_bodies
        const JointKind kind = rows.kind(row_i);
        if (kind == JointKind::none) continue;
        FigureRow<width>& row = rows[row_i];
        if (!knows(row_i)) write(rows.all, row.sent, impulse_to_send(rows.all, row, kind));
        const auto sent = read(rows.all, row.sent);
        const Index parent_i = rows.node(row_i).parent;
        if (parent_i == no_node) continue;
        FigureRow<width>& parent = rows[parent_i];
        write(rows.all, parent.impulse, read(rows.all, parent.impulse) + impulse_from(sent, read(rows.all, row.d)));
    }
}

template <unsigned width, class Kinds>
void pass_up(const FigureRows<width, Kinds>& rows) {
    pass_up(rows, [](int) { return false; });
}

/// The way down, to the first `count` rows.
template <unsigned width, class Kinds>
void pass_down(const FigureRows<width, Kinds>& rows, int count) {
    for (int row_i = 0; row_i < count; ++row_i) {  // bound: max_bodies
        const JointKind kind = rows.kind(row_i);
        FigureRow<width>& row = rows[row_i];
        if (kind == JointKind::none) {
            write(rows.all, row.change, twist_of_floating(rows.all, row));
            continue;
        }
        write(rows.all, row.change, change_of_child(rows.all, row, kind, change_of_parent(rows, rows.all, row_i)));
    }
}
/// The whole way down.
template <unsigned width, class Kinds>
void pass_down(const FigureRows<width, Kinds>& rows) {
    pass_down(rows, rows.count());
}

} }  // namespace ingot

#pragma GCC diagnostic pop
