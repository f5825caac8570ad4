// SPDX-License-Identifier: MIT
// `using solver = ingot::BlockSweeps;` of a scene: the many-body scheme, manifolds as blocks.
#pragma once

#include "../../constraint/material_view.h"
#include "../conduct_substeps.h"
#include "work_together.h"

namespace ingot { inline namespace INGOT_ABI {

/// Solves all contacts of a step by sweeps over their blocks. View: SolverView, or a MaterialView.
///
/// Bound: of an island, steady_substeps * sweeps_of_small and then substeps * sweeps_of_small visits a manifold where few touch; else
///        substeps times the larger of 4 * sweeps of its Effort and sweeps_of_stack. All that again gaining_rounds times at most
///        where sweeps that did not settle give energy, and bounce_rounds times where bounces do. Where impacts cause impacts, impacts_of_contact
///        of them a contact and substep.
template <bool notes_impulses, bool bounces, class View>
void solve_by_sweeps(View& view, const ContactStep& step, StepReport& report);

/// The same by several cores, to the bit, whatever islands there are: for one that is too large for one core. View: none with joints.
template <bool notes_impulses, bool bounces, class View>
void sweep_together(View& view, const ContactStep& step, StepReport& report, const WorkTogether& work);

/// What solvers have in common that work on blocks.
struct BlockSolver {
    static constexpr bool is_frictionless = false, is_pointwise = false;

    template <bool rolls, bool has_belts, bool>
    using View = MaterialViewOf<rolls, has_belts>;

    /// The contacts of two bodies that meet within a step, see continuous/: they are left to the sweeps, whatever else the solver has.
    template <bool notes_impulses, bool bounces, class View>
    static void solve_pair(View& view, const ContactStep& step, StepReport& report) {
        solve_by_sweeps<notes_impulses, bounces>(view, step, report);
    }
};

/// `using solver = ingot::BlockSweeps;`, for many bodies of like masses. No memory of its own. StepReport::residual says how far it got: some 1e-6
/// m/s where contacts rest, 0.1 and more where a heavy body crushes a light one.
struct BlockSweeps : BlockSolver {
    static constexpr const char* name = "block_sweeps";
    static constexpr bool is_direct = false;

    template <int max_bodies, int max_manifolds, bool rolls = false, bool = true>
    struct Memory {
        template <bool notes_impulses, bool bounces, class View>
        void solve_contacts(View& solver, const ContactStep& step, StepReport& report) {
            solve_by_sweeps<notes_impulses, bounces>(solver, step, report);
        }
        template <bool notes_impulses, bool bounces, class View>
        void solve_together(View& solver, const ContactStep& step, StepReport& report, const WorkTogether& work) {
            sweep_together<notes_impulses, bounces>(solver, step, report, work);
        }
    };
};

} }  // namespace ingot
