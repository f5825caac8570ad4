// SPDX-License-Identifier: MIT
// What the fuzzer knows of surfaces that resist being rolled or move by themselves: by shape, from the calls it made.
#pragma once

#include "bytes.h"

namespace fuzz { inline namespace INGOT_ABI {

/// Of scenes that name neither, nothing.
template <class S, bool present = ingot::has_materials<S>>
struct Materials {
    void begin_body(int, int) {}
    static double fastest() { return 0; }
    static void demand_kept(const World<S>&) {}
};

template <class S>
struct Materials<S, true> {
    static constexpr int shapes_max = S::max_shapes_of_body;

    int shape_count[S::max_bodies];  ///< of the body in this slot; one whose shape is ShapeKind::none has none
    scalar lever[S::max_bodies * shapes_max];
    Vector belt[S::max_bodies * shapes_max];

    /// A body that is added neither resists nor moves.
    void begin_body(int slot, int count) {
        shape_count[slot] = count;
        for (int i = 0; i < shapes_max; ++i) lever[slot * shapes_max + i] = 0, belt[slot * shapes_max + i] = {};
    }

    /// m/s; no surface goes faster over its body. Bodies that are gone may count.
    double fastest() const {
        double speed_sq = 0;
        for (const Vector& v : belt) {
            const double x = static_cast<double>(v.x), y = static_cast<double>(v.y), z = static_cast<double>(v.z);
            const double of_shape = x * x + y * y + z * z;
            speed_sq = of_shape > speed_sq ? of_shape : speed_sq;
        }
        return __builtin_sqrt(speed_sq);
    }

    /// What a call about a shape answers, but for its number.
    Status status_of(const World<S>& world, BodyId id, int shape_i) const {
        const Status status = world.state(id).status;
        if (status != Status::ok) return status;
        return shape_i >= 0 && shape_i < shape_count[id.slot] ? Status::ok : Status::out_of_range;
    }
    static Status status_of(scalar of_lever) {
        if (!ingot::is_finite(of_lever)) return Status::not_finite;
        return of_lever >= 0 && of_lever <= limits::size_max ? Status::ok : Status::out_of_range;
    }
    static Status status_of(const Vector& v) {
        if (!ingot::is_finite(v)) return Status::not_finite;
        const bool slow = magnitude(v.x) <= limits::speed_max && magnitude(v.y) <= limits::speed_max && magnitude(v.z) <= limits::speed_max;
        return slow ? Status::ok : Status::out_of_range;
    }

    /// Every shape of the living has what it was told, and no other shape can be asked.
    void demand_kept(const World<S>& world) const {
        for (int slot = 0; slot < S::max_bodies; ++slot) {
            const BodyId id = world.body_at(slot);
            for (int shape_i = -1; shape_i <= shapes_max; ++shape_i) {
                const Status status = status_of(world, id, shape_i);
                const int at = slot * shapes_max + shape_i;
                if constexpr (S::rolling_resistance) {
                    const Result<scalar> got = world.rolling_resistance(id, shape_i);
                    demand(got.status == status && (!got.ok() || got.value == lever[at]), "a surface keeps its rolling resistance");
                }
                if constexpr (S::surface_velocities) {
                    const Result<Vector> got = world.surface_velocity(id, shape_i);
                    const auto same = [](const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
                    demand(got.status == status && (!got.ok() || same(got.value, belt[at])), "a surface keeps its velocity");
                }
            }
        }
    }
};

} }  // namespace fuzz
