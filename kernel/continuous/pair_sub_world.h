// SPDX-License-Identifier: MIT
// A small world of one or two bodies and what is around them that no impulse moves, for a while of a step of all.
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
/// At the begin of a path.
INGOT_INLINE FlightState begin_of(const BodyPath& path) { return {path.r_CM, path.v_CM, path.L, path.A}; }

/// How the bodies of a sub-world move: at places 0 and 1 those that impulses move, one or two, and from first_kinematic on those that move by
/// themselves. What stands still has no extent.
struct Movers {
    BodyView bodies;
    const BodyExtent* extents;
    int count, first_kinematic, kinematic_count;

    /// s; as long as they move little, against each other and against all that is not in the sub-world.
    scalar moment() const;
    /// One of those that impulses move gets past its own size within h seconds.
    bool some_fast(scalar h) const;
    /// m; how far two bodies may be apart and still touch within h seconds.
    scalar margin(int place_A, int place_B, scalar h, scalar unit) const;

    /// J; of those that impulses move. Needs inv_I_world.
    scalar kinetic_energy() const;
    /// Gives them this part, 0 .. 1, of what has changed their motion since it was as it is here.
    void take_part_of_change(const FlightState (&before)[2], scalar part) const;

    template <class Each>
    INGOT_INLINE void for_each(const Each& each) const {
        for (int place = 0; place < count; ++place) each(place);  // bound: PairSubWorld::movers_max
        // bound: limits::pair_kinematic_max
        for (int i = 0; i < kinematic_count; ++i) each(first_kinematic + i);
    }
};
void clear_tiles(const BodyView& bodies);
/// Copies mass and moments of the body of a slot. Its motion is that of the begin of its path, and so are the forces on it.
void take_body(const BodyView& to, int place, const BodyView& from, int slot, const BodyPath& path);

/// kinematic_max: room for bodies that move by themselves.
template <int kinematic_max>
struct PairSubWorld {
    static constexpr int movers_max = 2, fixed = 2, first_kinematic = 3;  ///< places of bodies; all that stands still is one of them
    static constexpr int slots = first_kinematic + kinematic_max, tiles = (slots + lanes - 1) / lanes;
    static constexpr unsigned tile_room = static_cast<unsigned>(tiles);
    RotationTile rotation[tile_room];
    TranslationTile translation[tile_room];
    CompensationTile compensation[tile_room];
    EnergyTile energy[tile_room];
    BodyExtent extents[static_cast<unsigned>(slots)];
    Vector F_T[movers_max], tau_T[movers_max];
    Index kinematic[static_cast<unsigned>(kinematic_max + 1)];  ///< slots in the world of those at first_kinematic and on
    int count;                                                  ///< movers
    int kinematic_count;

    BodyView bodies() { return {rotation, translation, compensation, energy, tiles}; }
    Movers movers() { return {bodies(), extents, count, first_kinematic, kinematic_count}; }
    void clear() {
        clear_tiles(bodies());
        count = kinematic_count = 0;
        extents[fixed] = {};
    }
    /// One more mover, as its path begins.
    void take(const BodyView& from, const BodyShapes& shapes, int slot, const BodyPath& path) {
        extents[count] = extent_of(shapes, slot);
        take_body(bodies(), count++, from, slot, path);
    }
    FlightState state(int which) { return flight_state(bodies(), which); }
    /// The forces of users, while those of contacts stand in their place.
    void keep_forces() {
        for (int which = 0; which < count; ++which) {  // bound: movers_max
            const Place at = place_of(which);
            F_T[which] = lane_of(translation[at.tile].F_T, at.lane);
            tau_T[which] = lane_of(rotation[at.tile].tau_T, at.lane);
        }
    }
    void drop_forces() {
        for (int which = 0; which < count; ++which) {  // bound: movers_max
            const Place at = place_of(which);
            set_lane(translation[at.tile].F_T, at.lane, {});
            set_lane(rotation[at.tile].tau_T, at.lane, {});
        }
    }
    void return_forces() {
        for (int which = 0; which < count; ++which) {  // bound: movers_max
            const Place at = place_of(which);
            set_lane(translation[at.tile].F_T, at.lane, F_T[which]);
            set_lane(rotation[at.tile].tau_T, at.lane, tau_T[which]);
        }
    }
    /// Kinematic body i, at first_kinematic + i, where it is yet to be put.
    void put_kinematic(const BodyShapes& shapes, int i, int slot) {
        kinematic[i] = static_cast<Index>(slot);
        extents[first_kinematic + i] = extent_of(shapes, slot);
    }
    /// The place of a kinematic body; -1: it has none.
    int place_of_kinematic(int slot) const {
        for (int i = 0; i < kinematic_count; ++i)  // bound: limits::pair_kinematic_max
            if (kinematic[i] == slot) return first_kinematic + i;
        return -1;
    }
};

} }  // namespace ingot
