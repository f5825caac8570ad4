// SPDX-License-Identifier: MIT
// A world of two bodies, for what they do to each other within a step of all.
#pragma once

#include "body_path.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where one body is, and how it moves.
struct FlightState {
    Vector r_CM, v_CM, L;
    Matrix A;
};
FlightState flight_state(const BodyView& bodies, int slot);
/// Its turn was not free: what a rotation method keeps of the turn so far is forgotten.
void put_state(const BodyView& bodies, int slot, const FlightState& motion);

struct PairSubWorld {
    static constexpr int tiles = (2 + lanes - 1) / lanes;
    RotationTile rotation[tiles];
    TranslationTile translation[tiles];
    CompensationTile compensation[tiles];
    EnergyTile energy[tiles];
    BodyExtent extents[2];
    Vector F_T[2], tau_T[2];

    BodyView bodies() { return {rotation, translation, compensation, energy, tiles}; }
    /// Empty places, all zero but for what makes a body of none.
    void clear();
    /// Copies the body of a slot, with its forces.
    void take(int which, const BodyView& from, const BodyShapes& shapes, int slot);
    /// The forces of users, while those of contacts stand in their place.
    void keep_forces();
    void return_forces();
    /// s; as long as the two move little, against each other and against all that is not in the sub-world.
    scalar moment();
    /// One of them gets past its own size within h seconds.
    bool some_fast(scalar h);
    /// m; how far apart the two can be and still touch within h seconds.
    scalar margin(scalar h, scalar unit);
};

} }  // namespace ingot
