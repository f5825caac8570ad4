// SPDX-License-Identifier: MIT
// Bodies that move as they are told, whatever is in their way: platforms, lifts, doors, flippers, turntables.
//
// Between two steps the tiles of a kinematic body are those of an immovable one: inv_M = 0, inv_I_scale = 0, no motion. Within a step they show how
// it moves, from begin_motion until it has been moved: v_CM is its velocity, and
//
//     inv_I_scale = -1, inv_I_ratio = 1, L = -omega          so that omega_of, which is I^-1 L, is its spin
//
// No test for a body that can move is passed, for these ask for an inverse mass or moment above 0; and whatever reads velocities reads the right one.
#pragma once

#include "../base/if.h"
#include "body_tiles.h"
#include "check_body.h"

namespace ingot { inline namespace INGOT_ABI {

using KinematicWord = If<sizeof(scalar) == sizeof(uint64_t), uint64_t, uint32_t>;

/// What a body that moves by itself is on its way to. As large as a scalar: a record has no gaps.
enum class KinematicGoal : KinematicWord {
    none,      ///< it is no kinematic body
    velocity,  ///< it goes on with v_CM and omega
    pose,      ///< it goes to r_CM and A of its goal in the next step, and stands there
};

/// The motion of one body. All zero: that of one that is not kinematic.
struct KinematicBody {
    Vector v_CM, omega;         ///< m/s, rad/s, world; on the way to a pose those of the step at hand
    Vector v_CM_before, omega_before;  ///< in the middle of the step before; 0: it stood still
    Vector v_CM_change, omega_change;  ///< from the begin of the step at hand to its end; 0 but on the way from goal to goal: see aim_at_goal
    Vector r_CM_goal;           ///< m
    Matrix A_goal;              ///< body to world
    Vector r_CM_low;            ///< m, what r_CM knows beyond its last bit: a slow lift far away does not stand still
    Matrix A_low;
    KinematicGoal goal;
};

inline bool is_kinematic(const KinematicBody& body) { return body.goal != KinematicGoal::none; }
/// True for one that the next step moves.
inline bool moves(const KinematicBody& body) {
    return body.goal == KinematicGoal::pose || (body.goal == KinematicGoal::velocity && length_sq(body.v_CM) + length_sq(body.omega) > 0);
}

/// Within a step: whether the tiles of a slot show the motion of a kinematic body.
INGOT_INLINE bool shows_kinematic_motion(const BodyView& bodies, int slot) {
    return bodies.rotation[place_of(slot).tile].inv_I_scale[place_of(slot).lane] < 0;
}
/// See the top of the file.
void show_kinematic_motion(const BodyView& bodies, int slot, const Vector& v_CM, const Vector& omega);
/// The tiles are those of an immovable body again.
void hide_kinematic_motion(const BodyView& bodies, int slot);

/// What a steady turn for h seconds adds to r: (exp(omega h) - 1) r, exact to a rounding of itself. The turn is cut at limits::kinematic_turn_max.
Vector change_by_turn(const Vector& omega, scalar h, const Vector& r);

/// Begins a step of h seconds; of a body on the way to a pose, finds v_CM and omega that lead there.
///
/// It turns by the shorter way, about one axis. Where it would have to be faster than limits::speed_max, contacts see no motion: it is put there.
/// From goal to goal it moves smoothly, where its speed changes by no more than smooth, m/s, from step to step: v_CM is what it has in the middle
/// of the step, and before and after it changes evenly, by as much in a step as from the step before. So what it carries is carried by
/// trapezoids, of second order, and does not lag by half a substep.
void aim_at_goal(const BodyView& bodies, scalar h, scalar smooth, int slot, KinematicBody& body);

/// Ends it: the body is where its motion leads from where it was, and stands there if that was its goal. One that would leave limits::position_max
/// stands still from then on.
void move_kinematic_body(const BodyView& bodies, scalar h, int slot, KinematicBody& body);

/// Errors: not_finite, out_of_range (beyond limits::speed_max, spin_max).
Status check_kinematic_motion(const Vector& v_CM, const Vector& omega);
/// Goes on with these.
void set_kinematic_motion(KinematicBody& body, const Vector& v_CM, const Vector& omega);
/// False for numbers that no world holds.
bool is_valid(const KinematicBody& body);

} }  // namespace ingot
