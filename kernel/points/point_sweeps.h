// SPDX-License-Identifier: MIT
// `using solver = ingot::PointSweeps;` of a scene, in the least memory there is.
#pragma once

#include "solve_points.h"

namespace ingot { inline namespace INGOT_ABI {

/// `using solver = ingot::PointSweeps;`, for a few bodies on a small target: ten or twenty that stand, slide, roll, fall. Sweeps point by point in
/// scalar arithmetic, whatever `lanes` is. Nothing bounces: set bounces = false. RAM of the world: 180 bytes a body and 52 a manifold in float,
/// where Sweeps takes 224 and 700. Time at rest is less than theirs; of what moves it is more, for they solve a manifold at once.
struct PointSweeps {
    static constexpr bool is_direct = false, is_pointwise = true;

    template <int max_bodies, int max_manifolds>
    struct Memory {
        PointBody point_bodies[static_cast<unsigned>((max_bodies + lanes - 1) / lanes * lanes)] = {};
        PointContact point_contacts[static_cast<unsigned>(max_manifolds)] = {};

        PointView solver_of(const BodyPair* pairs, ManifoldRecord* records, int manifold_count) {
            return {pairs, records, manifold_count, point_bodies, point_contacts, 0};
        }
        template <bool notes_impulses, bool>
        void solve_contacts(PointView& solver, const BodyView& bodies, const Vector& gravity, scalar h, ImpactNote* notes, StepReport& report) {
            solve_points<notes_impulses>(solver, bodies, gravity, h, notes, report);
        }
    };
};

} }  // namespace ingot
