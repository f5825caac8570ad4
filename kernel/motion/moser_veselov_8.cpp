// SPDX-License-Identifier: MIT
#include "moser_veselov_stage.h"

namespace ingot { inline namespace INGOT_ABI {

INGOT_MOSER_VESELOV_STAGES(8, false);

} }  // namespace ingot
