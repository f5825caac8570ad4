// SPDX-License-Identifier: MIT
// What two bodies do to each other in their sub-world: a manifold for each pair of their shapes that touch, as the scene's solver takes them.
#pragma once

#include "../base/report.h"
#include "../constraint/impact_note.h"
#include "../constraint/kinematic_view.h"
#include "../constraint/surface_materials.h"
#include "pair_sub_world.h"

namespace ingot { inline namespace INGOT_ABI {

/// A pair of shapes, one of each body.
struct ShapePair {
    ShapeSlot A, B;
};

/// How deep two shapes are in each other at most, m.
INGOT_INLINE scalar depth_of(const Manifold& manifold) {
    scalar depth = -limits::unbounded;
    // bound: 4: Manifold::points_max
    for (int point_i = 0; point_i < manifold.count; ++point_i) depth = max(depth, -manifold.points[point_i].separation);
    return depth;
}

/// Room for `capacity` manifolds. View: that of the scene's solver.
template <int capacity, class View>
struct PairContacts {
    static constexpr unsigned room = static_cast<unsigned>(capacity);
    BodyPair pairs[room];  ///< all of the same two bodies; the number of its record is the place of a pair
    ManifoldRecord records[room];
    ImpactNote notes[room];
    ShapePair shapes[room];
    Vector friction_references[View::is_pointwise ? 1 : room];
    RollingRecord rolling[View::rolls ? room : 1];
    Vector belts[View::has_belts ? room : 1];
    Index local_of[View::is_pointwise ? 1 : static_cast<unsigned>(PairSubWorld::tiles * lanes)];
    Index count;

    /// A place for what two shapes of the pair do; the manifold that is the least deep makes room. -1: it is this one.
    /// Counted in `lost` where one has none.
    int place_for(const Manifold& found, Index& lost) {
        if (count < capacity) return count++;
        ingot::count(lost);
        int least = 0;
        // bound: limits::pair_manifolds_max
        for (int i = 1; i < capacity; ++i)
            if (depth_of(records[i].manifold) < depth_of(records[least].manifold)) least = i;
        return depth_of(found) > depth_of(records[least].manifold) ? least : -1;
    }
    void put(int place, const Manifold& found, const ShapePair& of) {
        pairs[place] = {0, 1, static_cast<Index>(place)};
        records[place] = {};
        records[place].manifold = found;
        notes[place] = {};
        shapes[place] = of;
    }
    /// Rolling resistance and belts, by the laws of surface_materials.h; A_of_shapes: their axes, shape to world.
    void mix(int place, [[maybe_unused]] const ShapeMaterials& materials, [[maybe_unused]] const Matrix (&A_of_shapes)[2]) {
        const int A = shapes[place].A.number, B = shapes[place].B.number;
        if constexpr (View::rolls) rolling[place] = {max(materials.rolling_levers[A], materials.rolling_levers[B]), {}};
        if constexpr (View::has_belts)
            belts[place] = A_of_shapes[0] * materials.surface_velocities[A] - A_of_shapes[1] * materials.surface_velocities[B];
    }

    /// The pair's own solver, in the memory of another that is done.
    View solver(const View& done) {
        View own = done;
        own.pairs = pairs;
        own.records = records;
        own.manifold_count = count;
        if constexpr (!View::is_pointwise) {
            for (Index& local : local_of) local = 0;
            own.friction_references = friction_references;
            own.local_of = local_of;
            own.body_count = own.island_count = 0;
        }
        if constexpr (sees_kinematic<View>) own.kinematic.of_slots = nullptr;
        if constexpr (View::rolls) own.rolling_records = rolling;
        if constexpr (View::has_belts) own.belt_velocities = belts;
        return own;
    }
    /// Some of the manifolds still carry something at the end.
    bool carries() const {
        bool some = false;
        for (int place = 0; place < count; ++place)  // bound: limits::pair_manifolds_max
            // bound: 4: Manifold::points_max
            for (int point_i = 0; point_i < records[place].manifold.count; ++point_i) some = some || records[place].j[point_i] > 0;
        return some;
    }
};

} }  // namespace ingot
