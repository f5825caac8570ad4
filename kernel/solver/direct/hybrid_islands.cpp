// SPDX-License-Identifier: MIT
#include "hybrid_islands.h"

#include "hybrid_contacts.h"

namespace ingot { inline namespace INGOT_ABI {

template <bool notes_impulses, bool bounces, class View>
void solve_hybrid(View& view, const DirectView& direct, const ContactStep& step, StepReport& report) {
    HybridContacts<View, notes_impulses, bounces> contacts(view, direct);
    conduct_substeps(contacts, step, report);
}

// The linker takes the one that the scene calls.
#define INGOT_VIEW(View)                                                                 \
    template void solve_hybrid<false, false>(View&, const DirectView&, const ContactStep&, StepReport&); \
    template void solve_hybrid<false, true>(View&, const DirectView&, const ContactStep&, StepReport&);  \
    template void solve_hybrid<true, false>(View&, const DirectView&, const ContactStep&, StepReport&);  \
    template void solve_hybrid<true, true>(View&, const DirectView&, const ContactStep&, StepReport&)
INGOT_VIEW(SolverView);
INGOT_VIEW(RollingView);
INGOT_VIEW(BeltView);
INGOT_VIEW(RollingBeltView);
#undef INGOT_VIEW

} }  // namespace ingot
