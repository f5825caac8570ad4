// SPDX-License-Identifier: MIT
// The sequential solver in scenes with kinematic bodies.
#include "kinematic_points.h"
#include "point_reversals.h"

namespace ingot { inline namespace INGOT_ABI {

template <bool notes_impulses, class View>
void solve_kinematic_sequentially(KinematicPointViewOf<View>& solver, const ContactStep& step, StepReport& report) {
    SeesKinematicPoints<KinematicPointViewOf<View>, notes_impulses> contacts(solver);
    conduct_substeps(contacts, step, report);
}

// The linker takes the one that the scene calls.
#define INGOT_POINT_VIEW(...)                                                                                              \
    template void solve_kinematic_sequentially<false>(KinematicPointViewOf<__VA_ARGS__>&, const ContactStep&, StepReport&); \
    template void solve_kinematic_sequentially<true>(KinematicPointViewOf<__VA_ARGS__>&, const ContactStep&, StepReport&)
INGOT_POINT_VIEW(PointView);
INGOT_POINT_VIEW(PointMaterialView<false, false, true>);
INGOT_POINT_VIEW(PointMaterialView<false, true, false>);
INGOT_POINT_VIEW(PointMaterialView<false, true, true>);
INGOT_POINT_VIEW(PointMaterialView<true, false, false>);
INGOT_POINT_VIEW(PointMaterialView<true, false, true>);
INGOT_POINT_VIEW(PointMaterialView<true, true, false>);
INGOT_POINT_VIEW(PointMaterialView<true, true, true>);
#undef INGOT_POINT_VIEW

} }  // namespace ingot
