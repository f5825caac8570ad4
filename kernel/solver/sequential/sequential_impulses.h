// SPDX-License-Identifier: MIT
// `using solver = ingot::SequentialImpulses;` of a scene, in the least memory there is.
#pragma once

#include "solve_sequentially.h"

namespace ingot { inline namespace INGOT_ABI {

/// What restitution adds.
template <int max_manifolds, bool bounces>
struct LandingPart {
    PointLandings landings[static_cast<unsigned>(max_manifolds)] = {};

    template <class View>
    void show_landings(View& view) {
        view.landings = landings;
    }
};
template <int max_manifolds>
struct LandingPart<max_manifolds, false> {
    template <class View>
    static void show_landings(View&) {}
};

/// `using solver = ingot::SequentialImpulses;`, for a few bodies on a small target: ten or twenty that stand, slide, roll, fall. Towers
/// of ten sink by 0.04 mm, and 10 kg on three times 1 kg by 0.2; for more, or for restitution, there is BlockSweeps. Sweeps go point by
/// point in scalar arithmetic, whatever `lanes` is. Nothing bounces: set bounces = false.
///
/// RAM of the world in float: 188 bytes a body and 116 a manifold, where BlockSweeps on one lane takes 220 and 720. Flash on a
/// Cortex-M4F: 7 KB, where BlockSweeps takes 20. Bodies at rest take less time than with BlockSweeps. Bodies that begin to move take up to four times
/// as much, because BlockSweeps solves the points of a manifold at once.
struct SequentialImpulses {
    static constexpr const char* name = "sequential_impulses";
    static constexpr bool is_frictionless = false, is_direct = false, is_pointwise = true;

    template <bool rolls, bool has_belts, bool bounces>
    using View = PointViewOf<rolls, has_belts, bounces>;

    /// The contacts of two bodies that meet within a step: see continuous/.
    template <bool notes_impulses, bool, class View>
    static void solve_pair(View& view, const ContactStep& step, StepReport& report) {
        solve_sequentially<notes_impulses>(view, step, report);
    }

    template <int max_bodies, int max_manifolds, bool = false, bool bounces = false>
    struct Memory : LandingPart<max_manifolds, bounces> {
        PointBody point_bodies[static_cast<unsigned>((max_bodies + lanes - 1) / lanes * lanes)] = {};
        PointContact point_contacts[static_cast<unsigned>(max_manifolds)] = {};

        Index members[static_cast<unsigned>(max_manifolds)] = {}, body_slots[static_cast<unsigned>(max_bodies)] = {};

        PointView solver_of(const BodyPair* pairs, ManifoldRecord* records, int manifold_count) {
            return {pairs, records, manifold_count, 1, point_bodies, point_contacts, members, body_slots, 0, 0, 0, 0};
        }
        template <bool notes_impulses, bool, class View>
        void solve_contacts(View& solver, const ContactStep& step, StepReport& report) {
            solve_sequentially<notes_impulses>(solver, step, report);
        }
    };
};

} }  // namespace ingot
