// SPDX-License-Identifier: MIT
// Free flight and impacts without friction: see machine.h. The first byte chooses the scene.
//
// Compiled once for each lane count. INGOT_FUZZ_RUN names the function.
#include "fuzz_world.h"
#include "machine.h"

namespace {

using fuzz::Bytes;
using fuzz::Machine;

/// Everything there is, with arrays so small that they fill, and a last tile that is not full.
struct Yard : ingot::Scene {
    static constexpr int max_bodies = 6;
    static constexpr bool translates = true;
    static constexpr int max_contacts = 10;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};
/// The same with another rotation method.
template <class Method>
struct YardWith : Yard {
    using rotation = Method;
};
struct Tops : ingot::Scene {
    static constexpr int max_bodies = 3;
};

}  // namespace

uint64_t INGOT_FUZZ_RUN(const uint8_t* data, size_t size) {
    Bytes in(data, size);
    switch (in.byte() % 13u) {
        case 0: case 1: case 2: case 3: return Machine<Yard>().run(in);
        case 4: case 5: return Machine<Tops>().run(in);
        case 6: return Machine<YardWith<ingot::Listing1Euler>>().run(in);
        case 7: return Machine<YardWith<ingot::LieMidpoint>>().run(in);
        case 8: return Machine<YardWith<ingot::Rk4Polar>>().run(in);
        case 9: return Machine<YardWith<ingot::SymmetricTop>>().run(in);
        case 10: return Machine<YardWith<ingot::SymmetricTopSplitting<6>>>().run(in);
        case 11: return Machine<YardWith<ingot::ExactElliptic>>().run(in);
        default: return Machine<YardWith<ingot::DiscreteMoserVeselov<4, false, false, 2>>>().run(in);
    }
}
