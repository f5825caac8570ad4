// SPDX-License-Identifier: MIT
// The numbers of a gear in a snapshot: they stand with those of joints.
#pragma once

#include "../../joint/check_tie.h"

namespace ingot { inline namespace INGOT_ABI { namespace features {

struct GearNumbers {
    GearRecord record;
    uint32_t turns[2];

    template <class Each>
    constexpr void numbers(Each& each) {
        each("joint.ratio", record.ratio);
        for (int i = 0; i < 2; ++i) {
            each("joint.geared", record.joint[i]);
            each("joint.gear_begin", record.begin[i]);
            each("joint.gear_angle", record.value[i].angle);
            each("joint.gear_turns", turns[i]);
        }
    }
    void take(const GearRecord& gear) {
        record = gear;
        for (int i = 0; i < 2; ++i) turns[i] = static_cast<uint32_t>(gear.value[i].turns);
    }
    GearRecord read() const {
        GearRecord gear = record;
        for (int i = 0; i < 2; ++i) gear.value[i].turns = static_cast<int32_t>(turns[i]);
        return gear;
    }
};

} } }  // namespace ingot::features
