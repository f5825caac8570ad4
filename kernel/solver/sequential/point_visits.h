// SPDX-License-Identifier: MIT
// What a visit to a manifold does, for sweep_points.cpp and sequential_materials.cpp. Each of them compiles it for a view of its own, so a scene
// links only the one that it needs.
#pragma once

#include "../../constraint/flight.h"
#include "point_visit.h"
#include "sweep_points.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

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

INGOT_SHARED scalar load_on(const PointVisit& visit) {
    scalar sum = 0;
    for (int point_i = 0; point_i < visit.count(); ++point_i) sum += visit.record.j[point_i];  // bound: 4: Manifold::points_max
    return sum;
}

/// Friction cut to its cone.
Vector clamp_length(const Vector& f, scalar limit) {
    const scalar size_sq = length_sq(f);
    return size_sq > limit * limit ? f * cone_cut(size_sq, limit) : f;
}

/// gap: m, limits::touching_gap at the scale of the contact.
INGOT_INLINE scalar resting_speed(scalar separation, scalar gap, scalar h) { return -resting_room(separation, gap) / h; }

/// The part of v across n.
INGOT_SHARED Vector across(const Vector& n, const Vector& v) { return v - n * dot(n, v); }

/// Of gravity and forces, m^2 s^-4.
scalar pull_sq_on(const PointBody& body) { return body.inv_M > 0 ? length_sq(body.forces.linear) : 0; }

/// m/s, that forces explain of a change of speed in a substep of h seconds: twice that of the larger.
[[maybe_unused]] scalar allowance_of(const PointPair& pair, scalar h) { return 2 * h * sqrt(max(pull_sq_on(pair.A), pull_sq_on(pair.B))); }

/// Cuts the impulses of normals on bodies that were hit: of an impact no more is kept than gravity explains.
[[maybe_unused]] void cut_impulses_of_hit(const PointVisit& visit, scalar h) {
    const scalar allowance = allowance_of(visit.pair, h);
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        scalar& j = visit.record.j[point_i];
        j = impulse_after_impact(j, visit.record.j_before[point_i], allowance, compliance_of_point(visit, point_i));
    }
}

/// Adds a row's change of impulse.
INGOT_SHARED void note_change(SweepOfPoints& sweep, scalar d, scalar K, scalar lever) {
    sweep.fastest = max(sweep.fastest, d * K * lever);
    sweep.size += d * d * K;
}

/// One round over the normals, which keeps `relative` up to date. Returns the largest speed corrected, m/s.
template <class Visit>
scalar round_of_normals(const Visit& visit, RelativeVelocity& relative, scalar ignored, SweepOfPoints& sweep) {
    scalar largest = 0;
    NormalMotion motion;
    bool is_known = false;
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        if (!is_known) motion = normal_motion(visit, relative);
        is_known = true;
        scalar& j = visit.record.j[point_i];
        const scalar speed = motion.at(visit.P(point_i)) - visit.contact.target[point_i];
        if (j > 0 ? abs(speed) <= ignored : j == 0 && speed >= -ignored) continue;
        const scalar K = compliance_of_point(visit, point_i), d = max(-speed / K, -j);
        j += d;
        visit.contact.change.j[point_i] += d;
        largest = max(largest, abs(d * K));
        note_change(sweep, abs(d), K, 1);
        push_pair(visit.pair, &PointBody::velocity, visit.P(point_i), visit.n() * d, {});
        relative = relative_motion(pair_in(visit), &PointBody::velocity, visit.contact.middle);
        is_known = false;
    }
    return largest;
}

/// Friction within its circle; where the slip turns round in the substep, within the smaller circle about what is given before that: see
/// reversal_share.
INGOT_SHARED Vector clamp_friction(const PointContact& contact, const Vector& f, scalar limit) {
    const scalar share_sq = length_sq(contact.before_reversal);
    if (share_sq == 0) return clamp_length(f, limit);
    const Vector given = contact.before_reversal * limit;
    return given + clamp_length(f - given, limit * (1 - sqrt(share_sq)));
}

[[maybe_unused]] void solve_friction(const PointVisit& visit, const RelativeVelocity& relative, scalar limit, scalar ignored, SweepOfPoints& sweep) {
    const Vector slip = across(visit.n(), relative.linear), before = visit.record.j_friction;
    if (length_sq(slip) <= ignored * ignored && length_sq(before) <= limit * limit) return;
    const scalar K = compliance_of_friction(visit);
    const Vector d = clamp_friction(visit.contact, before - slip * (1 / K), limit) - before, next = before + d;
    visit.record.j_friction = next;
    visit.contact.change.friction += d;
    push_pair(visit.pair, &PointBody::velocity, visit.contact.middle, d, {});
    note_change(sweep, sqrt(length_sq(d)), K, 1);
}

/// True if it changed something.
[[maybe_unused]] bool solve_torsion(const PointVisit& visit, const RelativeVelocity& relative, scalar limit, scalar ignored, SweepOfPoints& sweep) {
    const scalar spin = dot(visit.n(), relative.angular), before = visit.record.j_torsion, radius = visit.contact.radius;
    if (abs(spin) * radius <= ignored && abs(before) <= limit * radius) return false;
    const scalar K = compliance_about(visit.pair, visit.n());
    const scalar next = clamp(K > 0 ? before - spin / K : before, limit * radius), d = next - before;  // K is 0 where locks leave no turn
    visit.record.j_torsion = next;
    visit.contact.change.torsion += d;
    push_pair(visit.pair, &PointBody::velocity, visit.contact.middle, {}, visit.n() * d);
    note_change(sweep, abs(d), K, radius);
    return true;
}

/// Resistance to being rolled: a torque across n, up to lever N. True if it changed something.
template <class View>
bool solve_rolling(const VisitOf<View>& visit, const RelativeVelocity& relative, scalar load, scalar ignored, SweepOfPoints& sweep) {
    PointRolling& rolling = visit.rolling();
    if (!(rolling.K > 0)) return false;
    RollingRecord& record = visit.rolling_record();
    const Vector spin = across(visit.n(), relative.angular), before = record.j;
    const scalar limit = record.lever * load, ignored_spin = ignored / rolling.size;
    if (length_sq(spin) <= ignored_spin * ignored_spin && length_sq(before) <= limit * limit) return false;
    const Vector next = clamp_length(before - spin * (1 / rolling.K), limit), d = next - before;
    record.j = next;
    rolling.change += d;
    push_pair(visit.pair, &PointBody::velocity, visit.contact.middle, {}, d);
    note_change(sweep, sqrt(length_sq(d)), rolling.K, rolling.size);
    return true;
}

template <class View>
void visit_velocities(const VisitOf<View>& visit, scalar ignored, SweepOfPoints& sweep) {
    RelativeVelocity relative = relative_motion(pair_in(visit), &PointBody::velocity, visit.contact.middle);
    for (int round_i = 0; round_i < limits::rounds_of_points; ++round_i)
        if (round_of_normals(visit, relative, ignored, sweep) <= ignored) break;
    const scalar load = load_on(visit), limit = visit.record.mu * load;
    bool turned = solve_torsion(visit, relative, limit, ignored, sweep);
    if constexpr (View::rolls) turned = solve_rolling(visit, relative, load, ignored, sweep) || turned;  // across n: the torsion is about it
    if (turned) relative = relative_motion(pair_in(visit), &PointBody::velocity, visit.contact.middle);
    if constexpr (View::has_belts) relative.linear += visit.belt_velocity();
    solve_friction(visit, relative, limit, ignored, sweep);
}

/// What of each point is to be taken back.
struct PointsOff {
    scalar separation[Manifold::points_max], wanted[Manifold::points_max], q[Manifold::points_max];  ///< m, m, kg m
};

/// kg^-1, of both bodies.
INGOT_INLINE scalar inv_M_of(const PointPair& pair) { return max(pair.A.inv_M, scalar(0)) + max(pair.B.inv_M, scalar(0)); }

/// Pressed points, and those that land, are brought to their place from either side; others only push.
template <class View>
INGOT_INLINE bool pulls(const VisitOf<View>& visit, scalar inv_M_of_both, int point_i) {
    bool is_pulled = presses(visit.record.j[point_i], inv_M_of_both, visit.unit);
    if constexpr (View::bounces) is_pulled = is_pulled || visit.lands(point_i);
    return is_pulled;
}
template <class View>
void round_of_pushes(const VisitOf<View>& visit, scalar inv_M_of_both, PointsOff& off) {
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        const scalar moved = normal_displacement(visit).at(visit.P(point_i)) + off.separation[point_i];
        scalar d = -(off.wanted[point_i] + moved) / compliance_of_point(visit, point_i);
        if (!pulls(visit, inv_M_of_both, point_i)) d = max(d, -off.q[point_i]);
        off.q[point_i] += d;
        push_pair(visit.pair, &PointBody::displacement, visit.P(point_i), visit.n() * d, {});
    }
}

/// Number by number: cleared as a whole it would be a call of memset.
INGOT_INLINE void clear(PointImpulses& impulses) {
    for (scalar& j : impulses.j) j = 0;
    impulses.friction = {};
    impulses.torsion = 0;
}

template <class View>
void visit_positions(const VisitOf<View>& visit, scalar h) {
    clear(visit.contact.change);
    if constexpr (View::rolls) visit.rolling().change = {};
    if (visit.pair.A.hit || visit.pair.B.hit) cut_impulses_of_hit(visit, h);
    const NormalMotion motion = normal_displacement(visit);
    const scalar scale = visit.scale(), touching_gap = limits::touching_gap * scale, settled_gap = limits::settled_gap_of_points * scale;
    const scalar inv_M_of_both = inv_M_of(visit.pair);
    PointsOff off;
    bool is_off = false;
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        const scalar moved = motion.at(visit.P(point_i)), s = visit.record.manifold.points[point_i].separation + moved;
        const bool pressed = pulls(visit, inv_M_of_both, point_i);
        visit.record.j_before[point_i] = visit.record.j[point_i];
        scalar w = position_target(s, pressed, -limits::push_speed_max * h * visit.unit);
        if constexpr (View::bounces)
            if (visit.lands(point_i)) w = s - visit.landing(point_i);
        visit.contact.target[point_i] = resting_speed(s, touching_gap, h);
        is_off = is_off || (pressed ? abs(w) : -w) > settled_gap;
        off.separation[point_i] = -moved;
        off.wanted[point_i] = w;
        off.q[point_i] = 0;
    }
    for (int round_i = 0; is_off && round_i < limits::rounds_of_pushes; ++round_i) round_of_pushes(visit, inv_M_of_both, off);
}

INGOT_SHARED void scale_impulses(ManifoldRecord& record, scalar share) {
    for (int point_i = 0; point_i < record.manifold.count; ++point_i) record.j[point_i] *= share;  // bound: 4: Manifold::points_max
    record.j_friction = record.j_friction * share;
    record.j_torsion *= share;
}

/// Compliance of turning across n, as compliance_across: less than the sum of both, no less than 3/4 of the greater.
template <class View>
void begin_rolling(const VisitOf<View>& visit, scalar share) {
    const auto trace_of = [](const PointBody& body) { return body.inv_M > 0 ? body.turning_compliances() : scalar(0); };
    const PointBody &A = visit.pair.A, &B = visit.pair.B;
    const scalar about = compliance_about(visit.pair, visit.n());
    RollingRecord& record = visit.rolling_record();
    PointRolling& rolling = visit.rolling();
    const scalar trace = trace_of(A) + trace_of(B), K = trace - about;
    // Locked axes may leave no turn across n, and a rounding, of either sign, in its place: 0, and nothing rolls.
    rolling.K = K > 64 * epsilon * trace ? K * limits::friction_stiffening : scalar(0);
    rolling.size = rolling.K > 0 ? sqrt(((A.inv_M > 0 ? A.inv_M : 0) + (B.inv_M > 0 ? B.inv_M : 0)) / rolling.K) : scalar(0);
    rolling.change = rolling.along = {};
    record.j = rolling.K > 0 ? across(visit.n(), record.j) * share : Vector{};
}

template <class View>
void begin_contact(const VisitOf<View>& visit, scalar share, scalar h) {
    PointContact& contact = visit.contact;
    contact = {};
    if constexpr (View::rolls) begin_rolling(visit, share);
    if constexpr (View::bounces)
        for (int point_i = 0; point_i < Manifold::points_max; ++point_i) visit.landing(point_i) = limits::unbounded;
    scale_impulses(visit.record, share);
    const scalar scale = visit.scale(), touching_gap = limits::touching_gap * scale, margin = limits::contact_margin * scale;
    scalar weight[Manifold::points_max], weights = 0;
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        const scalar separation = visit.record.manifold.points[point_i].separation;
        contact.target[point_i] = resting_speed(separation, touching_gap, h);
        visit.record.j_before[point_i] = visit.record.j[point_i];
        weight[point_i] = max(nearness(separation, margin), limits::least_point_weight);
        weights += weight[point_i];
        contact.middle += visit.P(point_i) * weight[point_i];
    }
    contact.middle = contact.middle * (1 / weights);
    for (int point_i = 0; visit.count() > 1 && point_i < visit.count(); ++point_i)
        contact.radius += weight[point_i] / weights * sqrt(length_sq(visit.P(point_i) - contact.middle));
    visit.record.j_friction = across(visit.n(), visit.record.j_friction);
}

[[maybe_unused]] void give_impulses(const PointVisit& visit, const scalar* j, const Vector& friction, scalar torsion) {
    Vector levers = {0, 0, 0};
    scalar sum = 0;
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        levers += (visit.P(point_i) - visit.contact.middle) * j[point_i];
        sum += j[point_i];
    }
    push_pair(visit.pair, &PointBody::velocity, visit.contact.middle, visit.n() * sum + friction, cross(levers, visit.n()) + visit.n() * torsion);
}

/// Points that bounce begin with nothing.
template <class View>
void drop_impulses_of_bounces(const VisitOf<View>& visit) {
    for (int point_i = 0; point_i < visit.count(); ++point_i)
        if (visit.lands(point_i)) visit.record.j[point_i] = visit.record.j_before[point_i] = 0;
}

template <class View>
void start_visit(const VisitOf<View>& visit) {
    ManifoldRecord& record = visit.record;
    if constexpr (View::bounces) drop_impulses_of_bounces(visit);
    const scalar load = load_on(visit), limit = record.mu * load;
    record.j_friction = clamp_length(record.j_friction, limit);
    record.j_torsion = clamp(record.j_torsion, limit * visit.contact.radius);
    give_impulses(visit, record.j, record.j_friction, record.j_torsion);
    if constexpr (View::rolls) {
        Vector& j = visit.rolling_record().j;
        j = clamp_length(j, visit.rolling_record().lever * load);
        push_pair(visit.pair, &PointBody::velocity, visit.contact.middle, {}, j);
    }
}

template <class View>
void go_on(const VisitOf<View>& visit, scalar beta) {
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
    clear(change);
    give_impulses(visit, j, along.friction * beta, along.torsion * beta);
    if constexpr (View::rolls) {
        PointRolling& rolling = visit.rolling();
        rolling.along = rolling.along * beta + rolling.change;
        rolling.change = {};
        visit.rolling_record().j += rolling.along * beta;
        push_pair(visit.pair, &PointBody::velocity, visit.contact.middle, {}, rolling.along * beta);
    }
}

/// Of one manifold: see predict_point_bounces.
template <class View>
bool predict_bounces_of(const VisitOf<View>& visit, scalar h) {
    const NormalMotion moved = normal_displacement(visit);
    const auto along_n = [&](MotionOfBody kind) { return normal_motion(visit, relative_motion(pair_in(visit), kind, visit.contact.middle)); };
    const NormalMotion speed = along_n(&PointBody::velocity), pull = along_n(&PointBody::forces);
    bool some = false;
    for (int point_i = 0; point_i < visit.count(); ++point_i) {
        const Vector& P = visit.P(point_i);
        const scalar s = visit.record.manifold.points[point_i].separation + moved.at(P), e = visit.record.e;
        const RowFlight<scalar> from = {s, speed.at(P), pull.at(P)};
        const RowImpact<scalar> impact = impact_of(from, h, visit.unit);
        visit.landing(point_i) = limits::unbounded;
        if (!impact.meets) visit.contact.target[point_i] = no_bound(from, h);
        if (!bounces_off(impact, e)) continue;
        const RowLanding<scalar> landing = landing_of(from, impact, e, h, visit.unit);
        visit.contact.target[point_i] = landing.speed;
        visit.landing(point_i) = landing.s;
        some = true;
    }
    return some;
}

/// Calls a stage for the manifolds of the island at hand.
template <class View, class Stage>
void over_manifolds(const View& solver, bool forward, const Stage& stage) {
    // bound: max_manifolds
    for (int i = 0; i < solver.member_count; ++i) stage(visit_of(solver, solver.members[forward ? i : solver.member_count - 1 - i]));
}

}  // namespace

template <class View>
void begin_contacts(const View& solver, scalar share, scalar h) {
    over_manifolds(solver, true, [share, h](const VisitOf<View>& visit) { begin_contact(visit, share, h); });
}

template <class View>
void end_contacts(const View& solver, scalar share, bool steady) {
    over_manifolds(solver, true, [share, steady](const VisitOf<View>& visit) {
        scale_impulses(visit.record, share);
        if constexpr (View::rolls) visit.rolling_record().j = visit.rolling_record().j * share;
        visit.record.substeps = steady ? steady_bit : uint16_t(0);
    });
}

template <class View>
bool predict_point_bounces(const View& solver, scalar h) {
    bool some = false;
    over_manifolds(solver, true, [&some, h](const VisitOf<View>& visit) {
        if (visit.record.e > 0 && predict_bounces_of(visit, h)) some = true;
    });
    return some;
}

template <class View>
void warm_start(const View& solver) {
    over_manifolds(solver, true, [](const VisitOf<View>& visit) { start_visit(visit); });
}

template <class View>
SweepOfPoints sweep_point_velocities(const View& solver, bool forward, scalar ignored) {
    SweepOfPoints sweep = {0, 0};
    over_manifolds(solver, forward, [&](const VisitOf<View>& visit) { visit_velocities(visit, ignored, sweep); });
    return sweep;
}

template <class View>
void go_on_along(const View& solver, scalar beta) {
    over_manifolds(solver, true, [beta](const VisitOf<View>& visit) { go_on(visit, beta); });
}

template <class View>
void sweep_point_positions(const View& solver, scalar h) {
    over_manifolds(solver, true, [h](const VisitOf<View>& visit) { visit_positions(visit, h); });
}

} }  // namespace ingot
