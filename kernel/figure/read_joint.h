// SPDX-License-Identifier: MIT
// Where a joint is and how it moves, between two steps: B against A.
#pragma once

#include "../joint/joint_record.h"
#include "../joint/limit_record.h"
#include "../math/rotation.h"

namespace ingot { inline namespace INGOT_ABI {

/// A side of a joint: a body, or the world.
struct JointBody {
    Vector r_CM{};
    Matrix A = identity_matrix<scalar>();
    Vector v_CM{}, omega{};
};
struct JointPair {
    JointBody A, B;
};

/// Of each direction that may end: see JointLimits.
struct JointReading {
    scalar of[2];  ///< rad, m; rad/s, m/s
};

/// rad, m.
JointReading joint_values(const JointRecord& joint, const JointPair& bodies);

/// rad, rad/s; of a wheel.
scalar steering_angle(const JointRecord& joint, const JointPair& bodies);
scalar steering_rate(const JointRecord& joint, const JointPair& bodies);

/// rad, rad/s: of a ball joint, B against A, in the axes of A; a turn of 0: its axis is in the middle of its cone, and it is not twisted.
Vector ball_turn(const JointRecord& joint, const JointPair& bodies);
Vector ball_rate(const JointPair& bodies);

/// The angle that is nearest to where the joint was last, over whole turns.
scalar angle_over_turns(scalar angle, const AngleRecord& last);

/// m, rad: how far the sides are off each other along what the joint locks. NaN, or scalar_max, where there is no short way back.
scalar misfit_of(const JointRecord& joint, const JointPair& bodies);

/// rad/s, m/s; 0 for the cone of a ball joint in whose middle the axis is.
JointReading joint_rates(const JointRecord& joint, const JointPair& bodies);

} }  // namespace ingot
