// SPDX-License-Identifier: MIT
// Figures shot into closed halls with `continuous`, with room for all their contacts and for few of them: how far beyond the walls anything comes,
// how far joints open, and what energy does.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <ingot/ingot.h>

#include "reference/draws.h"
#include "reference/kernel_types.h"
#include "reference/random_input.h"

namespace {

using Eigen::Vector3d;
using ingot::BodyDef;
using ingot::BodyId;
using ingot::BodyState;
using ingot::scalar;
using ingot::Vector;
using ingot_reference::RandomInput;
using ingot_reference::to_eigen;
using ingot_reference::to_vector;
namespace limits = ingot::limits;

template <int manifolds>
struct Hall : ingot::Scene {
    static constexpr int max_bodies = 48, max_joints = 32, max_manifolds = manifolds, max_pairs = 600;
    static constexpr bool translates = true, continuous = true;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint>;
    using shapes = ingot::Shapes<ingot::Box, ingot::Capsule, ingot::Sphere, ingot::HalfSpace>;
};

constexpr double half_hall = 3, g = 9.81;  ///< m, m/s^2

/// Two to six figures, each of three to six bodies in a chain of balls and hinges, shot as one: apart, or all into one corner.
template <class S>
class Shot {
public:
    explicit Shot(uint64_t seed) : random_(seed), world_(new ingot::World<S>{}) {
        constexpr double rates[] = {30, 60, 120, 240};
        has_weight_ = random_.integer(0, 1) == 1;
        EXPECT_EQ(world_->set_gravity({0, 0, has_weight_ ? scalar(-g) : scalar(0)}), ingot::Status::ok);
        for (int side = 0; side < 6; ++side) add_wall(side);
        const int figures = random_.integer(2, 6);
        rate = rates[random_.integer(0, 3)];
        speed = 5 * std::pow(12.0, random_.real(0, 1));
        const bool into_corner = random_.integer(0, 1) == 1;
        for (int i = 0; i < figures; ++i) {
            Vector3d at;
            for (int k = 0; k < 3; ++k) at[k] = ((i >> k & 1) != 0 ? 1.2 : -1.2) + random_.real(-0.2, 0.2);
            const Vector3d to = into_corner ? Vector3d(half_hall, half_hall, -half_hall) - at : Vector3d(random_.direction());
            add_figure(at, to.normalized() * speed);
        }
    }
    ingot::StepReport step() { return ingot::step(*world_, scalar(1) / static_cast<scalar>(rate)); }

    /// m; how far the lowest point of any body is beyond a wall, and by how much that is more than the body's least half extent.
    struct Beyond {
        double most = 0, more_than_thick = 0;
    };
    Beyond beyond() const {
        Beyond deepest;
        for (const Member& member : members_) {
            const BodyState state = world_->state(member.id).value;
            const auto thick = static_cast<double>(ingot::least_half_extent(member.shape, nullptr));
            for (int axis = 0; axis < 3; ++axis) {
                const double out = std::abs(to_eigen(state.r_CM)[axis]) + reach(member.shape, state.A, axis) - half_hall;
                deepest.most = std::max(deepest.most, out);
                deepest.more_than_thick = std::max(deepest.more_than_thick, out - thick);
            }
        }
        return deepest;
    }
    /// m, of the joint that is open furthest.
    double gap() const {
        double most = 0;
        for (const Pin& pin : pins_) most = std::max(most, (place_of(pin.A, pin.on_A) - place_of(pin.B, pin.on_B)).norm());
        return most;
    }
    /// J, kinetic and of gravity.
    double energy() const {
        auto sum = static_cast<double>(world_->kinetic_energy());
        for (const Member& member : members_)
            if (has_weight_) sum += member.M * g * static_cast<double>(world_->state(member.id).value.r_CM.z);
        return sum;
    }
    /// J, that its weight may give at most.
    double fall() const {
        double sum = 0;
        for (const Member& member : members_) sum += member.M * g * half_hall;
        return sum;
    }

    double rate, speed;  ///< Hz, m/s

private:
    struct Member {
        BodyId id;
        ingot::Shape shape;
        double M;
    };
    struct Pin {
        BodyId A, B;
        Vector3d on_A, on_B;
    };

    /// m, along an axis of the world.
    static double reach(const ingot::Shape& shape, const ingot::Matrix& A, int axis) {
        const Vector3d along(std::abs(to_eigen(A.c0)[axis]), std::abs(to_eigen(A.c1)[axis]), std::abs(to_eigen(A.c2)[axis]));
        const Vector3d size = to_eigen(shape.size);
        if (shape.kind == ingot::ShapeKind::box) return along.dot(size);
        return shape.kind == ingot::ShapeKind::capsule ? size.x() + along.z() * size.y() : size.x();
    }
    Vector3d place_of(BodyId id, const Vector3d& P) const {
        const BodyState state = world_->state(id).value;
        return to_eigen(state.r_CM) + to_eigen(state.A.c0) * P.x() + to_eigen(state.A.c1) * P.y() + to_eigen(state.A.c2) * P.z();
    }
    Vector3d seen(BodyId id, const Vector3d& P) const {
        const BodyState state = world_->state(id).value;
        const Vector3d way = P - to_eigen(state.r_CM);
        return {way.dot(to_eigen(state.A.c0)), way.dot(to_eigen(state.A.c1)), way.dot(to_eigen(state.A.c2))};
    }

    void add_wall(int side) {
        Vector3d n(0, 0, 0);
        n[side / 2] = side % 2 == 0 ? 1 : -1;
        BodyDef wall;
        wall.immovable = true;
        wall.shape = ingot::HalfSpace{to_vector(n), scalar(-half_hall)};
        wall.friction = scalar(0.4);
        EXPECT_TRUE(world_->add(wall).ok());
    }
    BodyId add_body(const Vector3d& r, const Vector3d& v, double size) {
        BodyDef def;
        const int kind = random_.integer(0, 2);
        const double h = size * random_.real(0.5, 1), M = std::exp(random_.real(0, 2));
        const auto side = [&](double least, double most) { return static_cast<scalar>(h * random_.real(least, most)); };
        if (kind == 0) def.shape = ingot::Box{{static_cast<scalar>(h), side(0.3, 1), side(0.3, 1)}};
        if (kind == 1) def.shape = ingot::Capsule{side(0.3, 0.8), static_cast<scalar>(h)};
        if (kind == 2) def.shape = ingot::Sphere{static_cast<scalar>(h)};
        const auto I = static_cast<scalar>(M * h * h * 0.4);
        def.mass.M = static_cast<scalar>(M);
        def.mass.I_body = {I, I * scalar(1.1), I * scalar(1.2)};
        def.mass.A_principal = ingot::identity_matrix<scalar>();
        def.state.A = ingot::rotation_about(to_vector(random_.direction()), static_cast<scalar>(random_.real(-3, 3))).value;
        def.state.r_CM = to_vector(r);
        def.state.v_CM = to_vector(v);
        def.friction = static_cast<scalar>(random_.real(0.2, 1));
        def.restitution = random_.integer(0, 2) == 0 ? scalar(0.4) : scalar(0);
        const auto id = world_->add(def);
        EXPECT_TRUE(id.ok());
        members_.push_back({id.value, def.shape, M});
        return id.value;
    }
    void add_figure(const Vector3d& at, const Vector3d& v) {
        const double size = random_.real(0.08, 0.2);
        const int count = random_.integer(3, 6);
        BodyId last = add_body(at, v, size);
        Vector3d r = at;
        for (int i = 1; i < count; ++i) {
            const Vector3d pin = r + random_.direction() * size;
            r = pin + random_.direction() * size;
            const BodyId id = add_body(r, v, size);
            ingot::JointDef def;
            def.body_A = last;
            def.body_B = id;
            def.P = to_vector(pin);
            def.axis = to_vector(random_.direction());
            if (random_.integer(0, 1) == 1)
                def.joint = ingot::BallJoint{};
            else
                def.joint = ingot::HingeJoint{};
            EXPECT_TRUE(world_->add_joint(def).ok());
            pins_.push_back({last, id, seen(last, pin), seen(id, pin)});
            last = id;
        }
    }

    RandomInput random_;
    std::unique_ptr<ingot::World<S>> world_;
    bool has_weight_;
    std::vector<Member> members_;
    std::vector<Pin> pins_;
};

/// What is not followed gets no further in a step than it is thick (limits::fast_share), and overlaps are pushed out at push_speed_max, by others
/// too: so nothing is further beyond a wall than the two. After a step for which there was no room, nothing is by more than touching_gap, but where a
/// joint took a body to a wall that was not near it: one step of a thousand. Joints hold as they do elsewhere; without room bodies are stopped one by
/// one, and joints open by no more than their two ends go in a step of the shot. No step gives a tenth of what there was at the begin.
template <class S>
void expect_halls_hold(bool has_room) {
    int full = 0, deep = 0, without_room = 0, left_in = 0;
    for (int draw = 0; draw < ingot_reference::draws(80); ++draw) {
        Shot<S> shot(static_cast<uint64_t>(draw));
        const double begin = shot.energy(), most = 0.1 * (std::abs(begin) + shot.fall());
        const double slack = 64 * static_cast<double>(ingot::epsilon) * half_hall;
        const double pushed = static_cast<double>(limits::push_speed_max) / shot.rate;
        double last = begin, before = begin;
        bool lost = false;
        for (int step_i = 0; step_i < static_cast<int>(shot.rate / 3); ++step_i) {
            const ingot::StepReport report = shot.step();
            lost = lost || report.contacts_lost > 0;
            const auto beyond = shot.beyond();
            EXPECT_LE(beyond.more_than_thick, pushed + slack) << draw << " step " << step_i;
            without_room += report.contacts_lost > 0 ? 1 : 0;
            left_in += report.contacts_lost > 0 && beyond.most > static_cast<double>(limits::touching_gap) + slack ? 1 : 0;
            EXPECT_LE(shot.gap(), has_room ? 5e-5 : 2 * shot.speed / shot.rate) << draw << " step " << step_i;
            const double now = shot.energy();
            EXPECT_LE(now - std::max(last, before), most) << draw << " step " << step_i;
            before = last;
            last = now;
            deep += beyond.most > static_cast<double>(limits::touching_gap) + slack ? 1 : 0;
        }
        full += lost ? 1 : 0;
        if (has_room) {
            EXPECT_FALSE(lost) << draw;
        }
    }
    if (has_room) {
        EXPECT_GT(deep, 0);
    } else {
        EXPECT_GT(2 * full, ingot_reference::draws(80));
        EXPECT_LE(left_in, 1 + without_room / 1000) << "of " << without_room;
    }
}
TEST(FiguresInHalls, stay_there) { expect_halls_hold<Hall<400>>(true); }
TEST(FiguresInHalls, stay_there_with_room_for_twelve) { expect_halls_hold<Hall<12>>(false); }
TEST(FiguresInHalls, stay_there_with_room_for_four) { expect_halls_hold<Hall<4>>(false); }

}  // namespace
