// SPDX-License-Identifier: MIT
// The scenes of the page, as data: which bodies and joints, what people read of them, and where the camera stands.
#pragma once

#include "worlds.h"

namespace viewer {

/// Takes bodies and joints for a world whose type the scene does not know. A body's number is its slot.
class Builder {
public:
    using Add = bool (*)(void* world, const ingot::BodyDef& def);
    using Join = bool (*)(void* world, const ingot::JointDef& def, int A, int B);
    using Drive = bool (*)(void* world, int joint_i, const ingot::JointDrive& drive, int which);
    using Gear = bool (*)(void* world, int joint_A, int joint_B, scalar ratio);
    using Level = bool (*)(void* world, const ingot::LevelDef& def);

    /// Those that a scene has no use for are null.
    Builder(void* world, Add to_add, Join to_join, Drive to_drive, Gear to_gear = nullptr, Level to_level = nullptr)
        : world_(world), add_(to_add), join_(to_join), drive_(to_drive), gear_(to_gear), level_(to_level) {}

    int add(const ingot::BodyDef& def) {
        good_ = add_(world_, def) && good_;
        return bodies_++;
    }
    /// A, B: numbers of bodies; -1: the world.
    int join(int A, int B, const ingot::Joint& joint, const Vector& P, const Vector& axis = {0, 1, 0}, const Vector& other = {}) {
        ingot::JointDef def;
        def.joint = joint;
        def.P = P;
        def.axis = axis;
        if (ingot::has_length(joint.kind)) def.P_B = other;
        if (ingot::is_wheel(joint.kind)) def.axis_B = other;
        good_ = join_(world_, def, A, B) && good_;
        return joints_++;
    }
    void drive(int joint_i, const ingot::JointDrive& drive, int which) { good_ = drive_(world_, joint_i, drive, which) && good_; }
    void gear(int joint_A, int joint_B, scalar ratio) {
        good_ = gear_(world_, joint_A, joint_B, ratio) && good_;
        ++joints_;
    }
    /// number: of Machines::levels. It is the first that is added: it takes slots of several bodies.
    void level(int number, scalar friction) {
        ingot::LevelDef def;
        def.number = number;
        def.friction = friction;
        good_ = level_(world_, def) && good_;
    }

    bool good() const { return good_; }

private:
    void* world_;
    Add add_;
    Join join_;
    Drive drive_;
    Gear gear_;
    Level level_;
    int bodies_ = 0, joints_ = 0;
    bool good_ = true;
};

// Bodies.

inline ingot::BodyDef solid(const ingot::Shape& shape, scalar M, const Vector& r, scalar friction = scalar(0.6), scalar restitution = 0) {
    ingot::BodyDef def;
    def.mass = ingot::principal(ingot::with_mass(ingot::solid_of_shape(1000, shape), M)).value;
    def.shape = shape;
    def.state.r_CM = r;
    def.friction = friction;
    def.restitution = restitution;
    return def;
}
inline ingot::BodyDef fixed(const ingot::Shape& shape, const Vector& r = {}, scalar friction = scalar(0.6), scalar restitution = 0) {
    ingot::BodyDef def;
    def.shape = shape;
    def.immovable = true;
    def.state.r_CM = r;
    def.friction = friction;
    def.restitution = restitution;
    return def;
}
inline ingot::BodyDef& spin(ingot::BodyDef& def, const Vector& omega) {
    def.state.L = ingot::angular_momentum_of_spin(def.state.A, def.mass.I_body, omega);
    return def;
}
inline ingot::BodyDef turned(ingot::BodyDef def, const ingot::Matrix& A) {
    def.state.A = A;
    return def;
}
inline void ground(Builder& to, scalar friction = scalar(0.6), scalar restitution = 0) {
    to.add(fixed(ingot::HalfSpace{{0, 0, 1}, 0}, {}, friction, restitution));
}
/// Ground and four walls of a pit.
inline void pit(Builder& to, scalar side, scalar friction) {
    ground(to, friction);
    const Vector inwards[4] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    for (const Vector& n : inwards) to.add(fixed(ingot::HalfSpace{n, -side / 2}, {}, friction));
}

/// In [-1, 1), of index and channel alone.
/// Source: the mixing function of Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
inline scalar scattered(int index, int channel) {
    uint64_t bits = (static_cast<uint64_t>(index) * 64 + static_cast<uint64_t>(channel) + 1) * 0x9e3779b97f4a7c15u;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    bits ^= bits >> 31;
    return static_cast<scalar>(static_cast<int32_t>(bits >> 40) - (1 << 23)) * (scalar(1) / (1 << 23));
}
inline ingot::Matrix scattered_rotation(int index) {
    return ingot::axis_angle({0, 0, 1}, 3 * scattered(index, 32)) * ingot::axis_angle({1, 0, 0}, 3 * scattered(index, 33)) *
           ingot::axis_angle({0, 0, 1}, 3 * scattered(index, 34));
}

inline constexpr scalar half = scalar(0.5);
inline ingot::Shape cube() { return ingot::Box{{half, half, half}}; }

// The article.

inline void crate(Builder& to) {
    ground(to);
    ingot::BodyDef def = solid(cube(), 200, {0, 0, 3});
    def.state.A = ingot::axis_angle({1, 0, 0}, scalar(0.5)) * ingot::axis_angle({0, 1, 0}, scalar(0.3));
    to.add(spin(def, {1, scalar(0.5), 2}));
}
inline constexpr Vector brick = {half, scalar(0.3), scalar(0.1)};
/// The anchor of free rotation, 1.0 x 0.6 x 0.2 m, 1 kg, 10 rad/s about the middle axis; but half a rad/s beside it. With the hundredth of one that
/// the anchor has, an error of one rounding grows a million times from flip to flip, and floats have no more digits.
inline void flip(Builder& to) {
    ingot::BodyDef def = solid(ingot::Box{brick}, 1, {});
    def.shape = {};
    to.add(spin(def, {half, 10, 0}));
}
inline constexpr scalar bounce_e = scalar(0.8), bounce_height = 3, bounce_radius = half;
inline void bounce(Builder& to) {
    ground(to, scalar(0.6), bounce_e);
    to.add(solid(ingot::Sphere{bounce_radius}, 1, {0, 0, bounce_height + bounce_radius}, scalar(0.6), bounce_e));
}
/// Ten bodies, nothing that touches, no gravity.
inline void spinning(Builder& to) {
    const ingot::Shape shapes[5] = {ingot::Box{{scalar(0.6), scalar(0.36), scalar(0.12)}}, ingot::Cylinder{half, scalar(0.1)},
                                    ingot::Capsule{scalar(0.2), half}, ingot::Box{{scalar(0.7), scalar(0.1), scalar(0.1)}}, ingot::Sphere{half}};
    for (int i = 0; i < 10; ++i) {
        ingot::BodyDef def = solid(shapes[i % 5], 10, {static_cast<scalar>(2 * (i % 5) - 4), 0, static_cast<scalar>(2 * (i / 5)) + scalar(1.5)});
        def.state.A = i < 5 ? scattered_rotation(i) : ingot::axis_angle({1, 0, 0}, scalar(0.1));
        to.add(spin(def, i < 5 ? Vector{2 * scattered(i, 1), 4 * scattered(i, 2), 3} : Vector{scalar(0.05), 6, scalar(0.05)}));
    }
}

// Contact.

inline void pyramid(Builder& to) {
    ground(to);
    constexpr int base = 20;
    for (int row = 0; row < base; ++row)
        for (int i = 0; i < base - row; ++i)
            to.add(solid(cube(), 1,
                         {scalar(1.1) * (static_cast<scalar>(i) - static_cast<scalar>(base - row - 1) / 2), 0, static_cast<scalar>(row) + half}));
}
inline void balls(Builder& to) {
    constexpr int n = 8;
    constexpr scalar pitch = scalar(1.125), side = pitch * n;
    pit(to, side, half);
    for (int i = 0; i < n * n * n; ++i) {
        const auto place = [&](int cell, int channel) { return pitch * (static_cast<scalar>(cell) + half) + scalar(0.05) * scattered(i, channel); };
        to.add(solid(ingot::Sphere{half}, 1, {place(i % n, 0) - side / 2, place(i / n % n, 1) - side / 2, place(i / (n * n), 2) + 1}, half));
    }
}
inline void boxes(Builder& to) {
    pit(to, scalar(6.5), half);
    for (int i = 0; i < 125; ++i) {
        const auto of = [&](int channel) { return scalar(0.3) + scalar(0.13) * scattered(i, channel); };
        const auto place = [](int cell) { return scalar(1.25) * static_cast<scalar>(cell - 2); };
        const Vector size = {of(0), of(1), of(2)};
        to.add(turned(solid(ingot::Box{size}, 3200 * size.x * size.y * size.z, {place(i % 5), place(i / 5 % 5), place(i / 25) + 5}, half),
                      scattered_rotation(i)));
    }
}
inline void mixed(Builder& to) {
    pit(to, 6, half);
    for (int i = 0; i < 120; ++i) {
        const scalar r = scalar(0.3) + scalar(0.08) * scattered(i, 0), l = scalar(0.3) + scalar(0.1) * scattered(i, 1);
        ingot::Shape shape = ingot::Sphere{r};
        if (i % 4 == 1) shape = ingot::Box{{r, l, scalar(0.2)}};
        if (i % 4 == 2) shape = ingot::Capsule{r * scalar(0.7), l};
        if (i % 4 == 3) shape = ingot::Cylinder{r, l * scalar(0.8)};
        const auto place = [&](int cell, int channel) { return scalar(1.3) * static_cast<scalar>(cell) + scalar(0.1) * scattered(i, channel); };
        to.add(turned(solid(shape, 10, {place(i % 4, 2) - scalar(1.95), place(i / 4 % 4, 3) - scalar(1.95), place(i / 16, 4) + 1}, half),
                      scattered_rotation(i)));
    }
}
inline void tower(Builder& to) {
    ground(to);
    for (int i = 0; i < 20; ++i) to.add(solid(cube(), 1, {0, 0, static_cast<scalar>(i) + half}));
}
/// They stand on a spiral, an arm's length of each behind the next; the first is pushed.
inline void dominoes(Builder& to) {
    ground(to);
    constexpr int count = 90;
    const Vector size = {scalar(0.08), scalar(0.25), half};
    scalar angle = 0;
    for (int i = 0; i < count; ++i) {
        const scalar R = 1.6f + scalar(0.28) * angle;  // m; a turn of the spiral lies 1.76 m outside the last
        const ingot::SinCos a = ingot::sin_cos(angle);
        const scalar slope = scalar(0.28) / R, turn = 1 / ingot::sqrt(1 + slope * slope);
        const Vector ahead = {(slope * a.cos - a.sin) * turn, (slope * a.sin + a.cos) * turn, 0};
        ingot::BodyDef def = solid(ingot::Box{size}, 20, {R * a.cos, R * a.sin, half}, scalar(0.4));
        def.state.A = {ahead, {-ahead.y, ahead.x, 0}, {0, 0, 1}};
        if (i == 0) {
            spin(def, def.state.A.c1 * scalar(1.2));
            def.state.v_CM = ahead * scalar(0.6);
        }
        to.add(def);
        angle += scalar(0.5) / ingot::sqrt(R * R + scalar(0.0784));
    }
}
/// A slope of 20 degrees, tan = 0.364; six crates whose friction goes from 0.1 to 0.6.
inline void slope(Builder& to) {
    ground(to, 1);
    const ingot::Matrix A = ingot::axis_angle({0, 1, 0}, scalar(0.34906585));
    to.add(turned(fixed(ingot::Box{{5, 4, scalar(0.2)}}, {0, 0, scalar(1.9)}, 1), A));
    for (int i = 0; i < 6; ++i) {
        const scalar mu = scalar(0.1) * static_cast<scalar>(i + 1);  // of the pair: the geometric mean of mu^2 and 1
        const Vector at =
            Vector{0, 0, scalar(1.9)} + A.c0 * scalar(-4) + A.c1 * (scalar(1.25) * static_cast<scalar>(i) - scalar(3.125)) + A.c2 * scalar(0.601);
        to.add(turned(solid(ingot::Box{{scalar(0.4), scalar(0.4), scalar(0.4)}}, 10, at, mu * mu), A));
    }
}

// Hard cases.

inline void heavy(Builder& to) {
    ground(to);
    to.add(solid(cube(), 1, {-3, 0, half}));
    to.add(solid(cube(), 1000, {-3, 0, 3 * half}));
    for (int i = 0; i < 9; ++i) to.add(solid(cube(), 1, {0, 0, static_cast<scalar>(i) + half}));
    to.add(solid(cube(), 1000, {0, 0, scalar(9.5)}));
    const scalar masses[3] = {1, 100, 10000};
    for (int i = 0; i < 3; ++i) to.add(solid(cube(), masses[i], {3, 0, static_cast<scalar>(i) + half}));
}
/// Four plates of 2 cm, and one of 1 cm that nothing moves. Balls of 10 cm come at 100 to 400 m/s, which is 1.7 to 6.7 m in a step of 1/60 s.
inline void bullets(Builder& to) {
    ground(to, half, scalar(0.25));
    to.add(fixed(ingot::Box{{scalar(0.005), 3, scalar(1.5)}}, {5, 0, scalar(1.5)}, half, scalar(0.25)));
    for (int i = 0; i < 4; ++i) to.add(solid(ingot::Box{{scalar(0.01), half, half}}, 2, {static_cast<scalar>(i) + 1, 0, half}, half, scalar(0.25)));
    for (int i = 0; i < 4; ++i) {
        ingot::BodyDef def =
            solid(ingot::Sphere{scalar(0.05)}, 1, {-60 - 100 * static_cast<scalar>(i), scalar(0.1) * scattered(i, 0), 1}, half, scalar(0.25));
        def.state.v_CM = {100 * static_cast<scalar>(i + 1), 0, 1};
        to.add(def);
    }
}
/// A cube on a cube, its middle 1 mm on this side of the edge, and 1 mm beyond it.
inline void overhang(Builder& to) {
    ground(to);
    for (int side = -1; side <= 1; side += 2) {
        const scalar y = static_cast<scalar>(side) * scalar(1.2);
        to.add(fixed(cube(), {0, y, half}));
        to.add(solid(cube(), 1, {half + scalar(0.001) * static_cast<scalar>(side), y, 3 * half}));
    }
}

// Joints.

struct Part {
    int parent;
    scalar y, z, half_length, radius, M;
    bool is_hinge;
    scalar joint_y, joint_z;
};
inline constexpr int part_count = 11;
/// Pelvis, chest, head, two arms, two legs: 66 kg, as it stands with its feet at z = 0.
inline const Part* parts() {
    constexpr auto m = [](double x) { return static_cast<scalar>(x); };
    static constexpr Part of[part_count] = {{-1, 0, m(1.0), m(0.08), m(0.13), 12, false, 0, 0},
                                            {0, 0, m(1.35), m(0.16), m(0.14), 18, false, 0, m(1.15)},
                                            {1, 0, m(1.75), m(0.04), m(0.11), 5, false, 0, m(1.6)},
                                            {1, m(0.26), m(1.33), m(0.14), m(0.05), 2, false, m(0.22), m(1.5)},
                                            {3, m(0.26), m(1.02), m(0.13), m(0.045), m(1.3), true, m(0.26), m(1.18)},
                                            {1, m(-0.26), m(1.33), m(0.14), m(0.05), 2, false, m(-0.22), m(1.5)},
                                            {5, m(-0.26), m(1.02), m(0.13), m(0.045), m(1.3), true, m(-0.26), m(1.18)},
                                            {0, m(0.1), m(0.72), m(0.16), m(0.07), 7, false, m(0.1), m(0.93)},
                                            {7, m(0.1), m(0.3), m(0.17), m(0.06), 4, true, m(0.1), m(0.51)},
                                            {0, m(-0.1), m(0.72), m(0.16), m(0.07), 7, false, m(-0.1), m(0.93)},
                                            {9, m(-0.1), m(0.3), m(0.17), m(0.06), 4, true, m(-0.1), m(0.51)}};
    return of;
}
inline void ragdoll(Builder& to, const Vector& place, const ingot::Matrix& A) {
    int number[part_count];
    for (int i = 0; i < part_count; ++i) {
        const Part& part = parts()[i];
        number[i] = to.add(turned(solid(ingot::Capsule{part.radius, part.half_length}, part.M, place + A * Vector{0, part.y, part.z}), A));
        if (part.parent < 0) continue;
        // Knees bend backwards, elbows forwards: x is forwards.
        const bool is_knee = part.parent >= 7;
        ingot::Joint joint = ingot::BallJoint{scalar(part.parent == 1 && i != 2 ? 1.5 : 0.7), scalar(-0.6), scalar(0.6)};
        if (part.is_hinge) joint = is_knee ? ingot::HingeJoint{0, scalar(2.2)} : ingot::HingeJoint{scalar(-2.2), 0};
        to.join(number[part.parent], number[i], joint, place + A * Vector{0, part.joint_y, part.joint_z}, part.is_hinge ? A.c1 : A.c2);
    }
}
inline void ragdolls(Builder& to) {
    ground(to);
    for (int i = 0; i < 3; ++i)  // stairs
        to.add(fixed(ingot::Box{{half, 2, scalar(0.25) * static_cast<scalar>(i + 1)}},
                     {static_cast<scalar>(-i) - 1, 0, scalar(0.25) * static_cast<scalar>(i + 1)}));
    for (int i = 0; i < 8; ++i)
        ragdoll(to, {scattered(i, 0) - scalar(0.8), scattered(i, 1), scalar(2.4) + scalar(1.3) * static_cast<scalar>(i)},
                ingot::axis_angle({0, 0, 1}, 3 * scattered(i, 2)) * ingot::axis_angle({0, 1, 0}, scattered(i, 3)));
}

inline void bridge(Builder& to) {
    constexpr int planks = 16;
    ground(to);
    const auto height = [](scalar x) { return scalar(0.02) * x * x + scalar(1.2); };  // hangs through by 0.98 m over 14 m
    for (int side = -1; side <= 1; side += 2)
        to.add(fixed(ingot::Box{{scalar(1.5), scalar(1.2), scalar(1.09)}}, {scalar(8.55) * static_cast<scalar>(side), 0, scalar(1.09)}));
    int before = -1;
    for (int i = 0; i <= planks; ++i) {
        const scalar x_0 = 14 * static_cast<scalar>(i) / planks - 7, x_1 = x_0 + scalar(14) / planks, dx = x_1 - x_0, dz = height(x_1) - height(x_0);
        int plank = -1;
        if (i < planks) {
            const scalar length = ingot::sqrt(dx * dx + dz * dz);
            ingot::BodyDef def =
                solid(ingot::Box{{length / 2 - scalar(0.04), 1, scalar(0.05)}}, 30, {(x_0 + x_1) / 2, 0, (height(x_0) + height(x_1)) / 2});
            const Vector along = {dx / length, 0, dz / length};
            def.state.A = {along, {0, 1, 0}, {-along.z, 0, along.x}};
            plank = to.add(def);
        }
        to.join(before, plank, ingot::HingeJoint{}, {x_0, 0, height(x_0)}, {0, 1, 0});
        before = plank;
    }
    for (int i = 0; i < 3; ++i)
        to.add(solid(ingot::Sphere{scalar(0.45)}, scalar(i == 1 ? 1000 : 40), {scalar(-5.2) + scalar(1.6) * static_cast<scalar>(i), 0, scalar(2.8)}));
}

/// Chassis, four wheels, sprung and driven, over bumps; arrow keys drive it. Its chassis is body car_chassis, its joints 0 to 3.
inline constexpr int car_chassis = 1;
inline void car(Builder& to) {
    ground(to, 1);
    const scalar radius = scalar(0.35), base = scalar(2.6), track = scalar(1.6);
    const auto hub = [&](int i) { return Vector{i < 2 ? base / 2 : -base / 2, i % 2 == 0 ? track / 2 : -track / 2, radius}; };
    to.add(solid(ingot::Box{{scalar(1.9), scalar(0.65), scalar(0.25)}}, 900, {0, 0, scalar(0.7)}));
    for (int i = 0; i < 4; ++i) to.add(turned(solid(ingot::Cylinder{radius, scalar(0.1)}, 20, hub(i), 1), {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}));
    for (int i = 0; i < 4; ++i) {
        const int wheel = to.join(car_chassis, car_chassis + 1 + i, ingot::WheelJoint{scalar(-0.15), scalar(0.15)}, hub(i), {0, 0, 1}, {0, 1, 0});
        to.drive(wheel, ingot::SpringDrive{25000, 3000}, ingot::WheelJoint::travel);
        if (i >= 2) to.drive(wheel, ingot::MotorDrive{12, 300}, ingot::WheelJoint::spin);
    }
    for (int i = 0; i < 6; ++i)
        to.add(turned(fixed(ingot::Capsule{scalar(0.15), scalar(1.2)},
                            {5 + scalar(1.7) * static_cast<scalar>(i), scalar(i % 2 == 0 ? 0.9 : -0.9), scalar(-0.04)}, 1),
                      {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}));
    to.add(turned(fixed(ingot::Box{{3, scalar(1.6), scalar(0.1)}}, {scalar(20.5), 0, scalar(0.45)}, 1), ingot::axis_angle({0, 1, 0}, scalar(-0.2))));
    for (int row = 0; row < 4; ++row)
        for (int i = 0; i < 4; ++i)
            to.add(solid(ingot::Box{{scalar(0.3), scalar(0.3), scalar(0.3)}}, 8,
                         {scalar(30), scalar(0.65) * static_cast<scalar>(i) - 1, scalar(0.3) + scalar(0.6) * static_cast<scalar>(row)}));
}

/// A chain with a ball of 300 kg swings into a wall.
inline void chain(Builder& to) {
    ground(to);
    const Vector top = {0, 0, 8};
    const scalar pitch = scalar(0.5);
    const Vector down = {scalar(-0.8), 0, scalar(-0.6)};  // of the chain, as it is let go
    const ingot::Matrix A = {{scalar(0.6), 0, scalar(-0.8)}, {0, 1, 0}, {scalar(0.8), 0, scalar(0.6)}};
    int before = -1;
    for (int i = 0; i < 12; ++i) {
        const int link =
            to.add(turned(solid(ingot::Capsule{scalar(0.07), scalar(0.16)}, 3, top + down * (pitch * (static_cast<scalar>(i) + half))), A));
        to.join(before, link, ingot::BallJoint{}, top + down * (pitch * static_cast<scalar>(i)));
        before = link;
    }
    const Vector end = top + down * (12 * pitch);
    const int ball = to.add(solid(ingot::Sphere{scalar(0.6)}, 300, end + down * scalar(0.6)));
    to.join(before, ball, ingot::BallJoint{}, end);
    for (int row = 0; row < 6; ++row)
        for (int i = 0; i < 5 - row % 2; ++i)
            to.add(solid(
                ingot::Box{{scalar(0.25), scalar(0.4), scalar(0.25)}}, 6,
                {2, scalar(0.82) * (static_cast<scalar>(i) - static_cast<scalar>(4 - row % 2) / 2), scalar(0.25) + half * static_cast<scalar>(row)}));
}

/// Balls on rods whose lengths make 12, 13, 14 ... swings in 30 s: they drift apart and come together again.
inline void pendulums(Builder& to) {
    ground(to);
    for (int i = 0; i < 13; ++i) {
        // Swings of 0.3 rad take 0.565 % longer than small ones; a body that has a moment of its own, I, swings as a point at l + I / (M l).
        constexpr scalar M = 1, radius = scalar(0.16), I = scalar(0.04) * M * radius * radius;
        const scalar period = 30 / static_cast<scalar>(12 + i), root = period / scalar(2 * 3.14159265) / scalar(1.00565);
        const scalar of_point = scalar(9.81) * root * root, l = (of_point + ingot::sqrt(of_point * of_point - 4 * I / M)) / 2;
        const scalar x = scalar(0.45) * static_cast<scalar>(i - 6);
        const ingot::SinCos a = ingot::sin_cos(scalar(0.3));
        ingot::BodyDef def = solid(ingot::Sphere{radius}, M, {x, l * a.sin, scalar(2.4) - l * a.cos});
        def.mass.I_body = {I, I, I};
        const int ball = to.add(def);
        to.join(-1, ball, ingot::HingeJoint{}, {x, 0, scalar(2.4)}, {1, 0, 0});
    }
}

/// A pinion with a motor turns a wheel of three times its size, whose other half lifts a platform by its teeth. Joint 0 has the motor.
inline void gears(Builder& to) {
    ground(to);
    const scalar small = scalar(0.3), large = scalar(0.9), height = scalar(1.8);
    const ingot::Matrix lies = {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    const Vector places[2] = {{-small - large, 0, height}, {0, 0, height}};
    const int pinion = to.add(turned(solid(ingot::Cylinder{small, scalar(0.15)}, 20, places[0]), lies));
    const int wheel = to.add(turned(solid(ingot::Cylinder{large, scalar(0.15)}, 120, places[1]), lies));
    const int rack = to.add(solid(ingot::Box{{scalar(0.08), scalar(0.15), 2}}, 30, {large + scalar(0.09), 0, scalar(2.01)}));
    const int platform = to.add(solid(ingot::Box{{scalar(0.9), scalar(0.9), scalar(0.08)}}, 30, {large + scalar(1.1), 0, scalar(0.1)}));
    const int motor = to.join(-1, pinion, ingot::HingeJoint{}, places[0], {0, 1, 0});
    const int axle = to.join(-1, wheel, ingot::HingeJoint{}, places[1], {0, 1, 0});
    const int rail = to.join(-1, rack, ingot::SliderJoint{0, scalar(2.2)}, {large, 0, height}, {0, 0, 1});
    to.join(rack, platform, ingot::HingeJoint{0, 0}, {large + scalar(0.2), 0, scalar(0.1)}, {0, 1, 0});
    to.gear(motor, axle, -small / large);
    to.gear(axle, rail, -large);
    to.drive(motor, ingot::MotorDrive{2, 800}, 0);
    for (int i = 0; i < 4; ++i)
        to.add(solid(ingot::Box{{scalar(0.25), scalar(0.25), scalar(0.25)}}, 20,
                     {large + scalar(1.1), 0, scalar(0.44) + scalar(0.5) * static_cast<scalar>(i)}));
}

/// A walker of seven bodies, see ../scenes/walker.h, which is added to this. Bodies to trip over lie in its way.
inline void biped(Builder& to) { ground(to, scalar(0.8)); }

// Levels.

inline void tumble(Builder& to) {
    to.level(0, scalar(0.7));
    for (int i = 0; i < 48; ++i) {
        const scalar r = scalar(0.3) + scalar(0.06) * scattered(i, 0);
        ingot::Shape shape = ingot::Sphere{r};
        if (i % 4 == 1) shape = ingot::Box{{r, r * scalar(0.8), r * scalar(0.6)}};
        if (i % 4 == 2) shape = ingot::Capsule{r * scalar(0.7), r};
        if (i % 4 == 3) shape = ingot::Cylinder{r, r * scalar(0.5)};
        const ingot::SinCos a = ingot::sin_cos(scalar(6.2831853) * static_cast<scalar>(i) / 48);
        const scalar far = scalar(8.5) + scattered(i, 1);
        to.add(turned(solid(shape, 20, {far * a.cos, far * a.sin, scalar(6.5)}, scalar(0.7)), scattered_rotation(i)));
    }
}
/// A capsule that walks, see Stage::mover, goes round: up the stairs, down the ramp, through crates that it pushes.
inline void stroll(Builder& to) {
    to.level(1, scalar(0.6));
    ground(to);
    for (int row = 0; row < 2; ++row)
        for (int i = 0; i < 5 - row; ++i)
            to.add(solid(ingot::Box{{scalar(0.25), scalar(0.25), scalar(0.25)}}, 10,
                         {scalar(0.6) * (static_cast<scalar>(i) + scalar(0.5) * static_cast<scalar>(row)) - 1, scalar(-3.5),
                          scalar(0.25) + scalar(0.5) * static_cast<scalar>(row)}));
}

/// Where the camera looks, m, from how far, and from where, rad.
struct Camera {
    float x, y, z, distance, yaw, pitch;
};
struct SceneInfo {
    const char *id, *group, *title, *text;
    Kind kind;
    unsigned kinds;  ///< bits: those it can run in
    Camera camera;
    float wall;  ///< m, half of the side of a pit; else 0
    void (*set_up)(Builder&);
};

inline constexpr unsigned of(Kind kind) { return 1u << kind; }
inline constexpr unsigned loose = of(swept) | of(chosen) | of(coarse) | of(fine),
                          turns = of(turn_moser_veselov) | of(turn_order_4) | of(turn_runge_kutta) | of(turn_lie_midpoint) | of(turn_listing_1);

/// Those that run in Machines come last: without it they are left out.
inline constexpr SceneInfo scene_list[] = {
    {"crate",
     "The article",
     "A crate falls",
     "It tumbles, lands on an edge, comes to rest and falls asleep: from then on it costs nothing.",
     swept,
     loose,
     {0, 0, 1.2f, 9, 0.6f, 0.25f},
     0,
     crate},
    {"flip",
     "The article",
     "A body that flips over",
     "Spun about its middle axis, a free body turns over again and again. Beside it: the exact motion.",
     turn_moser_veselov,
     turns,
     {0, 0, 0, 3, 0.7f, 0.35f},
     0,
     flip},
    {"spin",
     "The article",
     "Ten that spin",
     "No gravity, nothing touches. Only a ball, or what turns about an axis of its own, turns evenly.",
     swept,
     loose,
     {0, 0, 2.5f, 13, 0.3f, 0.2f},
     0,
     spinning},
    {"bounce",
     "The article",
     "A ball that bounces",
     "Each bounce keeps eight tenths of the speed. Beside it: where an ideal ball would be.",
     swept,
     loose,
     {0, 0, 1.7f, 9, 0.5f, 0.15f},
     0,
     bounce},
    {"pyramid", "Contact", "Pyramid of 210", "Twenty cubes in the lowest row. Pull one out.", swept, loose, {0, 0, 9, 36, 0.5f, 0.1f}, 0, pyramid},
    {"balls", "Contact", "512 balls", "They fall into a pit and come to rest.", swept, loose, {0, 0, 3.5f, 24, 0.7f, 0.35f}, 4.5f, balls},
    {"boxes", "Contact", "125 boxes", "Mixed sizes, dropped into a pit.", swept, loose, {0, 0, 3, 19, 0.7f, 0.4f}, 3.25f, boxes},
    {"mixed", "Contact", "All shapes", "Balls, boxes, capsules and cylinders.", swept, loose, {0, 0, 3, 18, 0.7f, 0.4f}, 3, mixed},
    {"tower",
     "Contact",
     "Tower of twenty",
     "Twenty cubes in one column stand for as long as you like.",
     chosen,
     loose,
     {0, 0, 10.5f, 37, 0.6f, 0.08f},
     0,
     tower},
    {"dominoes", "Contact", "Dominoes", "Ninety in a spiral. The first is pushed.", swept, loose, {0, 0, 0.4f, 15, 0.8f, 0.6f}, 0, dominoes},
    {"slope",
     "Contact",
     "Slope",
     "Twenty degrees; friction from 0.1 to 0.6. Below 0.36 they slide.",
     swept,
     loose,
     {1, 0, 1, 17, 0.9f, 0.35f},
     0,
     slope},
    {"heavy",
     "Hard cases",
     "1000 to 1",
     "A ton on a kilogram, on nine, ten tons on a hundred kilograms. Solved directly nothing gives; by sweeps alone a millimetre does.",
     chosen,
     loose,
     {0, 0, 5.6f, 21, 0.5f, 0.12f},
     0,
     heavy},
    {"bullets",
     "Hard cases",
     "Bullets",
     "Up to 400 m/s, seven metres a frame, and plates of 2 cm: none goes through.",
     chosen,
     loose,
     {2.2f, 0, 0.8f, 9, -0.7f, 0.25f},
     0,
     bullets},
    {"overhang",
     "Hard cases",
     "Overhang of 1 mm",
     "One cube's middle is 1 mm on this side of the edge, the other's 1 mm beyond it.",
     swept,
     loose,
     {0.3f, 0, 1, 7, 0.9f, 0.2f},
     0,
     overhang},
#ifndef VIEWER_CONTACTS_ALONE
    {"ragdolls",
     "Joints",
     "Ragdolls",
     "Eight, of eleven parts, whose joints bend as far as ours.",
     machines,
     of(machines),
     {-0.6f, 0, 1.6f, 12, 0.7f, 0.3f},
     0,
     ragdolls},
    {"bridge",
     "Joints",
     "Bridge",
     "Sixteen planks on hinges, held at both ends; one of the balls weighs a ton.",
     machines,
     of(machines),
     {0, 0, 1.6f, 22, 0.6f, 0.25f},
     0,
     bridge},
    {"car",
     "Joints",
     "Car",
     "Suspension, motor and steering in each wheel. Arrow keys drive it.",
     machines,
     of(machines),
     {0, 0, 0.8f, 11, -1, 0.3f},
     0,
     car},
    {"chain", "Joints", "Wrecking ball", "A chain of 36 kg holds a ball of 300 kg.", machines, of(machines), {0, 0, 3.4f, 20, 0.8f, 0.15f}, 0, chain},
    {"pendulums",
     "Joints",
     "Pendulum wave",
     "In half a minute the first swings 12 times, the next 13, and so on: then they are together again.",
     machines,
     of(machines),
     {0, 0, 1.5f, 9, 0.7f, 0.25f},
     0,
     pendulums},
    {"gears",
     "Joints",
     "Gears",
     "A motor, two gears and a rack lift a platform up to its stop. Arrow keys: up and down.",
     machines,
     of(machines),
     {0.8f, 0, 1.8f, 12, 0.35f, 0.15f},
     0,
     gears},
    {"biped",
     "Joints",
     "It walks",
     "By motors in hips, knees and ankles; it falls where it is pushed too hard.",
     machines,
     of(machines),
     {0, 0, 1, 8, 0.5f, 0.12f},
     0,
     biped},
    {"tumble",
     "Levels",
     "Hills and ice",
     "A field of heights in steps of 1/64 m; what comes to the light quarter slides, for that is ice.",
     machines,
     of(machines),
     {0, 0, 3, 34, 0.5f, 0.5f},
     0,
     tumble},
    {"stroll",
     "Levels",
     "A character",
     "No body: a capsule that steps up stairs, keeps to the ramp, and pushes crates. Arrow keys take over.",
     machines,
     of(machines),
     {0, 0, 1, 17, 0.4f, 0.45f},
     0,
     stroll},
#endif
};
inline constexpr int scene_count = sizeof(scene_list) / sizeof(scene_list[0]);

}  // namespace viewer
