// SPDX-License-Identifier: MIT
// The manifolds of a body with a level. The pair with the first of the level's shapes stands for all of them: they are found at once.
#pragma once

#include "../broad_phase/crowd.h"
#include "find_manifolds.h"

namespace ingot { inline namespace INGOT_ABI {

INGOT_INLINE bool is_level(const SurfaceView& surfaces, int slot) { return surfaces.surfaces[slot].shape.kind == ShapeKind::level; }
INGOT_INLINE bool is_with_level(const SurfaceView& surfaces, const BodyPair& pair) {
    return is_level(surfaces, pair.body_A) || is_level(surfaces, pair.body_B);
}
/// Of a pair with a level: with the first of its shapes.
INGOT_INLINE bool is_first_of_level(const SurfaceView& surfaces, const BodyPair& pair) {
    return patch_number(surfaces.surfaces[is_level(surfaces, pair.body_A) ? pair.body_A : pair.body_B].shape) == 0;
}

/// Friction and restitution of a pair with a level, of the material that it touches.
template <class Shapes>
void mix_level_material(const SurfaceView& surfaces, const BodyPair& pair, ManifoldRecord& record) {
    const Surface &A = surfaces.surfaces[pair.body_A], &B = surfaces.surfaces[pair.body_B];
    const bool level_is_A = A.shape.kind == ShapeKind::level;
    const Surface &body = level_is_A ? B : A, &ground = level_is_A ? A : B;
    const LevelMaterial* material = Shapes::level_of(ground.shape)->material(record.manifold.material);
    struct {
        scalar e, mu;
    } touched = {ground.e, ground.mu};
    if (material != nullptr) touched = {material->restitution, material->friction};
    mix_materials(body, touched, record);
}

/// After mix_materials_of: of contacts with levels.
template <class Shapes>
void mix_level_materials_of(const SurfaceView& surfaces, const ManifoldView& manifolds, int shape_slot) {
    for (int pair_i = 0; pair_i < *manifolds.count; ++pair_i) {  // bound: max_manifolds
        const BodyPair& pair = manifolds.pairs[pair_i];
        if ((pair.body_A == shape_slot || pair.body_B == shape_slot) && is_with_level(surfaces, pair))
            mix_level_material<Shapes>(surfaces, pair, manifolds.records[pair.record]);
    }
}

/// What pairs with a level are found by.
template <class Shapes, bool renews>
struct LevelPairs {
    const BodyView& bodies;
    const SurfaceView& surfaces;
    const PairList& found;
    const ManifoldView& manifolds;
    StepReport& report;

    /// pair: with the first shape of a level; its own record and those of its companions become what they are in this step.
    void update(BodyPair& pair, scalar margin, bool fast) const {
        BodyPair* pairs[level_patches];
        if (!has_all(pair, pairs)) count(report.contacts_lost);  // the list of pairs is full
        if (renews && !fast && are_renewed(pairs, margin)) return;
        (void)search(pairs, margin, [](const auto&...) { return true; });
    }
    /// The same where no record is taken or given back, which has to wait for its turn: false, and the pairs are to be updated then.
    bool update_ahead(BodyPair& pair, scalar margin) const {
        BodyPair* pairs[level_patches];
        if (!has_all(pair, pairs)) return false;
        if (renews && are_renewed(pairs, margin)) return true;
        return search(pairs, margin, [this](BodyPair* const(&all)[level_patches], const int(&patch_of)[level_patches]) {
            for (int i = 0; i < level_patches; ++i)
                if (has_record(all[i]) != (patch_of[i] >= 0)) return false;
            return true;
        });
    }

private:
    bool level_is_A(const BodyPair& pair) const { return is_level(surfaces, pair.body_A); }

    /// Null for a companion that the list has not.
    bool has_all(BodyPair& pair, BodyPair* (&pairs)[level_patches]) const {
        bool all = true;
        pairs[0] = &pair;
        for (int patch_i = 1; patch_i < level_patches; ++patch_i) {
            const int A = pair.body_A + (level_is_A(pair) ? patch_i : 0), B = pair.body_B + (level_is_A(pair) ? 0 : patch_i);
            const int place = place_in(found.pairs, *found.count, key_of(static_cast<Index>(A), static_cast<Index>(B)));
            pairs[patch_i] = place < 0 ? nullptr : found.pairs + place;
            all = all && place >= 0;
        }
        return all;
    }
    bool has_record(const BodyPair* pair) const { return pair != nullptr && pair->record < refused_record; }

    bool are_renewed(BodyPair* (&pairs)[level_patches], scalar margin) const {
        bool some = false;
        for (BodyPair* pair : pairs) {
            if (!has_record(pair)) continue;
            some = true;
            if (!renew_manifold<Shapes>(bodies, surfaces, *pair, margin, manifolds.anchors[pair->record], manifolds.records[pair->record].manifold))
                return false;
        }
        return some;
    }

    /// Unless may(pairs, patch_of) forbids it: false.
    template <class May>
    bool search(BodyPair* (&pairs)[level_patches], scalar margin, const May& may) const {
        const bool swapped = level_is_A(*pairs[0]);
        const int level_slot = swapped ? pairs[0]->body_A : pairs[0]->body_B, body_slot = swapped ? pairs[0]->body_B : pairs[0]->body_A;
        const PlacedShape level = placed_body<Shapes>(bodies, surfaces, level_slot), body = placed_body<Shapes>(bodies, surfaces, body_slot);
        const LevelTouch<Shapes> touch(body, level, margin, flush_of(body, surfaces.unit));

        int patch_of[level_patches];
        assign(pairs, touch, swapped ? scalar(-1) : scalar(1), patch_of);
        if (!may(pairs, patch_of)) return false;
        for (int i = 0; i < level_patches; ++i) {
            if (pairs[i] == nullptr) continue;
            if (patch_of[i] < 0) {
                if (has_record(pairs[i])) give_back(manifolds, pairs[i]->record);
                continue;
            }
            Manifold now;
            now.halvings = static_cast<uint16_t>(surfaces.halvings(pairs[i]->body_A, pairs[i]->body_B));
            touch.write(patch_of[i], has_record(pairs[i]) ? manifolds.records[pairs[i]->record].manifold : no_manifold_before, now);
            if (swapped) now.n = -now.n;
            keep(*pairs[i], now, margin);
            if (touch.has_materials() && has_record(pairs[i])) keep_material(*pairs[i], touch.material(patch_of[i]));
        }
        return true;
    }

    /// Which patch goes to which pair; -1: none. A pair that has a contact keeps the plane that it had, as near as there is one, and its material;
    /// others take what is left.
    void assign(BodyPair* const (&pairs)[level_patches], const LevelTouch<Shapes>& touch, scalar to_body, int (&patch_of)[level_patches]) const {
        bool taken[level_patches] = {};
        for (int i = 0; i < level_patches; ++i) {
            patch_of[i] = -1;
            if (!has_record(pairs[i])) continue;
            const Manifold& before = manifolds.records[pairs[i]->record].manifold;
            const Vector n = before.n * to_body;
            scalar nearest = limits::same_plane_cos;
            for (int k = 0; k < touch.count(); ++k) {  // bound: level_patches
                const scalar along = touch.along(k, n);
                if (taken[k] || !(along > nearest) || (touch.has_materials() && touch.material(k) != before.material)) continue;
                nearest = along;
                patch_of[i] = k;
            }
            if (patch_of[i] >= 0) taken[patch_of[i]] = true;
        }
        for (int k = 0; k < touch.count(); ++k) {  // bound: level_patches
            for (int i = 0; i < level_patches && !taken[k]; ++i) {
                if (pairs[i] == nullptr || patch_of[i] >= 0) continue;
                patch_of[i] = k;
                taken[k] = true;
            }
        }
    }

    void keep_material(const BodyPair& pair, uint8_t material) const {
        ManifoldRecord& record = manifolds.records[pair.record];
        record.manifold.material = material;
        mix_level_material<Shapes>(surfaces, pair, record);
    }
    void keep(BodyPair& pair, const Manifold& now, scalar margin) const {
        if (!has_record(&pair)) {
            pair.record = take_record(manifolds);
            if (pair.record == no_record) {
                count(report.contacts_lost);
                pair.record = refused_record;
                return;
            }
            mix_materials(surfaces, pair, manifolds.records[pair.record]);
        } else {
            carry_impulses(manifolds.records[pair.record], now);
        }
        keep_manifold(now, manifolds.records[pair.record].manifold);
        if (renews && worth_renewing(surfaces.surfaces[pair.body_A], surfaces.surfaces[pair.body_B]))
            anchor(frame_of(bodies, pair.body_A), frame_of(bodies, pair.body_B), now, margin, manifolds.anchors[pair.record]);
    }
};

/// True for a pair with a level, whose manifolds are then up to date, and listed.
template <class Shapes, bool renews, class FastPairs>
bool update_level_pair(const BodyView& bodies, const SurfaceView& surfaces, const BoundsTile* bounds, scalar h, const FastPairs& fast_pairs,
                       const PairList& found, const ManifoldView& manifolds, StepReport& report, BodyPair& pair) {
    if constexpr (!Shapes::has(ShapeKind::level)) {
        (void)bodies, (void)surfaces, (void)bounds, (void)h, (void)fast_pairs, (void)found, (void)manifolds, (void)report, (void)pair;
        return false;
    } else {
        if (!is_with_level(surfaces, pair)) return false;
        const LevelPairs<Shapes, renews> levels = {bodies, surfaces, found, manifolds, report};
        if (is_first_of_level(surfaces, pair)) {
            const bool fast = fast_pairs.has(pair);
            levels.update(pair, fast ? margin_of_fast(bodies, surfaces, pair) : margin_of(bodies, surfaces, bounds, pair, h), fast);
        }
        if (pair.record < refused_record) manifolds.pairs[(*manifolds.count)++] = pair;
        return true;
    }
}

} }  // namespace ingot
