// SPDX-License-Identifier: MIT
#include "forget_bad_impulses.h"

namespace ingot { inline namespace INGOT_ABI {

void forget_bad_impulses(ManifoldRecord* records, int records_used, Vector* references, ImpulseSum* sums) {
    for (int record_i = 0; record_i < records_used; ++record_i) {  // bound: max_manifolds
        ManifoldRecord& record = records[record_i];
        scalar squares = length_sq(record.j_friction) + record.j_torsion * record.j_torsion;
        if (references != nullptr) squares += length_sq(references[record_i]);
        if (sums != nullptr) squares += length_sq(sums[record_i].friction);
        for (int row = 0; row < Manifold::points_max; ++row) {  // bound: 4: Manifold::points_max
            squares += record.j[row] * record.j[row] + record.j_before[row] * record.j_before[row];
            if (sums != nullptr) squares += sums[record_i].j[row] * sums[record_i].j[row];
        }
        if (is_finite(squares)) continue;
        for (int row = 0; row < Manifold::points_max; ++row) record.j[row] = record.j_before[row] = 0;  // bound: 4: Manifold::points_max
        record.j_friction = {};
        record.j_torsion = 0;
        if (references != nullptr) references[record_i] = {};
        if (sums != nullptr) sums[record_i] = {};
    }
}

} }  // namespace ingot
