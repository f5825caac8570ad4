// SPDX-License-Identifier: MIT
// A manifold as the sequential solver visits it, and how its bodies move there.
#pragma once

#include "point_rows.h"
#include "point_view.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// A manifold with its bodies, while it is visited.
struct PointVisit {
    PointPair pair;
    ManifoldRecord& record;
    PointContact& contact;
    scalar unit;  ///< m; of lengths and speeds in limits.h

    INGOT_INLINE const Vector& n() const { return record.manifold.n; }
    INGOT_INLINE int count() const { return record.manifold.count; }
    /// What lengths of the contact are measured by, m.
    INGOT_INLINE scalar scale() const { return scale_of(unit, record.manifold.halvings); }
    INGOT_INLINE const Vector& P(int point_i) const { return record.manifold.points[point_i].P; }
};
/// With what a view adds.
template <class View>
struct VisitOf : PointVisit {
    const View& solver;
    int manifold_i, record_i;

    INGOT_INLINE PointRolling& rolling() const { return solver.rolling[manifold_i]; }
    INGOT_INLINE RollingRecord& rolling_record() const { return solver.rolling_records[record_i]; }
    /// What surfaces in motion add to the slip.
    INGOT_INLINE const Vector& belt_velocity() const { return solver.belt_velocities[record_i]; }
    INGOT_INLINE scalar& landing(int point_i) const { return solver.landings[manifold_i].at[point_i]; }
    INGOT_INLINE bool lands(int point_i) const { return landing(point_i) < limits::unbounded; }
};
template <>
struct VisitOf<PointView> : PointVisit {};

template <class View>
INGOT_INLINE VisitOf<View> visit_of(const View& solver, int manifold_i) {
    const BodyPair& pair = solver.pairs[manifold_i];
    PointBody &A = solver.bodies[pair.body_A], &B = solver.bodies[pair.body_B];
    if constexpr (View::rolls || View::has_belts || View::bounces || sees_kinematic<View>)
        return {{{A, B}, solver.records[pair.record], solver.contacts[manifold_i], solver.unit}, solver, manifold_i, pair.record};
    else
        return {{{A, B}, solver.records[pair.record], solver.contacts[manifold_i], solver.unit}};
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
/// The bodies of a manifold as relative_motion asks for them.
INGOT_INLINE const PointPair& pair_in(const PointVisit& visit) { return visit.pair; }
/// Of a contact with a kinematic body, with that.
struct KinematicPair {
    const PointPair& pair;
    const KinematicPoint& point;
};
template <class View>
INGOT_INLINE KinematicPair pair_in(const VisitOf<KinematicPointViewOf<View>>& visit) {
    return {visit.pair, visit.solver.kinematic.points[visit.manifold_i]};
}
/// The motion of the body that moves, less what it would have if it were stuck to the kinematic one.
[[maybe_unused]] RelativeVelocity relative_motion(const KinematicPair& of, MotionOfBody kind, const Vector& P) {
    const PointMotion& motion = kind == &PointBody::velocity ? of.point.velocity
                                : kind == &PointBody::forces ? of.point.forces
                                : kind == &PointBody::begin  ? of.point.begin
                                                             : of.point.displacement;
    RelativeVelocity relative = relative_motion(of.pair, kind, P);
    relative.linear -= (motion.linear + cross(motion.angular, P - of.point.r_partner)) * of.point.sign;
    relative.angular -= motion.angular * of.point.sign;
    return relative;
}

template <class Visit>
INGOT_SHARED NormalMotion normal_displacement(const Visit& visit) {
    return normal_motion(visit, relative_motion(pair_in(visit), &PointBody::displacement, visit.contact.middle));
}

}  // namespace

} }  // namespace ingot
