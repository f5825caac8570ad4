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

/// rad/s; the fastest that the body spins on its way: |omega|^2 is linear in sn^2, so it is so at sn = 0 or at sn = 1.
scalar fastest_spin(const Polhode& polhode) {
    const auto spin_sq = [&](int axis) { return polhode.J[axis] * polhode.Y[axis] * (polhode.J[axis] * polhode.Y[axis]); };
    return sqrt(max(spin_sq(0) + spin_sq(2), spin_sq(1) + spin_sq(2) * polhode.mc));
}

/// The angle by which axis `reference` of the body turns about L: the integral of (J_a y_a^2 + J_b y_b^2) / (y_a^2 + y_b^2) over the other two,
/// times |L|.
scalar angle_about_L(const Polhode& polhode, const JacobiOf& jacobi, int reference, scalar h) {
    const int a = reference == 0 ? 1 : 0, b = reference == 2 ? 1 : 2;
    const scalar u = polhode.p * h;
    const int pieces = 1 + static_cast<int>((abs(u) < limits::elliptic_turn_of_part ? abs(u) : limits::elliptic_turn_of_part) * 2);
    const scalar piece = u / static_cast<scalar>(pieces), half_time = h / static_cast<scalar>(2 * pieces);
    scalar sum = 0;
    // bound: 1 + 2 limits::elliptic_turn_of_part; p is no more than the spin of the body, but for rounding, and where squares leave the range
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

/// tan(beta / 2): on the shortest way from y + dy to y, both of length 1, directions turn by beta about y, against the circles about the axis.
/// Source: Napier's analogies, in components.
scalar half_tangent_of_convergence(const Vector& y, const Vector& dy, const Vector& y_next, int axis) {
    const Vector e = {axis == 0 ? scalar(1) : scalar(0), axis == 1 ? scalar(1) : scalar(0), axis == 2 ? scalar(1) : scalar(0)};
    const scalar z = dot(e, y), z_next = dot(e, y_next);
    const Vector across = y - e * z, across_next = y_next - e * z_next;
    const scalar product = sqrt(length_sq(across) * length_sq(across_next));
    const scalar half_tangent_of_azimuth = dot(e, cross(dy, y)) / (product + dot(across, across_next));
    return -half_tangent_of_azimuth * (z + z_next) / (1 + z * z_next + product);
}

/// The Rodrigues vector, in body axes, of the turn of h seconds: the shortest turn that takes y of the end to y of the begin, and then one
/// about y by what is left of the angle about L.
///
/// All is formed from differences, so its roundings are epsilon of the turn and not of 1.
/// Valid for: turns of up to limits::elliptic_turn_of_part.
Vector turn_along(const Polhode& polhode, const Vector& y_body, scalar length, scalar h) {
    const JacobiOf jacobi(polhode.mc);
    const Jacobi change = change_by(polhode.begin, jacobi(polhode.p * h), polhode.m);
    scalar dy_of_axis[3];
    dy_of_axis[polhode.x] = polhode.Y[0] * change.cn;
    dy_of_axis[polhode.y] = polhode.Y[1] * change.sn;
    dy_of_axis[polhode.z] = polhode.Y[2] * change.dn;
    const scalar per_length = 1 / length;
    const Vector y = y_body * per_length, dy = Vector{dy_of_axis[0], dy_of_axis[1], dy_of_axis[2]} * per_length, y_next = y + dy;

    // Of the two extreme axes the one that L keeps further from: at least 45 degrees.
    const int reference = polhode.Y[0] * polhode.Y[0] >= polhode.Y[2] * polhode.Y[2] ? 2 : 0;
    const SinCos angle = sin_cos(angle_about_L(polhode, jacobi, reference, h) * length);
    const scalar half_tangent = angle.sin / (1 + angle.cos);
    const scalar convergence = half_tangent_of_convergence(y, dy, y_next, reference == 0 ? polhode.x : polhode.z);
    const scalar left = (half_tangent - convergence) / (1 + half_tangent * convergence);
    const Vector sum = y + y_next;
    return (cross(dy, y) + sum * left) * (2 / length_sq(sum));
}

/// A (R(c) - 1) for the turn with Rodrigues vector c in body axes: see turn_body.
Matrix increment_of(const Matrix& A, const Vector& c) {
    const Matrix rows = transposed(A);
    const scalar f = 2 / (1 + length_sq(c));
    const auto of_row = [&](const Vector& a) {
        const Vector u = cross(a, c);
        return (u + cross(u, c)) * f;
    };
    return transposed(Matrix{of_row(rows.c0), of_row(rows.c1), of_row(rows.c2)});
}

/// An orientation, and what it knows beyond its last bit.
struct Attitude {
    Matrix A, A_low;
};

/// The attitude after h seconds; `clamped` where the turn had to be cut.
Attitude exact_turn(Attitude at, const Vector& inv_I_body, const Vector& L, scalar h, bool polar_step, bool& clamped) {
    const scalar length = sqrt(length_sq(L));
    if (!(length > 0) || !(inv_I_body.x > 0)) return at;
    int parts = 1;
    // bound: 1 + limits::elliptic_turn_max / limits::elliptic_turn_of_part: parts is set in the first
    for (int part_i = 0; part_i < parts; ++part_i) {
        const Vector y = transpose_times(at.A, L) + transpose_times(at.A_low, L);
        const Polhode polhode = polhode_of(inv_I_body, y);
        if (part_i == 0) {
            scalar bound = fastest_spin(polhode) * abs(h);
            clamped = bound > limits::elliptic_turn_max;
            if (clamped) h *= limits::elliptic_turn_max / bound;
            if (clamped) bound = limits::elliptic_turn_max;
            if (bound > limits::elliptic_turn_of_part) parts = 1 + static_cast<int>(bound * (1 / limits::elliptic_turn_of_part));  // NaN: one
            h /= static_cast<scalar>(parts);
        }
        add_compensated(at.A, at.A_low, increment_of(at.A, turn_along(polhode, y, length, h)));
    }
    if (polar_step || parts > 1) add_compensated(at.A, at.A_low, polar_correction(at.A));
    return at;
}

}  // namespace

int ExactElliptic::integrate_A(const BodyView& bodies, scalar h, const FlightClock& clock) {
    const bool polar_step = clock.steps % limits::polar_interval == 0;
    int clamped_count = 0;
    for (int tile_i = 0; tile_i < bodies.tile_count; ++tile_i) {  // bound: max_bodies / lanes, rounded up
        RotationTile& tile = bodies.rotation[tile_i];
        CompensationTile& compensation = bodies.compensation[tile_i];
        for (int lane_i = 0; lane_i < lanes; ++lane_i) {
            if (!(tile.inv_I_scale[lane_i] > 0)) continue;
            const Attitude at = {lane_of(tile.A, lane_i), lane_of(compensation.A_low, lane_i)};
            const Vector inv_I_body = lane_of(tile.inv_I_ratio, lane_i) * tile.inv_I_scale[lane_i];
            const Vector L = lane_of(tile.L, lane_i) - lane_of(tile.tau_T, lane_i) * clock.kick_ahead;
            if (!is_within_runaway(spin_of(at.A, inv_I_body, L))) {
                tile.bad = static_cast<uint16_t>(tile.bad | (1u << lane_i));
                continue;
            }
            bool clamped = false;
            const Attitude next = exact_turn(at, inv_I_body, L, h, polar_step, clamped);
            clamped_count += clamped ? 1 : 0;
            if (is_finite(next.A) && is_finite(next.A_low)) {
                set_lane(tile.A, lane_i, next.A);
                set_lane(compensation.A_low, lane_i, next.A_low);
            } else {
                tile.bad = static_cast<uint16_t>(tile.bad | (1u << lane_i));
            }
        }
        tile.kicked = 0;
    }
    return clamped_count;
}

} }  // namespace ingot
