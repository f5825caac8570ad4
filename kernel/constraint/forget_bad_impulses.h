// SPDX-License-Identifier: MIT
#pragma once

#include "../narrow_phase/manifold_record.h"
#include "impact_note.h"

namespace ingot { inline namespace INGOT_ABI {

/// After a step that has driven bodies out of range: what the solve of their island has left in its contacts is forgotten where it is no number to
/// begin the next step with, to tell, or to save. Whether a body of the contact froze is not asked: others of its figure may have been left out.
///
/// An impulse whose square is no number counts as bad: all that forces, speeds and masses within their limits give is below
/// limits::speed_max * limits::mass_max = 1e18 N s, so contacts of other islands keep their bits.
/// references, sums: by record; null where a scene keeps none.
void forget_bad_impulses(ManifoldRecord* records, int records_used, Vector* references, ImpulseSum* sums);

} }  // namespace ingot
