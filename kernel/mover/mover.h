// SPDX-License-Identifier: MIT
// A character: a capsule that goes where it is told, over steps and slopes, along walls, on lifts, and is no body.
//
//     ingot::Mover walker;
//     walker.r = {0, 0, 1};
//     for (;;) {
//         (void)ingot::step(world, h);
//         (void)world.move(walker, {{2, 0, 0}}, h);     // 2 m/s over the ground along x
//     }
//
// A user keeps it, copies it, puts it somewhere else. World::move is made of what stands here for everybody: which planes bound the way
// (World::collide_mover), how much of a way they leave (solve_planes), how far nothing else is met (World::cast_mover), and what they leave of a
// velocity (clip_velocity).
#pragma once

#include "../base/ids.h"
#include "../base/status.h"
#include "../broad_phase/body_filter.h"
#include "../shape/shapes.h"

namespace ingot { inline namespace INGOT_ABI {

/// What a mover stands on.
enum class MoverFooting : uint8_t {
    none,      ///< it is in the air
    steep,     ///< it touches ground that is too steep to walk on
    walkable,  ///< it stands
};

/// Ground below a mover.
struct MoverGround {
    MoverFooting footing{};  ///< what it is good for
    BodyId body{};           ///< whose; the null id: none
    int shape{};             ///< which of the body's shapes, where it has several; else 0
    Vector n{};              ///< unit, world: of the face there is; of an edge or a corner, of the most upright of the faces that meet there
    Vector P{};              ///< m, world: where it is touched
    Vector v{};              ///< m/s, of the ground where the mover stands
};

/// A plane that bounds the way of a mover: what it touches is on the other side.
struct MoverPlane {
    Vector n{};                            ///< unit, world: out of what is touched
    scalar gap{};                          ///< m, from the skin of the mover, along n; below 0: the skin is in it, and is pushed out
    scalar push_max = limits::unbounded;   ///< m, how far it pushes at most
    Vector v{};                            ///< m/s, of the surface at P
    Vector P{};                            ///< m, world: on the surface
    Vector upright{};                      ///< unit, world: as MoverGround::n
    BodyId body{};                         ///< whose
    int shape{};                           ///< which of the body's shapes, where it has several; else 0
};

/// A character. Lengths that say so are in units of Scene::length_unit.
struct Mover {
    // Yours to set.
    Capsule capsule = {scalar(0.3), scalar(0.6)};  ///< m; its axis is `up`
    Vector up = {0, 0, 1};               ///< unit, world
    Vector r{};                          ///< m, world: the middle of the capsule
    Vector v{};                          ///< m/s, world; move sets it to what has come of it
    scalar step = scalar(0.35);          ///< length_unit, 0 .. size_max: what is no higher is stepped on
    scalar stick = scalar(0.35);         ///< length_unit, 0 .. size_max: ground that is no lower is stuck to, while it stands
    scalar slope = scalar(0.87266463);   ///< rad, 0 .. 1.5: ground that is no steeper is walked on; 50 degrees
    scalar skin = scalar(0.01);          ///< length_unit, size_min .. : how far it keeps from all there is; no more than the capsule's radius
    scalar force_max = 500;              ///< N, 0 .. limits::force_max: how hard it pushes bodies in its way
    BodyFilter filter = {0xffffffffu, 0xffffffffu};  ///< as if it were a body: it meets those that would meet it; and no sensors

    // What a move tells, and what the next one starts from.
    MoverGround ground{};  ///< where it stands
    Vector r_in_ground{};  ///< m, of its middle in the frame of the body it stands on
    Vector v_drift{};      ///< m/s, world: what it has in the air of the ground that it left, and of gravity across `up`
};

/// What a mover is asked to do in a step.
struct MoverInput {
    Vector v{};       ///< m/s, world, over the ground, in the air too; what is along `up` does not count
    scalar jump = 0;  ///< m/s, along `up`: where it is above 0 it leaves the ground, and in the air jumps once more
};

namespace movers {

inline constexpr int planes_max = 16;
inline constexpr int touches_max = 32;  ///< before those are left out that neighbours hide, and those that say the same
inline constexpr int slides_max = 5;    ///< times that a way is bent by what is met
inline constexpr int lifts_max = 3;     ///< heights that are tried for a step: all of it, a half, a quarter
/// Times all lengths that are given: where planes that are all but parallel meet further away they do not meet. For whoever asks, and for a move:
/// what is pressed between two of them, a wall and a ball, slips no further than this out of their wedge.
inline constexpr scalar far_planes = 1024, far_of_move = 4;
inline constexpr scalar merge_cos = scalar(0.99939083);  ///< planes within 2 degrees are one
/// The most that a plane to stand on may be tilted against `up`, as a sine: what is steeper is a wall, whatever faces meet there.
inline constexpr scalar support_min = scalar(0.05);

// Parts of the skin. A way ends where the skin is entered by `enter`, which is more than what is flush is apart (limits::flush_gap is `flush` of the
// skin at most): so the way over a seam never ends there. What is nearer than `reach` beyond the skin bounds the way.
inline constexpr scalar enter_share = scalar(0.125), reach_share = scalar(0.25), flush_share = scalar(0.0625);
inline constexpr scalar still_share = scalar(1) / 256;  ///< what is so near to the skin is on it: who stands still does not move by roundings

}  // namespace movers

/// Errors: not_finite, out_of_range (beyond the ranges above, and those of limits.h), bad_shape (of the capsule; a skin outside its range),
///         bad_direction (an `up` that is not of unit length).
Status check_mover(const Mover& mover, scalar unit);
/// Errors: not_finite, out_of_range (beyond limits::speed_max; a jump below 0).
Status check_mover_input(const MoverInput& input);

} }  // namespace ingot
