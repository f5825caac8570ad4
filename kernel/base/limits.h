// SPDX-License-Identifier: MIT
// Every tolerance and range of the kernel, with its unit and what happens beyond it.
#pragma once

#include "config.h"

namespace ingot { inline namespace INGOT_ABI { namespace limits {

// Ranges of input. Beyond them a call answers out_of_range (or the named status). They keep every product that the step
// forms inside the range of float: the largest is force_max * lever, 1e15 * 1e9 = 1e24.
inline constexpr scalar position_max = scalar(1e9);    ///< m
inline constexpr scalar speed_max    = scalar(1e6);    ///< m/s
inline constexpr scalar spin_max     = scalar(1e6);    ///< rad/s
inline constexpr scalar force_max    = scalar(1e15);   ///< N, and N s for impulses
inline constexpr scalar torque_max   = scalar(1e15);   ///< N m, and N m s
inline constexpr scalar gravity_max  = scalar(1e6);    ///< m/s^2
inline constexpr scalar gravity_share_max = 100;       ///< of World::set_gravity_share, either way
inline constexpr scalar damping_max  = scalar(1e6);    ///< 1/s
inline constexpr scalar mass_min     = scalar(1e-9);   ///< kg; bad_mass
inline constexpr scalar mass_max     = scalar(1e12);   ///< kg; bad_mass
inline constexpr scalar inertia_min  = scalar(1e-18);  ///< kg m^2; bad_inertia
inline constexpr scalar inertia_max  = scalar(1e18);   ///< kg m^2; bad_inertia
/// Largest over smallest moment; bad_inertia. One rounding of A lets this times epsilon of the spin about the long axis leak
/// into the short one: with a larger ratio a needle's motion is noise.
inline constexpr scalar inertia_ratio_max = INGOT_DOUBLE ? scalar(1e9) : scalar(2e6);
inline constexpr scalar size_min     = scalar(1e-6);  ///< m, radius or half extent of a shape; bad_shape
inline constexpr scalar size_max     = scalar(1e6);   ///< m; bad_shape
inline constexpr scalar step_min     = scalar(1e-9);  ///< s; bad_step
inline constexpr scalar step_max     = scalar(1);     ///< s; bad_step

// Ranges of motion. Forces may drive a body beyond what a call accepts; past these it is taken out of the motion, frozen and
// reported, long before a product overflows.
inline constexpr scalar speed_runaway = scalar(1e9);  ///< m/s
inline constexpr scalar spin_runaway  = scalar(1e9);  ///< rad/s

/// rad in a step, by which a kinematic body turns at most: beyond it nothing that touches it could follow.
inline constexpr scalar kinematic_turn_max = 500;
/// Of the speed of a kinematic body, and of length_unit/s: what sweeps leave by more than both, at their bound, cannot be, as between two plates that
/// close. Impulses of such an island are halved from substep to substep, or they would add up without end.
inline constexpr scalar kinematic_yield_share = scalar(0.1), kinematic_yield_speed = scalar(0.01);

// Tolerances of input.
/// Largest entry of |A^T A - 1| that is taken for a rotation; it is then made orthonormal at the door.
inline constexpr scalar orthogonality = scalar(1e-2);
/// The same of a rotation that was one at the door, however it has turned since: a snapshot with more is none of ours.
inline constexpr scalar orthogonality_kept = 1024 * epsilon;
/// Relative excess of one moment over the sum of the other two that is taken for rounding (a flat plate has none to spare).
inline constexpr scalar triangle_inequality = scalar(1e-5);
/// | |n|^2 - 1 | of a direction; the direction is used as it is given.
inline constexpr scalar unit_length = 8 * epsilon;

// Rotation (motion/). Angles are |omega| h.
inline constexpr scalar angle_per_substep = scalar(0.5);   ///< rad; the series and the sweeps converge well below 0.8
inline constexpr int substeps_max = 16;                    ///< beyond 16 * 0.5 rad the turn of a step is clamped and reported
inline constexpr int sweeps_max = INGOT_DOUBLE ? 32 : 16;  ///< of the fixed point; at 0.5 rad 15 and 7 are needed
inline constexpr scalar angle_per_forced_substep = scalar(0.25);  ///< rad; of CommutatorFree4, whose error grows with its fifth power
inline constexpr int forced_substeps_max = 16;             ///< beyond 16 * 0.25 rad a body of CommutatorFree4 is reported
inline constexpr scalar elliptic_turn_max = 16;            ///< rad; of ExactElliptic, beyond it the turn of a step is clamped and reported
inline constexpr scalar elliptic_turn_of_part = 1;         ///< rad; of ExactElliptic, a step that turns further is made in parts
inline constexpr int agm_steps_max = 10;                   ///< of the arithmetic-geometric mean, which doubles its digits in each
inline constexpr int polar_interval = 16;                  ///< steps from one polar step to the next
inline constexpr int polar_steps_max = 5;                  ///< of Rk4Polar, from one step's slopes back to a rotation; then A stays

// Impacts without friction (impulse/).
/// Shapes that are apart by this fraction of the bounding radius touch. So a box that lands flat, to rounding, lands on all its
/// corners at once, and a body that is put down touching does not fall for one step.
inline constexpr scalar flatness = scalar(1e-4);
inline constexpr int impact_waves_max = 128;    ///< impacts that impacts cause at the same time; what is left is reported
/// Of a contact, at different times of a step; in the second half of them it bounces no more, and then its bodies do not pass the plane between them
/// any more. Both are reported.
inline constexpr int impacts_in_step_max = 64;
inline constexpr int contact_sweeps_max = 128;  ///< over the contacts solved together; what is left is reported
/// Visits of solves to a contact, for all impacts of a step together: as many as one solve makes at most, of whose sweeps over pairs each may be as
/// many over the contacts of a pair. Then the impacts go on without it, which is reported, and what presses holds it. So a step has no more than
/// three times as many for each contact, the solve that had its last and that of what presses among them.
inline constexpr int impact_visits_max = contact_sweeps_max * contact_sweeps_max;
/// rad; corners are followed on their way for so long: further on they are off by more than a fiftieth of their lever.
inline constexpr scalar corner_turn = scalar(0.5);
/// Of a step; corners of a box that come no later after the first come with it. Else a box dropped flat begins to spin once rounding has tilted it by
/// 1e-4 rad.
inline constexpr scalar corners_together = scalar(1) / 16;
/// Of Newton's method for the time at which two balls meet that forces bend the ways of: each doubles the digits, from three on.
inline constexpr int meeting_passes = 3;
/// A contact counts as approaching, and a sweep as unfinished, beyond this many roundings of the speeds that it is computed from.
inline constexpr scalar contact_roundings = 8;
inline constexpr scalar contact_slack = 8;  ///< contact_roundings is multiplied by this once a quarter of the sweeps are done
/// Impacts slower than this many times |gravity| h are contacts at rest: restitution does not apply to them.
inline constexpr scalar rest_speed_factor = 2;
/// Of that speed: what touches and leaves no faster is taken to rest. Its force lifts it by the way that it would have gone in half a step.
inline constexpr scalar still_share = contact_roundings * contact_slack * epsilon;

// Arrays that are full (broad_phase/crowd.h).
/// Of the lesser bounding radius: a contact that carries something gives way to what is deeper by more than this. With less they would take turns,
/// and none would know what it carries.
inline constexpr scalar crowd_patience = scalar(0.02);

// Manifolds (narrow_phase/).
inline constexpr scalar contact_margin = scalar(0.02);     ///< m; shapes this far apart, and what they travel in a step, have a manifold
/// length_unit; contact_margin and touching_gap are halved for shapes whose least half extent is less, until it is not less than so much of them: a
/// margin is no more than a fifth of it.
inline constexpr scalar thin_extent = 5 * contact_margin;
inline constexpr unsigned halvings_max = 40;  ///< size_min, where length_unit is 1e5
inline constexpr scalar fast_margin = 5 * contact_margin;  ///< m; a pair with a larger margin in this step looks for more points
/// Bodies that have moved by less than this against each other, as a fraction of their size and in radians, keep their manifold.
inline constexpr scalar recycled_slip = scalar(1e-3);
/// Fixed shapes whose surfaces are no further apart are one surface: a body feels no edge there. A lip that is higher is an edge.
inline constexpr scalar flush_gap = scalar(5e-4);    ///< length_unit
inline constexpr scalar flush_share = scalar(5e-3);  ///< of the lesser bounding radius of body and shape: of small things it is less
/// A contact is off the normals of a fixed shape when it is by this sine. The second is where the normal is that of a side of the body, which tilts
/// while it lands.
inline constexpr scalar edge_tilt = scalar(1e-3);
inline constexpr scalar face_tilt = scalar(0.02);
/// Of a half extent: a side of a box, or an edge of a hull, that is further from a point of contact is one of it only where the direction is off by
/// face_tilt.
inline constexpr scalar far_side = scalar(1) / 16;
/// Of how deep a body and a triangle of a level overlap: what pokes into the body counts where it is out again within so much. Its direction is then
/// within 60 degrees of the nearest.
inline constexpr scalar poking_share = scalar(2);
/// The cosine within which a contact with a level goes on as the one that it was; 25 degrees: a body that rolls over a hill turns by less in a step.
inline constexpr scalar same_plane_cos = scalar(0.9);
/// Of its radius: a point this far aside of the lowest line of a cylinder is not on it. Rolling at 10 m/s, it moves up at 0.1 mm/s.
inline constexpr scalar off_round = scalar(1e-5);
inline constexpr int substeps_kept = 1000;         ///< the age of a manifold is counted up to this
inline constexpr scalar friction_max = 1000;       ///< coefficient mu of a body
inline constexpr scalar unbounded = scalar(1e30);  ///< m; further away than any body

// Rows of contacts (constraint/).
inline constexpr scalar touching_gap = scalar(1e-3);  ///< m; points this far apart are stopped as if they touched, and drawn together
/// m/s; a point that carries nothing and approaches more slowly than this is left out of a solve. The position sweep takes back the
/// overlap that this adds.
inline constexpr scalar approach_slack = scalar(1e-6);
inline constexpr scalar position_share = scalar(0.4);     ///< of an overlap, taken back in a substep
inline constexpr scalar push_speed_max = scalar(3);       ///< m/s, at which deep overlaps are taken back
inline constexpr scalar settled_gap = scalar(2e-8);       ///< m; a contact that is off by no more than this is not displaced
inline constexpr scalar bounce_speed_min = scalar(0.01);  ///< m/s; slower impacts do not bounce
/// The diagonal of a manifold's 4x4 compliance, which has rank 3, is multiplied by this: the load spreads over four points evenly. 1.001 loses
/// digits in float.
inline constexpr scalar block_diagonal = scalar(1.01);
/// Weight of a point in the middle of a manifold, at least. So the middle of points that are all far away is their mean.
inline constexpr scalar least_point_weight = scalar(1e-6);
/// Friction has a slow mean. In a substep each is drawn towards the other by this share of what is between them, which quietens ringing.
inline constexpr scalar friction_smoothing = scalar(0.1);
/// m/s; a slip that turns round within a substep is split there if it was faster. What is slower is off by no more than twice that afterwards.
inline constexpr scalar reversal_speed = scalar(1e-5);
/// Of the load that normals are foreseen to carry in a substep whose slip turns round: by so much friction may be beyond its cone, where they carry
/// less.
inline constexpr scalar load_foreseen = scalar(0.01);
/// Of the square of the cone's radius: friction that is as large slides.
inline constexpr scalar sliding_share_sq = scalar(0.998);
/// Of the sum of the two compliances across n. It is no less than 3/4 of the greater, so that friction converges. Where the two are equal,
/// each visit leaves a third of the slip.
inline constexpr scalar friction_stiffening = scalar(0.75);

// Bodies that turn in contact (body/turning_inertia.h).
/// rad, times what the inverse moments differ by, of the least: a body that turns further in a substep has another inertia in the next. Its contacts
/// give no more than this part of its energy of rotation.
inline constexpr scalar inertia_turn = INGOT_DOUBLE ? scalar(1e-9) : scalar(1e-5);
inline constexpr scalar turning_speed = scalar(0.01);   ///< m/s; one that spins more slowly, by its energy, is taken as it was when the step began
/// rad; of a body in a substep: where one turns further, its island has twice as many, with twice of it four times, if it is small. The tip of a
/// slender body may sink by the sagitta of such an arc, a hundredth of its half length, and is lifted again.
inline constexpr scalar turn_of_substep = scalar(0.15);
/// rad; a free turn is made of parts that are no larger, up to turn_parts_max of them: then its axis is off by their cube / 24, 7e-4.
inline constexpr scalar turn_of_part = scalar(0.25), locked_turn_of_part = scalar(0.125);  ///< the second of a body with locks, about two axes
inline constexpr int turn_parts_max = 16, locked_parts_max = 64;
/// A normal is that of a face when the cosine between them is no further than this from 1. Then it turns with the face.
inline constexpr scalar along_normal = scalar(1e-4);
/// Of its radius: a point of a cylinder that is no further from where the normal meets its round is there, and stays there however it rolls.
inline constexpr scalar on_rim = scalar(1e-3);
inline constexpr int energy_turns = 16;                 ///< by which the energy of a turn is made right, at most: one or two as a rule
inline constexpr scalar energy_turn_max = scalar(0.25); ///< rad, of one of them
/// Of the energy: what is off by less is rounding. A body that spins about an axis of inertia would be turned by degrees to take that back.
inline constexpr scalar energy_rounding = 16 * epsilon;

// Stages that several cores share: what is worth a task, tens of thousands of instructions on a PC.
inline constexpr int bodies_of_task = 64;     ///< to be moved, or bounded
inline constexpr int pairs_of_task = 64;      ///< to be looked at
inline constexpr int manifolds_of_task = 16;  ///< to be solved
// And within a solve that they share, a microsecond.
inline constexpr int visits_of_task = 8;                ///< of a sweep
inline constexpr int tasks_worth_share = 8;             ///< so many times as many visits, of stages that go along blocks
inline constexpr int tasks_worth_extrapolation = 32;    ///< and of what reads much and computes little
inline constexpr int manifolds_together = 256;          ///< of an island, to be shared at all
inline constexpr scalar uneven_share = scalar(1.25);    ///< a part with so many times what each core should have leaves others idle

// Sweeps (solver/sweeps/).
inline constexpr int substeps = 4;  ///< of a step, unless the scene says other: see Effort; each is solved and displaced by itself
inline constexpr int sweeps = 3;    ///< over all contacts in a substep, unless the scene says other
/// Manifolds: an island with no more of them is small.
inline constexpr int small_island = 64;
/// An island with more contacts of three or four points than this to one of fewer is a stack, and while as large a part of its bodies stands it is
/// solved as a small one is. Random boxes in a tray have one such to two or three of fewer points, walls no others.
inline constexpr int stack_faces = 3;
inline constexpr int sweeps_of_stack = 16;                      ///< of a substep, at most
inline constexpr int sweeps_of_small = 64;                      ///< of a substep, at most
inline constexpr scalar settled_speed_of_small = scalar(2e-7);  ///< m/s; settled_speed of a small island
/// m/s; a sweep that corrects no speed by more than this is the last of its substep. Contacts at rest then cost one sweep. The error that it
/// leaves in heaps adds up to less than 0.1 mm in a minute. It stands for an acceleration in a quarter of a step: other substeps have other
/// limits, in proportion.
inline constexpr scalar settled_speed = scalar(1.5e-6);
/// m/s; speeds round, so the limit of a sweep is raised by 4 epsilon of the fastest body's speed. Bodies faster than this count as no faster:
/// in float 4 epsilon of it are half of sleep_speed, and bodies at rest elsewhere in the same island must stay at rest.
inline constexpr scalar rounding_speed_max = 1000;
/// Of settled_speed: where a sweep changes a body by more, the next sweep visits the contacts of that body.
inline constexpr scalar active_share = scalar(0.5);
/// An island is steady while none of its bodies accelerates by more than this share of what gravity and forces give it. Its step is cut into
/// fewer substeps, because substeps are there for what changes.
inline constexpr scalar steady_acceleration = scalar(1e-4);
inline constexpr int steady_levels = 12;  ///< a small island is steady only while no chain of contacts up from the ground is longer
inline constexpr int steady_substeps = 2;
inline constexpr scalar settled_turn = 2 * epsilon;                        ///< rad; a correction that turns by less rounds to nothing
inline constexpr int level_passes_max = 32;                                ///< over the contacts, to find the distance of bodies from the ground
/// m/s; sweeps that end at their bound with a larger residual may give energy, where something is faster than the second. An island that gains more
/// than this part of what it would have without contacts is swept again, so many times at most.
inline constexpr scalar gaining_residual = scalar(1e-4), gaining_speed = scalar(0.25);
inline constexpr scalar gain_allowed = scalar(1e-6);
inline constexpr scalar figure_gain_allowed = scalar(1e-4);  ///< the same of islands with joints, found from the energies of three shares
/// sqrt(1/24): what a push gives a body that stood in line between it and its joint, v / h sqrt(M tr I) times as much. See pushed_figures.h.
inline constexpr scalar pushed_rod = scalar(0.20412415);
inline constexpr int gaining_rounds = 8;
/// An island whose heaviest body has so many times the mass of its lightest, and whose sweeps end at their bound with a residual of this share of the
/// speed that its heavy bodies would have without contacts, is being crushed: its impulses are dropped. Heavy: the heaviest is no more than
/// heavy_ratio times as heavy. (Not by the mass of all: ten thousand like bodies are a pile.)
inline constexpr scalar crushing_ratio = scalar(1e4), crushing_share = scalar(0.25), heavy_ratio = 50;
inline constexpr int bounce_rounds = 8;           ///< in which bounces are lowered that gain energy by friction
inline constexpr int landing_pushes = 4;                                   ///< of points that bounce within a substep: each leaves 1 % of the way
inline constexpr int impacts_of_contact = 8;      ///< within a substep, where impacts cause others; in the mean over the contacts
inline constexpr scalar together = scalar(5e-5);  ///< of a substep; impacts no further apart are simultaneous: 0.2 us at 60 Hz

// Contacts solved point by point (solver/sequential/).
inline constexpr int sweeps_of_points = 16;  ///< of a substep, at most
inline constexpr int rounds_of_points = 4;   ///< over the normals of a manifold in a visit, at most: with 1 a column of ten drifts by millimetres
inline constexpr int rounds_of_pushes = 4;   ///< of the sweep over positions, where something is off
/// m/s; settled_speed of this solver. It cannot be less: in a column of ten, rows at rest round by half of it.
inline constexpr scalar settled_speed_of_points = scalar(1e-6);
/// m/s; a row that is off by no more is left alone, which at rest are nearly all. A slip of this speed may go on: 1 um in 10 s.
inline constexpr scalar ignored_speed = scalar(1e-7);
inline constexpr scalar settled_gap_of_points = scalar(1e-6);  ///< m; settled_gap of this solver: ten metres up separations round by that much

// The direct solver (solver/direct/).
inline constexpr scalar direct_mass_ratio = 50;          ///< across one contact, from which sweeps do not carry the load in time
inline constexpr int direct_levels = 15;                 ///< of bodies on each other, from which sweeps let a tower lean
inline constexpr int unsettled_steps = 4;                ///< in a row with sweeps at their bound, from which an island is solved directly
inline constexpr scalar unsettled_speed = scalar(1e-5);  ///< m/s, that sweeps at their bound still correct
/// Of what gravity gives in a substep: where sweeps of a small island leave more than this, and than unsettled_speed, the step is not clean. A plate
/// that sinks for ever leaves twice as much, a stack that is pushed gently half.
inline constexpr scalar unsettled_share = scalar(1e-3);
inline constexpr int direct_sets_max = 16;               ///< tried in a solve
inline constexpr int direct_refinements_max = 12;        ///< of a solve
inline constexpr int direct_refinements_of_sliding = 1;  ///< of one with sliding friction, which is not linear
inline constexpr int direct_newton_steps_max = 6;        ///< with the same set, where something slides
/// Multiplications that an island may spend on factors in each of its three attempts: before the sweeps of a substep, after them, and for
/// positions. 40 cubes on each other take 40000. An island that takes more is swept.
inline constexpr int direct_work_max = 200000;
/// Added to the diagonal, as a fraction of it: rows that depend on each other then have a factor.
inline constexpr double direct_diagonal = 1e-12;
/// An island of so many times the mass of its lightest body is steep: direct_diagonal, of the row of the lightest, is then no small part of the row
/// of the heaviest, and refinement would need hundreds of passes. There it is left out of rows whose pivot is this part of their diagonal or more:
/// they depend on no others. (Columns keep their digits with 1e-2 as with 1e-6; with 1e-9 a plate on sixteen balls loses them.)
inline constexpr double direct_steepness = 1e7, direct_independence = 1e-4;
inline constexpr double direct_roundings = 1e-12;      ///< of the load of a manifold; an impulse below it is rounding
/// Of an impulse: its grain in double. What it gives to the body that gives way most is left of a solve; where that is more than unsettled_speed, at
/// masses of some 3e11 : 1 and 30 Hz, the report says so.
inline constexpr double direct_grain = 0x1p-52;
inline constexpr double direct_settled_speed = 1e-9;   ///< m/s, that a solve may leave; sweeps leave a thousand times as much
inline constexpr double direct_settled_length = 1e-9;  ///< m, that a solve of positions may leave

// Sleep (sleep/).
/// m/s; a body is slow when no point of it is faster. At rest the solver leaves a thousandth of it, and a pile fidgets with a tenth of it.
/// A body that falls asleep loses less energy than a drop from 0.1 micrometres gives.
inline constexpr scalar sleep_speed = scalar(1e-3);
inline constexpr scalar sleep_time = scalar(0.5);  ///< s; a body that is slow only on its way has passed by then
/// Of gravity; a body that accelerates by more than this is not at rest, however slow it is.
inline constexpr scalar balance = scalar(0.01);

// Bodies too fast for a step (continuous/).
/// A body is fast when it gets further in a step than this times its least half extent: it might pass through something between two steps.
inline constexpr scalar fast_share = 1;
/// Two bodies on their way have met when they touch, or are apart by less than this fraction of the lesser of their least half extents and less than
/// impact_gap_max. A search that comes so near ends.
inline constexpr scalar impact_gap = scalar(1e-3);
inline constexpr scalar impact_gap_max = touching_gap / 4;  ///< m
inline constexpr int approaches_max = 64;              ///< of the search for a time of impact; then they are taken for met: too early, never too late
inline constexpr scalar angle_per_path = scalar(0.25);  ///< rad; a body that turns further in a step is followed in parts
inline constexpr int path_parts_max = 256;             ///< of a whole step
inline constexpr int path_boxes_max = 16;              ///< in which the triangles of a level along a part of a path are looked for
/// rad; beyond it what a body touches is somewhere else on it: contacts are found anew after such a turn, and those of bodies that turn further in a
/// step are not solved for all of it.
inline constexpr scalar tilt_of_contact = angle_per_path / 2;
/// Two bodies that meet are solved together for as long as they get no further than this part of the lesser of their least half extents, and turn
/// by no more than tilt_of_contact.
inline constexpr scalar together_share = scalar(0.25);
/// Of the lesser of their least half extents: so deep two bodies may be in each other on their paths, if they touch at the begin. Contacts lift them
/// out again; with less they meet more often.
inline constexpr scalar skin_share = scalar(0.1);
/// s; an impact is solved as a step as short as this, in which nothing moves: it changes velocities alone.
inline constexpr scalar impact_time = step_min;
inline constexpr int impacts_of_body_max = 64;       ///< of a fast body in a step; its other impacts wait for the next, and are counted
inline constexpr int flight_impacts_max = 64;        ///< of fast bodies that events tell of in a step
inline constexpr int pair_manifolds_max = 16;        ///< of two bodies that meet, and of what is fixed around them: the deepest; others have no room
inline constexpr int pair_kinematic_max = 2;         ///< kinematic bodies around two that meet; the contacts of others are lost
inline constexpr scalar last_moment = scalar(1e-5);  ///< of a step; bodies that meet later do so in the next
inline constexpr scalar first_moment = scalar(0.015625);  ///< of a step; who meets another so early does not wait for the next

// Points of two shapes (narrow_phase/). Fractions of a length are of the smallest half extent of both shapes, unless another is named.
/// An edge axis is taken when it separates better than every face by this fraction: nearly parallel edges have no normal of
/// their own, and the face's manifold has the crossing of the edges among its points.
inline constexpr scalar edge_preference = scalar(0.01);
/// The face or edge of the step before is kept until another separates better by this fraction.
inline constexpr scalar axis_hysteresis = scalar(0.005);
/// Corners this far outside the face they lie on, as a fraction of its half extent, count as inside and are moved to its rim:
/// equal boxes on top of each other keep their corners however these round.
inline constexpr scalar corner_slack = scalar(1e-3);
/// Edges of boxes that lie along each other are rounded: the normal turns from one face to the other as they shift by this.
inline constexpr scalar ridge = scalar(0.01);
/// sin^2 of the angle below which two edges are parallel and make no axis: its rounding would exceed edge_preference.
inline constexpr scalar parallel_sin_sq = scalar(1e-5);
/// A capsule lies along a face or an edge, with two points, up to this sin^2 of the angle between them.
inline constexpr scalar lying_sin_sq = scalar(0.01);
inline constexpr scalar lying_cos = scalar(0.995);  ///< of the angle between the normal of such a point and that of the manifold
/// Of the search for nearest points. Polyhedra end within a dozen; what is round gets a digit every two or three.
inline constexpr int nearest_iterations_max = 32;
/// Nearest points are found when no point can be nearer by this fraction of the distance.
inline constexpr scalar nearest_accuracy = INGOT_DOUBLE ? scalar(1e-10) : scalar(1e-5);
/// The direction between the nearest points is right when, to this fraction, it separates the shapes by the distance of the points. Where shapes
/// nearly touch it is wrong: its error is epsilon size / distance.
inline constexpr scalar nearest_direction = scalar(2e-3);
// The search for the shortest way out of overlapping cylinders turns a direction.
inline constexpr scalar round_accuracy = scalar(1e-3);   ///< the search ends when a turn gains less than this
inline constexpr int refinements_max = 8;                ///< turns, at most
inline constexpr scalar refinement_lift = scalar(0.02);  ///< A is held this far away meanwhile
/// Deeper than this the search starts three times: from the best face of either shape, and from the best other direction. Else it starts once,
/// from the best of these.
inline constexpr scalar shallow = scalar(0.1);
/// Corners of the polygon that stands for the end of a cylinder where it lies on something: it is within 1.9 % of the circle.
inline constexpr int cap_corners = 16;
/// A face faces a contact up to this cosine between its normal and that of the manifold; an edge lies across up to this sine.
inline constexpr scalar facing_cos = scalar(0.98);
inline constexpr scalar facing_sin = scalar(0.2);
/// A cylinder on its end that is tilted by more than this sine rolls on its rim.
inline constexpr scalar rolling_sin = scalar(0.02);
/// Lines along each other, one of them on something round, make two points if they are apart, sideways, by less than this:
/// then the surface is lower there by half its square, 4.5e-4.
inline constexpr scalar round_aside = scalar(0.03);

// Queries (query/).
/// A moving shape has met another when they are apart by this fraction of the smaller bounding radius. Smaller gaps have worse
/// normals: rounding turns them by epsilon over this.
inline constexpr scalar cast_gap = INGOT_DOUBLE ? scalar(1e-7) : scalar(1e-4);
inline constexpr int cast_iterations_max = 32;  ///< then it is taken for met where it is

// Hulls (shape/).
/// Corners of a convex hull; indices of corners, edges and corners of faces fit into a byte. no_room beyond.
inline constexpr int hull_vertices_max = 32;
/// Points this far from the plane of a face, as a fraction of the size of the hull, lie in it: what rounding leaves of the
/// faces of a turned solid. A hull thinner than that is bad_shape.
inline constexpr scalar hull_flatness = INGOT_DOUBLE ? scalar(1e-13) : scalar(4e-6);

} } }  // namespace ingot::limits
