// SPDX-License-Identifier: MIT
// The satellite turned by Listing 1 as printed. It is linked to see what is not in it: the default method.
#include <ingot/ingot.h>

namespace {

struct Listing1Satellite : ingot::Scene {
    using rotation = ingot::Listing1Euler;
};

ingot::World<Listing1Satellite> world;

}  // namespace

int main() {
    ingot::BodyDef def;
    def.mass = {4, {ingot::scalar(0.04), ingot::scalar(0.04), ingot::scalar(0.007)}, {}, ingot::identity_matrix<ingot::scalar>()};
    def.state.L = {ingot::scalar(0.04), ingot::scalar(0.02), 0};
    if (world.add(def).status != ingot::Status::ok) return 1;
    for (int step_i = 0; step_i < 10; ++step_i)
        if (!ingot::step(world, ingot::scalar(1) / 60).clean()) return 1;
    return 0;
}
