// SPDX-License-Identifier: MIT
#include "point_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

void push_body(PointBody& body, MotionOfBody kind, const Vector& P, const Vector& impulse, const Vector& moment) {
    if (!(body.inv_M > 0)) return;
    PointMotion& motion = body.*kind;
    const Vector change = body.lever_of(P, impulse) + moment;
    motion.linear += body.velocity_of(impulse);
    motion.angular += body.spin_of(change);
    motion.moment += change;
}

INGOT_INLINE Vector velocity_at(const PointBody& body, MotionOfBody kind, const Vector& P) {
    const PointMotion& motion = body.*kind;
    return motion.linear + cross(motion.angular, P - body.r_CM);
}

/// Written once: a visit asks for it in several places.
INGOT_SHARED scalar turning_compliance_of(const PointBody& body, const Vector& J) { return body.turning_compliance(J); }

scalar compliance_of(const PointBody& body, const Vector& P, const Vector& n) {
    if (!(body.inv_M > 0)) return 0;
    return body.inv_M + turning_compliance_of(body, body.lever_of(P, n));
}

/// The trace of the compliance at P less its part along n.
scalar compliance_across_of(const PointBody& body, const Vector& P, const Vector& n) {
    if (!(body.inv_M > 0)) return 0;
    const Vector r = P - body.r_CM;
    const scalar trace = 3 * body.inv_M + body.turning_compliances() * length_sq(r) - turning_compliance_of(body, r);
    return trace - compliance_of(body, P, n);
}

scalar compliance_about_of(const PointBody& body, const Vector& n) {
    if (!(body.inv_M > 0)) return 0;
    return turning_compliance_of(body, n);
}

}  // namespace

RelativeVelocity relative_motion(const PointPair& pair, MotionOfBody kind, const Vector& P) {
    Vector linear = {0, 0, 0}, angular = {0, 0, 0};
    if (pair.A.inv_M > 0) {
        linear += velocity_at(pair.A, kind, P);
        angular += (pair.A.*kind).angular;
    }
    if (pair.B.inv_M > 0) {
        linear -= velocity_at(pair.B, kind, P);
        angular -= (pair.B.*kind).angular;
    }
    return {linear, angular};
}

void push_pair(const PointPair& pair, MotionOfBody kind, const Vector& P, const Vector& impulse, const Vector& moment) {
    push_body(pair.A, kind, P, impulse, moment);
    push_body(pair.B, kind, P, -impulse, -moment);
}

scalar compliance_at(const PointPair& pair, const Vector& P, const Vector& n) { return compliance_of(pair.A, P, n) + compliance_of(pair.B, P, n); }

scalar compliance_across(const PointPair& pair, const Vector& P, const Vector& n) {
    return compliance_across_of(pair.A, P, n) + compliance_across_of(pair.B, P, n);
}

scalar compliance_about(const PointPair& pair, const Vector& n) { return compliance_about_of(pair.A, n) + compliance_about_of(pair.B, n); }

} }  // namespace ingot
