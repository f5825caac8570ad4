// SPDX-License-Identifier: MIT
// A slip that turns round within a substep, for the sequential solver: see reversal_share.
#pragma once

#include "point_visits.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// True where there is an impact in this substep, or was one in the substep before: there friction does not go on as before.
template <class View>
bool is_hit(const VisitOf<View>& visit, scalar h) {
    bool hit = visit.pair.A.hit || visit.pair.B.hit;
    const NormalMotion motion = normal_motion(visit, relative_motion(pair_in(visit), &PointBody::velocity, visit.contact.middle));
    const scalar allowance = allowance_of(visit.pair, h);
    // bound: 4: Manifold::points_max
    for (int point_i = 0; point_i < visit.count(); ++point_i)
        hit = hit || is_impact(motion.at(visit.P(point_i)), visit.contact.target[point_i], allowance);
    return hit;
}
/// Of one manifold: see begin_point_reversals.
template <class View>
bool begin_reversal(const VisitOf<View>& visit, scalar h) {
    const scalar limit = visit.record.mu * load_on(visit);
    if (!(limit > 0) || !is_on_cone(length_sq(visit.record.j_friction), limit)) return false;
    const auto slip = [&](MotionOfBody kind) {
        Vector relative = relative_motion(pair_in(visit), kind, visit.contact.middle).linear;
        if constexpr (View::has_belts) relative += visit.belt_velocity();
        return across(visit.n(), relative);
    };
    const Vector before = slip(&PointBody::begin);
    const scalar share = reversal_share(length_sq(before), dot(before, slip(&PointBody::velocity)), visit.unit);
    if (!(share > 0) || is_hit(visit, h)) return false;
    visit.contact.before_reversal = before * (-share / sqrt(length_sq(before)));
    return true;
}
/// Of one manifold: see end_point_reversals.
[[maybe_unused]] void end_reversal(const PointVisit& visit, bool is_alone, scalar h) {
    Vector& before = visit.contact.before_reversal;
    const scalar share_sq = length_sq(before);
    if (share_sq == 0) return;
    const Vector given = before * (visit.record.mu * load_on(visit)), j = visit.record.j_friction;
    const Vector q = displacement_of_reversal(given, j, sqrt(share_sq), h);
    if (is_alone) {
        PointBody &A = visit.pair.A, &B = visit.pair.B;
        if (A.inv_M > 0) A.displacement.linear += q * A.inv_M;
        if (B.inv_M > 0) B.displacement.linear -= q * B.inv_M;
    }
    before = {};
}

}  // namespace

template <class View>
bool begin_point_reversals(const View& solver, scalar h) {
    bool some = false;
    over_manifolds(solver, true, [&some, h](const VisitOf<View>& visit) { some = begin_reversal(visit, h) || some; });
    return some;
}

template <class View>
void end_point_reversals(const View& solver, scalar h) {
    const bool is_alone = solver.member_count == 1;
    over_manifolds(solver, true, [is_alone, h](const VisitOf<View>& visit) { end_reversal(visit, is_alone, h); });
}

} }  // namespace ingot
