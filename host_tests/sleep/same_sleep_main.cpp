// SPDX-License-Identifier: MIT
// Prints hashes of worlds that sleep in part: the same for every lane count.
#include <ingot/ingot.h>

#include <cstdio>

#include "sleep/nursery.h"
#include "scenes/contact/piles.h"
#include "scenes/contact/stacks.h"

namespace {

using namespace scenes;

template <class Method>
struct Rows : ingot::Scene {
    static constexpr int max_bodies = 60, max_manifolds = 300;
    static constexpr bool translates = true, sleeps = true;
    static constexpr scalar sleep_time = scalar(0.2);
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using rotation = Method;
    using broad_phase = ingot::SortedTree;
};

/// Towers that sleep, a ball that bounces among them, and a tower that is hit and removed piece by piece: slots are dealt in turn, so that
/// every tile holds sleepers and others.
template <class Method>
bool play(const char* name) {
    static ingot::World<Rows<Method>> world;
    bool ok = world.set_gravity(OnEarth::gravity) == ingot::Status::ok;
    const auto add = [&](PlacedBody body) {
        body.def.friction = body.mu;
        const auto added = world.add(body.def);
        ok = ok && added.ok();
        return added.value;
    };
    add(flat_ground(scalar(0.6)));
    ingot::BodyId cube[5][5];
    for (int level = 0; level < 5; ++level)
        for (int tower = 0; tower < 5; ++tower)
            cube[tower][level] = add(solid_box(1, {scalar(0.4), scalar(0.5), scalar(0.3)},
                                               {scalar(2 * tower), 0, scalar(0.6) * static_cast<scalar>(level) + scalar(0.3)}, scalar(0.6)));
    const ingot::BodyId ball = add(solid_ball(2, scalar(0.4), {-8, scalar(0.1), scalar(1.5)}, scalar(0.4), scalar(0.6)));
    int most = 0;
    for (int step_i = 0; step_i < 600; ++step_i) {
        if (step_i == 60) ok = ok && world.apply_central_impulse(ball, {9, 0, 2}) == ingot::Status::ok;
        if (step_i == 200) ok = ok && world.remove(cube[4][0]) == ingot::Status::ok;
        if (step_i == 300) ok = ok && world.apply_impulse(cube[3][4], {1, 2, 0}, {6, 0, 3}) == ingot::Status::ok;
        ok = ingot::step(world, display_rate_h).status == ingot::Status::ok && ok;
        if (world.asleep_count() > most) most = world.asleep_count();
        if (step_i % 50 != 49) continue;
        static uint8_t bytes[ingot::snapshot_size<Rows<Method>>()];
        const auto size = ingot::save_snapshot(world, bytes, sizeof bytes);
        std::printf("%s %d %016llx snapshot %016llx asleep %d in %d\n", name, step_i + 1, static_cast<unsigned long long>(world.state_hash()),
                    static_cast<unsigned long long>(ingot::snapshot_checksum(bytes, size.value)), world.asleep_count(), world.asleep_island_count());
    }
    std::printf("%s most asleep %d\n", name, most);
    return ok && most > 20;
}

/// Random lives, of which every call and every step may tell lanes apart.
template <class S>
bool live_through(const char* name) {
    static ingot::World<S> world;
    int asleep = 0;
    for (uint64_t seed = 1; seed <= 8; ++seed) {
        ingot_sleep::begin(world);
        ingot_sleep::Dice dice(seed);
        for (int call_i = 0; call_i < 600; ++call_i) {
            ingot_sleep::live(world, dice);
            asleep += world.asleep_count();
        }
        static uint8_t bytes[ingot::snapshot_size<S>()];
        const auto size = ingot::save_snapshot(world, bytes, sizeof bytes);
        std::printf("%s seed %d snapshot %016llx asleep so far %d\n", name, static_cast<int>(seed),
                    static_cast<unsigned long long>(ingot::snapshot_checksum(bytes, size.value)), asleep);
    }
    return asleep > 1000;
}

}  // namespace

int main() {
    bool ok = play<ingot::MoserVeselov>("default");
    ok = play<ingot::Rk4Polar>("rk4_polar") && ok;
    ok = play<ingot::ExactElliptic>("exact_elliptic") && ok;
    ok = live_through<ingot_sleep::Nursery<ingot::MoserVeselov, ingot::SortedTree>>("nursery by tree") && ok;
    ok = live_through<ingot_sleep::Compounds<ingot::AllPairs>>("compounds") && ok;
    ok = live_through<ingot_sleep::Compounds<ingot::SortedTree>>("compounds by tree") && ok;
    ok = live_through<ingot_sleep::Crowd<ingot::SortedTree>>("crowd by tree") && ok;
    return ok ? 0 : 1;
}
