// SPDX-License-Identifier: MIT
// Crowds that fall on a floor: bodies of every shape at random, in worlds with more or less room for their contacts.
#pragma once

#include <ingot/ingot.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "reference/random_input.h"
#include "scenes/hulls.h"

namespace crowd {

using ingot::Matrix;
using ingot::RoomNeeded;
using ingot::scalar;
using ingot::Shape;
using ingot::ShapeKind;
using ingot::StepReport;
using ingot::Vector;
using ingot_reference::RandomInput;

constexpr int tiles_along = 10, bodies_max = 48;
constexpr double tile = 3, floor_half = tile * tiles_along / 2;

/// Room for so many; friction.
template <int manifolds, int pairs, class BroadPhase = ingot::AllPairs, class Solver = ingot::BlockSweeps, bool asleep = false>
struct Tight : scenes::Hulled<bodies_max + tiles_along * tiles_along, manifolds> {
    static constexpr int max_pairs = pairs;
    static constexpr bool sleeps = asleep;
    using broad_phase = BroadPhase;
    using solver = Solver;
};
/// Without friction: balls and boxes.
template <int contacts>
struct TightImpacts : ingot::Scene {
    static constexpr int max_bodies = bodies_max + 1;
    static constexpr bool translates = true;
    static constexpr int max_contacts = contacts;
    using solver = ingot::FrictionlessImpacts;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Box, ingot::HalfSpace>;
};

struct Plan {
    unsigned seed;
    int bodies, rate;
    bool on_tiles;
    double seconds = 20;
    double restitution = 0;
};

/// Bodies stand apart in layers and fall.
template <class S>
class Crowd {
public:
    explicit Crowd(const Plan& plan) : plan_(plan), random_(plan.seed), world_(new ingot::World<S>{}) {
        sound_ = world_->set_gravity({0, 0, scalar(-g)}) == ingot::Status::ok;
        plan.on_tiles ? add_tiles() : add_ground();
        for (int i = 0; i < plan.bodies; ++i) add_body(i);
    }

    static constexpr double g = 9.81;
    bool sound() const { return sound_; }
    ingot::World<S>& world() { return *world_; }
    scalar h() const { return scalar(1) / static_cast<scalar>(plan_.rate); }
    int steps() const { return static_cast<int>(plan_.seconds * plan_.rate); }
    double weight() const {
        double sum = 0;
        for (const Member& member : members_) sum += member.M * g;
        return sum;
    }
    double highest() const { return highest_; }
    /// m, that what fell from the top comes in one step.
    double way_of_step() const { return std::sqrt(2 * g * highest_) / plan_.rate; }

    StepReport step() { return ingot::step(*world_, h()); }

    /// J, kinetic and of gravity.
    double energy() const {
        double sum = static_cast<double>(world_->kinetic_energy());
        for (const Member& member : members_) sum += member.M * g * static_cast<double>(world_->state(member.id).value.r_CM.z);
        return sum;
    }
    /// m, of the lowest point of all below the floor.
    double depth() const {
        double deepest = 0;
        for (const Member& member : members_) {
            const ingot::BodyState state = world_->state(member.id).value;
            const double x = static_cast<double>(state.r_CM.x), y = static_cast<double>(state.r_CM.y);
            if (plan_.on_tiles && std::max(std::abs(x), std::abs(y)) > floor_half - 1) continue;  // beyond the last tile it falls by right
            deepest = std::max(deepest, reach_down(member, state.A) - static_cast<double>(state.r_CM.z));
        }
        return deepest;
    }

private:
    struct Member {
        ingot::BodyId id;
        Shape shape;
        double M;
    };
    static constexpr bool has_hulls = S::shapes::has(ShapeKind::hull);

    static double reach_down(const Member& member, const Matrix& A) {
        const double x = std::abs(static_cast<double>(A.c0.z)), y = std::abs(static_cast<double>(A.c1.z)), z = std::abs(static_cast<double>(A.c2.z));
        const double a = static_cast<double>(member.shape.size.x), b = static_cast<double>(member.shape.size.y);
        switch (member.shape.kind) {
            case ShapeKind::box: return x * a + y * b + z * static_cast<double>(member.shape.size.z);
            case ShapeKind::capsule: return a + z * b;
            case ShapeKind::cylinder: return std::sqrt(std::max(0.0, 1 - z * z)) * a + z * b;
            case ShapeKind::hull: return reach_of_hull(static_cast<int>(b), A);
            default: return a;
        }
    }
    static double reach_of_hull([[maybe_unused]] int form, [[maybe_unused]] const Matrix& A) {
        double reach = 0;
        if constexpr (has_hulls)
            for (int i = 0; i < S::hulls[form].vertex_count; ++i)
                reach = std::max(reach, -static_cast<double>((A * S::hulls[form].vertices[i]).z));
        return reach;
    }

    void add(ingot::BodyDef def) {
        const ingot::Result<ingot::BodyId> added = world_->add(def);
        sound_ = sound_ && added.ok();
        if (!def.immovable) members_.push_back({added.value, def.shape, static_cast<double>(def.mass.M)});
    }
    void add_ground() {
        ingot::BodyDef def;
        def.shape = ingot::HalfSpace{{0, 0, 1}, 0};
        def.immovable = true;
        def.friction = scalar(0.6);
        add(def);
    }
    void add_tiles() {
        for (int i = 0; i < tiles_along * tiles_along; ++i) {
            ingot::BodyDef def;
            def.shape = ingot::Box{{scalar(tile / 2), scalar(tile / 2), 1}};
            def.state.r_CM = {scalar(tile * (i % tiles_along + 0.5) - floor_half), scalar(tile * (i / tiles_along + 0.5) - floor_half), -1};
            def.immovable = true;
            def.friction = scalar(0.6);
            add(def);
        }
    }
    void add_body(int i) {
        constexpr int side = 3;
        ingot::BodyDef def;
        const int kind = random_.integer(0, has_hulls ? 4 : 1);
        const auto size = [&] { return static_cast<scalar>(random_.real(0.2, 0.35)); };
        if (kind == 0) def.shape = ingot::Sphere{size()};
        if (kind == 1) def.shape = ingot::Box{{size(), size(), size()}};
        if (kind == 2) def.shape = ingot::Capsule{size(), size()};
        if (kind == 3) def.shape = ingot::Cylinder{size(), size()};
        if (kind == 4) {
            def = scenes::hull_body<scenes::Hulled<1, 1>>(static_cast<scenes::HullForm>(random_.integer(0, 2)), {}, 0).def;
        } else {
            const scalar M = static_cast<scalar>(random_.real(20, 200)), I = M * scalar(0.05);
            def.mass.M = M;
            def.mass.I_body = {I, I * scalar(1.2), I * scalar(1.3)};
            def.mass.A_principal = ingot::identity_matrix<scalar>();
        }
        const Vector axis = {scalar(0.6), 0, scalar(0.8)};
        def.state.A = ingot::rotation_about(axis, static_cast<scalar>(random_.real(-3, 3))).value;
        const auto at = [&](int k) { return 1.5 * (k - 1) + random_.real(0, 0.05); };
        const double z = 1 + 1.5 * (i / (side * side));
        highest_ = std::max(highest_, z);
        def.state.r_CM = {static_cast<scalar>(at(i % side)), static_cast<scalar>(at(i / side % side)), static_cast<scalar>(z)};
        def.friction = static_cast<scalar>(random_.real(0.2, 1));
        def.restitution = static_cast<scalar>(plan_.restitution);
        add(def);
    }

    const Plan plan_;
    RandomInput random_;
    std::unique_ptr<ingot::World<S>> world_;
    std::vector<Member> members_;
    double highest_ = 0;
    bool sound_ = true;
};

}  // namespace crowd
