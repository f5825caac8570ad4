// SPDX-License-Identifier: MIT
// Two worlds of one crowd, one of them on several cores: the same bits.
#pragma once

#include <memory>

#include "crowded_scenes.h"

namespace cores_test {

template <class S, class Workers>
struct On : S {
    using workers = Workers;
};

inline bool same(const ingot::StepReport& a, const ingot::StepReport& b) {
    return a.status == b.status && a.direct == b.direct && a.figures == b.figures && a.bodies_frozen == b.bodies_frozen &&
           a.spins_clamped == b.spins_clamped && a.contacts == b.contacts && a.contacts_lost == b.contacts_lost && a.pairs_lost == b.pairs_lost &&
           a.pairs_untested == b.pairs_untested && a.impact_waves == b.impact_waves && a.impacts_deferred == b.impacts_deferred &&
           a.sweeps == b.sweeps && a.overlaps_lost == b.overlaps_lost && a.residual == b.residual && a.sweeps_unfinished == b.sweeps_unfinished &&
           a.events_lost == b.events_lost;
}
inline bool same(const ingot::Event& a, const ingot::Event& b) {
    return a.kind == b.kind && a.A == b.A && a.B == b.B && a.shape_A == b.shape_A && a.shape_B == b.shape_B && a.speed == b.speed && a.P.x == b.P.x &&
           a.n.x == b.n.x;
}

template <class S>
std::vector<uint8_t> saved(const ingot::World<S>& world) {
    std::vector<uint8_t> bytes(ingot::snapshot_size<S>());
    const auto size = ingot::save_snapshot(world, bytes.data(), bytes.size());
    EXPECT_TRUE(size.ok());
    bytes.resize(size.value);
    return bytes;
}

/// Steps both, until they differ; what one has saved the other goes on from.
template <class S, class Workers>
void expect_same_bits(uint64_t seed, int steps, scalar h, Lie lie = Lie::apart) {
    const auto one = std::make_unique<Crowd<S>>(seed, lie);
    const auto many = std::make_unique<Crowd<On<S, Workers>>>(seed, lie);
    for (int step_i = 0; step_i < steps; ++step_i) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", step " << step_i << ", " << Workers::workers << " workers");
        one->edit(step_i);
        many->edit(step_i);
        const ingot::StepReport a = step(one->world, h), b = step(many->world, h);
        ASSERT_EQ(one->world.state_hash(), many->world.state_hash());
        ASSERT_TRUE(same(a, b));
        if constexpr (S::max_events > 0) {
            const auto told = one->world.events(), told_too = many->world.events();
            ASSERT_EQ(told.end() - told.begin(), told_too.end() - told_too.begin());
            for (auto i = told.begin(), j = told_too.begin(); i != told.end(); ++i, ++j) ASSERT_TRUE(same(*i, *j));
        }
        if (step_i % 16 != 15) continue;
        const std::vector<uint8_t> bytes = saved(one->world);
        ASSERT_EQ(bytes, saved(many->world));
        if (step_i == 47) {
            ASSERT_EQ(ingot::load_snapshot(many->world, bytes.data(), bytes.size()), ingot::Status::ok);
        }
    }
}

}  // namespace cores_test
