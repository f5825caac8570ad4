// SPDX-License-Identifier: MIT
// C10, the arch: hulls that hold each other up by thrust and friction. And C18, a tetrahedron of 1000 : 1.
#include <gtest/gtest.h>

#include "contact/play.h"
#include "scenes/hulls.h"

namespace {

using namespace ingot_contact;
using namespace scenes;

constexpr int blocks = 16;
constexpr double mid_radius = 2;  // m, of the middle of the ring
constexpr double pi = 3.14159265358979323846;

/// One of 16 blocks of a half ring of this thickness, m, and 1 m deep: its faces radial, its middle at the top of the ring, the centre at the origin.
template <int thickness_cm>
struct Voussoir {
    static constexpr Vector corner(int i) {
        const ingot::SinCos half = ingot::sin_cos(scalar(pi / blocks / 2));
        const scalar radius = scalar(mid_radius) + ((i & 4) != 0 ? scalar(thickness_cm) : -scalar(thickness_cm)) / 200;
        return {((i & 1) != 0 ? half.sin : -half.sin) * radius, (i & 2) != 0 ? scalar(0.5) : scalar(-0.5), half.cos * radius};
    }
    static constexpr Vector points[8] = {corner(0), corner(1), corner(2), corner(3), corner(4), corner(5), corner(6), corner(7)};
    static constexpr auto solid = solid_hull_of(points, 10);
    static_assert(solid.hull.ok());
};

template <int thickness_cm>
struct ArchRoom : Room<blocks + 1> {
    using shapes = ingot::Shapes<ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {Voussoir<thickness_cm>::solid.hull.value.view()};
};

template <int thickness_cm>
PlacedBody arch_body(int body_i, scalar mu) {
    if (body_i == 0) return flat_ground(mu);
    PlacedBody block;
    block.def.mass = Voussoir<thickness_cm>::solid.mass;
    block.def.shape = ingot::hull_of<ArchRoom<thickness_cm>>(0);
    const double from_top = pi * (body_i - 0.5) / blocks - pi / 2;
    block.def.state = ingot::body_state(block.def.mass, {{0, 0, 0}, ingot::axis_angle({0, 1, 0}, static_cast<scalar>(from_top))});
    block.mu = mu;
    return block;
}

/// The least friction with which some thrust holds the arch: over all forces between the two halves, which are horizontal by symmetry, and
/// all heights of them within the ring, so that at every joint the resultant passes through the ring; 1 and more where none does. If any
/// forces hold it, symmetric ones do: their mean with their mirror image. (Heyman, "The stone skeleton", 1966. The least thickness comes out
/// as Milankovitch's of 1907, 0.1075 R.)
double least_friction(double thickness) {
    const double b = pi / blocks, in = mid_radius - thickness / 2, out = mid_radius + thickness / 2;
    const double weight = std::sin(b) / 2 * (out * out - in * in);
    const double centre = 2.0 / 3 * std::cos(b / 2) * (out * out * out - in * in * in) / (out * out - in * in);
    double least = 1;
    for (int force_i = 1; force_i <= 2000; ++force_i) {
        for (int height_i = 0; height_i <= 200; ++height_i) {
            const double H = force_i * weight * blocks / 2000.0, height = in + (out - in) * height_i / 200;
            double W = 0, moment = height * H, worst = 0;
            for (int joint = 1; joint <= blocks / 2; ++joint) {
                W += weight;
                moment += weight * centre * std::sin(b * (joint - 0.5));
                const double s = std::sin(b * joint), c = std::cos(b * joint), N = H * c + W * s, T = H * s - W * c, at = moment / N;
                worst = at >= in && at <= out ? std::max(worst, std::abs(T / N)) : 1;
            }
            least = std::min(least, worst);
        }
    }
    return least;
}

template <int thickness_cm>
auto play_arch(double mu) {
    using S = ArchRoom<thickness_cm>;
    return Play<S>(bodies_from<blocks + 1>([&](int body_i) { return arch_body<thickness_cm>(body_i, static_cast<scalar>(mu)); }), OnEarth::gravity);
}

/// Stands for a minute: nothing moves by more than a millimetre, as C8 asks of a stack.
template <int thickness_cm>
void expect_arch_stands(double mu) {
    auto scene = play_arch<thickness_cm>(mu);
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 60);
    figure("friction", mu);
    figure("shift, mm", 1e3 * scene.shift());
    figure("sink, mm", 1e3 * scene.sink());
    figure("fastest, m/s", scene.fastest());
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(scene.shift(), 1e-3);
    EXPECT_LE(scene.sink(), 1e-3);
}
template <int thickness_cm>
void expect_arch_falls(double mu) {
    auto scene = play_arch<thickness_cm>(mu);
    ASSERT_TRUE(scene.sound());
    scene.run(OnEarth::h, 10);
    figure("friction", mu);
    figure("sink, m", scene.sink());
    EXPECT_GE(scene.sink(), 0.5);
    EXPECT_TRUE(scene.finite());
}

TEST(Arch, has_the_least_thickness_that_is_known) {
    EXPECT_LT(least_friction(0.1085 * mid_radius), 0.42);
    EXPECT_EQ(least_friction(0.1035 * mid_radius), 1);
}
TEST(Arch, stands_at_11_of_its_least_friction) { expect_arch_stands<40>(1.1 * least_friction(0.4)); }
TEST(Arch, stands_with_friction_to_spare) { expect_arch_stands<40>(0.8); }
TEST(Arch, falls_at_09_of_its_least_friction) { expect_arch_falls<40>(0.9 * least_friction(0.4)); }
TEST(Arch, stands_at_12_of_its_least_thickness) { expect_arch_stands<26>(0.8); }
TEST(Arch, falls_at_09_of_its_least_thickness) { expect_arch_falls<19>(0.8); }

/// C18: 1 m across and 1 mm high, its top over the middle of its base: four faces of which three all but lie in the fourth.
struct SliverRoom : Room<2> {
    static constexpr Vector points[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {scalar(0.3), scalar(0.3), scalar(0.001)}};
    static constexpr auto solid = solid_hull_of(points, 1);
    static_assert(solid.hull.ok());
    using shapes = ingot::Shapes<ingot::Hull, ingot::HalfSpace>;
    static constexpr ingot::ConvexHull hulls[] = {solid.hull.value.view()};
};
/// On its base, as the slivers of boxes: 60 s without jitter, and its base stays on the ground, of which its top is as near as what touches.
/// (Its mass properties: MassProperties, against inertia_polyhedra.)
TEST(SliverTetrahedron, rests) {
    PlacedBody tetrahedron;
    tetrahedron.def.mass = SliverRoom::solid.mass;
    tetrahedron.def.shape = ingot::hull_of<SliverRoom>(0);
    tetrahedron.def.state = ingot::body_state(tetrahedron.def.mass, {{0, 0, 0}});
    tetrahedron.mu = scalar(0.6);
    Play<SliverRoom> scene({flat_ground(scalar(0.6)), tetrahedron}, OnEarth::gravity);
    ASSERT_TRUE(scene.sound());
    double fastest = 0;
    scene.run(OnEarth::h, 60, [&](int step_i) {
        if (step_i > 60) fastest = std::max(fastest, scene.fastest());
    });
    figure("fastest after 1 s, m/s", fastest);
    figure("shift, mm", 1e3 * scene.shift());
    figure("sink, mm", 1e3 * scene.sink());
    EXPECT_TRUE(scene.reports().clean());
    EXPECT_LE(fastest, 1e-3);
    EXPECT_LE(scene.shift(), 1e-6);
    EXPECT_LE(scene.sink(), 1e-6) << "a thousandth of its height";
    EXPECT_LE((scene.A(1) - to_eigen(tetrahedron.def.state.A)).norm(), 1e-5);
}

}  // namespace
