// SPDX-License-Identifier: MIT
// Tolerances and ranges of joints, and of the figures that they make of bodies: as limits.h.
#pragma once

#include "limits.h"

namespace ingot { inline namespace INGOT_ABI { namespace limits {

// Figures: bodies with joints (figure/).
/// Of the least moment of inertia of a body: where h times the impulse of a joint times its arm is more, tension turns the body back in a substep.
inline constexpr scalar stiff_tension = scalar(0.5);
/// rad, by which the spins of a figure change a turn of the substep, at most: then its joints follow turns to second order.
inline constexpr scalar resolved_turn = scalar(0.02);
/// rad: of a figure with a body that turns by more than far_turn in a substep, or a joint that would be off by more than far_off at its end, targets
/// may be motions that there are not. What is resolved is off by hundredths: by the squares of its turns, and what forces give in a substep.
inline constexpr scalar far_turn = 1, far_off = scalar(0.25);
/// How often the substeps of a figure are halved, at most, and from what tension on: (omega h)^2 of the turning back, in a substep that is whole.
inline constexpr int doublings_max = 3;
inline constexpr scalar tension_of_doublings[doublings_max] = {scalar(0.5), 2, 8};
inline constexpr scalar turn_of_doublings[doublings_max] = {scalar(0.25), scalar(0.5), 1};  ///< rad, of a body in a whole substep
/// Of the compliance that two bodies would have without joints: where these leave a contact less, it is rounding, and nothing is solved there.
inline constexpr scalar held_compliance = 64 * epsilon;
/// The same of a figure whose loops are far from a dead point, over the root of the least pivot of their rows.
inline constexpr scalar looped_compliance = 16 * epsilon;
/// Of the energy of a figure, by its targets of a substep: they are left out beyond. Less of machines, against which no inertia is added: with 1.5,
/// 14 of 1000 rings gained more with each substep, and came apart. What is driven needs its targets: with 1.02 an engine's crank lagged by a third of
/// its way.
inline constexpr scalar target_gain = scalar(1.5), target_gain_of_machines = scalar(1.02);
/// Of the rows of a figure that close its loops: of four hinges, say. More would be solved in the cube of their number.
inline constexpr int loop_rows_max = 24;
/// Of the compliance that a row which closes a loop would have if its bodies had no joints: what gives way by less, once the rows before it hold, is
/// left out. With less, rows that say the same as others would be solved by their roundings; with more, what is nearly straight comes apart.
inline constexpr scalar loop_compliance = INGOT_DOUBLE ? scalar(1e-10) : scalar(4e-6);
/// What gives way by less than this of it is near a dead point: targets of second order are given up. See fit_taut_machines.
inline constexpr scalar taut_compliance = scalar(1e-4);
/// The same of the free direction of a joint, without the loops: what they leave of it is a difference of sums.
inline constexpr scalar row_compliance = 16 * loop_compliance;
inline constexpr scalar loop_gap = INGOT_DOUBLE ? scalar(5e-10) : scalar(2e-5);  ///< m, rad; joint_gap of figures with loops
inline constexpr scalar taut_gap = 4 * loop_compliance;  ///< of an arm; rad; a push leaves half of a way, and the row still gives way
inline constexpr scalar parted_gap = scalar(1e-3);       ///< m, rad, that pushes leave of a figure with loops: what asks for more cannot be
inline constexpr scalar push_turn = scalar(0.1);         ///< rad, of any body by one push of a figure with loops, or by those of contacts
inline constexpr scalar throw_speed = 4 * push_speed_max;  ///< m/s, of any body of a figure by pushes of contacts: levers make more of them
inline constexpr int pushes_max = 9;                     ///< of the bodies of a figure, to where its joints want them, in a substep
inline constexpr scalar joint_gap = scalar(2e-5);        ///< m, rad; a joint that is further off after a push is pushed again
inline constexpr scalar tie_length_min = scalar(1e-3);   ///< units of length, of a rod or a rope; shorter, it has no direction: take a ball joint
inline constexpr scalar reel_speed = 3;                  ///< units of length a second, with which one becomes as long as it was told to be
inline constexpr scalar gear_ratio_max = scalar(1e6);    ///< of a gear, either way; of a rack and its pinion m/rad, of units of length
inline constexpr int rope_rounds = 8;                    ///< of a substep, in which ropes may come to their ends; then those that push are let go

// Figures on their way through a step (continuous/).
/// Factors of a figure that is put back to a time within the step: its bodies turn far by that, and pushes go by the levers of their factor.
inline constexpr int closings = 4;
inline constexpr int figure_retreats = 12;  ///< halvings of the time that it is put back to
/// Of the least half extent of a body with joints: contacts may leave it so deep in what it meets. It is taken back from there as any overlap is;
/// what is deeper may be pushed out on the other side of what is thin.
inline constexpr scalar depth_of_figure = scalar(0.5);

/// Of what gravity gives in a substep: a sweep of an island with joints that moves, and corrects no speed by more, is the last of its substep. A
/// clean step may leave so much, see unsettled_share; the next substep goes on from there.
inline constexpr scalar jointed_settled_share = scalar(1e-3);

// Limits of joints. What is an angle is so many metres of a travel.
inline constexpr scalar joint_angle_max = 1000;          ///< rad; limits of a hinge: in float an angle of so many turns has 6e-5 rad left
inline constexpr scalar turns_max = scalar(1e9);         ///< of a hinge that has been turned; then its angle begins again
inline constexpr scalar joint_swing_max = 3;             ///< rad; limits of what has no more than a turn
inline constexpr scalar joint_cone_min = scalar(0.01);   ///< rad; half of a cone: in a narrower one the axis has no direction to turn back to
inline constexpr scalar joint_opposite_cos = scalar(-0.99);  ///< between the middle of a cone and the axis in it: beyond, a turn has no direction
/// rad; a joint that is so near to its limit is at it, and beyond it by no more is not pushed back. What rounding makes of an angle is a third of it.
inline constexpr scalar limit_slack = INGOT_DOUBLE ? scalar(1e-9) : scalar(1e-6);
/// rad; a limit that is further away, with twice the way that the joint goes in a substep, is not looked at in it.
inline constexpr scalar limit_reach = scalar(0.02);
inline constexpr scalar limit_return = 1;                ///< rad/s, with which a joint that is far beyond its limit goes back
inline constexpr int limit_sweeps_max = 128;              ///< over the limits of a figure that touches nothing, in a substep
inline constexpr int limit_pushes = 4;                   ///< the same where they are pushed back

// Figures that move by the energy-momentum step (energy_momentum/).
/// Shares of what is in a balance, and of the size of a body; rad. What is off by less than newton_settled is off by a dozen roundings of its own
/// terms: passes end. What is off by less than newton_close is off by less than that after one move more, which squares it.
inline constexpr scalar newton_settled = 12 * epsilon, newton_close = INGOT_DOUBLE ? scalar(1e-9) : 64 * epsilon;
inline constexpr scalar newton_turn = scalar(0.85);  ///< rad; the step of a figure with a body that turns further is cut in halves
inline constexpr int newton_halvings_max = 3;  ///< of a step; then the substeps take the figure
inline constexpr int newton_passes_max = 12;        ///< of a step, or of a part of it; then it is cut
inline constexpr int newton_steep_passes_max = 16;  ///< the same where masses differ by newton_steep_ratio
inline constexpr scalar newton_steep_ratio = 1000;
inline constexpr int newton_easy_passes = 8;   ///< where no part took more, the next step begins with parts twice as long
/// Of the kinetic energy of a figure: so much may be in velocities that its joints do not allow.
inline constexpr scalar hidden_share = scalar(1e-4);
inline constexpr scalar snap_gain_max = 4;  ///< by which a snap may raise the kinetic energy of a figure, its motion as a whole excepted

/// m, rad; a joint that was broken, or switched off, works again where its sides are no further off each other. They are drawn together in a step:
/// bodies that are further apart would be thrown about by what is left of that in their velocities.
inline constexpr scalar mended_gap = scalar(0.05);

// Drives of joints.
inline constexpr scalar drive_gain_max = scalar(1e12);   ///< N m/rad, N m s/rad, N m; of a slider N/m, N s/m, N
inline constexpr scalar drive_hertz_max = 1000;          ///< Hz, of what is tuned
inline constexpr scalar damping_ratio_max = 10;          ///< of what is tuned: of more than this the slow pole alone is left
inline constexpr scalar drive_rate_max = 1000000;        ///< rad/s, m/s; of a target
inline constexpr scalar tuned_turn_max = scalar(1.5707963267948966);  ///< rad, of the phase of what is tuned, in a substep: a quarter of a turn
/// The damping of a motor, in its inertia a substep: in each it takes off all but so much of what its rate is off by. In float the load that it feels
/// has lost as many digits.
inline constexpr scalar motor_gain = INGOT_DOUBLE ? scalar(1e6) : scalar(1e4);
/// Of the largest torque of a ball joint's drive: what it is found to, in so many passes of Newton's method at most.
inline constexpr scalar torque_settled = scalar(1e-3);
inline constexpr int torque_passes = 8;
inline constexpr int drive_rounds = 4;                   ///< solves in a substep, for drives that turn out to be at their torque

} } }  // namespace ingot::limits
