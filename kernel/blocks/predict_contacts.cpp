// SPDX-License-Identifier: MIT
#include "predict_contacts.h"

#include "../base/limits.h"
#include "../math/sqrt.h"
#include "block_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

INGOT_INLINE Vec3<lane> gather_history(const SolverView& solver, const uint16_t* index, scalar (SolverBodyHistory::*part)[4]) {
    scalar rows[3][lanes];
    for (int lane_i = 0; lane_i < lanes; ++lane_i)
        for (int axis = 0; axis < 3; ++axis) rows[axis][lane_i] = (solver.histories[index[lane_i]].*part)[axis];
    return load(rows);
}

/// Points of a block that restitution throws back within the substep.
INGOT_INLINE void predict_bounces(ContactBlock& block, const SolverView& solver, const Vec3<lane>& n, const lane (&separation)[block_rows], scalar h) {
    const BodyPairLanes motion = gather_bodies(solver, block, &SolverBody::v_CM, &SolverBody::L);
    const BodyPairLanes forces = {gather_history(solver, block.body_A, &SolverBodyHistory::a), gather_history(solver, block.body_A, &SolverBodyHistory::tau),
                                  gather_history(solver, block.body_B, &SolverBodyHistory::a), gather_history(solver, block.body_B, &SolverBodyHistory::tau), {}};
    const lane approach = dot(n, motion.linear_A - motion.linear_B), pull = dot(n, forces.linear_A - forces.linear_B);
    const lane step = splat<lane>(h), half = splat<lane>(scalar(0.5)), two = splat<lane>(2), one = splat<lane>(1), e = load(block.e);
    for (int row = 0; row < block.rows; ++row) {
        const lane s = separation[row], speed = row_speed(block.row[row].levers, approach, motion), a = row_speed(block.row[row].levers, pull, forces);
        const mask meets = s + speed * step + a * step * step * half < lane{};
        const mask apart = s > lane{};
        const lane root = sqrt(greatest(speed * speed - two * a * s, lane{}));
        const lane divisor = root - speed;
        const lane when = select(both(apart, divisor > lane{}), least(two * s / select(divisor > lane{}, divisor, one), step), lane{});
        const lane impact = speed + a * when, leaving = -e * impact, rest = step - when;
        const lane rest_speed = greatest(splat<lane>(limits::bounce_speed_min), two * abs(a) * step);
        const mask bounces = both(both(meets, -impact > rest_speed), both(e > lane{}, load(block.B[Sym4::index(row, row)]) > lane{}));
        // A point that does not get there is left alone: to stop it as if it touched would take energy from the bounce to come.
        const mask flies = both(opposite(meets), e > lane{});
        const lane no_bound = load(block.row[row].target) - two * abs(speed);
        store(block.row[row].target, select(bounces, leaving + a * rest, select(flies, no_bound, load(block.row[row].target))));
        store(block.row[row].landing, select(bounces, leaving * rest + a * rest * rest * half, splat<lane>(limits::unbounded)));
    }
}

}  // namespace

void predict_contacts(const SolverView& solver, scalar h) {
    const lane inv_h = splat<lane>(1 / h);
    for (int block_i = 0; block_i < solver.block_count; ++block_i) {
        ContactBlock& block = solver.blocks[block_i];
        const BodyPairLanes displaced = gather_bodies(solver, block, &SolverBody::dp, &SolverBody::dth);
        const Vec3<lane> n = load(block.n);
        const lane apart = dot(n, displaced.linear_A - displaced.linear_B);
        lane separation[block_rows];
        for (int row = 0; row < block.rows; ++row) {
            separation[row] = separation_now(block, row, apart, displaced);
            store(block.row[row].target, -greatest(separation[row] - splat<lane>(limits::touching_gap), lane{}) * inv_h);
        }
        if (any(load(block.e) > lane{})) predict_bounces(block, solver, n, separation, h);
    }
}

} }  // namespace ingot
