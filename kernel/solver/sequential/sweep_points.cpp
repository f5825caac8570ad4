// SPDX-License-Identifier: MIT
#include "sweep_points.h"

#include "../../base/limits.h"
#include "../../math/sqrt.h"
#include "point_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// A manifold with its bodies, while it is visited.
struct PointVisit {
    PointPair pair;
    ManifoldRecord& record;
    PointContact& contact;

    INGOT_INLINE const Vector& n() const { return record.manifold.n; }
    INGOT_INLINE int count() const { return record.manifold.count; }
    INGOT_INLINE const Vector& P(int point_i) const { return record.manifold.points[point_i].P; }
};
PointVisit visit_of(const PointView& solver, int manifold_i) {
    const BodyPair& pair = solver.pairs[manifold_i];
    return {{solver.bodies[pair.body_A], solver.bodies[pair.body_B]}, solver.records[pair.record], solver.contacts[manifold_i]};
}

/// Motion along n at the points of a manifold: n.(V + W x d) = n.V + (n x W).d at a distance d from the middle.
struct NormalMotion {
    Vector slope, middle;
    scalar at_middle;

    INGOT_INLINE scalar at(const Vector& P) const { return at_middle + dot(slope, P - middle); }
};
INGOT_INLINE NormalMotion normal_motion(const PointVisit& visit, const RelativeVelocity& relative) {
    return {cross(visit.n(), relative.angular), visit.contact.middle, dot(visit.n(), relative.linear)};
}
INGOT_INLINE NormalMotion normal_motion(const PointVisit& visit, MotionOfBody kind) {
    return normal_motion(visit, relative_motion(visit.pair, kind, visit.contact.middle));
}

scalar compliance_of_point(const PointVisit& visit, int point_i) {
    scalar& K = visit.contact.K[point_i];
    if (K == 0) K = compliance_at(visit.pair, visit.P(point_i), visit.n());
    return K;
}
scalar compliance_of_friction(const PointVisit& visit) {
    scalar& K = visit.contact.K_friction;
    if (K == 0) K = compliance_across(visit.pair, visit.contact.middle, visit.n()) * limits::friction_stiffening;
    return K;
}

scalar load_on(const PointVisit& visit) {
    scalar sum = 0;
    for (int point_i = 0; point_i < visit.count(); ++point_i) sum += visit.record.j[point_i];  // bound: 4: Manifold::points_max
    return sum;
}

/// Friction cut to its cone.
Vector clamp_length(const Vector& f, scalar limit) {
    const scalar size_sq = length_sq(f);
    return size_sq > limit * limit ? f * (limit / sqrt(size_sq)) : f;
}

/// Points stop as if they touched from touching_gap on.
scalar resting_speed(scalar separation, scalar h) { return -max(separation - limits::touching_gap, scalar(0)) / h; }

/// Of gravity and forces, m^2 s^-4.
scalar pull_sq_on(const PointBody& body) { return body.inv_M > 0 ? length_sq(body.forces.linear) : 0; }

/// What is kept of the normals of bodies that were hit: of an impact no more than gravity explains.
void cut_impulses_of_hit(const PointVisit& visit, scalar h) {
    const scalar allowance = 2 * h * sqrt(max(pull_sq_on(visit.pair.A), pull_sq_on(visit.pair.B)));
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        scalar& j = visit.record.j[point_i];
        j = min(j, 2 * visit.record.j_before[point_i] + allowance / compliance_of_point(visit, point_i));
    }
}

/// Adds a row's change of impulse.
void note_change(SweepOfPoints& sweep, scalar d, scalar K, scalar lever) {
    sweep.fastest = max(sweep.fastest, d * K * lever);
    sweep.size += d * d * K;
}

/// One round over the normals, which keeps `relative` up to date. Returns the largest speed corrected, m/s.
scalar round_of_normals(const PointVisit& visit, RelativeVelocity& relative, scalar ignored, SweepOfPoints& sweep) {
    scalar largest = 0;
    NormalMotion motion = normal_motion(visit, relative);
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        scalar& j = visit.record.j[point_i];
        const scalar speed = motion.at(visit.P(point_i)) - visit.contact.target[point_i];
        if (j > 0 ? abs(speed) <= ignored : j == 0 && speed >= -ignored) continue;
        const scalar K = compliance_of_point(visit, point_i), d = max(-speed / K, -j);
        j += d;
        visit.contact.change.j[point_i] += d;
        largest = max(largest, abs(d * K));
        note_change(sweep, abs(d), K, 1);
        push_pair(visit.pair, &PointBody::velocity, visit.P(point_i), visit.n() * d, {});
        relative = relative_motion(visit.pair, &PointBody::velocity, visit.contact.middle);
        motion = normal_motion(visit, relative);
    }
    return largest;
}

void solve_friction(const PointVisit& visit, const RelativeVelocity& relative, scalar limit, scalar ignored, SweepOfPoints& sweep) {
    const Vector slip = relative.linear - visit.n() * dot(visit.n(), relative.linear), before = visit.record.j_friction;
    if (length_sq(slip) <= ignored * ignored && length_sq(before) <= limit * limit) return;
    const scalar K = compliance_of_friction(visit);
    const Vector next = clamp_length(before - slip * (1 / K), limit), d = next - before;
    visit.record.j_friction = next;
    visit.contact.change.friction += d;
    push_pair(visit.pair, &PointBody::velocity, visit.contact.middle, d, {});
    note_change(sweep, sqrt(length_sq(d)), K, 1);
}

/// True if it changed something.
bool solve_torsion(const PointVisit& visit, const RelativeVelocity& relative, scalar limit, scalar ignored, SweepOfPoints& sweep) {
    const scalar spin = dot(visit.n(), relative.angular), before = visit.record.j_torsion, radius = visit.contact.radius;
    if (abs(spin) * radius <= ignored && abs(before) <= limit * radius) return false;
    const scalar K = compliance_about(visit.pair, visit.n());
    const scalar next = clamp(before - spin / K, limit * radius), d = next - before;
    visit.record.j_torsion = next;
    visit.contact.change.torsion += d;
    push_pair(visit.pair, &PointBody::velocity, visit.contact.middle, {}, visit.n() * d);
    note_change(sweep, abs(d), K, radius);
    return true;
}

void visit_velocities(const PointVisit& visit, scalar ignored, SweepOfPoints& sweep) {
    RelativeVelocity relative = relative_motion(visit.pair, &PointBody::velocity, visit.contact.middle);
    for (int round_i = 0; round_i < limits::rounds_of_points; ++round_i)
        if (round_of_normals(visit, relative, ignored, sweep) <= ignored) break;
    const scalar limit = visit.record.mu * load_on(visit);
    if (solve_torsion(visit, relative, limit, ignored, sweep)) relative = relative_motion(visit.pair, &PointBody::velocity, visit.contact.middle);
    solve_friction(visit, relative, limit, ignored, sweep);
}

/// What of each point is to be taken back.
struct PointsOff {
    scalar separation[Manifold::points_max], wanted[Manifold::points_max], q[Manifold::points_max];  ///< m, m, kg m
};

/// Pressed points are brought together from either side; others only push.
void round_of_pushes(const PointVisit& visit, PointsOff& off) {
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        const scalar moved = normal_motion(visit, &PointBody::displacement).at(visit.P(point_i)) + off.separation[point_i];
        scalar d = -(off.wanted[point_i] + moved) / compliance_of_point(visit, point_i);
        if (!(visit.record.j[point_i] > 0)) d = max(d, -off.q[point_i]);
        off.q[point_i] += d;
        push_pair(visit.pair, &PointBody::displacement, visit.P(point_i), visit.n() * d, {});
    }
}

void visit_positions(const PointVisit& visit, scalar h) {
    visit.contact.change = {};
    if (visit.pair.A.hit || visit.pair.B.hit) cut_impulses_of_hit(visit, h);
    const NormalMotion motion = normal_motion(visit, &PointBody::displacement);
    PointsOff off;
    bool is_off = false;
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        const scalar moved = motion.at(visit.P(point_i)), s = visit.record.manifold.points[point_i].separation + moved;
        const bool pressed = visit.record.j[point_i] > 0;
        visit.record.j_before[point_i] = visit.record.j[point_i];
        const scalar w = pressed || s < 0 ? max(s * limits::position_share, -limits::push_speed_max * h) : s;
        visit.contact.target[point_i] = resting_speed(s, h);
        is_off = is_off || (pressed ? abs(w) : -w) > limits::settled_gap_of_points;
        off.separation[point_i] = -moved;
        off.wanted[point_i] = w;
        off.q[point_i] = 0;
    }
    for (int round_i = 0; is_off && round_i < limits::rounds_of_pushes; ++round_i) round_of_pushes(visit, off);
}

void scale_impulses(ManifoldRecord& record, scalar share) {
    for (int point_i = 0; point_i < record.manifold.count; ++point_i) record.j[point_i] *= share;  // bound: 4: Manifold::points_max
    record.j_friction = record.j_friction * share;
    record.j_torsion *= share;
}

void begin_contact(const PointVisit& visit, scalar share, scalar h) {
    PointContact& contact = visit.contact;
    contact = {};
    scale_impulses(visit.record, share);
    scalar weight[Manifold::points_max], weights = 0;
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        const scalar separation = visit.record.manifold.points[point_i].separation;
        contact.target[point_i] = resting_speed(separation, h);
        visit.record.j_before[point_i] = visit.record.j[point_i];
        weight[point_i] = max(min(2 - separation / limits::contact_margin, scalar(1)), scalar(1e-6));
        weights += weight[point_i];
        contact.middle += visit.P(point_i) * weight[point_i];
    }
    contact.middle = contact.middle * (1 / weights);
    for (int point_i = 0; visit.count() > 1 && point_i < visit.count(); ++point_i)
        contact.radius += weight[point_i] / weights * sqrt(length_sq(visit.P(point_i) - contact.middle));
    visit.record.j_friction -= visit.n() * dot(visit.n(), visit.record.j_friction);
}

void give(const PointVisit& visit, const scalar* j, const Vector& friction, scalar torsion) {
    Vector levers = {0, 0, 0};
    scalar sum = 0;
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        levers += (visit.P(point_i) - visit.contact.middle) * j[point_i];
        sum += j[point_i];
    }
    push_pair(visit.pair, &PointBody::velocity, visit.contact.middle, visit.n() * sum + friction, cross(levers, visit.n()) + visit.n() * torsion);
}

void start_visit(const PointVisit& visit) {
    ManifoldRecord& record = visit.record;
    const scalar limit = record.mu * load_on(visit);
    record.j_friction = clamp_length(record.j_friction, limit);
    record.j_torsion = clamp(record.j_torsion, limit * visit.contact.radius);
    give(visit, record.j, record.j_friction, record.j_torsion);
}

void go_on(const PointVisit& visit, scalar beta) {
    ManifoldRecord& record = visit.record;
    PointImpulses &change = visit.contact.change, &along = visit.contact.along;
    scalar j[Manifold::points_max];
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        along.j[point_i] = along.j[point_i] * beta + change.j[point_i];
        j[point_i] = along.j[point_i] * beta;
        record.j[point_i] += j[point_i];
    }
    along.friction = along.friction * beta + change.friction;
    along.torsion = along.torsion * beta + change.torsion;
    record.j_friction += along.friction * beta;
    record.j_torsion += along.torsion * beta;
    change = {};
    give(visit, j, along.friction * beta, along.torsion * beta);
}

/// Calls a stage for the manifolds of the island at hand.
template <class Stage>
void over_manifolds(const PointView& solver, bool forward, const Stage& stage) {
    // bound: max_manifolds
    for (int i = 0; i < solver.member_count; ++i) stage(visit_of(solver, solver.members[forward ? i : solver.member_count - 1 - i]));
}

}  // namespace

void begin_contacts(const PointView& solver, scalar share, scalar h) {
    over_manifolds(solver, true, [share, h](const PointVisit& visit) { begin_contact(visit, share, h); });
}

void end_contacts(const PointView& solver, scalar share, bool steady) {
    over_manifolds(solver, true, [share, steady](const PointVisit& visit) {
        scale_impulses(visit.record, share);
        visit.record.substeps = steady ? steady_bit : uint16_t(0);
    });
}

void warm_start(const PointView& solver) {
    over_manifolds(solver, true, [](const PointVisit& visit) { start_visit(visit); });
}

SweepOfPoints sweep_point_velocities(const PointView& solver, bool forward, scalar ignored) {
    SweepOfPoints sweep = {0, 0};
    over_manifolds(solver, forward, [&](const PointVisit& visit) { visit_velocities(visit, ignored, sweep); });
    return sweep;
}

void go_on_along(const PointView& solver, scalar beta) {
    over_manifolds(solver, true, [beta](const PointVisit& visit) { go_on(visit, beta); });
}

void sweep_point_positions(const PointView& solver, scalar h) {
    over_manifolds(solver, true, [h](const PointVisit& visit) { visit_positions(visit, h); });
}

} }  // namespace ingot
