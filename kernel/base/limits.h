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
inline constexpr scalar gravity_share_max = 100;          ///< of World::set_gravity_share, either way
inline constexpr scalar mass_min     = scalar(1e-9);   ///< kg; bad_mass
inline constexpr scalar mass_max     = scalar(1e12);   ///< kg; bad_mass
inline constexpr scalar inertia_min  = scalar(1e-18);  ///< kg m^2; bad_inertia
inline constexpr scalar inertia_max  = scalar(1e18);   ///< kg m^2; bad_inertia
/// Largest over smallest moment; bad_inertia. One rounding of A lets this times epsilon of the spin about the long axis leak
/// into the short one: beyond it a needle's motion is noise.
inline constexpr scalar inertia_ratio_max = INGOT_DOUBLE ? scalar(1e9) : scalar(2e6);
inline constexpr scalar size_min     = scalar(1e-6);   ///< m, radius or half extent of a shape; bad_shape
inline constexpr scalar size_max     = scalar(1e6);    ///< m; bad_shape
inline constexpr scalar step_min     = scalar(1e-9);   ///< s; bad_step
inline constexpr scalar step_max     = scalar(1);      ///< s; bad_step

// Ranges of motion. Forces may drive a body beyond what a call accepts; past these it is taken out of the motion, frozen and
// reported, long before a product overflows.
inline constexpr scalar speed_runaway = scalar(1e9);   ///< m/s
inline constexpr scalar spin_runaway  = scalar(1e9);   ///< rad/s

// Tolerances of input.
/// Largest entry of |A^T A - 1| that is taken for a rotation; it is then made orthonormal at the door.
inline constexpr scalar orthogonality = scalar(1e-2);
/// The same of a rotation that was one at the door, however it has turned since: a snapshot with more is none of ours.
inline constexpr scalar orthogonality_kept = 1024 * epsilon;
/// Relative excess of one moment over the sum of the other two that is taken for rounding (a flat plate has none to spare).
inline constexpr scalar triangle_inequality = scalar(1e-5);
/// | |n|^2 - 1 | of a direction; the direction is used as it is given.
inline constexpr scalar unit_length = 8 * epsilon;

// Rotation (motion/moser_veselov): angles are |omega| h.
inline constexpr scalar angle_per_substep = scalar(0.5);  ///< rad; the series and the sweeps converge well below 0.8
inline constexpr int substeps_max = 16;                   ///< beyond 16 * 0.5 rad the turn of a step is clamped and reported
inline constexpr int sweeps_max = INGOT_DOUBLE ? 32 : 16; ///< of the fixed point; at 0.5 rad 15 and 7 are needed
inline constexpr scalar elliptic_turn_max = 16;           ///< rad; of ExactElliptic, beyond it the turn of a step is clamped and reported
inline constexpr int agm_steps_max = 10;                  ///< of the arithmetic-geometric mean, which doubles its digits in each
inline constexpr int polar_interval = 16;                 ///< steps from one polar step to the next
inline constexpr int polar_steps_max = 5;                 ///< of Rk4Polar, from one step's slopes back to a rotation; then A stays

// Contacts (collide/, solve/).
/// Shapes that are apart by this fraction of the bounding radius touch: a box that lands flat but for rounding lands on all its
/// corners at once, and what is put down touching does not fall for one step.
inline constexpr scalar flatness = scalar(1e-4);
inline constexpr int impact_waves_max = 128;    ///< impacts that impacts cause, within one step; the rest is reported
inline constexpr int contact_sweeps_max = 128;  ///< over the contacts solved together; the rest is reported
/// A contact counts as approaching, and a sweep as unfinished, beyond this many roundings of the speeds it is made of.
inline constexpr scalar contact_roundings = 8;
inline constexpr scalar contact_slack = 8;      ///< times that, once a quarter of the sweeps are done
/// Impacts slower than this many times |gravity| h are contacts at rest: restitution does not apply to them.
inline constexpr scalar rest_speed_factor = 2;

// Contacts with friction (pairs/, contact/, blocks/).
inline constexpr int substeps = 4;                ///< of a step; each is solved and displaced by itself
inline constexpr int sweeps = 3;                  ///< over all contacts in a substep
/// In a heap of balls: where more than three quarters of the normals go through both centres. They hold up no tilt, so that nothing leans while
/// loads find their way. A stack of boxes would shift twice as far.
inline constexpr int sweeps_of_balls = 2;
inline constexpr int sweeps_of_new = 12;        ///< while more than a quarter of the contacts are younger than four steps
inline constexpr int small_island = 64;          ///< an island with no more of them is swept by the two that follow
inline constexpr int sweeps_of_small = 64;          ///< the most sweeps of a substep there
inline constexpr scalar settled_speed_of_small = scalar(2e-7);  ///< m/s; settled_speed there
/// m/s; a sweep that corrects no speed by more than this is the last of its substep. Contacts at rest then cost one sweep. What is left adds up to
/// less than 0.1 mm in a minute. In a longer substep so much more: it is an acceleration.
inline constexpr scalar settled_speed = scalar(1.5e-6);
/// m/s; what fast bodies round a solve is not waited for, but no more than at this speed: in float 4 epsilon of it are half of sleep_speed, and what
/// is at rest elsewhere in the same island must stay so.
inline constexpr scalar rounding_speed_max = 1000;
inline constexpr scalar active_share = scalar(0.5);     ///< of settled_speed: contacts of bodies that a sweep stirs by more are visited by the next
/// Where nothing that touches accelerates by more than this share of what gravity and forces give it, a step is cut into fewer
/// substeps: those are there for what changes.
inline constexpr scalar steady_acceleration = scalar(1e-4);
inline constexpr int steady_levels = 12;            ///< where few touch: no chain of contacts up from the ground is longer
inline constexpr int steady_substeps = 2;
inline constexpr int steady_sweeps = sweeps * substeps / steady_substeps;  ///< at most, in each
inline constexpr scalar settled_gap = scalar(2e-8);      ///< m; a contact with no more than this to be taken back is not displaced
inline constexpr scalar settled_turn = 2 * epsilon;       ///< rad; corrections that round to nothing
inline constexpr scalar friction_max = 1000;             ///< coefficient mu of a body
inline constexpr int substeps_kept = 1000;                ///< the age of a manifold is counted so far
inline constexpr int level_passes_max = 32;       ///< that look for the distance of bodies from the ground
inline constexpr scalar unbounded = scalar(1e30);           ///< m; further than any body is
inline constexpr scalar contact_margin = scalar(0.02);      ///< m; shapes this far apart, and what they travel in a step, have a manifold
inline constexpr scalar fast_margin = 5 * contact_margin;   ///< m; pairs with more than this in a step look for more points
inline constexpr scalar touching_gap = scalar(1e-3);        ///< m; points this far apart are stopped as if they touched, and drawn together
/// Bodies that have moved by less than this against each other, as a fraction of their size and in radians, keep their manifold.
inline constexpr scalar recycled_slip = scalar(1e-3);
/// m/s; a point that carries nothing and approaches more slowly than this is left out of a solve. The position sweep takes back what that adds.
inline constexpr scalar approach_slack = scalar(1e-6);
inline constexpr scalar position_share = scalar(0.4);       ///< of an overlap, taken back in a substep
inline constexpr int landing_pushes = 4;                    ///< of points that bounce within a substep: each leaves 1 % of the way
inline constexpr scalar push_speed_max = scalar(3);         ///< m/s, at which deep overlaps are taken back
inline constexpr int impacts_of_contact = 8;                ///< within a substep, where impacts cause others; in the mean over the contacts
inline constexpr scalar together = scalar(5e-5);            ///< of a substep; impacts no further apart are simultaneous: 0.2 us at 60 Hz
inline constexpr scalar bounce_speed_min = scalar(0.01);    ///< m/s; slower impacts do not bounce
/// The diagonal of a manifold's 4x4 compliance, which has rank 3, is multiplied by this: the load spreads over four points evenly. 1.001 loses
/// digits in float.
inline constexpr scalar block_diagonal = scalar(1.01);

// Contacts solved point by point (points/).
inline constexpr int sweeps_of_points = 16;  ///< of a substep, at most
inline constexpr int rounds_of_points = 4;   ///< over the normals of a manifold in a visit, at most: with 1 a column of ten drifts by millimetres
inline constexpr int rounds_of_pushes = 4;   ///< of the sweep over positions, where something is off
/// m/s; settled_speed there. Less is not to be had: rows at rest round by half of it in a column of ten.
inline constexpr scalar settled_speed_of_points = scalar(1e-6);
/// m/s; a row that is off by no more is left alone, which at rest are nearly all. A slip may go on so: 1 um in 10 s.
inline constexpr scalar ignored_speed = scalar(1e-7);
inline constexpr scalar settled_gap_of_points = scalar(1e-6);  ///< m; settled_gap there: what rounding makes of separations ten metres up
/// Of a point's weight in the middle of a manifold: of those that all are far away, the middle is the mean.
inline constexpr scalar least_point_weight = scalar(1e-6);
/// Of its distance from its slow mean, that friction is drawn towards it in a substep, and the mean towards it: which quietens its ringing.
inline constexpr scalar friction_smoothing = scalar(0.1);
/// Of the square of the cone's radius: friction that is as large slides.
inline constexpr scalar sliding_share_sq = scalar(0.998);

/// Of the sum of the two compliances across n: no less than 3/4 of the greater, so that friction converges. Where they are equal each visit leaves
/// a third of the slip.
inline constexpr scalar friction_stiffening = scalar(0.75);

// The direct solver (direct/).
inline constexpr scalar direct_mass_ratio = 50;             ///< across one contact, from which sweeps do not carry the load in time
inline constexpr int direct_levels = 15;                    ///< of bodies on each other, from which sweeps let a tower lean
inline constexpr int unsettled_steps = 4;                   ///< in a row with sweeps at their bound, from which an island is solved directly
inline constexpr scalar unsettled_speed = scalar(1e-5);      ///< m/s, that sweeps at their bound still correct
inline constexpr int direct_sets_max = 16;                  ///< tried in a solve
inline constexpr int direct_refinements_max = 12;                  ///< of a solve
inline constexpr int direct_refinements_of_sliding = 1;            ///< of one with sliding friction, which is not linear
inline constexpr int direct_newton_steps_max = 6;                  ///< with the same set, where something slides
/// Multiplications that the attempts at an island may spend on factors: before the sweeps of a substep, after them, and for positions,
/// each. 40 cubes on each other take 40000. What takes more is swept.
inline constexpr int direct_work_max = 200000;
inline constexpr double direct_diagonal = 1e-12;             ///< added to the diagonal, as a fraction of it: rows that depend on each other
inline constexpr double direct_roundings = 1e-12;           ///< of the load of a manifold, below which an impulse is rounding
inline constexpr double direct_settled_speed = 1e-9;        ///< m/s; what a solve may leave. What the sweeps leave is a thousand times that
inline constexpr double direct_settled_length = 1e-9;       ///< m

// Sleep (sleep/).
/// m/s; a body no point of which is faster is slow. What the solver leaves of contacts at rest is a thousandth of it and what a pile
/// fidgets a tenth; what falls asleep loses less energy than a drop from 0.1 micrometres gives.
inline constexpr scalar sleep_speed = scalar(1e-3);
inline constexpr scalar sleep_time = scalar(0.5);  ///< s; a body that is slow only on its way has passed by then
/// Of gravity; a body that more than this accelerates is not at rest, however slow.
inline constexpr scalar balance = scalar(0.01);

// Bodies too fast for a step (fast/).
/// A body is fast when it gets further in a step than this times its least half extent: it may be beyond something before a step sees it.
inline constexpr scalar fast_share = 1;
/// Bodies on their way have met when they are apart by this fraction of the lesser of their least half extents, and no more than
/// impact_gap_max: the step that follows finds them touching.
inline constexpr scalar impact_gap = scalar(1e-3);
inline constexpr scalar impact_gap_max = touching_gap / 4;  ///< m
inline constexpr int approaches_max = 64;     ///< of the search for a time of impact; then they are taken for met: too early, never too late
inline constexpr scalar angle_per_path = scalar(0.25);  ///< rad; a body that turns further in a step is followed in parts
inline constexpr int path_parts_max = 256;             ///< of a whole step
/// Bodies that meet are together for as long as they take for this part of the lesser of their least half extents, with half the turn of a path.
inline constexpr scalar together_share = scalar(0.25);
/// Bodies that touch already are looked at without this part of one of them: so deep they may get before they have met again.
inline constexpr scalar skin_share = scalar(0.1);
inline constexpr int skins_max = 6;  ///< that are left out, one after another, of bodies that are deeper in each other already
inline constexpr int impacts_in_step_max = 64;  ///< of fast bodies; those that are left wait for the next step, and are counted
inline constexpr int pair_manifolds_max = 8;  ///< of two bodies of several shapes that meet: the deepest; the others have no room
inline constexpr scalar last_moment = scalar(1e-5);  ///< of a step; what meets later does so in the next

// Narrow phase (collide/). Fractions of a length are of the smallest half extent of both shapes, unless another is named.
/// An edge axis is taken when it separates better than every face by this fraction: nearly parallel edges have no normal of
/// their own, and the face's manifold has the crossing of the edges among its points.
inline constexpr scalar edge_preference = scalar(0.01);
/// The face or edge of the step before is kept until another separates better by this fraction.
inline constexpr scalar axis_hysteresis = scalar(0.005);
/// Corners this far outside the face they lie on, as a fraction of its half extent, count as inside and are moved to its rim:
/// equal boxes on top of each other keep their corners whatever the rounding.
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

// Queries (query/).
/// A moving shape has met another when they are apart by this fraction of the smaller bounding radius. Smaller gaps have worse
/// normals: rounding turns them by epsilon over this.
inline constexpr scalar cast_gap = INGOT_DOUBLE ? scalar(1e-7) : scalar(1e-4);
inline constexpr int cast_iterations_max = 32;  ///< then it is taken for met where it is

/// Corners of a convex hull; indices of corners, edges and corners of faces fit into a byte. no_room beyond.
inline constexpr int hull_vertices_max = 32;
/// Points this far from the plane of a face, as a fraction of the size of the hull, lie in it: what rounding leaves of the
/// faces of a turned solid. A hull thinner than that is bad_shape.
inline constexpr scalar hull_flatness = INGOT_DOUBLE ? scalar(1e-13) : scalar(4e-6);

/// The direction of the nearest points is right when it separates by their distance but for this. It is not where shapes all but
/// touch: of what lies between the points rounding leaves epsilon size / distance.
inline constexpr scalar nearest_direction = scalar(2e-3);
/// Of the search for the direction in which overlapping cylinders are parted by the least way: it ends when a turn gains less
/// than this, or after so many turns; A is held this far away meanwhile.
inline constexpr scalar round_accuracy = scalar(1e-3);
inline constexpr int refinements_max = 8;
inline constexpr scalar refinement_lift = scalar(0.02);
/// Deeper than this the search starts from the best face of either shape and from the best of the rest, else from the best of all.
inline constexpr scalar shallow = scalar(0.1);
/// Corners of the polygon that stands for the end of a cylinder where it lies on something: it is within 1.9 % of the circle.
inline constexpr int cap_corners = 16;
/// A face faces a contact up to this cosine between its normal and that of the manifold; an edge lies across up to this sine.
inline constexpr scalar facing_cos = scalar(0.98);
inline constexpr scalar facing_sin = scalar(0.2);
/// Lines along each other, one of them on something round, make two points if they are apart, sideways, by less than this:
/// then the surface is lower there by half its square, 4.5e-4.
inline constexpr scalar round_aside = scalar(0.03);

} } }  // namespace ingot::limits
