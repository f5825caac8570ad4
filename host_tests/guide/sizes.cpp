// SPDX-License-Identifier: MIT
// Figures of worlds that are known when they are compiled: what they take of RAM as they grow, beside those of budgets/capacities. See guide.py.
// It knows sizes alone, so it is compiled for any lane count without a kernel to link.
#include <ingot/ingot.h>

#include <cstdio>

namespace {

using namespace ingot;

// A world of all that is asked for; what it has beside comes by With.
template <int n_bodies, int n_manifolds, int n_pairs, int n_joints, int n_loops, class With>
struct Grown : With {
    static constexpr int max_bodies = n_bodies, max_manifolds = n_manifolds, max_pairs = n_pairs, max_joints = n_joints, max_loops = n_loops;
};
template <int bodies, int manifolds, int pairs, class With, int joints = 0, int loops = 0>
constexpr long size_of() {
    return static_cast<long>(sizeof(World<Grown<bodies, manifolds, pairs, joints, loops, With>>));
}

struct Flying : Scene {
    static constexpr bool translates = true;
};
struct Touching : Flying {
    using shapes = Shapes<Sphere, Box, HalfSpace>;
};
#define WITH(name, ...)      \
    struct name : Touching { \
        __VA_ARGS__;         \
    }
WITH(Tree, using broad_phase = SortedTree);
WITH(Filtered, static constexpr bool filters = true);
WITH(Forced, static constexpr bool body_forces = true);
WITH(Damped, static constexpr bool damping = true);
WITH(Shared, static constexpr bool gravity_shares = true);
WITH(Owned, static constexpr bool user_data = true);
WITH(Hybrid, using solver = HybridIslands<>);
WITH(SmallHybrid, using solver = HybridIslands<20, 10>);
WITH(Hinged, using joints = Joints<HingeJoint>);
WITH(Limited, using joints = Joints<HingeJoint, WithLimits>);
WITH(Driven, using joints = Joints<HingeJoint, WithDrives>);
WITH(LimitedAndDriven, using joints = Joints<HingeJoint, WithLimits, WithDrives>);
WITH(Balls, using joints = Joints<BallJoint, WithLimits, WithDrives>);
WITH(Reacting, using joints = Joints<HingeJoint, WithReactions>);
WITH(Breaking, using joints = Joints<HingeJoint, WithBreaking>);

// Powers of two: the tree of boxes has as many.
constexpr int some = 1024;

constexpr char build[] = {static_cast<char>('0' + lanes), INGOT_DOUBLE ? 'd' : '\0', '\0'};  // 1, 4, 8, 1d

void begin(const char* name, const char* head) { std::printf("%s.%s\t%s", name, build, head); }
void add(const char* name, long bytes) { std::printf("\\n| %s | %ld |", name, bytes); }
void end() { std::printf("\n"); }

template <class With>
void add_body(const char* name) {
    constexpr long more = size_of<some, 2 * some, 4 * some, With>() - size_of<some, 2 * some, 4 * some, Touching>();
    add(name, more / some);
}
template <class With, int loops = 0>
void add_joint(const char* name) {
    constexpr long many = size_of<some, 2 * some, 4 * some, With, 768, loops * 768>();
    constexpr long few = size_of<some, 2 * some, 4 * some, With, 512, loops * 512>();
    add(name, (many - few) / 256);
}
template <class With>
void print_pair(const char* name) {
    constexpr long bytes = (size_of<some, 2 * some, 8 * some, With>() - size_of<some, 2 * some, 4 * some, With>()) / (4 * some);
    std::printf("%s.%s\t%ld\n", name, build, bytes);
}
// What a solver has of its own, in a world of fifty bodies.
template <class With>
void print_solver(const char* name) {
    std::printf("%s.%s\t%ld\n", name, build, size_of<50, 150, 300, With>() - size_of<50, 150, 300, Touching>());
}

template <class With, int manifolds = 0>
void print_body(const char* name) {
    constexpr long bytes = (size_of<2 * some, manifolds, 2 * manifolds, With>() - size_of<some, manifolds, 2 * manifolds, With>()) / some;
    std::printf("%s.%s\t%ld\n", name, build, bytes);
}

}  // namespace

int main() {
    print_body<Scene>("sizes.turning");
    print_body<Flying>("sizes.flying");
    print_body<Touching, 8 * some>("sizes.touching");
    constexpr long manifolds = size_of<some, 4 * some, 8 * some, Touching>() - size_of<some, 2 * some, 4 * some, Touching>();
    std::printf("sizes.manifold.%s\t%ld\n", build, manifolds / (2 * some));
    if (lanes != 1 || INGOT_DOUBLE) return 0;

    print_pair<Touching>("sizes.pair");
    print_pair<Tree>("sizes.pair_of_tree");

    print_solver<Hybrid>("sizes.hybrid");
    print_solver<SmallHybrid>("sizes.small_hybrid");

    begin("sizes.body_traits", "| trait | more for a body |\\n| --- | ---: |");
    add_body<Filtered>("`filters`");
    add_body<Owned>("`user_data`");
    add_body<Shared>("`gravity_shares`");
    add_body<Damped>("`damping`");
    add_body<Forced>("`body_forces`");
    end();

    begin("sizes.joints", "| joints of a world | a joint |\\n| --- | ---: |");
    add_joint<Hinged>("`HingeJoint`, or another kind");
    add_joint<Limited>("and `WithLimits`");
    add_joint<Driven>("and `WithDrives`");
    add_joint<LimitedAndDriven>("and both");
    add_joint<Balls>("`BallJoint`, and both");
    add_joint<Reacting>("`HingeJoint` and `WithReactions`");
    add_joint<Breaking>("`HingeJoint` and `WithBreaking`");
    add_joint<Hinged, 1>("`HingeJoint`, and each of them may close a loop: `max_loops`");
    end();
}
