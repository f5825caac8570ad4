// SPDX-License-Identifier: MIT
#include "point_rows.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

void push_body(PointBody& body, MotionOfBody kind, const Vector& P, const Vector& impulse, const Vector& moment) {
    if (!(body.inv_M > 0)) return;
    PointMotion& motion = body.*kind;
    const Vector change = cross(P - body.r_CM, impulse) + moment;
    motion.linear += impulse * body.inv_M;
    motion.angular += body.inv_I_world * change;
    motion.moment += change;
}

/// J . inv_I_world J.
INGOT_SHARED scalar compliance_about_axis(const PointBody& body, const Vector& J) { return dot(J, body.inv_I_world * J); }

scalar compliance_of(const PointBody& body, const Vector& P, const Vector& n) {
    if (!(body.inv_M > 0)) return 0;
    return body.inv_M + compliance_about_axis(body, cross(P - body.r_CM, n));
}

/// The trace of the compliance at P less its part along n.
scalar compliance_across_of(const PointBody& body, const Vector& P, const Vector& n) {
    if (!(body.inv_M > 0)) return 0;
    const SymmetricMatrix& inv_I = body.inv_I_world;
    const Vector r = P - body.r_CM;
    const scalar trace = 3 * body.inv_M + (inv_I.xx + inv_I.yy + inv_I.zz) * length_sq(r) - compliance_about_axis(body, r);
    return trace - compliance_of(body, P, n);
}

scalar compliance_about_of(const PointBody& body, const Vector& n) {
    if (!(body.inv_M > 0)) return 0;
    return compliance_about_axis(body, n);
}

}  // namespace

RelativeVelocity relative_motion(const PointPair& pair, MotionOfBody kind, const Vector& P) {
    Vector linear = {0, 0, 0}, angular = {0, 0, 0};
    const PointBody* const bodies[2] = {&pair.A, &pair.B};
    scalar sign = 1;
    for (const PointBody* body : bodies) {
        if (body->inv_M > 0) {
            const PointMotion& motion = body->*kind;
            linear += (motion.linear + cross(motion.angular, P - body->r_CM)) * sign;
            angular += motion.angular * sign;
        }
        sign = -1;
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
