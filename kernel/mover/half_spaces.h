// SPDX-License-Identifier: MIT
// The point of a few half spaces that is nearest to another: see solve_planes.h.
#pragma once

#include "mover.h"

namespace ingot { inline namespace INGOT_ABI {

/// All x with n . x >= least for each of them.
struct HalfSpaces {
    Vector n[movers::planes_max];
    scalar least[movers::planes_max];
    int count = 0;

    void add(const Vector& normal, scalar at_least) {
        n[count] = normal;
        least[count++] = at_least;
    }
};
/// The point of them that is nearest to w; see solve_planes. The order of the planes is left as it may be.
/// far: times all lengths that are given: planes that meet further from w do not meet, and each is passed by.
Vector nearest_in(HalfSpaces& spaces, const Vector& w, scalar far);

} }  // namespace ingot
