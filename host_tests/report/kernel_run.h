// SPDX-License-Identifier: MIT
// How a build of the kernel runs a placed scene. For files that are compiled once for each build and say `#define scenes` first: see
// contact_cases.cpp.
#pragma once

#include <ingot/ingot.h>

#include <type_traits>

#include "contact_case.h"
#include "scenes/contact/placed_body.h"

namespace report {

namespace {

using ingot::scalar;

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
    body.solid = shape.kind == ingot::ShapeKind::sphere    ? Solid::ball
                 : shape.kind == ingot::ShapeKind::capsule ? Solid::capsule
                 : shape.kind == ingot::ShapeKind::box     ? Solid::box
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

/// Its bodies, and nothing that runs it.
template <class Placed>
ContactCase contact_case_of(const char* name) {
    ContactCase one;
    one.name = name;
    copy(Placed::gravity, one.gravity);
    one.seconds = static_cast<double>(Placed::seconds);
    for (int body_i = 0; body_i < Placed::body_count; ++body_i) one.bodies.push_back(plain(Placed::body(body_i)));
    return one;
}

/// `manifolds`: pairs that touch, for which the world has room.
template <class Placed, class Shapes_, int manifolds, bool renews = true>
ContactCase contact_case(const char* name) {
    ContactCase one = contact_case_of<Placed>(name);
    one.begin = [] { return std::make_unique<KernelRun<Placed, SceneFor<Placed, Shapes_, manifolds, renews>>>(); };
    return one;
}

}  // namespace

}  // namespace report
