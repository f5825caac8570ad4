// SPDX-License-Identifier: MIT
#include "exact_elliptic.h"

#include "elliptic_functions.h"
#include "turn.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

constexpr int gauss_points = 12;
/// Nodes in 0 .. 1 and weights of Gauss and Legendre's rule (the other half mirrors them).
constexpr double gauss_nodes[gauss_points / 2] = {0.125233408511468915, 0.367831498998180194, 0.587317954286617447,
                                                  0.769902674194304687, 0.904117256370474857, 0.981560634246719251};
constexpr double gauss_weights[gauss_points / 2] = {0.249147045813402785, 0.233492536538354809, 0.203167426723065922,
                                                    0.160078328543346226, 0.106939325995318431, 0.0471753363865118272};

/// y = A^T L of a free body as a function of time: Y_x cn, Y_y sn, Y_z dn of p t + a phase. Axes are renamed so that the moments are in order,
/// with z the extreme one about which the momentum circles.
struct Polhode {
    int x, y, z;       ///< which axes of the body these are
    scalar J[3];       ///< inverse moments, renamed
    scalar Y[3];       ///< amplitudes
    scalar p, m, mc;   ///< rate, s^-1; parameter, and 1 less it
    Jacobi begin;

    scalar square_of(int axis, const Jacobi& at) const {
        const scalar value = Y[axis] * (axis == 0 ? at.cn : axis == 1 ? at.sn : at.dn);
        return value * value;
    }
};

scalar axis_of(const Vector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// a / b, or `otherwise` where b is 0.
scalar quotient(scalar a, scalar b, scalar otherwise) { return b != 0 ? a / b : otherwise; }

Polhode polhode_of(const Vector& inv_I_body, const Vector& y_body) {
    int low = 0, middle = 1, high = 2;  // by inverse moment
    const auto swap_if = [&](bool wrong, int& a, int& b) {
        if (!wrong) return;
        const int kept = a;
        a = b;
        b = kept;
    };
    swap_if(axis_of(inv_I_body, low) > axis_of(inv_I_body, middle), low, middle);
    swap_if(axis_of(inv_I_body, middle) > axis_of(inv_I_body, high), middle, high);
    swap_if(axis_of(inv_I_body, low) > axis_of(inv_I_body, middle), low, middle);

    Polhode polhode{};
    const auto J_of = [&](int axis) { return axis_of(inv_I_body, axis); };
    const auto sq = [&](int axis) { return axis_of(y_body, axis) * axis_of(y_body, axis); };
    // L^2 J_middle - 2 E, as a sum without a common part: its sign tells the axis that is circled.
    const scalar about_low = sq(low) * (J_of(middle) - J_of(low)), about_high = sq(high) * (J_of(high) - J_of(middle));
    const bool circles_low = about_low >= about_high;
    polhode.x = circles_low ? high : low;
    polhode.y = middle;
    polhode.z = circles_low ? low : high;
    for (int axis = 0; axis < 3; ++axis) polhode.J[axis] = J_of(axis == 0 ? polhode.x : axis == 1 ? polhode.y : polhode.z);

    const scalar J_xz = polhode.J[0] - polhode.J[2], J_yz = polhode.J[1] - polhode.J[2], J_xy = polhode.J[0] - polhode.J[1];  // of one sign
    const scalar x_sq = sq(polhode.x), y_sq = sq(polhode.y), z_sq = sq(polhode.z);
    const scalar across = x_sq * J_xz + y_sq * J_yz, along = z_sq * J_xz + y_sq * J_xy;
    polhode.p = sqrt(J_yz * along);
    polhode.m = quotient(J_xy * across, J_yz * along, 0);
    polhode.mc = quotient(J_xz * (z_sq * J_yz - x_sq * J_xy), J_yz * along, 1);
    polhode.m = polhode.m < 1 ? polhode.m : 1;
    polhode.mc = polhode.mc > epsilon * epsilon ? (polhode.mc < 1 ? polhode.mc : 1) : epsilon * epsilon;

    const scalar z_sign = axis_of(y_body, polhode.z) < 0 ? scalar(-1) : scalar(1);
    // The sense of the circle: that of the axes, which may be named left-handed, and of the moments.
    const bool right_handed = (polhode.y - polhode.x + 3) % 3 == 1;
    const scalar y_sign = (J_xz > 0) == right_handed ? z_sign : -z_sign;
    polhode.Y[0] = sqrt(quotient(across, J_xz, x_sq));
    polhode.Y[1] = y_sign * sqrt(quotient(across, J_yz, y_sq));
    polhode.Y[2] = z_sign * sqrt(quotient(along, J_xz, z_sq));
    polhode.begin = {quotient(axis_of(y_body, polhode.y), polhode.Y[1], 0), quotient(axis_of(y_body, polhode.x), polhode.Y[0], 1),
                     quotient(axis_of(y_body, polhode.z), polhode.Y[2], 1)};
    return polhode;
}

/// The angle by which axis `reference` of the body turns about L: the integral of (J_a y_a^2 + J_b y_b^2) / (y_a^2 + y_b^2) over the other two,
/// times |L|.
scalar angle_about_L(const Polhode& polhode, const JacobiOf& jacobi, int reference, scalar h) {
    const int a = reference == 0 ? 1 : 0, b = reference == 2 ? 1 : 2;
    const scalar u = polhode.p * h;
    const int pieces = 1 + static_cast<int>(abs(u) * 2);
    const scalar piece = u / static_cast<scalar>(pieces), half_time = h / static_cast<scalar>(2 * pieces);
    scalar sum = 0;
    // bound: 1 + 2 limits::elliptic_turn_max
    for (int piece_i = 0; piece_i < pieces; ++piece_i) {
        for (int point_i = 0; point_i < gauss_points; ++point_i) {
            const int i = point_i / 2;
            const scalar node = static_cast<scalar>(point_i % 2 == 0 ? gauss_nodes[i] : -gauss_nodes[i]);
            const scalar at = piece * (static_cast<scalar>(piece_i) + (1 + node) * scalar(0.5));
            const Jacobi now = sum_of(polhode.begin, jacobi(at), polhode.m);
            const scalar a_sq = polhode.square_of(a, now), b_sq = polhode.square_of(b, now);
            const scalar rate = quotient(polhode.J[a] * a_sq + polhode.J[b] * b_sq, a_sq + b_sq, polhode.J[a]);
            sum += static_cast<scalar>(gauss_weights[i]) * rate * half_time;
        }
    }
    return sum;
}

/// The frame along y and an axis of the body: columns towards the axis across y, its normal, and y.
Matrix frame_of(const Vector& y_unit, int axis) {
    const Vector e = {axis == 0 ? scalar(1) : scalar(0), axis == 1 ? scalar(1) : scalar(0), axis == 2 ? scalar(1) : scalar(0)};
    const Vector across = cross(e, y_unit);
    const Vector c0 = across * (1 / sqrt(length_sq(across)));
    return {c0, cross(y_unit, c0), y_unit};
}

/// A after h seconds; `clamped` where the turn had to be cut.
Matrix exact_turn(const Matrix& A, const Vector& inv_I_body, const Vector& L, scalar h, bool& clamped) {
    const scalar length = sqrt(length_sq(L));
    if (!(length > 0) || !(inv_I_body.x > 0)) return A;
    const Vector y = transpose_times(A, L);
    const Polhode polhode = polhode_of(inv_I_body, y);
    const scalar fastest = polhode.J[0] > polhode.J[2] ? polhode.J[0] : polhode.J[2];
    const scalar bound = fastest * length * abs(h);  // of |omega| h, and so of p h
    clamped = bound > limits::elliptic_turn_max;
    if (clamped) h *= limits::elliptic_turn_max / bound;

    // Of the two extreme axes the one that L keeps further from: at least 45 degrees.
    const int reference = polhode.Y[0] * polhode.Y[0] >= polhode.Y[2] * polhode.Y[2] ? 2 : 0;
    const JacobiOf jacobi(polhode.mc);
    const Jacobi end = sum_of(polhode.begin, jacobi(polhode.p * h), polhode.m);
    const SinCos turn = sin_cos(angle_about_L(polhode, jacobi, reference, h) * length);

    scalar y_end[3];
    y_end[polhode.x] = polhode.Y[0] * end.cn;
    y_end[polhode.y] = polhode.Y[1] * end.sn;
    y_end[polhode.z] = polhode.Y[2] * end.dn;
    const Vector y_next = {y_end[0], y_end[1], y_end[2]};
    const int axis = reference == 0 ? polhode.x : polhode.z;
    const Matrix from = frame_of(y * (1 / sqrt(length_sq(y))), axis), to = frame_of(y_next * (1 / sqrt(length_sq(y_next))), axis);

    // The frame along L in the world turns about it; the body hangs in it by its own frame.
    const Matrix world = A * from;
    const Vector c0 = world.c0 * turn.cos + world.c1 * turn.sin, c1 = world.c1 * turn.cos - world.c0 * turn.sin;
    return Matrix{c0, c1, world.c2} * transposed(to);
}

}  // namespace

int ExactElliptic::integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock) {
    int clamped_count = 0;
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        RotationTile& tile = bodies.rotation[tile_i];
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            if (!(tile.inv_I_scale[lane_i] > 0)) continue;
            const Matrix A = lane_of(tile.A, lane_i);
            const Vector inv_I_body = lane_of(tile.inv_I_ratio, lane_i) * tile.inv_I_scale[lane_i];
            const Vector L = lane_of(tile.L, lane_i) - lane_of(tile.tau_T, lane_i) * clock.kick_ahead;
            bool clamped = false;
            const Matrix turned = exact_turn(A, inv_I_body, L, h, clamped);
            const Matrix A_next = turned + polar_correction(turned);  // every step: what is left of roundings walks less
            clamped_count += clamped ? 1 : 0;
            if (is_finite(A_next) && is_within_runaway(spin_of(A, inv_I_body, L)))
                set_lane(tile.A, lane_i, A_next);
            else
                tile.bad = static_cast<uint16_t>(tile.bad | (1u << lane_i));
        }
        tile.kicked = 0;
    }
    return clamped_count;
}

} }  // namespace ingot
