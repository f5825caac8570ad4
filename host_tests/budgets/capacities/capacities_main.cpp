// SPDX-License-Identifier: MIT
// Prints what worlds take of RAM as they grow: name, bytes a body, bytes a manifold or contact, of worlds that say no more than the name.
// It knows sizes alone, so it is compiled for any lane count without a kernel to link.
#include <ingot/ingot.h>

#include <cstdio>

namespace {

using namespace ingot;

template <int bodies>
struct Turning : Scene {
    static constexpr int max_bodies = bodies;
};
template <int bodies>
struct Flying : Turning<bodies> {
    static constexpr bool translates = true;
};
template <int bodies, int contacts>
struct Impacts : Flying<bodies> {
    static constexpr int max_contacts = contacts;
    using solver = FrictionlessImpacts;
    using shapes = Shapes<Sphere, Box, HalfSpace>;
};
template <int bodies, int manifolds>
struct Contacts : Flying<bodies> {
    static constexpr int max_manifolds = manifolds;
    using shapes = Shapes<Sphere, Box, HalfSpace>;
};
#define WITH(name, ...)                      \
    template <int bodies, int manifolds>     \
    struct name : Contacts<bodies, manifolds> { \
        __VA_ARGS__;                         \
    }
WITH(Tree, using broad_phase = SortedTree);
WITH(Sleeping, static constexpr bool sleeps = true);
WITH(Followed, static constexpr bool continuous = true);
WITH(TwoShapes, static constexpr int max_shapes_of_body = 2);
WITH(Kinematic, static constexpr bool kinematic_bodies = true);
WITH(Read, static constexpr bool reads_contacts = true);
WITH(Summed, static constexpr bool compensated_sums = true);
WITH(Searched, static constexpr bool recycles_manifolds = false);
WITH(PointByPoint, using solver = SequentialImpulses; static constexpr bool bounces = false);

// Powers of two: the tree of boxes has as many. Manifolds are several times the bodies, as in piles.
constexpr int some = 1024;

template <template <int> class S>
void print_bodies(const char* name) {
    std::printf("%s,%d,\n", name, static_cast<int>((sizeof(World<S<2 * some>>) - sizeof(World<S<some>>)) / some));
}
template <template <int, int> class S>
void print(const char* name) {
    const auto slope = [](std::size_t large, std::size_t small, unsigned more) { return static_cast<int>((large - small) / more); };
    const int body = slope(sizeof(World<S<2 * some, 8 * some>>), sizeof(World<S<some, 8 * some>>), some);
    const int manifold = slope(sizeof(World<S<some, 8 * some>>), sizeof(World<S<some, 4 * some>>), 4 * some);
    std::printf("%s,%d,%d\n", name, body, manifold);
}

}  // namespace

int main() {
    print_bodies<Turning>("a body that turns");
    print_bodies<Flying>("and `translates`");
    print<Impacts>("impacts without friction, `max_contacts`");
    print<Contacts>("contacts with friction, `max_manifolds`");
    print<PointByPoint>("and `solver = SequentialImpulses`, `bounces = false`");
    print<Searched>("and `recycles_manifolds = false`");
    print<Tree>("and `broad_phase = SortedTree` or `QueryTree`");
    print<Sleeping>("and `sleeps`");
    print<Followed>("and `continuous`");
    print<TwoShapes>("and `max_shapes_of_body = 2`");
    print<Kinematic>("and `kinematic_bodies`");
    print<Read>("and `reads_contacts`");
    print<Summed>("and `compensated_sums`");
}
