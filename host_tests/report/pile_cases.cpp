// SPDX-License-Identifier: MIT
// Piles beside peers in one build of the kernel. Compiled once for each of those that race with them.
#include <ingot/ingot.h>
#define scenes INGOT_JOIN(scenes_, INGOT_ABI, )

#include "kernel_run.h"
#include "random_piles.h"

namespace report {

std::vector<ContactCase> INGOT_JOIN(pile_cases_, INGOT_ABI, )();

std::vector<ContactCase> INGOT_JOIN(pile_cases_, INGOT_ABI, )() {
    using namespace scenes;
    using Boxes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
    using Mixed = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::HalfSpace>;
    return {
        contact_case<RandomPile<8, 8, false>, Boxes, 4000>("pile_boxes_512"),
        contact_case<RandomPile<16, 8, false>, Boxes, 16000>("pile_boxes_2048"),
        contact_case<RandomPile<8, 8, true>, Mixed, 4000>("pile_mixed_512"),
        contact_case<RandomPile<16, 8, true>, Mixed, 16000>("pile_mixed_2048"),
    };
}

}  // namespace report
