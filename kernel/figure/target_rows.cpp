// SPDX-License-Identifier: MIT
#include "target_rows.h"

#include "../base/figure_limits.h"
#include "../body/check_body.h"
#include "../math/sqrt.h"
#include "close_loops.h"
#include "driven_motion.h"
#include "step_poles.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Of a force, which = 0, or a torque.
scalar& part_of(scalar (&rows)[rows_of_joint_max], int which, int axis) { return rows[3 * which + axis]; }
Vector vector_of(const scalar* rows, int which) { return {rows[3 * which], rows[3 * which + 1], rows[3 * which + 2]}; }
void set_vector(scalar (&rows)[rows_of_joint_max], int which, const Vector& value) {
    part_of(rows, which, 0) = value.x;
    part_of(rows, which, 1) = value.y;
    part_of(rows, which, 2) = value.z;
}
scalar most_given(const TargetDrive& drive, int which) { return which == 0 ? drive.max_force : drive.max_torque; }

/// N s, N m s, in a substep.
scalar most_of_target(const TargetRecord& record, int which, scalar h) {
    const scalar most = most_given(record.drive(), which);
    return most < unlimited ? h * most : unlimited;
}

Poles poles_of_target(const TargetDrive& drive, scalar h) {
    return poles_of(min(whole_turn * drive.hertz * h, limits::tuned_turn_max), drive.damping_ratio);
}
/// Of what is not damped a little all the same: else all of it would be compliance.
scalar lost_of(const Poles& poles) { return max(poles.lost, 16 * epsilon); }

/// How far a body is beyond its target, and how fast it goes beyond its velocity.
struct TargetError {
    Vector place, turn, v, w;
};
TargetError error_of_target(const FigureView& view, const LoopJoint& loop, const TargetRecord& record) {
    const JointRecord& joint = view.lists.joints[loop.joint];
    const scalar t = view.elapsed;
    return at_node(view, loop.child, [&](const auto& rows, const auto& at, int row_i) {
        const Matrix A = read(at, rows[row_i].A);
        const Vector arm = A * joint.frame_B.anchor, w = read(at, rows[row_i].w);
        const Matrix own = triad_of(A * joint.frame_B.axis, A * joint.frame_B.side);
        const Matrix target = rotation_by(record.spin * t) * triad_of(joint.frame_A.axis, joint.frame_A.side);
        return TargetError{read(at, rows[row_i].r) + arm - (joint.frame_A.anchor + record.velocity * t),
                           rotation_vector_of(times_transposed(own, target)), read(at, rows[row_i].v) + cross(w, arm) - record.velocity,
                           w - record.spin};
    });
}

/// The twist of a body alone for an impulse on it, at its q.
Spatial<scalar> answer_alone(const FigureView& view, Index node_i, const Spatial<scalar>& f) {
    return at_node(view, node_i, [&](const auto& rows, const auto& at, int row_i) {
        const Matrix A = read(at, rows[row_i].A);
        const Vector c = read(at, rows[row_i].c), I = read(at, rows[row_i].I_body);
        const Vector w = A * unscaled(I, transpose_times(A, f.w - cross(c, f.v)));
        return Spatial<scalar>{w, f.v * (1 / at.get(rows[row_i].M)) - cross(w, c)};
    });
}

}  // namespace

void begin_targets(const LoopView& loops, const LoopFigure& of, scalar h) {
    for_loop_joints(loops, of, [&](LoopJoint& loop) {
        if (loop.kind != JointKind::target) return;
        TargetMotion& motion = loops.target_motions[loop.joint];
        const TargetDrive drive = loops.targets[loop.joint].drive();
        const scalar lost = lost_of(poles_of_target(drive, h));
        motion = {};
        motion.h = h;
        motion.share = (1 - lost) / lost;
        for (int which = 0; which < 2; ++which) {
            motion.held[which] = !(most_given(drive, which) > 0) || !(drive.hertz > 0);
        }
    });
}

void aim_targets(const FigureView& view, const LoopView& loops, const LoopFigure& of, scalar h) {
    for_loop_joints(loops, of, [&](LoopJoint& loop) {
        if (loop.kind != JointKind::target) return;
        const TargetRecord& record = loops.targets[loop.joint];
        TargetMotion& motion = loops.target_motions[loop.joint];
        const TargetError error = error_of_target(view, loop, record);
        const Poles poles = poles_of_target(record.drive(), h);
        const scalar pull = poles.moved / (lost_of(poles) * h);
        set_vector(loop.target, 0, -error.v - error.place * pull);
        set_vector(loop.target, 1, -error.w - error.turn * pull);
        for (int which = 0; which < 2; ++which) {
            if (!motion.held[which]) continue;
            const scalar most = record.hertz > 0 ? most_of_target(record, which, h) : 0;
            const Vector asked = vector_of(loop.target, which);
            const scalar size = sqrt(length_sq(asked));
            set_vector(loop.j, which, size > 0 ? asked * (most / size) : Vector{});
        }
    });
}

scalar give_between(const FigureView& view, const LoopView& loops, const LoopJoint& loop, int row, int other) {
    return loops.target_motions[loop.joint].share * dot(loop.rows[row].on_child, answer_alone(view, loop.child, loop.rows[other].on_child));
}

scalar give_of_target(const FigureView& view, const LoopView& loops, const LoopJoint& loop, int row) {
    const TargetMotion& motion = loops.target_motions[loop.joint];
    Spatial<scalar> f{};
    for (int i = 0; i < loop.row_count; ++i)  // bound: rows_of_joint_max
        if (!motion.held[i / 3]) f = f + loop.rows[i].on_child * loop.j[i];
    return motion.share * dot(loop.rows[row].on_child, answer_alone(view, loop.child, f));
}

bool settle_target(const FigureView& view, const LoopView& loops, LoopJoint& loop, const scalar* more, bool may_release) {
    const TargetRecord& record = loops.targets[loop.joint];
    TargetMotion& motion = loops.target_motions[loop.joint];
    bool some = false;
    for (int which = 0; which < 2; ++which) {
        const scalar most = most_of_target(record, which, motion.h);
        if (!(most < unlimited) || !(most > 0) || !(record.hertz > 0)) continue;
        const Vector given = vector_of(loop.j, which) + vector_of(more, which);
        const scalar size = sqrt(length_sq(given));
        if (!motion.held[which]) {
            if (!(size > most)) continue;
            motion.held[which] = true;
            set_vector(loop.j, which, given * (most / size));
            some = true;
        } else if (may_release && size > 0) {
            // Along what is given: what the law asks for as the body moves now.
            const Vector along = given * (1 / size);
            const Spatial<scalar> change = change_of_body(view, loop.child);
            scalar lack = 0, give = 0;
            Spatial<scalar> f{};
            for (int axis = 0; axis < 3; ++axis) {
                const int row = 3 * which + axis;
                const scalar part = axis == 0 ? along.x : axis == 1 ? along.y : along.z;
                lack += part * (loop.target[row] - dot(loop.rows[row].on_child, change));
                f = f + loop.rows[row].on_child * part;
            }
            give = motion.share * dot(f, answer_alone(view, loop.child, f));
            if (lack >= most * give) continue;
            motion.held[which] = false;
            set_vector(loop.j, which, {});
            some = true;
        }
    }
    return some;
}

void note_targets(const FigureView& view, const LoopView& loops) {
    if (loops.targets == nullptr) return;
    for_looped_figures(view, loops, [&](const LoopFigure& of) {
        for_loop_joints(loops, of, [&](const LoopJoint& loop) {
            if (loop.kind != JointKind::target) return;
            TargetMotion& motion = loops.target_motions[loop.joint];
            motion.force = motion.force + vector_of(loop.j, 0);
            motion.torque = motion.torque + vector_of(loop.j, 1);
        });
    });
}

void keep_target(const FigureView& view, const LoopView& loops, const LoopJoint& loop) {
    TargetRecord& record = loops.targets[loop.joint];
    const TargetMotion& motion = loops.target_motions[loop.joint];
    JointFrame& target = view.lists.joints[loop.joint].frame_A;
    const Vector force = motion.force * (1 / view.h), torque = motion.torque * (1 / view.h);
    if (is_finite(force) && is_finite(torque)) {  // else of a body that has gone bad
        record.force = force;
        record.torque = torque;
    }
    const Vector P = target.anchor + record.velocity * view.h;
    const auto within = [](scalar x) { return max(-limits::position_max, min(limits::position_max, x)); };
    target.anchor = {within(P.x), within(P.y), within(P.z)};
    if (!(length_sq(record.spin) > 0)) return;
    const Matrix turned = nearest_rotation(rotation_by(record.spin * view.h) * triad_of(target.axis, target.side));
    target.axis = turned.c0;
    target.side = turned.c1;
}

} }  // namespace ingot
