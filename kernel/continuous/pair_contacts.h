// SPDX-License-Identifier: MIT
// What the bodies of a sub-world do to each other and to what is fixed: a manifold for each pair of shapes that touch, as the scene's solver takes
// them.
#pragma once

#include "../base/report.h"
#include "../constraint/impact_note.h"
#include "../constraint/kinematic_view.h"
#include "../constraint/surface_materials.h"
#include "../narrow_phase/manifold_record.h"
#include "../shape/body_shapes.h"
#include "../solver/sequential/point_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// Two shapes that may touch: A is of a body that impulses move.
struct ShapePair {
    ShapeSlot A, B;

    bool is(const ShapePair& other) const { return A.number == other.A.number && B.number == other.B.number; }
    bool is_before(const ShapePair& other) const { return A.number < other.A.number || (A.number == other.A.number && B.number < other.B.number); }
};

/// How deep two shapes are in each other at most, m.
INGOT_INLINE scalar depth_of(const Manifold& manifold) { return -least_separation(manifold); }

/// Room for `capacity` manifolds of `slots` bodies. View: that of the scene's solver.
template <int capacity, int slots, class View>
struct PairContacts {
    static constexpr unsigned room = static_cast<unsigned>(capacity);
    BodyPair pairs[room];    ///< places of bodies in their sub-world
    ShapePair shapes[room];  ///< in order
    ManifoldRecord records[room];
    ImpactNote notes[room];
    Vector friction_references[View::is_pointwise ? 1 : room];
    RollingRecord rolling[View::rolls ? room : 1];
    Vector belts[View::has_belts ? room : 1];
    static constexpr unsigned places = static_cast<unsigned>((slots + lanes - 1) / lanes * lanes);
    Index local_of[View::is_pointwise ? 1 : places];
    PointBody point_bodies[View::is_pointwise ? places : 1];
    uint8_t locks[View::locks_axes ? places : 1];  ///< by place
    Index count;

    /// Takes a manifold in, in the order of the shapes; where there is no room, the least deep of all has none, whatever they came in. Those are
    /// counted in `lost`.
    void take(const Manifold& found, const ShapePair& of, const BodyPair& bodies, Index& lost) {
        if (count == capacity) {
            ingot::count(lost);
            const int least = least_deep();
            const scalar depth = depth_of(records[least].manifold);
            if (depth_of(found) < depth || (!(depth_of(found) > depth) && shapes[least].is_before(of))) return;
            drop(least);
        }
        int place = count++;
        // bound: limits::pair_manifolds_max
        for (; place > 0 && of.is_before(shapes[place - 1]); --place) copy(place - 1, place);
        pairs[place] = bodies;
        records[place] = {};
        records[place].manifold = found;
        shapes[place] = of;
    }
    /// Takes one out; the others keep their order.
    void drop(int place) {
        --count;
        for (; place < count; ++place) copy(place + 1, place);  // bound: limits::pair_manifolds_max
    }
    /// The place of a pair; -1: it has none.
    int find(const ShapePair& of) const {
        for (int place = 0; place < count; ++place)  // bound: limits::pair_manifolds_max
            if (shapes[place].is(of)) return place;
        return -1;
    }
    /// What their surfaces are to each other, for the manifold at a place. A_of_shapes: their axes, shape to world.
    void mix(int place, const SurfaceView& surfaces, [[maybe_unused]] const ShapeMaterials& materials,
             [[maybe_unused]] const Matrix (&A_of_shapes)[2]) {
        const auto A = static_cast<Index>(shapes[place].A.number), B = static_cast<Index>(shapes[place].B.number);
        mix_materials(surfaces, {A, B, no_record}, records[place]);
        // The views of locks and of joints are of all materials, also in scenes that name one of them, or none.
        [[maybe_unused]] const bool rolls = materials.rolling_levers != nullptr, moves = materials.surface_velocities != nullptr;
        if constexpr (View::rolls)
            rolling[place] = {rolls ? max(materials.rolling_levers[A], materials.rolling_levers[B]) : scalar(0), {}};
        if constexpr (View::has_belts)
            belts[place] = moves ? A_of_shapes[0] * materials.surface_velocities[A] - A_of_shapes[1] * materials.surface_velocities[B] : Vector{};
    }

    /// A solver of its own, in the memory of another that is done.
    View solver(const View& done) {
        View own = done;
        for (int place = 0; place < count; ++place) pairs[place].record = static_cast<Index>(place);  // bound: limits::pair_manifolds_max
        own.pairs = pairs;
        own.records = records;
        own.manifold_count = count;
        if constexpr (View::is_pointwise) {
            own.bodies = point_bodies;
        } else {
            for (Index& local : local_of) local = 0;
            own.friction_references = friction_references;
            own.local_of = local_of;
            own.shape_pairs = nullptr;  // contacts of a part of a step keep their points
            own.body_count = own.island_count = 0;
        }
        if constexpr (sees_kinematic<View>) own.kinematic.of_slots = nullptr;
        if constexpr (View::locks_axes) own.locks = locks;
        if constexpr (View::rolls) own.rolling_records = rolling;
        if constexpr (View::has_belts) own.belt_velocities = belts;
        return own;
    }
    /// Some of the manifolds between two bodies still carry something at the end.
    bool carries(int place_A, int place_B) const {
        bool some = false;
        for (int place = 0; place < count; ++place)  // bound: limits::pair_manifolds_max
            some = some || (pairs[place].body_A == place_A && pairs[place].body_B == place_B && load_of(records[place]) > 0);
        return some;
    }

private:
    int least_deep() const {
        int least = 0;
        // bound: limits::pair_manifolds_max
        for (int i = 1; i < count; ++i) {
            const scalar depth = depth_of(records[i].manifold), depth_of_least = depth_of(records[least].manifold);
            if (!(depth > depth_of_least)) least = i;  // of those as deep the last
        }
        return least;
    }
    void copy(int from, int to) {
        pairs[to] = pairs[from];
        shapes[to] = shapes[from];
        records[to] = records[from];
    }
};

} }  // namespace ingot
