// SPDX-License-Identifier: MIT
#include "floating_point.h"

namespace ingot { inline namespace INGOT_ABI {

Status check_floating_point_of_kernel() {
    // volatile: the unit computes, not the compiler.
    volatile scalar half = scalar(0.5), one = 1, ulp = epsilon;
#if INGOT_DOUBLE
    volatile scalar smallest_normal = DBL_MIN;
#else
    volatile scalar smallest_normal = FLT_MIN;
#endif

    // Half a last place above 1 and above its neighbour: to nearest even goes down once and up once, any other way twice the same.
    const scalar down = one + ulp * half, up = (one + ulp) + ulp * half;
    if (down != 1 || up != 1 + 2 * epsilon) return Status::wrong_rounding;

    volatile scalar a = one + ulp, minus_a_sq = -(one + 2 * ulp);
    const scalar twice_rounded = a * a + minus_a_sq;
    if (twice_rounded != 0) return Status::wrong_rounding;

    // Made by the unit, then taken in by it; compared as a normal number, because a comparison may flush too.
    volatile scalar denormal = smallest_normal * half;
    const scalar doubled = denormal + denormal;
    return doubled == smallest_normal ? Status::ok : Status::flushes_denormals;
}

} }  // namespace ingot
