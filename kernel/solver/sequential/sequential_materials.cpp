// SPDX-License-Identifier: MIT
// The sequential solver in scenes whose surfaces resist being rolled, move by themselves, or bounce.
#include "point_reversals.h"
#include "sequential_contacts.h"

namespace ingot { inline namespace INGOT_ABI {

// The linker takes the one that the scene calls.
#define INGOT_POINT_VIEW(rolls, has_belts, bounces)                                                                        \
    template void solve_sequentially<false>(PointMaterialView<rolls, has_belts, bounces>&, const ContactStep&, StepReport&); \
    template void solve_sequentially<true>(PointMaterialView<rolls, has_belts, bounces>&, const ContactStep&, StepReport&)
INGOT_POINT_VIEW(false, false, true);
INGOT_POINT_VIEW(false, true, false);
INGOT_POINT_VIEW(false, true, true);
INGOT_POINT_VIEW(true, false, false);
INGOT_POINT_VIEW(true, false, true);
INGOT_POINT_VIEW(true, true, false);
INGOT_POINT_VIEW(true, true, true);
#undef INGOT_POINT_VIEW

} }  // namespace ingot
