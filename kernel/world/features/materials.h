// SPDX-License-Identifier: MIT
// What surfaces may have beside friction and restitution: resistance to rolling, and a velocity of their own.
#pragma once

#include "../../base/if.h"
#include "../../solver/sequential/point_view.h"
#include "manifolds.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

/// Of rolling: rows by block, or what the sequential solver has by manifold.
template <class S>
using RollingRowsOf = If<solves_pointwise<S>, PointRolling, RollingRows>;
template <class S>
inline constexpr unsigned row_capacity_of = solves_pointwise<S> ? static_cast<unsigned>(S::max_manifolds) : block_capacity_of<S>;

/// The sequential solver has no rows of belts: it takes their velocities as they are.
template <class S, bool present>
struct BeltRowPart {
    BeltRows belt_rows[block_capacity_of<S>] = {};

    template <class View>
    void show_belt_rows(View& view) {
        view.belts = belt_rows;
    }
};
template <class S>
struct BeltRowPart<S, false> {
    template <class View>
    static void show_belt_rows(View&) {}
};

/// Scenes with joints, or axis locks.
template <class S>
inline constexpr bool solves_all_materials = has_joints<S> || (S::axis_locks && !solves_pointwise<S>);

/// What solves them is compiled for both materials together. A scene that names one of them has the other at rest.
template <class S, bool present>
struct StillBeltPart {
    BeltRows still_belt_rows[block_capacity_of<S>] = {};
    Vector still_belt_velocities[static_cast<unsigned>(S::max_manifolds)] = {};

    template <class View>
    void show_still_belts(View& view) {
        view.belts = still_belt_rows;
        view.belt_velocities = still_belt_velocities;
    }
};
template <class S>
struct StillBeltPart<S, false> {
    template <class View>
    static void show_still_belts(View&) {}
};
template <class S, bool present>
struct FreeRollingPart {
    RollingRows free_rolling_rows[block_capacity_of<S>] = {};
    RollingRecord free_rolling_records[static_cast<unsigned>(S::max_manifolds)] = {};

    template <class View>
    void show_free_rolling(View& view) {
        view.rolling = free_rolling_rows;
        view.rolling_records = free_rolling_records;
    }
};
template <class S>
struct FreeRollingPart<S, false> {
    template <class View>
    static void show_free_rolling(View&) {}
};

struct RollingResistance : Feature {
    static constexpr uint32_t part = 8192;
    template <class S>
    static constexpr bool named = S::rolling_resistance;

    template <class S, bool present>
    struct Memory : StillBeltPart<S, solves_all_materials<S> && !S::surface_velocities> {
        scalar rolling_levers[static_cast<unsigned>(shape_capacity<S>)] = {};  ///< m, by shape slot
        RollingRecord rolling_records[static_cast<unsigned>(S::max_manifolds)] = {};
        RollingRowsOf<S> rolling_rows[row_capacity_of<S>] = {};

        const scalar* levers_of_shapes() const { return rolling_levers; }
        void mix_rolling(const ManifoldView& manifolds) { mix_rolling_levers(manifolds, rolling_levers, rolling_records); }
        template <class View>
        void show_rolling(View& view) {
            view.rolling = rolling_rows;
            view.rolling_records = rolling_records;
            this->show_still_belts(view);
        }
    };
    template <class S>
    struct Memory<S, false> {
        static constexpr const scalar* levers_of_shapes() { return nullptr; }
        static void mix_rolling(const ManifoldView&) {}
        template <class View>
        static void show_rolling(View&) {}
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::rolling_resistance);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::rolling_resistance || stacks<S>,
                      "rolling resistance is of contacts with friction: set max_manifolds, or rolling_resistance = false");
        return true;
    }
    template <class S>
    static void forget_shape(Storage<S>& storage, int shape_slot) {
        storage.rolling_levers[shape_slot] = 0;
    }

    struct OfShape : NoNumbers {
        scalar lever;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("rolling_resistance", lever);
        }
        template <class S>
        void take(const Storage<S>& storage, int shape_slot) {
            lever = storage.rolling_levers[shape_slot];
        }
        template <class S>
        void put(Storage<S>& storage, int shape_slot) const {
            storage.rolling_levers[shape_slot] = lever;
        }
        template <class S>
        bool is_valid(const SavedBody&) const {
            return lever >= 0 && lever <= limits::size_max;
        }
    };
    struct OfManifold : NoNumbers {
        Vector j;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("j_rolling", j);
        }
        template <class S>
        void take(const Storage<S>& storage, const BodyPair& pair) {
            j = storage.rolling_records[pair.record].j;
        }
        template <class S>
        void put(Storage<S>& storage, Index record) const {
            storage.rolling_records[record].j = j;
        }
        template <class S>
        bool is_valid(const ManifoldContext&) const {
            return is_finite(j);
        }
    };
};

struct Belts : Feature {
    static constexpr uint32_t part = 16384;
    template <class S>
    static constexpr bool named = S::surface_velocities;

    template <class S, bool present>
    struct Memory : BeltRowPart<S, !solves_pointwise<S>>, FreeRollingPart<S, solves_all_materials<S> && !S::rolling_resistance> {
        Vector surface_velocities[static_cast<unsigned>(shape_capacity<S>)] = {};  ///< m/s, in the shape's axes, by shape slot
        Vector belt_velocities[static_cast<unsigned>(S::max_manifolds)] = {};      ///< m/s, world, by record

        const Vector* velocities_of_shapes() const { return surface_velocities; }
        void turn_belts(const BodyView& shapes, const ManifoldView& manifolds) {
            turn_surface_velocities(shapes, manifolds, surface_velocities, belt_velocities);
        }
        template <class View>
        void show_belts(View& view) {
            view.belt_velocities = belt_velocities;
            this->show_belt_rows(view);
            this->show_free_rolling(view);
        }
    };
    template <class S>
    struct Memory<S, false> {
        static constexpr const Vector* velocities_of_shapes() { return nullptr; }
        static void turn_belts(const BodyView&, const ManifoldView&) {}
        template <class View>
        static void show_belts(View&) {}
    };

    template <class S, class Each>
    static constexpr void traits(Each& each) {
        each(S::surface_velocities);
    }
    template <class S>
    static constexpr bool check() {
        static_assert(!S::surface_velocities || stacks<S>,
                      "surfaces that move need contacts with friction: set max_manifolds, or surface_velocities = false");
        return true;
    }
    template <class S>
    static void forget_shape(Storage<S>& storage, int shape_slot) {
        storage.surface_velocities[shape_slot] = {};
    }

    struct OfShape : NoNumbers {
        Vector velocity;

        template <class Each>
        constexpr void numbers(Each& each, uint32_t) {
            each("surface_velocity", velocity);
        }
        template <class S>
        void take(const Storage<S>& storage, int shape_slot) {
            velocity = storage.surface_velocities[shape_slot];
        }
        template <class S>
        void put(Storage<S>& storage, int shape_slot) const {
            storage.surface_velocities[shape_slot] = velocity;
        }
        template <class S>
        bool is_valid(const SavedBody&) const {
            return check_vector(velocity, limits::speed_max) == Status::ok;
        }
    };
};

} } }  // namespace ingot::features
