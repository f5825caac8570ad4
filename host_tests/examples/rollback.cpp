// SPDX-License-Identifier: MIT
// Two players push a puck about. What the other presses arrives eight steps late, so each machine guesses that nothing was pressed; where it was, it
// goes back to the world as it was then, by memcpy, and steps anew. Both end in the same bits.
#include <ingot/ingot.h>

#include <cstdio>
#include <cstring>

struct Rink : ingot::Scene {
    static constexpr int max_bodies = 4, max_manifolds = 8;
    static constexpr bool translates = true;
    using shapes = ingot::Shapes<ingot::Cylinder, ingot::HalfSpace>;
};
using World = ingot::World<Rink>;
static constexpr int steps = 300, late = 8;

/// What a player presses in a step: a number that depends on both.
static unsigned pressed(int player, int step_i) { return (static_cast<unsigned>(step_i) * 2654435761u >> (20 + player)) % 5; }

/// A machine, of one of the players.
struct Machine {
    World world, kept[late + 1];  // kept: as they were before each of the last steps
    int rewinds;
    ingot::BodyId mallets[2];

    bool begin() {
        ingot::BodyDef ice;
        ice.immovable = true;
        ice.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        ingot::BodyDef disc;
        disc.mass = ingot::principal(ingot::solid_cylinder(1000, 0.3f, 0.05f)).value;
        disc.shape = ingot::Cylinder{0.3f, 0.05f};
        disc.friction = 0.1f;
        bool good = world.set_gravity({0, 0, -9.81f}) == ingot::Status::ok && world.add(ice).ok();
        for (int i = 0; i < 3; ++i) {
            disc.state.r_CM = {static_cast<ingot::scalar>(i - 1), 0, 0.05f};
            const ingot::Result<ingot::BodyId> id = world.add(disc);
            good = good && id.ok();
            if (i != 1) mallets[i / 2] = id.value;
        }
        return good;
    }
    void step_with(int step_i, const unsigned (&buttons)[2]) {
        std::memcpy(&kept[step_i % (late + 1)], &world, sizeof world);
        static constexpr ingot::Vector ways[5] = {{}, {8, 0, 0}, {-8, 0, 0}, {0, 8, 0}, {0, -8, 0}};
        for (int player = 0; player < 2; ++player) (void)world.apply_central_impulse(mallets[player], ways[buttons[player]]);
        (void)ingot::step(world, 1.0f / 60);
    }
    /// All up to now is known of me, of the other what is older than the line is long.
    void play(int me, int now) {
        const int known = now - late;
        if (known >= 0 && pressed(1 - me, known) != 0) {  // it was guessed wrongly: again from there
            ++rewinds;
            std::memcpy(&world, &kept[known % (late + 1)], sizeof world);
            for (int step_i = known; step_i < now; ++step_i) step_known(me, step_i, known);
        }
        step_known(me, now, known);
    }
    void step_known(int me, int step_i, int known) {
        unsigned buttons[2] = {step_i <= known ? pressed(0, step_i) : 0, step_i <= known ? pressed(1, step_i) : 0};
        buttons[me] = step_i < steps ? pressed(me, step_i) : 0;
        if (step_i >= steps) buttons[1 - me] = 0;
        step_with(step_i, buttons);
    }
};
static Machine machines[2];

int main() {
    bool good = machines[0].begin() && machines[1].begin();
    for (int me = 0; me < 2; ++me)
        for (int now = 0; good && now < steps + late; ++now) machines[me].play(me, now);  // in the end nobody presses, until all has arrived
    const unsigned long long a = machines[0].world.state_hash(), b = machines[1].world.state_hash();
    std::printf("rollback: %d and %d rewinds, hashes %016llx and %016llx\n", machines[0].rewinds, machines[1].rewinds, a, b);
    return good && machines[0].rewinds > 50 && a == b ? 0 : 1;
}
