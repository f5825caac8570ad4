// SPDX-License-Identifier: MIT
// The contact scenes in one build of the kernel. Compiled once for each scalar and lane count.
//
// Types of the scenes do not carry the scalar in their names as the kernel's do: each build gets a namespace of its own.
#include <ingot/ingot.h>
#define scenes INGOT_JOIN(scenes_, INGOT_ABI, )

#include <type_traits>

#include "contact_case.h"
#include "scenes/contact/all_contact_scenes.h"

namespace report {

std::vector<ContactCase> INGOT_JOIN(contact_cases_, INGOT_ABI, )();
std::vector<ContactCase> INGOT_JOIN(simbenchmark_cases_, INGOT_ABI, )();

namespace {

using ingot::scalar;
using Boxes = ingot::Shapes<ingot::Box, ingot::HalfSpace>;
using Balls = ingot::Shapes<ingot::Sphere, ingot::HalfSpace>;

/// A world for one of the scenes: room for so many pairs that touch, and four times as many that may.
template <class Placed, class Shapes_, int manifolds, bool renews = true, class Solver = ingot::BlockSweeps>
struct SceneFor : ingot::Scene {
    static constexpr int max_bodies = Placed::body_count;
    static constexpr bool translates = true;
    static constexpr int max_manifolds = manifolds;
    static constexpr int max_pairs = manifolds > 16000 ? 65535 : 4 * manifolds;
    static constexpr bool recycles_manifolds = renews;
    using shapes = Shapes_;
    using solver = Solver;
    using broad_phase = std::conditional_t<(max_bodies > 100), ingot::SortedTree, ingot::AllPairs>;
};

void copy(const ingot::Vector& v, double (&to)[3]) {
    to[0] = static_cast<double>(v.x);
    to[1] = static_cast<double>(v.y);
    to[2] = static_cast<double>(v.z);
}

void copy(const ingot::Matrix& A, double (&to)[9]) {
    const ingot::Vector columns[3] = {A.c0, A.c1, A.c2};
    for (int column = 0; column < 3; ++column) {
        to[3 * column] = static_cast<double>(columns[column].x);
        to[3 * column + 1] = static_cast<double>(columns[column].y);
        to[3 * column + 2] = static_cast<double>(columns[column].z);
    }
}

SceneBody plain(const scenes::PlacedBody& placed) {
    SceneBody body{};
    const ingot::Shape& shape = placed.def.shape;
    body.solid = shape.kind == ingot::ShapeKind::sphere ? Solid::ball
                 : shape.kind == ingot::ShapeKind::box  ? Solid::box
                                                        : Solid::half_space;
    copy(shape.size, body.size);
    body.offset = static_cast<double>(shape.offset);
    body.immovable = placed.def.immovable;
    body.M = static_cast<double>(placed.def.mass.M);
    copy(placed.def.mass.I_body, body.I);
    copy(placed.def.state.A, body.A);
    copy(placed.def.state.r_CM, body.r);
    body.mu = static_cast<double>(placed.mu);
    body.e = static_cast<double>(placed.def.restitution);
    return body;
}

template <class Placed, class S>
class KernelRun final : public ContactRun {
public:
    explicit KernelRun(const ingot::Vector& push = {}) : push_(push) {
        for (int body_i = 0; body_i < Placed::body_count; ++body_i) {
            const scenes::PlacedBody placed = Placed::body(body_i);
            ingot::BodyDef def = placed.def;
            def.friction = placed.mu;
            refused_ += world_.add(def).ok() ? 0 : 1;
        }
        (void)world_.set_gravity(Placed::gravity);
    }
    /// A world with a body that was driven out of range is not stepped any more: what it would show then is of no scene.
    void step(int rate) override {
        if (report_.bodies_frozen != 0) return;
        if (is_pushed() && world_.add_central_force(world_.body_at(1), push_) != ingot::Status::ok) ++refused_;
        report_ = ingot::step(world_, scalar(1) / static_cast<scalar>(rate));
    }
    void read(std::vector<BodyPose>& poses) const override {
        poses.resize(Placed::body_count);
        for (int body_i = 0; body_i < Placed::body_count; ++body_i) {
            const ingot::BodyId id = world_.body_at(body_i);
            const ingot::BodyState state = world_.state(id).value;
            BodyPose& pose = poses[static_cast<std::size_t>(body_i)];
            copy(state.A, pose.A);
            copy(state.r_CM, pose.r);
            copy(state.v_CM, pose.v);
            copy(world_.omega(id).value, pose.omega);
        }
    }
    StepFigures figures() const override {
        return {static_cast<double>(report_.residual), static_cast<double>(report_.sweeps),
                refused_ + report_.contacts_lost + report_.pairs_untested, report_.bodies_frozen};
    }
    double bytes() const override { return static_cast<double>(sizeof world_); }

private:
    bool is_pushed() const { return push_.x != 0 || push_.y != 0 || push_.z != 0; }

    ingot::World<S> world_ = {};
    ingot::Vector push_;
    ingot::StepReport report_{};
    int refused_ = 0;
};

/// `manifolds`: pairs that touch, for which the world has room.
template <class Placed, class Shapes_, int manifolds, bool renews = true>
ContactCase contact_case(const char* name) {
    ContactCase one;
    one.name = name;
    copy(Placed::gravity, one.gravity);
    one.seconds = static_cast<double>(Placed::seconds);
    for (int body_i = 0; body_i < Placed::body_count; ++body_i) one.bodies.push_back(plain(Placed::body(body_i)));
    one.begin = [] { return std::make_unique<KernelRun<Placed, SceneFor<Placed, Shapes_, manifolds, renews>>>(); };
    return one;
}

/// The same by sweeps and by the solver that picks itself.
template <class Placed, int manifolds>
ContactCase case_of_both(const char* name) {
    ContactCase one = contact_case<Placed, Boxes, manifolds>(name);
    one.begin_chosen = [] {
        return std::make_unique<KernelRun<Placed, SceneFor<Placed, Boxes, manifolds, true, ingot::HybridIslands<>>>>();
    };
    return one;
}

/// Friction of its pairs, 0.4 and 0.8, as geometric means.
struct RollingByMeans : scenes::SimRolling {
    static constexpr scenes::PlacedBody body(int body_i) {
        scenes::PlacedBody placed = scenes::SimRolling::body(body_i);
        placed.mu = body_i == 0 ? mu_ground_box * mu_ground_box / mu_box_ball : mu_box_ball;
        return placed;
    }
};
ContactCase rolling_case(const char* name, const ingot::Vector& push) {
    using S = SceneFor<RollingByMeans, ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>, 60>;
    ContactCase one = contact_case<RollingByMeans, S::shapes, 60>(name);
    copy(push, one.push);
    one.begin = [push] { return std::make_unique<KernelRun<RollingByMeans, S>>(push); };
    return one;
}

}  // namespace

std::vector<ContactCase> INGOT_JOIN(simbenchmark_cases_, INGOT_ABI, )() {
    using namespace scenes;
    return {
        rolling_case("simbenchmark_rolling_diagonal", SimRolling::push_diagonal),
        rolling_case("simbenchmark_rolling_along_y", SimRolling::push_along_y),
        contact_case<SimBouncing, Balls, 100>("simbenchmark_bouncing"),
        contact_case<Sim666<false>, Balls, 1700>("simbenchmark_666"),
        contact_case<Sim666<true>, Balls, 1700>("simbenchmark_elastic_666"),
    };
}

std::vector<ContactCase> INGOT_JOIN(contact_cases_, INGOT_ABI, )() {
    using namespace scenes;
    return {
        contact_case<Pyramid<10>, Boxes, 150>("pyramid_55"),
        contact_case<Pyramid<20>, Boxes, 600>("pyramid_210"),
        contact_case<Pyramid<30>, Boxes, 1400>("pyramid_465"),
        case_of_both<Tower<20>, 60>("tower_20"),
        contact_case<Tower<20>, Boxes, 60, false>("tower_20_searched"),
        case_of_both<Tower<40>, 120>("tower_40"),
        contact_case<SpherePile<8>, Balls, 2500>("pile_512"),
        contact_case<SpherePile<16>, Balls, 18000>("pile_4096"),
        case_of_both<MassRatio<1, 1000>, 4>("mass_ratio_1000"),
        case_of_both<MassRatio<1, 1000000>, 4>("mass_ratio_1e6"),
        case_of_both<MassRatio<9, 1000>, 20>("mass_ratio_ten"),
        contact_case<Incline<70>, Boxes, 2>("incline_mu07"),
        contact_case<Incline<40>, Boxes, 2>("incline_mu04"),
        contact_case<Bounce<100>, Balls, 2>("bounce_e1"),
        contact_case<Bounce<50>, Balls, 2>("bounce_e05"),
        contact_case<BoxDroppedFlat<50>, Boxes, 2>("box_dropped_flat"),
        contact_case<PitOfBoxes, Boxes, 1500>("pit_125"),
    };
}

}  // namespace report
