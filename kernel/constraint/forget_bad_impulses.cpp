// SPDX-License-Identifier: MIT
#include "forget_bad_impulses.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// It is 0 from now on where its square is no number.
INGOT_NOINLINE void forget_if_bad(scalar& j) {
    if (!is_finite(j * j)) j = 0;
}
INGOT_NOINLINE void forget_if_bad(Vector& j) {
    forget_if_bad(j.x);
    forget_if_bad(j.y);
    forget_if_bad(j.z);
}

}  // namespace

void forget_bad_impulses(ManifoldRecord* records, int records_used, Vector* references, ImpulseSum* sums) {
    for (int record_i = 0; record_i < records_used; ++record_i) {  // bound: max_manifolds
        ManifoldRecord& record = records[record_i];
        forget_if_bad(record.j_friction);
        forget_if_bad(record.j_torsion);
        if (references != nullptr) forget_if_bad(references[record_i]);
        if (sums != nullptr) forget_if_bad(sums[record_i].friction);
        for (int row = 0; row < Manifold::points_max; ++row) {  // bound: 4: Manifold::points_max
            forget_if_bad(record.j[row]);
            forget_if_bad(record.j_before[row]);
            if (sums != nullptr) forget_if_bad(sums[record_i].j[row]);
        }
    }
}

} }  // namespace ingot
