// SPDX-License-Identifier: MIT
// What the contacts of the step have seen to for bodies with joints, so that it is no impact of their paths.
#pragma once

#include "../base/figure_limits.h"
#include "lay_paths.h"
#include "level_on_path.h"
#include "parting_plane.h"

namespace ingot { inline namespace INGOT_ABI {

/// The manifold of two shapes; with a level, that whose normal is n, world, but for a little. Null: they have none.
template <class Collision>
const BodyPair* find_solved(const Collision& collision, const ShapePair& pair, [[maybe_unused]] const Vector& n) {
    if constexpr (sees_levels<Collision>)
        if (collision.shapes.surface(pair.B).shape.kind == ShapeKind::level) {
            for (int patch_i = 0; patch_i < level_patches; ++patch_i) {
                const BodyPair* const solved = collision.solved.find(pair.A, {pair.B.number + patch_i});
                if (solved == nullptr) continue;
                const Vector& of = collision.solver.records[solved->record].manifold.n;
                if (dot(of, n) * (solved->body_A == pair.A.number ? 1 : -1) > limits::same_plane_cos) return solved;
            }
            return nullptr;
        }
    return collision.solved.find(pair.A, pair.B);
}

template <class Collision>
INGOT_INLINE bool some_of_figure(const Collision& collision, int slot, int other) {
    return collision.is_of_figure(slot) || collision.is_of_figure(other);
}

/// What kinematic bodies do to figures is left to contacts: they wait for nobody, and would go through what does. So is what bodies of one figure do
/// to each other: all of it would wait.
template <class Collision>
bool is_carried_along([[maybe_unused]] const Collision& collision, [[maybe_unused]] int slot, [[maybe_unused]] int other) {
    if constexpr (Collision::some_figures) {
        if (collision.is_of_figure(slot) && collision.is_of_figure(other)) return collision.machine_of_body(slot) == collision.machine_of_body(other);
        return some_of_figure(collision, slot, other) && (is_kinematic(collision, slot) || is_kinematic(collision, other));
    }
    return false;
}

/// m; the least half extent of the shapes that bodies with joints have.
template <class Collision>
scalar least_of_figures(const Collision& collision, int slot, int other, const ShapePair& pair) {
    const auto least_of = [&](int body, ShapeSlot shape) {
        return collision.is_of_figure(body) ? least_half_extent(collision.shapes.surface(shape).shape, collision.shapes.hull(shape))
                                            : limits::unbounded;
    };
    return min(least_of(slot, pair.A), least_of(other, pair.B));
}

/// Two shapes on the paths of their bodies: of a level, one of its triangles.
struct MetPair {
    int slot, other;
    ShapePair pair;
    const ShapeOnPath &A, &B;
};

/// Whether two shapes that have a manifold are, at the end of their paths, still on either side of its plane, but for limits::depth_of_figure: then
/// its rows have stopped what was to be stopped, wherever a path cuts a corner in between.
template <class Collision>
bool has_stayed_outside([[maybe_unused]] const Collision& collision, [[maybe_unused]] const MetPair& met, [[maybe_unused]] const BodyPair* solved) {
    if constexpr (Collision::some_figures) {
        if (solved == nullptr || !some_of_figure(collision, met.slot, met.other)) return false;
        const ShapePair& pair = met.pair;
        const Vector n_of_record = collision.solver.records[solved->record].manifold.n;
        const Vector n = solved->body_A == pair.A.number ? n_of_record : -n_of_record;
        const auto gap_at = [&](bool at_end) {
            const auto placed = [&](const ShapeOnPath& of) {
                const PathFrame at = frame_on_path(of.path, at_end ? of.path.until : of.path.from);
                return place_on_body(of.shape, of.place, of.hull, at.r_CM, at.A);
            };
            return gap_along(placed(met.A), placed(met.B), n);
        };
        const scalar least = least_of_figures(collision, met.slot, met.other, pair);
        return !(gap_at(true) < min(gap_at(false) - limits::skin_share * least, -limits::depth_of_figure * least));
    }
    return false;
}

/// Whether some shapes of two bodies, one of them with joints, have a manifold.
template <class Collision>
bool have_manifold([[maybe_unused]] const Collision& collision, [[maybe_unused]] int slot, [[maybe_unused]] int other) {
    bool some = false;
    if constexpr (Collision::some_figures)
        if (some_of_figure(collision, slot, other))
            collision.shapes.for_shapes(slot, [&](ShapeSlot A) {
                collision.shapes.for_shapes(other, [&](ShapeSlot B) { some = some || collision.solved.find(A, B) != nullptr; });
            });
    return some;
}

/// The same of two shapes; of a level, whatever it has.
template <class Collision>
bool have_manifold(const Collision& collision, const ShapePair& pair) {
    bool some = collision.solved.find(pair.A, pair.B) != nullptr;
    if constexpr (sees_levels<Collision>)
        if (collision.shapes.surface(pair.B).shape.kind == ShapeKind::level)
            for (int patch_i = 1; patch_i < level_patches; ++patch_i)
                some = some || collision.solved.find(pair.A, {pair.B.number + patch_i}) != nullptr;
    return some;
}

/// Impacts at once of what has no manifold are none: inside a floor, or between bodies for whose contact there was no room.
template <class Collision>
bool is_left_to_contacts([[maybe_unused]] const Collision& collision, [[maybe_unused]] int slot, [[maybe_unused]] int other,
                         [[maybe_unused]] const ShapePair& pair, [[maybe_unused]] scalar t) {
    if constexpr (Collision::some_figures)
        if (some_of_figure(collision, slot, other)) return !(t > 0) && !have_manifold(collision, pair);
    return false;
}

} }  // namespace ingot
