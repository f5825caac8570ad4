// SPDX-License-Identifier: MIT
// In a file of its own: what compilers make of the others does not depend on it.
#include "conduct_sweeps.h"

namespace ingot { inline namespace INGOT_ABI {

// The linker takes the one that the scene calls.
#define INGOT_VIEW(View)                                                                                 \
    template void solve_by_sweeps<false, false>(ReactingViewOf<View>&, const ContactStep&, StepReport&); \
    template void solve_by_sweeps<false, true>(ReactingViewOf<View>&, const ContactStep&, StepReport&);  \
    template void solve_by_sweeps<true, false>(ReactingViewOf<View>&, const ContactStep&, StepReport&);  \
    template void solve_by_sweeps<true, true>(ReactingViewOf<View>&, const ContactStep&, StepReport&)
#define INGOT_KINEMATIC_VIEW(View)                                                                                        \
    template void solve_by_sweeps<false, false>(KinematicViewOf<ReactingViewOf<View>>&, const ContactStep&, StepReport&); \
    template void solve_by_sweeps<false, true>(KinematicViewOf<ReactingViewOf<View>>&, const ContactStep&, StepReport&);  \
    template void solve_by_sweeps<true, false>(KinematicViewOf<ReactingViewOf<View>>&, const ContactStep&, StepReport&);  \
    template void solve_by_sweeps<true, true>(KinematicViewOf<ReactingViewOf<View>>&, const ContactStep&, StepReport&)
INGOT_VIEW(JointedView);
INGOT_VIEW(LoopedView);
INGOT_VIEW(JointedMaterialView);
INGOT_VIEW(LoopedMaterialView);
INGOT_VIEW(RowedView);
INGOT_VIEW(RowedMaterialView);
INGOT_VIEW(DrivenView);
INGOT_VIEW(DrivenMaterialView);
INGOT_VIEW(LoopedRowedView);
INGOT_VIEW(LoopedRowedMaterialView);
INGOT_KINEMATIC_VIEW(JointedView);
INGOT_KINEMATIC_VIEW(LoopedView);
INGOT_KINEMATIC_VIEW(JointedMaterialView);
INGOT_KINEMATIC_VIEW(LoopedMaterialView);
INGOT_KINEMATIC_VIEW(RowedView);
INGOT_KINEMATIC_VIEW(RowedMaterialView);
INGOT_KINEMATIC_VIEW(DrivenView);
INGOT_KINEMATIC_VIEW(DrivenMaterialView);
INGOT_KINEMATIC_VIEW(LoopedRowedView);
INGOT_KINEMATIC_VIEW(LoopedRowedMaterialView);
#undef INGOT_VIEW
#undef INGOT_KINEMATIC_VIEW

} }  // namespace ingot
