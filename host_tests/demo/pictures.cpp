// SPDX-License-Identifier: MIT
// The scenes that are for looking at: things that fly, fall, collide, walk and roll.
#include "pictures.h"

#include <cmath>
#include <vector>

#include "../draw/picture.h"
#include "../scenes/contact/piles.h"
#include "../scenes/contact/stacks.h"
#include "../scenes/terrain.h"
#include "../scenes/walker_in_space.h"
#include "../viewer/scenes.h"

namespace {

using draw::Paint;
using draw::Picture;
using draw::operator+;
using ingot::scalar;
using ingot::Status;
using ingot::Vector;

constexpr scalar h = scalar(1) / 60;  // s
constexpr scalar half = scalar(0.5);

/// Balls, boxes and walls that touch.
struct Yard : ingot::Scene {
    static constexpr int max_bodies = 520, max_manifolds = 2500, max_pairs = 10000;
    static constexpr bool translates = true, sleeps = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
    using broad_phase = ingot::SortedTree;
};
/// Joints that end where those of people do.
struct Stairs : ingot::Scene {
    static constexpr int max_bodies = 64, max_manifolds = 300, max_pairs = 1200, max_joints = 48;
    static constexpr bool translates = true, sleeps = true;
    using shapes = ingot::Shapes<ingot::Capsule, ingot::Box, ingot::HalfSpace>;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint, ingot::WithLimits>;
};

template <class S>
ingot::World<S> world;

/// Goes on by seconds. False where a body was lost on the way.
template <class S>
bool go_on(double seconds) {
    bool good = true;
    for (int step_i = 0; step_i < static_cast<int>(seconds * 60 + 0.5); ++step_i) {
        const ingot::StepReport report = ingot::step(world<S>, h);
        good = good && report.contacts_lost == 0 && report.bodies_frozen == 0;
    }
    return good;
}
template <class S>
bool add(const ingot::BodyDef& def) {
    return world<S>.add(def).ok();
}
template <class S>
bool add(const scenes::PlacedBody& body) {
    ingot::BodyDef def = body.def;
    def.friction = body.mu;
    return add<S>(def);
}

/// All that moves, in the colour of its number.
template <class S, class PaintOf>
void add_bodies(Picture& picture, PaintOf paint_of, bool cast_shadows = true) {
    for (int slot = 0; slot < S::max_bodies; ++slot) {
        const ingot::BodyId id = world<S>.body_at(slot);
        if (!world<S>.is_movable(id)) continue;
        picture.add(world<S>.placed_shape(id).value, paint_of(slot), cast_shadows);
    }
}

bool say(bool good, const std::string& path, const char* words) {
    if (good)
        std::printf("picture file://%s\n        %s\n", path.c_str(), words);
    else
        std::printf("%s could not be made\n", path.c_str());
    std::fflush(stdout);  // pictures are there as soon as they are drawn
    return good;
}

/// A ball of iron is thrown into a wall of bricks.
bool wall(const std::string& path) {
    world<Yard> = {};
    bool good = world<Yard>.set_gravity({0, 0, scalar(-9.81)}) == Status::ok && add<Yard>(scenes::flat_ground(scalar(0.6)));
    for (int row = 0; row < 8; ++row)
        for (int brick = 0; brick < 7 - row % 2; ++brick) {
            const scalar y = scalar(1.02) * (static_cast<scalar>(brick) - 3) + static_cast<scalar>(row % 2) * scalar(0.51);
            good = good && add<Yard>(scenes::solid_box(40, {scalar(0.25), half, scalar(0.25)}, {0, y, scalar(0.25) + half * static_cast<scalar>(row)},
                                                       scalar(0.6)));
        }
    const int ball_slot = world<Yard>.body_count();
    scenes::PlacedBody ball = scenes::solid_ball(700, scalar(0.6), {-6, scalar(-0.2), scalar(2.2)}, scalar(0.4));
    ball.move({25, 0, scalar(0.5)}, {0, 6, 0});
    good = good && add<Yard>(ball);
    const auto paint = [&](int slot) { return slot == ball_slot ? draw::blue : slot % 2 == 0 ? draw::red : draw::ochre; };

    Picture picture("A ball of 700 kg is thrown into a wall of bricks, of which no two are joined", 3, 440, 400);
    const double times[] = {0.1, 0.3, 2.1};  // s, each after the one before
    const char* const notes[] = {"after 0.1 s", "0.4 s", "2.5 s"};
    for (int field = 0; good && field < 3; ++field) {
        good = go_on<Yard>(times[field]);
        picture.begin_field(field, {11, {0.6, 0, 1.5}, 40, 20}, notes[field]);
        picture.add_floor({1, 0, 0}, 16, 9);
        add_bodies<Yard>(picture, paint);
    }
    return say(good && picture.write(path.c_str()), path, "a ball is thrown into a wall of bricks");
}

/// 512 balls fall into a pit.
bool pile(const std::string& path) {
    using Balls = scenes::SpherePile<8>;
    world<Yard> = {};
    bool good = world<Yard>.set_gravity(Balls::gravity) == Status::ok;
    for (int body_i = 0; good && body_i < Balls::body_count; ++body_i) good = add<Yard>(Balls::body(body_i));
    const Paint paints[] = {draw::blue, draw::red, draw::ochre, draw::green, draw::violet};
    const auto paint = [&](int slot) { return paints[slot % 5]; };
    Picture picture("512 balls fall into a pit whose walls of glass are not drawn, and come to rest", 3, 440, 470);
    const double times[] = {0.5, 1, 6.5};
    const char* const notes[] = {"after half a second", "1.5 s", "8 s"};
    for (int field = 0; good && field < 3; ++field) {
        good = go_on<Yard>(times[field]);
        picture.begin_field(field, {15.5, {0, 0, 4.4}, 32, 20}, notes[field]);
        picture.add_floor({0, 0, 0}, 4.5, 4.5);
        add_bodies<Yard>(picture, paint, false);
    }
    return say(good && picture.write(path.c_str()), path, "512 balls fall into a pit");
}

/// Two people of eleven capsules fall down a flight of stairs.
bool stairs(const std::string& path) {
    constexpr int steps = 6;
    using World = ingot::World<Stairs>;
    World& w = world<Stairs>;
    bool good = w.set_gravity({0, 0, scalar(-9.81)}) == Status::ok;
    viewer::Builder to(
        &w, [](void*, const ingot::BodyDef& def) { return add<Stairs>(def); },
        [](void*, const ingot::JointDef& joint, int A, int B) {
            ingot::JointDef def = joint;
            def.body_A = world<Stairs>.body_at(A);
            def.body_B = world<Stairs>.body_at(B);
            return world<Stairs>.add_joint(def).ok();
        },
        nullptr);
    viewer::ground(to);
    for (int step = 0; step < steps; ++step) {
        const scalar height = scalar(0.11) * static_cast<scalar>(step + 1);
        to.add(viewer::fixed(ingot::Box{{scalar(0.2), 2, height}}, {scalar(-0.4) * static_cast<scalar>(step), 0, height}));
    }
    to.add(viewer::fixed(ingot::Box{{1, 2, scalar(0.11) * steps}}, {scalar(-0.4) * steps - scalar(0.8), 0, scalar(0.11) * steps}));  // the landing
    const int first = w.body_count();
    const ingot::Matrix leaning = ingot::axis_angle({0, 1, 0}, scalar(0.45));
    viewer::ragdoll(to, {scalar(-2.75), scalar(-0.7), scalar(0.22) * steps + scalar(0.12)}, leaning);
    viewer::ragdoll(to, {scalar(-2.9), scalar(0.8), scalar(0.22) * steps + scalar(0.12)}, ingot::axis_angle({0, 0, 1}, scalar(0.5)) * leaning);
    for (int slot = first; slot < w.body_count(); ++slot) {
        ingot::BodyState state = w.state(w.body_at(slot)).value;
        state.v_CM = {scalar(2.2), 0, 0};
        good = good && w.set_state(w.body_at(slot), state) == Status::ok;
    }
    good = good && to.good();
    const auto paint = [&](int slot) { return slot - first < viewer::part_count ? draw::blue : draw::red; };

    Picture picture("Two people of rag stumble on a landing and fall down the stairs; their joints end where ours do", 3, 440, 370);
    const double times[] = {0.1, 0.6, 4.3};
    const char* const notes[] = {"after 0.1 s", "0.7 s", "5 s, at rest"};
    for (int field = 0; good && field < 3; ++field) {
        good = go_on<Stairs>(times[field]);
        picture.begin_field(field, {6, {-1.1, 0, 1.1}, 18, 20}, notes[field]);
        picture.add_floor({0, 0, 0}, 9, 4);
        for (int slot = 1; slot < first; ++slot) {
            const ingot::PlacedShape block = w.placed_shape(w.body_at(slot)).value;
            picture.add_block(draw::point_of(block.r), draw::point_of(block.shape.size));
        }
        add_bodies<Stairs>(picture, paint);
    }
    return say(good && picture.write(path.c_str()), path, "two people of rag fall down the stairs");
}

/// Bones of the figure, of which the feet alone touch anything.
struct Bone {
    ingot::BodyId id;
    Vector half_extents;
    Paint paint;
};
std::vector<Bone> bones_of(const scenes::SpatialWalker& of) {
    namespace parts = scenes::spatial_parts;
    namespace legs = scenes::walker_parts;
    std::vector<Bone> bones = {{of.pelvis, parts::pelvis.half_extents, draw::ochre},
                               {of.chest, parts::chest.half_extents, draw::ochre},
                               {of.head, parts::head.half_extents, draw::ochre}};
    for (int side_i = 0; side_i < 2; ++side_i) {
        const Paint paint = side_i == 0 ? draw::red : draw::blue;
        const ingot::BodyId ids[] = {of.arm[side_i], of.forearm[side_i], of.thigh[side_i], of.shank[side_i], of.foot[side_i]};
        const scenes::WalkerPart of_side[] = {parts::arm, parts::forearm, legs::thigh, legs::shank, legs::foot};
        for (int i = 0; i < 5; ++i) bones.push_back({ids[i], of_side[i].half_extents, paint});
    }
    return bones;
}

/// A figure of thirteen bodies walks, by motors in its joints.
bool walker(const std::string& path) {
    using S = scenes::WalkingInSpace;
    ingot::World<S>& w = world<S>;
    scenes::SpatialWalker figure;
    const scenes::SpatialGait gait;
    scenes::WalkState state;
    bool good = scenes::add_ground(w) == Status::ok && scenes::add_walker(w, scalar(0.6), figure) == Status::ok;
    constexpr int figures = 6;
    constexpr double apart = 1.5;  // s
    Picture picture("It walks by motors in its joints, and nothing else holds it up: every one and a half seconds", 1, 1320, 440);
    picture.begin_field(0, {6.2, {2.5, 0, 0.85}, -9, 9});
    picture.add_floor({2, 0, 0}, 6, 0.9);
    for (int step_i = 0; good && step_i <= 60 * (1 + apart * (figures - 1)); ++step_i) {
        const double since = step_i / 60.0 - 1;  // it begins to walk before the picture begins
        const auto figure_i = static_cast<int>(std::floor(since / apart + 1e-6));
        if (since >= 0 && std::fabs(since - figure_i * apart) < 1e-6) {
            for (const Bone& bone : bones_of(figure)) {
                const ingot::BodyState now = w.state(bone.id).value;
                picture.add({ingot::Box{bone.half_extents}, now.r_CM, now.A, nullptr}, bone.paint);
            }
        }
        good = scenes::walk(w, figure, gait, state, h) == Status::ok && ingot::step(w, h).bodies_frozen == 0;
    }
    good = good && w.state(figure.pelvis).value.r_CM.z > scalar(0.7);
    return say(good && picture.write(path.c_str()), path, "a figure walks");
}

/// With room for what lies on several ridges at once.
struct Hills : scenes::Terrain {
    static constexpr int max_manifolds = 2 * scenes::Terrain::max_manifolds;
};

/// Hills that stand as a table in flash, and what rolls and slides down on them.
bool terrain(const std::string& path) {
    using S = Hills;
    constexpr int things = 10;
    ingot::World<S>& w = world<S>;
    ingot::LevelDef level;
    level.friction = half;
    bool good = w.set_gravity({0, 0, scalar(-9.81)}) == Status::ok && w.add_level(level).ok();
    for (int i = 0; good && i < things; ++i) {  // around the rim
        const Vector on_rim = ingot::axis_angle({0, 0, 1}, scalar(0.628) * static_cast<scalar>(i)) * Vector{scalar(3.3), 0, 0};
        const Vector at = on_rim + Vector{4, 4, scalar(2.2)};
        scenes::PlacedBody body =
            i % 2 == 0 ? scenes::solid_ball(1, scalar(0.3), at, half) : scenes::solid_box(2, {scalar(0.3), scalar(0.3), scalar(0.2)}, at, half);
        if (i % 4 == 2) body.def.shape = ingot::Capsule{scalar(0.2), scalar(0.3)};
        if (i % 4 == 3) body.def.shape = ingot::Cylinder{scalar(0.3), scalar(0.2)};
        body.turn(scenes::scattered_rotation(i));
        good = add<S>(body);
    }
    const Paint paints[] = {draw::red, draw::blue, draw::ochre, draw::violet, draw::grey};
    Picture picture("Things roll and slide down hills, which stand as a table in flash: every 0.3 s, and at rest", 1, 1100, 560);
    picture.begin_field(0, {14.8, {4, 4, 0.95}, 20, 36});
    for (int cell = 0; cell < 64; ++cell) {
        const int x = cell % 8, y = cell / 8;
        const auto corner = [](int i, int j) {
            return draw::Point{static_cast<double>(i), static_cast<double>(j), scenes::hills_of_terrain.heights[9 * j + i] / 32.0};
        };
        picture.add_ground_face({corner(x, y), corner(x + 1, y), corner(x + 1, y + 1)}, draw::green, false);
        picture.add_ground_face({corner(x, y), corner(x + 1, y + 1), corner(x, y + 1)}, draw::green, false);
        const auto down = [](const draw::Point& P) { return draw::Point{P[0], P[1], -0.3}; };  // the sides that are seen
        if (y == 0) picture.add_ground_face({corner(x, 0), corner(x + 1, 0), down(corner(x + 1, 0)), down(corner(x, 0))}, draw::ochre, false);
        if (x == 7) picture.add_ground_face({corner(8, y), corner(8, y + 1), down(corner(8, y + 1)), down(corner(8, y))}, draw::ochre, false);
    }
    for (int moment = 0; good && moment <= 6; ++moment) {
        for (int slot = 0, number = 0; slot < S::max_bodies; ++slot) {
            const ingot::BodyId id = w.body_at(slot);
            if (w.is_movable(id)) picture.add(w.placed_shape(id).value, paints[number++ % 5], false, moment == 6 ? 1 : 0.4);
        }
        if (moment < 6) good = go_on<S>(moment < 5 ? 0.3 : 6);
    }
    return say(good && picture.write(path.c_str()), path, "things roll down hills, drawn every 0.3 s, and at rest");
}

}  // namespace

bool demo::write_pictures(const std::string& out_dir) {
    bool good = wall(out_dir + "/wall.svg");
    good = stairs(out_dir + "/stairs.svg") && good;
    good = walker(out_dir + "/walker.svg") && good;
    good = pile(out_dir + "/pile.svg") && good;
    return terrain(out_dir + "/terrain.svg") && good;
}
