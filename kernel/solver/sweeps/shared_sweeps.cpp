// SPDX-License-Identifier: MIT
#include "conduct_sweeps.h"

namespace ingot { inline namespace INGOT_ABI {

// The linker takes the one that the scene calls.
#define INGOT_TOGETHER(View)                                                                                 \
    template void sweep_together<false, false>(View&, const ContactStep&, StepReport&, const WorkTogether&); \
    template void sweep_together<false, true>(View&, const ContactStep&, StepReport&, const WorkTogether&);  \
    template void sweep_together<true, false>(View&, const ContactStep&, StepReport&, const WorkTogether&);  \
    template void sweep_together<true, true>(View&, const ContactStep&, StepReport&, const WorkTogether&)
#define INGOT_VIEW(View)  \
    INGOT_TOGETHER(View); \
    INGOT_TOGETHER(KinematicViewOf<View>)
INGOT_VIEW(SolverView);
INGOT_VIEW(LockedView);
INGOT_VIEW(BallView);
INGOT_VIEW(RollingView);
INGOT_VIEW(BeltView);
INGOT_VIEW(RollingBeltView);
#undef INGOT_VIEW
#undef INGOT_TOGETHER

} }  // namespace ingot
