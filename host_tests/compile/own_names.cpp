// SPDX-License-Identifier: MIT
// A user who says `using namespace ingot;` has names of his own: those of all features, whose list OWN_NAMES is, and a few that lie near. With
// OWN_WORLD he has one too many, and is told.
#include <ingot/ingot.h>

using namespace ingot;

#define OWN(name)     \
    struct name {     \
        int own;      \
    };                \
    static_assert(sizeof(name) == sizeof(int), "");

OWN_NAMES
OWN(Feature)
OWN(Features)
OWN(FeatureList)
OWN(Materials)
OWN(NoNumbers)
#ifdef OWN_WORLD
OWN(World)
#endif

struct Crates : Scene {
    static constexpr int max_bodies = 10, max_manifolds = 40, max_events = 10;
    static constexpr bool translates = true, sleeps = true, filters = true;
    using shapes = Shapes<Box, HalfSpace>;
};

StepReport step_of_crates(World<Crates>& world, const Sleep& sleep, const Events& events);
StepReport step_of_crates(World<Crates>& world, const Sleep& sleep, const Events& events) {
    const Filters filters{sleep.own + events.own};
    return step(world, scalar(filters.own));
}
