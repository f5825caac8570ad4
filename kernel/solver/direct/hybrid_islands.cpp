// SPDX-License-Identifier: MIT
#include "hybrid_islands.h"

#include "../sweeps/kinematic_contacts.h"
#include "hybrid_contacts.h"

namespace ingot { inline namespace INGOT_ABI {

template <bool notes_impulses, bool bounces, class View>
void solve_hybrid(View& view, const DirectOf<View>& direct, const ContactStep& step, StepReport& report) {
    using Hybrid = HybridContacts<View, notes_impulses, bounces>;
    If<sees_kinematic<View>, SeesKinematic<Hybrid, View>, Hybrid> contacts(view, direct);
    conduct_substeps(contacts, step, report);
}

// The linker takes the one that the scene calls.
#define INGOT_VIEW(View)                                                                 \
    template void solve_hybrid<false, false>(View&, const DirectOf<View>&, const ContactStep&, StepReport&); \
    template void solve_hybrid<false, true>(View&, const DirectOf<View>&, const ContactStep&, StepReport&);  \
    template void solve_hybrid<true, false>(View&, const DirectOf<View>&, const ContactStep&, StepReport&);  \
    template void solve_hybrid<true, true>(View&, const DirectOf<View>&, const ContactStep&, StepReport&)
INGOT_VIEW(SolverView);
INGOT_VIEW(RollingView);
INGOT_VIEW(BeltView);
INGOT_VIEW(RollingBeltView);
INGOT_VIEW(KinematicViewOf<SolverView>);
INGOT_VIEW(KinematicViewOf<RollingView>);
INGOT_VIEW(KinematicViewOf<BeltView>);
INGOT_VIEW(KinematicViewOf<RollingBeltView>);
#undef INGOT_VIEW

} }  // namespace ingot
