// SPDX-License-Identifier: MIT
// The default order once more, for steps with contacts: see DiscreteMoserVeselov::integrate_A_beside_contacts.
#include "moser_veselov_stage.h"

namespace ingot { inline namespace INGOT_ABI {

INGOT_MOSER_VESELOV_STAGES(INGOT_DOUBLE ? 10 : 6, true);

} }  // namespace ingot
