// SPDX-License-Identifier: MIT
// Runs scenes to their golden step and prints what they came to: the same source on the host and as firmware.
//
//     satellite float steps 1000 hash 0x0123456789abcdef
//     satellite world_bytes 144 stack_bytes 212 instructions_per_step 648 worst_step 807 last_step 655      (where the clock counts them)
//
// With INGOT_SCENE defined the program holds that scene and no other: its size is the scene's size. With INGOT_METHODS it holds the
// rotation methods and the flights, each on the same bodies.
#include "../scenes/all_scenes.h"
#include <ingot/platform/clock.h>
#include <ingot/platform/console.h>
#include <ingot/platform/stack_watermark.h>

namespace {

using namespace ingot::platform;

template <class S>
ingot::World<S> world;

void write_number(const char* label, uint64_t value) {
    console_write(label);
    console_write_u64(value);
}

/// A scene may say which reports are sound; else they are clean.
template <class S>
auto went_well(const ingot::StepReport& report, int) -> decltype(S::went_well(report)) {
    return S::went_well(report);
}
template <class S>
bool went_well(const ingot::StepReport& report, long) {
    return report.clean();
}

/// Returns: true when the scene could be set up and every step was clean.
template <class S>
bool run(const char* name) {
    if (set_up(world<S>) != ingot::Status::ok) return false;

    uint64_t ticks = 0, ticks_sum = 0, ticks_worst = 0;
    uint32_t stack_bytes = 0;
    bool clean = true;
    const uint32_t depth = stack_depth_bytes();
    stack_paint();
    for (int step_i = 0; step_i < S::golden_steps; ++step_i) {
        const uint64_t begin = clock_ticks();
        const ingot::StepReport report = ingot::step(world<S>, S::h);
        ticks = clock_ticks() - begin;
        ticks_sum += ticks;
        ticks_worst = ticks > ticks_worst ? ticks : ticks_worst;
        clean = clean && went_well<S>(report, 0);
    }
    if (stack_size_bytes() > 0) stack_bytes = stack_deepest_bytes() - depth;

    console_write(name);
    console_write(sizeof(ingot::scalar) == 4 ? " float" : " double");
    write_number(" steps ", S::golden_steps);
    console_write(" hash ");
    console_write_hex(world<S>.state_hash(), 16);
    console_write("\n");
    if (clock_counts_instructions()) {
        console_write(name);
        write_number(" world_bytes ", sizeof(ingot::World<S>));
        write_number(" stack_bytes ", stack_bytes);
        write_number(" instructions_per_step ", clock_ticks_to_instructions(ticks_sum) / S::golden_steps);
        write_number(" worst_step ", clock_ticks_to_instructions(ticks_worst));
        write_number(" last_step ", clock_ticks_to_instructions(ticks));
        console_write("\n");
    }
    if (!clean) console_write("    a step was not clean\n");
    return clean;
}

#ifndef INGOT_SCENE
/// Prints the checksum of the snapshot of a world that was run: the same bytes on every target. Loaded after one more step, it brings the
/// world back. Returns: true when it does.
template <class S>
bool keep(const char* name) {
    static uint8_t bytes[ingot::snapshot_size<S>()];
    const uint64_t hash = world<S>.state_hash();
    const ingot::Result<size_t> size = ingot::save_snapshot(world<S>, bytes, sizeof bytes);
    (void)ingot::step(world<S>, S::h);
    const bool left = world<S>.state_hash() != hash;
    const bool back = ingot::load_snapshot(world<S>, bytes, size.value) == ingot::Status::ok && world<S>.state_hash() == hash;
    console_write(name);
    console_write(sizeof(ingot::scalar) == 4 ? " float" : " double");
    write_number(" steps ", S::golden_steps);
    console_write(" hash ");
    console_write_hex(ingot::snapshot_checksum(bytes, size.value), 16);
    console_write("\n");
    return size.ok() && left && back;
}

/// Methods of a limited range clamp or lose the fast bodies among the nine, which is part of what is compared.
void run_methods() {
    using namespace ingot;
    using namespace scenes;
    (void)run<Spinning<Listing1Euler>>("method_listing1_euler");
    (void)run<Spinning<LieMidpoint>>("method_lie_midpoint");
    (void)run<Spinning<Rk4Polar>>("method_rk4_polar");
    (void)run<Spinning<DiscreteMoserVeselov<2, false, false>>>("method_moser_veselov_2");
    (void)run<Spinning<DiscreteMoserVeselov<4, true, false>>>("method_moser_veselov_4");
    (void)run<Spinning<DiscreteMoserVeselov<6, false, true>>>("method_moser_veselov_6");
    (void)run<Spinning<DiscreteMoserVeselov<8, true, true, 2>>>("method_moser_veselov_8");
    (void)run<Spinning<DiscreteMoserVeselov<10, true, true, 4>>>("method_moser_veselov_10");
    (void)run<Spinning<MoserVeselov>>("method_default");
    (void)run<Spinning<ExactElliptic>>("method_exact_elliptic");
    (void)run<Spinning<SymmetricTop>>("method_symmetric_top");
    (void)run<Spinning<SymmetricTopSplitting<2>>>("method_symmetric_top_splitting_2");
    (void)run<Spinning<SymmetricTopSplitting<6>>>("method_symmetric_top_splitting_6");
    (void)run<InTide<KickDriftKick, TideAndDrag>>("method_kick_drift_kick");
    (void)run<TideOfMethods>("method_blanes_moan_4");
    (void)run<InTide<CommutatorFree4, TideAndDrag>>("method_commutator_free_4");
}
#endif

}  // namespace

int main() {
    clock_start();
#if defined(INGOT_SCENE)
    return run<scenes::INGOT_SCENE>(scenes::INGOT_SCENE::name) ? 0 : 1;
#elif defined(INGOT_METHODS)
    run_methods();
    return 0;
#else
    run_methods();
    const bool results[] = {run<scenes::Satellite>("satellite"),
                            run<scenes::THandle>("t_handle"),
                            run<scenes::Tumblers>("tumblers"),
                            run<scenes::Drop>("drop"),
                            keep<scenes::Drop>("snapshot_drop"),
                            keep<scenes::TideOfMethods>("snapshot_tide"),
                            run<scenes::Tower10>("tower_10"),
                            run<scenes::TenBoxesRow>("ten_boxes_row"),
                            run<scenes::TenBoxesColumn>("ten_boxes_column"),
                            run<scenes::TenBoxesOnBudget>("ten_boxes_on_budget"),
                            run<scenes::LightPile>("light_pile"),
                            keep<scenes::LightPile>("snapshot_light_pile"),
                            run<scenes::Playground>("playground"),
                            run<scenes::Pyramid55>("pyramid_55"),
                            run<scenes::MixedPile>("mixed_pile"),
                            run<scenes::BulletRange>("bullet_walls"),
                            run<scenes::HullPile>("hull_pile"),
                            keep<scenes::HullPile>("snapshot_hull_pile"),
                            run<scenes::CompoundPile>("compound_pile"),
                            keep<scenes::CompoundPile>("snapshot_compound_pile"),
                            run<scenes::MassRatio1e6>("mass_ratio_1e6"),
                            run<scenes::Tower20>("tower_20"),
                            keep<scenes::Tower20>("snapshot_tower_20"),
                            run<scenes::ChosenBoxes>("uneven_boxes"),
                            keep<scenes::ChosenBoxes>("snapshot_uneven_boxes"),
                            run<scenes::SleepingTowers>("sleeping_towers"),
                            keep<scenes::SleepingTowers>("snapshot_sleeping_towers"),
                            run<scenes::Conveyors>("conveyors"),
                            keep<scenes::Conveyors>("snapshot_conveyors"),
                            run<scenes::DoublePendulum>("double_pendulum"),
                            run<scenes::ArmOfSix>("arm_6"),
                            run<scenes::Ragdolls>("ragdolls"),
                            keep<scenes::Ragdolls>("snapshot_ragdolls"),
                            run<scenes::Terrain>("terrain"),
                            keep<scenes::Terrain>("snapshot_terrain")};
    for (bool result : results)
        if (!result) return 1;
    return 0;
#endif
}
