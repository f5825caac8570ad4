// SPDX-License-Identifier: MIT
#include "joint_drives.h"

#include "../base/figure_limits.h"
#include "driven_motion.h"
#include "row_compliance.h"
#include "step_poles.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Calls each(joint, node) for every joint of the batch that has a drive.
template <class Rows, class Each>
void for_driven(const FigureView& view, const Rows& all, const Each& each) {
    for_moving_joints(view, all, [&](const auto& joint) {
        const FigureNode& node = joint.node();
        bool driven = false;
        for (int i = 0; i < drives_in(node.kind, all); ++i) driven = driven || is_driven(node, all, i);  // bound: 3
        if (driven) each(joint, node);
    });
}

Vector unit_along(int direction_i) {
    const auto part = [&](int i) { return i == direction_i ? scalar(1) : scalar(0); };
    return {part(0), part(1), part(2)};
}
scalar along(const Vector& v, int direction_i) { return direction_i == 0 ? v.x : direction_i == 1 ? v.y : v.z; }

/// True of drives whose gains are those of what they move: see set_gains.
bool asks_for_inertia(const JointDrive& drive) { return drive.kind == DriveKind::tuned || drive.kind == DriveKind::motor; }

void set_gains(const JointDrive& drive, DriveMotion& motion, scalar h) {
    motion.resist = motion.spring = 0;
    if (drive.kind == DriveKind::spring) {
        motion.spring = h * drive.stiffness;
        motion.resist = h * drive.damping + h * motion.spring;
    } else if (drive.kind == DriveKind::tuned && drive.stiffness > 0) {
        const scalar phase = min(whole_turn * drive.stiffness * h, limits::tuned_turn_max);
        const Poles poles = poles_of(phase, drive.damping);
        const scalar product = max(1 - poles.lost, epsilon);
        motion.resist = motion.inertia * poles.lost / product;
        motion.spring = motion.inertia * poles.moved / (product * h);
    } else if (drive.kind == DriveKind::motor) {
        motion.resist = limits::motor_gain * motion.inertia;
    }
}

/// How a wheel's spring meets what it carries: of a wheel that is held. Where that cannot move, as any joint.
template <unsigned width, class Rows>
scalar compliance_of_carried(const TreeJoint<width>& joint, const Rows& all) {
    const auto& at = joint.at;
    const FigureRow<width>& row = joint.row();
    const FigureNode& node = joint.node();
    if (node.kind == JointKind::carriage) return at.get(row.inv_D[1]);
    if (node.parent == no_node) return compliance_of(joint, all, unit_along(1));
    const Vector d = read(at, row.d), along = read(at, row.axis_of_parent);
    const Spatial<scalar> sent = impulse_from(Spatial<scalar>{Vector{}, along}, d);
    return dot(along, twist_at(read(at, joint.rows.response(all.responses, node.parent)) * sent, d).v);
}
/// One that closes a loop is tuned for both.
scalar compliance_of_carried(const LoopedJoint& joint, const LoopedRowView& all) { return compliance_of(joint, all, unit_along(1)); }

/// What the drives of a joint have given in the solve: pull - R dq of each, without the digits that this loses where R is much more than the inertia.
template <unsigned width>
void given_by_drives(const TreeJoint<width>& joint, const DrivenRowView& all, scalar (&given)[3]) {
    const auto& [rows, at, row_i] = joint;
    const FigureRow<width>& row = joint.row();
    const FigureNode& node = joint.node();
    Spatial<scalar> u = change_of_parent(rows, at, row_i) + read(at, row.bias), P = read(at, row.impulse), s[3];
    const Vector drive = read(at, row.drive);
    const int free = free_directions(at, row, node.kind, s);
    scalar pressed[3];
    for (int i = 0; i < free; ++i) {  // bound: 3
        pressed[i] = dot(s[i], P);
        P = P - read(at, row.pulled[i]) * ((pressed[i] + along(drive, i)) * at.get(row.inv_D[i]));
    }
    for (int i = free - 1; i >= 0; --i) {  // bound: 3
        const DriveMotion& motion = drive_motion(node, all, i);
        const scalar inv_D = at.get(row.inv_D[i]), held = dot(read(at, row.pulled[i]), u), own = motion.saturated ? 0 : motion.pull;
        const scalar others = pressed[i] + (along(drive, i) - own) - held, resist = motion.saturated ? 0 : motion.resist;
        given[i] = own * (dot(s[i], read(at, row.pulled[i])) * inv_D) - resist * inv_D * others;
        u = u + s[i] * ((others + own) * inv_D);
    }
}

/// The largest impulse of a drive in a substep.
scalar most_of(const JointDrive& drive, scalar h) { return drive.max_torque < unlimited ? h * drive.max_torque : unlimited; }

/// True where more than the largest torque is asked for.
bool is_beyond(JointKind kind, const scalar (&given)[3], int direction_i, scalar most) {
    if (!is_ball(kind)) return abs(given[direction_i]) > most;
    return most < unlimited && length_sq(Vector{given[0], given[1], given[2]}) > most * most;
}

}  // namespace

template <class Rows>
void name_driven_kinds(const FigureView& view, const Rows& all) {
    for (int node_i = 0; node_i < view.node_count; ++node_i) {  // bound: max_bodies
        FigureNode& node = view.nodes[node_i];
        if (node.kind == JointKind::wheel && node.is_A) node.kind = JointKind::carriage;
        if (node.kind == JointKind::ball && drives_in(node.kind, all) > 0 && is_driven(node, all, 0)) node.kind = JointKind::driven_ball;
    }
}

bool place_carriages(const FigureView& view) {
    bool some = false;
    for_joints(view, [&](const auto& rows, const auto& at, int row_i) {
        auto& row = rows[row_i];
        const FigureNode& node = rows.node(row_i, at.lane_i);
        if (node.parent != no_node && rows.node(node.parent, at.lane_i).kind == JointKind::carriage) {
            const auto& parent = rows[node.parent];  // which comes before
            const Vector q = (read(at, row.r) - read(at, row.c)) - (read(at, parent.r) - read(at, parent.c));
            write(at, row.d, q);
        }
        if (node.kind != JointKind::carriage) return;
        some = true;
        const Vector along = read(at, row.axis), to_wheel = along * -dot(along, sides_now(rows, at, row_i, false).gap);
        write(at, row.c, read(at, row.c) - to_wheel);
        if (node.parent != no_node) write(at, row.d, read(at, row.d) + to_wheel);
    });
    return some;
}

template <class Rows>
void begin_drives(const FigureView& view, const Rows& all) {
    for_driven(view, all, [&](const auto& joint, const FigureNode& node) {
        const int count = drives_in(node.kind, all);
        scalar K[3] = {}, sum = 0;
        for (int i = 0; i < count; ++i) {  // bound: 3
            if (!asks_for_inertia(drive_of(node, all, i))) continue;
            K[i] = is_wheel(node.kind) && i == 1 ? compliance_of_carried(joint, all) : compliance_of(joint, all, unit_along(i));
            sum += K[i] / 3;
        }
        for (int i = 0; i < count; ++i) {
            DriveMotion& motion = drive_motion(node, all, i);
            const scalar K_i = is_ball(node.kind) ? sum : K[i];
            motion = {};
            motion.inertia = K_i > 0 ? 1 / K_i : 0;
        }
    });
}

template <class Rows>
void prepare_drives(const FigureView& view, const Rows& all, scalar h) {
    for_moving_joints(view, all, [&](const auto& joint) {
        const FigureNode& node = joint.node();
        for (int i = 0; i < drives_in(node.kind, all); ++i) {  // bound: 3
            DriveMotion& motion = drive_motion(node, all, i);
            motion.saturated = false;
            set_gains(drive_of(node, all, i), motion, h);
        }
    });
}

namespace {

/// True of a ball joint whose drive is three rows that are solved as one, where it is at its largest torque: of one that closes a loop it is a row
/// along the torque that is asked for.
template <unsigned width>
bool is_of_three(const TreeJoint<width>&) {
    return true;
}
bool is_of_three(const LoopedJoint& joint) { return locks_nothing(joint.loop); }

template <unsigned width, class Rows>
Vector answer_of(const TreeJoint<width>& joint, const Rows& all, int direction_i) {
    return answer_of_ball(joint, all, direction_i);
}
template <class Rows>
Vector answer_of(const LoopedJoint&, const Rows&, int) {
    return {};  // it is asked for a row at a time
}
void set_answer(JointRow& row, const Vector& answer) {
    const scalar parts[3] = {answer.x, answer.y, answer.z};
    row.K = max(parts[row.direction_i], 0);
    row.rate_begin = parts[(row.direction_i + 1) % 3];
    row.rate = parts[(row.direction_i + 2) % 3];
}

}  // namespace

template <class Rows>
void aim_drive(const FigureView& view, const Rows& all, JointRow& row, scalar h) {
    at_joint(view, all, row, [&](const auto& joint) {
        const FigureNode& node = joint.node();
        DriveMotion& motion = drive_motion(node, all, row.direction_i);
        const auto pull_of = [&](const DriveError& error, const DriveMotion& of) {
            return h * error.feedforward - of.spring * error.angle - of.resist * error.rate;
        };
        Vector pulls{};
        row.along = unit_along(row.direction_i);
        if (is_ball(node.kind)) {  // its rows follow each other, and the first finds what all three pull
            DriveMotion* const three = &drive_motion(node, all, 0);
            if (row.direction_i == 0) {
                DriveError errors[3];
                ball_errors(joint, all, errors);
                for (int i = 0; i < 3; ++i) three[i].pull = pull_of(errors[i], three[i]);
            }
            pulls = {three[0].pull, three[1].pull, three[2].pull};
        } else {
            motion.pull = pull_of(error_of(joint, all, row.direction_i), motion);
        }
        const bool is_one = !is_ball(node.kind), is_row = motion.saturated || joint.closes;
        row.K = row.gamma = row.lower = row.upper = row.direction = 0;
        row.most = most_of(drive_of(node, all, row.direction_i), h);
        row.j = row.j_sweep = motion.pull;
        if (!is_row) return;
        row.j = row.j_sweep = max(-row.most, min(row.most, motion.pull));
        scalar pull = motion.pull;
        if (!is_one && motion.saturated && is_of_three(joint)) {
            const scalar asked = sqrt(length_sq(pulls));
            row.j = row.j_sweep = asked > row.most ? pull * (row.most / asked) : pull;
        } else if (!is_one && motion.saturated) {
            // Along the torque that is asked for, as far as it may go; the other two rows are none.
            pull = row.direction_i == 0 ? sqrt(length_sq(pulls)) : 0;
            row.along = pull > 0 ? pulls * (1 / pull) : row.along;
            row.j = row.j_sweep = min(row.most, pull);
        }
        if (!(motion.resist > 0) || (!is_one && motion.saturated && !is_of_three(joint) && row.direction_i > 0)) return;
        if (!joint.closes && !is_one)
            set_answer(row, answer_of(joint, all, row.direction_i));
        else
            row.K = compliance_of(joint, all, row.along);
        row.gamma = 1 / motion.resist;
        row.lower = row.upper = pull * row.gamma;
        // Sweeps begin with what it gives by itself: beside what a stiff drive pulls at the rates as they are, what is left of it is rounding.
        if (!shares_with_tree(joint, all, row))
            row.j = row.j_sweep = 0;
        else if (joint.closes && !motion.saturated)
            row.j = row.j_sweep = max(-row.most, min(row.most, pull / (1 + row.K * motion.resist)));
    });
}

namespace {

/// What the drives of a row's joint have given in the solve.
template <unsigned width>
void given_in_solve(const TreeJoint<width>& joint, const DrivenRowView& all, const JointRow*, scalar (&given)[3]) {
    given_by_drives(joint, all, given);
}
/// Those of one that closes a loop are rows of their own; of a ball joint three, one after the other.
void given_in_solve(const LoopedJoint& joint, const DrivenRowView&, const JointRow* row, scalar (&given)[3]) {
    const JointRow* const first = is_ball(joint.node().kind) ? row - row->direction_i : row;
    for (int i = 0; i < 3; ++i) given[i] = is_ball(joint.node().kind) ? first[i].j : i == row->direction_i ? row->j : 0;
}

}  // namespace

namespace {

void loosen_held_ends(const FigureView&, const DrivenRowView&) {}
/// An end that a joint would go beyond, and that gives way by nothing but rounding once the loops hold, is held by a drive of its machine, which has
/// made that stiff: drives that have a largest torque are rows then.
void loosen_held_ends(const FigureView& view, const LoopedRowView& all) {
    const auto machine_of = [&](const JointRow& row) { return all.loops->of_node(view, node_of(all, row)); };
    for (int i = 0; i < all.count; ++i) {  // bound: the rows of joint_row_capacity
        const JointRow& end = all.list[i];
        if (end.is_drive || end.stands || end.K > 0 || !(end.lower > 0 || end.upper < 0)) continue;
        const LoopFigure* const machine = machine_of(end);
        for (int k = 0; k < all.count; ++k) {  // bound: the rows of joint_row_capacity
            const JointRow& row = all.list[k];
            if (row.is_drive && row.most < unlimited && !row.closes && machine != nullptr && machine_of(row) == machine) all.list[k].gave_way = true;
        }
    }
}

}  // namespace

template <class Rows>
bool saturate_drives(const FigureView& view, const Rows& all) {
    bool some = false;
    for (int i = 0; i < all.count; ++i) all.list[i].gave_way = false;  // bound: the rows of joint_row_capacity
    loosen_held_ends(view, all);
    for (int i = 0; i < all.count; ++i) {  // bound: the rows of joint_row_capacity
        JointRow& row = all.list[i];
        const bool is_loosened = row.gave_way;
        row.gave_way = false;
        if (!row.is_drive || !(row.most < unlimited)) continue;
        at_joint(view, all, row, [&](const auto& joint) {
            const FigureNode& node = joint.node();
            DriveMotion& motion = drive_motion(node, all, row.direction_i);
            if (motion.saturated || (joint.closes && !is_ball(node.kind))) return;
            if (is_ball(node.kind) && row.direction_i > 0) return;  // the first has asked for all three
            scalar given[3] = {};
            given_in_solve(joint, all, &row, given);
            if (!is_loosened && !is_beyond(node.kind, given, row.direction_i, row.most)) return;
            some = row.gave_way = motion.saturated = true;
            if (is_ball(node.kind))
                for (int k = 0; k < 3; ++k) drive_motion(node, all, k).saturated = true;
        });
    }
    return some;
}

namespace {

/// By how much the solve as it stands changes the rate along a row.
template <unsigned width>
scalar change_along(const TreeJoint<width>& joint, const JointRow& row) {
    const Spatial<scalar> u = read(joint.at, joint.row().change) - change_of_parent(joint.rows, joint.at, joint.row_i);
    return dot(row.along, free_rates(joint.at, joint.row(), joint.node().kind, u));
}
scalar change_along(const LoopedJoint& joint, const JointRow& row) {
    const ImpulseAlong impulse = impulse_along(joint, row.along);
    const auto change_of = [&](Index node_i) {
        return at_node(joint.view(), node_i, [](const auto& rows, const auto& at, int row_i) { return read(at, rows[row_i].change); });
    };
    const scalar change = dot(impulse.row.on_child, change_of(impulse.child));
    return impulse.other == no_node ? change : change + dot(impulse.row.on_other, change_of(impulse.other));
}

}  // namespace

template <class Rows>
DriveInSolve drive_in_solve(const FigureView& view, const Rows& all, const JointRow& row) {
    return at_joint(view, all, row, [&](const auto& joint) {
        const bool is_row = joint.closes || drive_motion(joint.node(), all, row.direction_i).saturated;
        scalar given[3] = {};
        if (!is_row) given_in_solve(joint, all, &row, given);
        const scalar alone = dot(row.along, joint.rates());
        return DriveInSolve{is_row ? row.j : given[row.direction_i], alone + change_along(joint, row), alone};
    });
}

template <class Rows>
void note_drives(const FigureView& view, const Rows& all) {
    for (int i = 0; i < all.count; ++i) {
        const JointRow& row = all.list[i];
        if (!row.is_drive) continue;
        at_joint(view, all, row, [&](const auto& joint) {
            const FigureNode& node = joint.node();
            DriveMotion& motion = drive_motion(node, all, row.direction_i);
            const bool ball = is_ball(node.kind);
            if (ball && row.direction_i > 0) return;  // the first is for all three
            if (ball && motion.saturated && !is_of_three(joint)) {
                for (int k = 0; k < 3; ++k) drive_motion(node, all, k).sum += along(row.along, k) * row.j;
                return;
            }
            scalar given[3] = {};
            if (ball || !motion.saturated) given_in_solve(joint, all, &row, given);
            for (int k = ball ? 0 : row.direction_i; k <= (ball ? 2 : int{row.direction_i}); ++k) {  // bound: 3
                DriveMotion& of = drive_motion(node, all, k);
                of.j = of.saturated ? (&row)[ball ? k : 0].j : given[k];
                of.sum += of.j;
            }
        });
    }
}

template <class Rows>
void keep_drives(const FigureView& view, const Rows& all, int doublings) {
    for_driven(view, all, [&](const auto& joint, const FigureNode& node) {
        if (joint.figure().doublings > doublings) return;
        DriveRecord* const of = drives_of(node, all);
        scalar torque[3] = {};
        const int count = drives_in(node.kind, all);
        for (int i = 0; i < count; ++i) {  // bound: 3
            const DirectionOfRecord direction = is_ball(node.kind) ? DirectionOfRecord{i, scalar(1)} : of_record(node, i);
            torque[direction.direction_i] = drive_motion(node, all, i).sum * direction.sign / view.h;
        }
        if (is_ball(node.kind)) {
            const Matrix A = node.is_A ? joint.A_of_child() : joint.A_of_parent();
            const Vector in_A = transpose_times(A, Vector{torque[0], torque[1], torque[2]}) * (node.is_A ? scalar(-1) : scalar(1));
            for (int i = 0; i < 3; ++i) torque[i] = along(in_A, i);
        }
        for (int i = 0; i < count; ++i) {
            if (is_finite(torque[i])) of[i].torque = torque[i];  // else of bodies that have gone bad
            of[i].go_on(view.h);
        }
        if (!is_ball(node.kind)) return;
        const Vector target = least_turn({of[0].drive.target, of[1].drive.target, of[2].drive.target});
        for (int i = 0; i < 3; ++i) of[i].drive.target = along(target, i);
    });
}

// The linker takes the one that the scene calls.
#define INGOT_ROWS(Rows)                                                     \
    template void name_driven_kinds(const FigureView&, const Rows&);         \
    template void begin_drives(const FigureView&, const Rows&);              \
    template void prepare_drives(const FigureView&, const Rows&, scalar);    \
    template void aim_drive(const FigureView&, const Rows&, JointRow&, scalar); \
    template bool saturate_drives(const FigureView&, const Rows&);           \
    template DriveInSolve drive_in_solve(const FigureView&, const Rows&, const JointRow&); \
    template void note_drives(const FigureView&, const Rows&);               \
    template void keep_drives(const FigureView&, const Rows&, int)
INGOT_ROWS(DrivenRowView);
INGOT_ROWS(LoopedRowView);
#undef INGOT_ROWS

} }  // namespace ingot

#pragma GCC diagnostic pop
