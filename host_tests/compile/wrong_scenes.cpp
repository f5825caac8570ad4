// SPDX-License-Identifier: MIT
// Compiles as it is, and with none of the macros that CMakeLists.txt defines one by one.
#ifdef LANES_OF_LIBRARY
#undef INGOT_LANES
#define INGOT_LANES 3
#endif
#ifdef FAST_MATH
#define __FAST_MATH__ 1
#endif
#ifdef FLUSHING_MVE
#define __ARM_FEATURE_MVE 3
#endif
#ifdef FLUSHING_ALTIVEC
#define __ALTIVEC__ 1
#endif
#ifdef FLUSHING_NEON
#define __clang__ 1
#define __ARM_NEON 1
#endif
#ifdef DOUBLE_OF_LIBGCC
#define __arm__ 1
#undef INGOT_DOUBLE
#define INGOT_DOUBLE 1
#endif
#ifdef WIDE_REGISTERS
#include <float.h>
#undef FLT_EVAL_METHOD
#define FLT_EVAL_METHOD 2
#endif
#include <ingot/ingot.h>

#ifdef STATUS_IGNORED
#pragma GCC diagnostic error "-Wunused-result"
#endif

struct Wrong : ingot::Scene {
#ifdef NO_BODIES
    static constexpr int max_bodies = 0;
#endif
#ifdef TOO_MANY_BODIES
    static constexpr int max_bodies = 65537;
#endif
#ifdef TOO_MANY_CONTACTS
    static constexpr bool translates = true;
    static constexpr int max_contacts = 65536;
#endif
#ifdef COLLIDES_BUT_DOES_NOT_TRANSLATE
    static constexpr int max_contacts = 4;
#endif
#ifdef SUBSTEPS_OF_METHOD
    using rotation = ingot::DiscreteMoserVeselov<6, true, true, 3>;
#endif
#ifdef ORDER_OF_SPLITTING
    using rotation = ingot::SymmetricTopSplitting<4>;
#endif
#ifdef FLIGHT_WITHOUT_FIELD
    using flight = ingot::CommutatorFree4;
#endif
#ifdef FLIGHT_AGAINST_VELOCITY
    using force_field = ingot::LinearDrag;
    using flight = ingot::BlanesMoan4;
#endif
#ifdef FIELD_OF_MORE_THAN_NUMBERS
    struct Owner : ingot::MagneticDipole {
        Owner() = default;
        Owner(const Owner&) {}
    };
    using force_field = Owner;
#endif
#ifdef ISLAND_WITHOUT_ROOM
    static constexpr bool translates = true;
    static constexpr int max_manifolds = 4;
    using solver = ingot::DirectIslands<0>;
#endif
#ifdef ORDER_OF_METHOD
    using rotation = ingot::DiscreteMoserVeselov<5>;
#endif
};

static ingot::World<Wrong> world;

int main() {
    const ingot::BodyId id = world.add({}).value;
#ifdef FORCE_WITHOUT_TRANSLATION
    (void)world.add_force(id, {}, {});
#endif
#ifdef GRAVITY_WITHOUT_TRANSLATION
    (void)world.set_gravity({});
#endif
#ifdef CONTACTS_WITHOUT_CONTACTS
    (void)world.contact_count();
#endif
#ifdef FIELD_WITHOUT_FIELD
    (void)world.force_field();
#endif
#ifdef STATUS_IGNORED
    world.remove(id);
#endif
    (void)id;
    return ingot::step(world, 1).clean() ? 0 : 1;
}
