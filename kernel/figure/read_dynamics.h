// SPDX-License-Identifier: MIT
// A figure of a world, as dynamics.h sees it.
#pragma once

#include "../body/body_tiles.h"
#include "../joint/joint_lists.h"
#include "dynamics.h"
#include "read_joint.h"

namespace ingot { inline namespace INGOT_ABI {

/// What of a world it is read from.
struct DynamicsSource {
    BodyView bodies;
    JointLists lists;
    const uint32_t *generation, *joint_generation;  ///< by slot
    uint16_t world_tag;
    Vector gravity;                    ///< m/s^2
    const scalar* shares_of_gravity;   ///< by slot; null: 1
    const BodyForceTile* body_forces;  ///< null: none
};

/// What holds the root of a figure: a joint to what cannot move.
struct DynamicsGround {
    Index joint;  ///< no_joint: it floats
    Index slot;   ///< no_body: the world
};

/// Lists the bodies that hang together with one by joints of trees: from the root, which is that one where nothing ties them; then body after body,
/// by the joints of each in their order. marks: a bit for each slot, all 0 to begin with.
/// Errors: no_room, bad_joint: see World::read_dynamics. Cost: a look at each joint of each body, twice.
Result<DynamicsGround> list_figure(const Dynamics& of, const DynamicsSource& from, Index slot, uint8_t* marks);

/// Where they are, how they move, and what acts on them; ground: what the root is tied to.
void read_motions(const Dynamics& of, const DynamicsSource& from, const JointBody& ground);

}}  // namespace ingot::INGOT_ABI
