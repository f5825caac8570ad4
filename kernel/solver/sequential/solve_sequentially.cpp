// SPDX-License-Identifier: MIT
#include "sequential_contacts.h"

namespace ingot { inline namespace INGOT_ABI {

// The linker takes the one that the scene calls.
template void solve_sequentially<false>(PointView&, const ContactStep&, StepReport&);
template void solve_sequentially<true>(PointView&, const ContactStep&, StepReport&);

} }  // namespace ingot
