// SPDX-License-Identifier: MIT
// Figures of accuracy.md: how far simple motions are off the exact ones. Its bits, and so its figures, are those of every target. See guide.py.
#include <ingot/ingot.h>

#include <cmath>
#include <cstdio>

namespace {

using namespace ingot;

constexpr int rates[] = {30, 60, 120, 240, 960};  // steps a second

void begin(const char* name, const char* head) {
    std::printf("accuracy.%s\t| %s |", name, head);
    for (const int rate : rates) std::printf(" %d |", rate);
    std::printf("\\n| --- |");
    for (unsigned i = 0; i < sizeof rates / sizeof *rates; ++i) std::printf(" ---: |");
}
void row(const char* name) { std::printf("\\n| %s |", name); }
void cell(double value) { std::printf(" %.2g |", value); }

scalar step_of(int rate) { return 1 / static_cast<scalar>(rate); }

// A box that tumbles about its middle axis, by a method.

template <class Method>
struct Tumbler : Scene {
    using rotation = Method;
};
constexpr Vector half_edges = {0.5f, 0.3f, 0.1f};

template <class Method>
Matrix attitude_after(int seconds, int rate) {
    static World<Tumbler<Method>> world;
    world = {};
    BodyDef def;
    def.mass = principal(solid_box(1000, half_edges)).value;
    def.state = body_state(def.mass, {}, {{}, {0.1f, 5, 0.1f}});
    const BodyId id = world.add(def).value;
    for (int step_i = 0; step_i < seconds * rate; ++step_i) (void)step(world, step_of(rate));
    return world.state(id).value.A;
}
// rad
double angle_between(const Matrix& A, const Matrix& B) {
    const double trace = static_cast<double>(dot(A.c0, B.c0)) + static_cast<double>(dot(A.c1, B.c1)) + static_cast<double>(dot(A.c2, B.c2));
    const Vector twice_sin = cross(A.c0, B.c0) + cross(A.c1, B.c1) + cross(A.c2, B.c2);
    return std::atan2(std::sqrt(static_cast<double>(length_sq(twice_sin))), trace - 1);
}
template <class Method>
void add_method(const char* name) {
    row(name);
    for (const int rate : rates) cell(angle_between(attitude_after<Method>(10, rate), attitude_after<ExactElliptic>(10, 10)));
}

// A ball that slides, and then rolls; one that bounces; a tower with a heavy top.

template <int substeps, int sweeps, int bodies>
struct Ground : Scene {
    static constexpr int max_bodies = bodies, max_manifolds = 4 * bodies;
    static constexpr bool translates = true;
    static constexpr Effort effort = {substeps, sweeps};
    using shapes = Shapes<Sphere, Box, HalfSpace>;
};
constexpr scalar radius = 0.5f;  // and half of the edge of a cube
constexpr double g = 9.81;

template <class S>
void begin_on_ground(World<S>& world) {
    world = {};
    BodyDef ground;
    ground.immovable = true;
    ground.friction = 0.4f;
    ground.shape = HalfSpace{{0, 0, 1}, 0};
    (void)world.set_gravity({0, 0, -9.81f});
    (void)world.add(ground);
}
template <class S>
Vector place_of_ball(const Vector& r, const Vector& v, scalar restitution, int seconds, int rate) {
    static World<S> world;
    begin_on_ground(world);
    BodyDef ball;
    ball.mass = principal(solid_sphere(1000, radius)).value;
    ball.shape = Sphere{radius};
    ball.friction = 0.4f;
    ball.restitution = restitution;
    ball.state.r_CM = r;
    ball.state.v_CM = v;
    const BodyId id = world.add(ball).value;
    for (int step_i = 0; step_i < seconds * rate; ++step_i) (void)step(world, step_of(rate));
    return world.state(id).value.r_CM;
}
// mm. It slides until it has lost two sevenths of its speed, and then rolls.
template <class S>
double rolling_error(int rate) {
    const double v = 5, a = 0.4 * g, t = 2 * v / (7 * a), exact = v * t - a * t * t / 2 + 5 * v / 7 * (2 - t);
    return std::fabs(static_cast<double>(place_of_ball<S>({0, 0, radius}, {5, 0, 0}, 0, 2, rate).x) - exact) * 1000;
}
// mm. From a metre above the ground, by e = 0.8.
template <class S>
double bouncing_error(int rate) {
    double t = std::sqrt(2 / g), v = std::sqrt(2 * g);
    while (t + 2 * 0.8 * v / g < 2) t += 2 * (v *= 0.8) / g;
    v *= 0.8;
    const double since = 2 - t, exact = v * since - g * since * since / 2 + static_cast<double>(radius);
    return std::fabs(static_cast<double>(place_of_ball<S>({0, 0, 1 + radius}, {}, 0.8f, 2, rate).z) - exact) * 1000;
}
// mm, after 10 s.
template <class S>
double sinking(int rate) {
    static World<S> world;
    begin_on_ground(world);
    BodyId top{};
    for (int cube_i = 0; cube_i < 10; ++cube_i) {
        BodyDef cube;
        cube.mass = principal(solid_box(cube_i < 9 ? scalar(100) : scalar(5000), {radius, radius, radius})).value;
        cube.shape = Box{{radius, radius, radius}};
        cube.state.r_CM = {0, 0, radius * static_cast<scalar>(1 + 2 * cube_i)};
        top = world.add(cube).value;
    }
    for (int step_i = 0; step_i < 10 * rate; ++step_i) (void)step(world, step_of(rate));
    return std::fabs(19 * static_cast<double>(radius) - static_cast<double>(world.state(top).value.r_CM.z)) * 1000;
}
template <int substeps, int sweeps>
void add_effort(const char* rolling, const char* bouncing, const char* standing) {
    row(rolling);
    for (const int rate : rates) cell(rolling_error<Ground<substeps, sweeps, 2>>(rate));
    row(bouncing);
    for (const int rate : rates) cell(bouncing_error<Ground<substeps, sweeps, 2>>(rate));
    row(standing);
    for (const int rate : rates) cell(sinking<Ground<substeps, sweeps, 11>>(rate));
}

// A rod that swings on a hinge at its end.

template <class Motion>
struct Pendulum : Scene {
    static constexpr int max_joints = 1;
    static constexpr bool translates = true;
    using joints = Joints<HingeJoint>;
    using figure_motion = Motion;
};
constexpr scalar half_length = 0.5f, thickness = 0.02f;

struct Swing {
    double angle, energy;  // rad from the horizontal; off by, of the energy that a fall to the lowest point gives
};
template <class Motion>
Swing swing_after(int seconds, int rate) {
    static World<Pendulum<Motion>> world;
    world = {};
    (void)world.set_gravity({0, 0, -9.81f});
    BodyDef rod;
    rod.mass = principal(with_mass(solid_box(1, {half_length, thickness, thickness}), 1)).value;
    rod.state.r_CM = {half_length, 0, 0};
    const BodyId id = world.add(rod).value;
    JointDef hinge;
    hinge.body_B = id;
    hinge.joint = HingeJoint{};
    hinge.axis = {0, 1, 0};
    (void)world.add_joint(hinge);
    for (int step_i = 0; step_i < seconds * rate; ++step_i) (void)step(world, step_of(rate));
    const BodyState now = world.state(id).value;
    const double height = static_cast<double>(now.r_CM.z), energy = static_cast<double>(world.kinetic_energy()) + 9.81 * height;
    return {std::atan2(-height, static_cast<double>(now.r_CM.x)), energy / (9.81 * static_cast<double>(half_length))};
}
// By Kutta's method with a hundred thousand steps a second.
double exact_angle_after(int seconds) {
    const double l = static_cast<double>(half_length), t = static_cast<double>(thickness);
    const double factor = 9.81 * l / ((4 * l * l + t * t) / 3);  // m l g / I about the end
    const auto rate = [factor](double angle) { return factor * std::cos(angle); };
    double angle = 0, omega = 0;
    const double h = 1e-5;
    for (int step_i = 0; step_i < seconds * 100000; ++step_i) {
        const double k1 = omega, l1 = rate(angle), k2 = omega + h / 2 * l1, l2 = rate(angle + h / 2 * k1);
        const double k3 = omega + h / 2 * l2, l3 = rate(angle + h / 2 * k2), k4 = omega + h * l3, l4 = rate(angle + h * k3);
        angle += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        omega += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    }
    return angle;
}
template <class Motion>
void add_motion(const char* angle, const char* energy) {
    const double exact = exact_angle_after(10);
    row(angle);
    for (const int rate : rates) cell(std::fabs(swing_after<Motion>(10, rate).angle - exact));
    row(energy);
    for (const int rate : rates) cell(std::fabs(swing_after<Motion>(10, rate).energy));
}

}  // namespace

int main() {
    begin("rotation", "method");
    add_method<MoserVeselov>("`MoserVeselov`, the default");
    add_method<SymmetricTopSplitting<2>>("`SymmetricTopSplitting<2>`");
    add_method<Rk4Polar>("`Rk4Polar`");
    add_method<LieMidpoint>("`LieMidpoint`");
    add_method<Listing1Euler>("`Listing1Euler`, the article's");
    std::printf("\n");

    begin("contact", "what, and `effort`");
    add_effort<2, 3>("ball that rolls, `low_effort`", "ball that bounces, `low_effort`", "tower, `low_effort`");
    add_effort<4, 3>("ball that rolls, the default", "ball that bounces, the default", "tower, the default");
    add_effort<8, 6>("ball that rolls, `high_effort`", "ball that bounces, `high_effort`", "tower, `high_effort`");
    std::printf("\n");

    begin("pendulum", "what, and `figure_motion`");
    add_motion<ArticulatedSubsteps>("angle, rad, the default", "energy, the default");
    add_motion<EnergyMomentum<>>("angle, rad, `EnergyMomentum<>`", "energy, `EnergyMomentum<>`");
    std::printf("\n");
}
