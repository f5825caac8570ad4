// SPDX-License-Identifier: MIT
#include "conduct_sweeps.h"

namespace ingot { inline namespace INGOT_ABI {

// The linker takes the one that the scene calls.
#define INGOT_VIEW(View)                                                                 \
    template void solve_by_sweeps<false, false>(View&, const ContactStep&, StepReport&); \
    template void solve_by_sweeps<false, true>(View&, const ContactStep&, StepReport&);  \
    template void solve_by_sweeps<true, false>(View&, const ContactStep&, StepReport&);  \
    template void solve_by_sweeps<true, true>(View&, const ContactStep&, StepReport&)
INGOT_VIEW(SolverView);
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
INGOT_VIEW(LockedView);
INGOT_VIEW(BallView);
INGOT_VIEW(RollingView);
INGOT_VIEW(BeltView);
INGOT_VIEW(RollingBeltView);
INGOT_VIEW(KinematicViewOf<SolverView>);
INGOT_VIEW(KinematicViewOf<JointedView>);
INGOT_VIEW(KinematicViewOf<LoopedView>);
INGOT_VIEW(KinematicViewOf<JointedMaterialView>);
INGOT_VIEW(KinematicViewOf<LoopedMaterialView>);
INGOT_VIEW(KinematicViewOf<RowedView>);
INGOT_VIEW(KinematicViewOf<RowedMaterialView>);
INGOT_VIEW(KinematicViewOf<DrivenView>);
INGOT_VIEW(KinematicViewOf<DrivenMaterialView>);
INGOT_VIEW(KinematicViewOf<LoopedRowedView>);
INGOT_VIEW(KinematicViewOf<LoopedRowedMaterialView>);
INGOT_VIEW(KinematicViewOf<LockedView>);
INGOT_VIEW(KinematicViewOf<BallView>);
INGOT_VIEW(KinematicViewOf<RollingView>);
INGOT_VIEW(KinematicViewOf<BeltView>);
INGOT_VIEW(KinematicViewOf<RollingBeltView>);
#undef INGOT_VIEW

} }  // namespace ingot
