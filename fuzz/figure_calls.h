// SPDX-License-Identifier: MIT
// Calls about bodies with joints, out of bytes: of fuzz_joints.cpp and fuzz_drives.cpp.
#pragma once

#include "figure_promises.h"

namespace fuzz { inline namespace INGOT_ABI {

template <class S>
class Figures : FigurePromises<S> {
public:
    uint64_t run(Bytes in) {
        const uint8_t setting = in.byte();
        if ((setting & 1u) != 0) {
            demand(world_.set_gravity({0, 0, scalar(-9.81)}) == Status::ok, "gravity is taken");
            floats_ = false;
            heavy_ = true;
        }
        if constexpr (ingot::stacks<S>)
            if ((setting & 2u) != 0) add_ground();
        h_ = (setting & 12u) == 0 ? scalar(1) / 60 : scalar(1) / static_cast<scalar>(30 << ((setting >> 2) & 3u));
        while (!in.empty()) {
            memcpy(static_cast<void*>(&before_), &world_, sizeof world_);
            call(in);
            demand_sound();
        }
        return seen_;
    }

private:
    using Promises = FigurePromises<S>;
    using Promises::N, Promises::size, Promises::world_, Promises::before_, Promises::other_, Promises::h_, Promises::reach_, Promises::seen_;
    using Promises::sane_, Promises::floats_, Promises::heavy_;
    using Promises::see, Promises::refused, Promises::refused_joint, Promises::flip, Promises::moves, Promises::energy, Promises::mass;
    using Promises::fast, Promises::stepped, Promises::demand_sound;

    static constexpr scalar ground_z = -2;

    double energy_before_ = 0;  ///< J, a step before the last, of those that follow each other
    bool steps_on_ = false, servos_between_bodies_ = false;
    int gears_ = 0;

    void call(Bytes& in) {
        const unsigned op = in.byte() % (S::joints::has_drives ? 18u : 14u);
        if (op < 10 || op > 13) steps_on_ = false;
        switch (op) {
            case 0: case 1: case 2: grow(in); break;
            case 3: join_wildly(in); break;
            case 4: remove_joint(in); break;
            case 5: remove_body(in); break;
            case 6: push(in); break;
            case 7: copy(); break;
            case 8: save(); break;
            case 9: tell(in); break;
            case 14: brake(in); break;
            case 15: drive(in); break;
            case 16: gear(in); break;
            case 17: serve(in); break;
            default: steps(in); break;
        }
    }

    void add_ground() {
        BodyDef ground;
        ground.immovable = true;
        if constexpr (ingot::stacks<S>) ground.shape = ingot::HalfSpace{{0, 0, 1}, ground_z};
        demand(world_.add(ground).ok(), "a ground is taken");
        floats_ = false;
    }

    static scalar within(Bytes& in, double low, double high) {
        return static_cast<scalar>(low + (high - low) * static_cast<double>(in.byte()) / 255);
    }
    static Vector aside(Bytes& in, double far) {
        const scalar x = within(in, -far, far), y = within(in, -far, far), z = within(in, -far, far);
        return {x, y, z};
    }
    static Vector unit(Bytes& in) {
        const Vector v = aside(in, 1);
        const scalar length = ingot::sqrt(ingot::length_sq(v));
        return length > scalar(0.1) ? v * (1 / length) : Vector{0, 0, 1};
    }

    /// One more body, joined to one that is there, or to the world, or to nothing.
    void grow(Bytes& in) {
        BodyDef def;
        const Vector half = {within(in, 0.3, 1) * scalar(size), within(in, 0.3, 1) * scalar(size), within(in, 0.3, 1) * scalar(size)};
        const scalar density = within(in, 10, 300);
        def.mass = ingot::principal(ingot::solid_box(density, half)).value;
        if constexpr (ingot::stacks<S>) def.shape = ingot::Box{half};
        const Result<Matrix> turned = ingot::rotation_about(unit(in), within(in, 0, 6));
        if (turned.ok()) def.state.A = turned.value;
        ingot::JointDef joint;
        const BodyId parent = pick_body(in);
        const uint8_t how = in.byte();
        const bool to_world = parent == BodyId{} && (how & 1u) != 0, alone = (how & 6u) == 6;
        if (world_.is_alive(parent)) joint.P = world_.state(parent).value.r_CM;
        joint.P = joint.P + aside(in, 1.5 * size);
        def.state.r_CM = joint.P + aside(in, 1.5 * size);
        if (is_in_the_way(def, half, world_.is_alive(parent) && !alone ? parent : BodyId{})) {
            if ((how & 56u) != 56u) return;
            sane_ = false;
        }
        const Result<BodyId> added = world_.add(def);
        refused(added.status);
        if (!added.ok()) return;
        reach_[added.value.slot] = ingot::sqrt(ingot::length_sq(half));
        if (alone || !(to_world || world_.is_alive(parent))) return;
        memcpy(static_cast<void*>(&before_), &world_, sizeof world_);
        joint.body_A = parent;
        joint.body_B = added.value;
        if ((how & 8u) != 0) {
            joint.body_A = added.value;
            joint.body_B = parent;
        }
        joint.joint.kind = static_cast<ingot::JointKind>(1 + (how >> 4) % 5);
        joint.axis = unit(in);
        const Vector x = ingot::cross(joint.axis, unit(in));
        const scalar length = ingot::sqrt(ingot::length_sq(x));
        joint.axis_B = length > scalar(0.1) ? x * (1 / length) : Vector{1, 0, 0};
        if (joint.joint.kind == ingot::JointKind::universal && !(length > scalar(0.1))) joint.joint.kind = ingot::JointKind::ball;
        if constexpr (S::joints::has_limits)
            if (in.byte() % 4 == 0) set_ranges(joint.joint, in);
        joint.bodies_meet = (how & 128u) != 0 && (how & 64u) != 0;
        if (joint.bodies_meet) sane_ = false;  // they may be in each other for good
        add_joint(joint);
        if (to_world) floats_ = false;
    }

    /// Whether a new body may be in another, or in the ground: what it is pushed out by is energy that nobody gave.
    bool is_in_the_way(const BodyDef& def, const Vector& half, BodyId parent) const {
        if (!ingot::stacks<S>) return false;
        const scalar reach = ingot::sqrt(ingot::length_sq(half));
        if (def.state.r_CM.z - reach < ground_z) return true;
        for (int slot = 0; slot < N; ++slot) {
            const BodyId id = world_.body_at(slot);
            if (!moves(slot) || id == parent) continue;
            const scalar apart = reach + reach_[slot];
            if (ingot::length_sq(world_.state(id).value.r_CM - def.state.r_CM) < apart * apart) return true;
        }
        return false;
    }

    void add_joint(const ingot::JointDef& def) {
        const Result<ingot::JointId> added = world_.add_joint(def);
        refused_joint(added.status);
        see(&added.status, sizeof added.status);
        if (!added.ok()) return;
        demand(world_.is_alive(added.value) && !before_.is_alive(added.value), "a new joint has a new id");
        demand(world_.joint_count() == before_.joint_count() + 1, "add_joint adds one joint");
        demand(world_.joint_gap(added.value).value <= scalar(1e-5), "bodies are joined as they are");
    }

    /// The start lies between them.
    void set_ranges(ingot::Joint& joint, Bytes& in) {
        const scalar below = within(in, -1, -0.02), above = within(in, 0.02, 1);
        if (joint.kind == ingot::JointKind::ball)
            joint.limits = {{{below, above}, {-ingot::unlimited, within(in, 0.1, 1)}}, 0};
        else if (ingot::limited_directions(joint.kind) > 0)
            joint.limits.range[0] = {below, above};
        if (joint.kind == ingot::JointKind::universal) joint.limits.range[1] = {below, above};
    }
    static ingot::JointLimits wild_limits(Bytes& in) {
        ingot::JointLimits limits;
        for (ingot::JointRange& range : limits.range) {
            range.lower = in.number(3);
            range.upper = in.number(3);
        }
        limits.restitution = in.number(1);
        return limits;
    }

    /// Calls about one joint, of any numbers.
    void tell(Bytes& in) {
        const ingot::JointId id = pick_joint(in);
        const uint8_t what = in.byte();
        if constexpr (S::joints::has_limits)
            if (what % 3 == 0) {
                const Status status = world_.set_joint_limits(id, wild_limits(in));
                refused(status);
                if (status == Status::ok) sane_ = false;
            }
        if constexpr (S::joints::may_break) {
            if (what % 3 == 0) return;
            const Status status =
                what % 3 == 1 ? world_.set_joint_strength(id, {in.number(100), in.number(20)}) : world_.set_joint_enabled(id, (what & 64u) != 0);
            refused(status);
            if (status == Status::ok) let_meet();
            memcpy(static_cast<void*>(&before_), &world_, sizeof world_);
        }
        if constexpr (S::joints::has(ingot::JointKind::target)) {
            const ingot::TargetDrive drive = {in.number(10), in.number(2), in.number(500), in.number(50)};
            const Vector P = in.vector(4), v = in.vector(2);
            if (what % 3 == 0) tell_of_ties(world_.set_joint_length(id, in.number(4)));
            if (what % 3 == 1) tell_of_ties(world_.set_target_drive(id, drive));
            if (what % 3 == 2) tell_of_ties(world_.set_target(id, P, v));
        }
    }
    void tell_of_ties(Status status) {
        refused(status);
        if (status == Status::ok) sane_ = floats_ = false;
    }

    /// Any numbers: loops too.
    void join_wildly(Bytes& in) {
        ingot::JointDef def;
        def.body_A = pick_body(in);
        def.body_B = pick_body(in);
        def.joint.kind = static_cast<ingot::JointKind>(in.byte() % (S::joints::has_drives ? 17u : 12u));
        if (in.byte() % 4 == 0) def.joint.limits = wild_limits(in);
        def.P = in.vector(4);
        def.axis = in.direction();
        def.axis_B = in.direction();
        def.P_B = in.vector(4);
        def.bodies_meet = (in.byte() & 1u) != 0;
        const int count = world_.joint_count();
        const Result<ingot::JointId> added = world_.add_joint(def);
        refused_joint(added.status);
        if (!added.ok()) return;
        demand(world_.joint_count() == count + 1, "add_joint adds one joint");
        sane_ = floats_ = false;
    }

    /// A brake takes energy and gives none, whatever else acts.
    void brake(Bytes& in) {
        if constexpr (S::joints::has_drives) {
            const ingot::JointId id = pick_joint(in);
            const ingot::JointDrive drive = ingot::MotorDrive{0, within(in, 0, 50)};
            const Status status = world_.set_joint_drive(id, drive, in.byte() % 3);
            refused(status);
            if (status == Status::ok && is_servo_between_bodies(id)) sane_ = floats_ = false;
            if (status != Status::ok) refused(world_.set_ball_drive(id, drive));
        }
    }
    /// What it measures is one body, and what it gives is on both: it may give energy.
    bool is_servo_between_bodies(ingot::JointId id) const { return servos_between_bodies_ && world_.is_alive(id); }

    /// Springs, servos and motors of any numbers.
    void drive(Bytes& in) {
        if constexpr (S::joints::has_drives) {
            const ingot::JointId id = pick_joint(in);
            ingot::JointDrive drive;
            const uint8_t how = in.byte();
            const scalar a = in.number(1000), b = in.number(50), target = in.number(2), rate = in.number(10), most = in.number(100);
            if (how % 3 == 0) drive = ingot::SpringDrive{a, b, target, rate, 0, most};
            if (how % 3 == 1) drive = ingot::TunedDrive{b, a, target};
            if (how % 3 == 2) drive = ingot::MotorDrive{rate, most};
            const Vector turn = in.vector(2), spin = in.vector(5);
            const Status status = (how & 64u) != 0 ? world_.set_ball_drive(id, drive, turn, spin) : world_.set_joint_drive(id, drive, (how >> 3) % 4);
            refused(status);
            if (status == Status::ok) sane_ = floats_ = false;
        }
    }

    /// Two joints, of any ratio; of the first gear of a plain one, whose figures stay as good as they were.
    void gear(Bytes& in) {
        if constexpr (S::joints::has_drives) {
            const ingot::JointId A = pick_joint(in), B = pick_joint(in);
            const uint8_t how = in.byte();
            const bool is_plain = (how & 3u) != 0;
            const scalar ratio = is_plain ? within(in, 0.2, 3) * ((how & 4u) != 0 ? scalar(-1) : scalar(1)) : in.number(10);
            const int count = world_.joint_count();
            const Result<ingot::JointId> added = world_.add_gear(A, B, ratio);
            refused_joint(added.status);
            if (!added.ok()) return;
            demand(world_.joint_count() == count + 1, "add_gear adds one joint");
            demand(world_.gear_ratio(added.value).value == ratio, "a gear has its ratio");
            demand(world_.joint_gap(added.value).value <= scalar(1e-5) * (1 + ingot::abs(ratio)), "joints are coupled as they are");
            if (!is_plain || gears_++ > 0) sane_ = floats_ = false;
        }
    }

    /// A servo, against another body, or against none; at first it does nothing.
    void serve(Bytes& in) {
        if constexpr (S::joints::has_drives) {
            ingot::JointDef def;
            def.body_A = pick_body(in);
            def.body_B = pick_body(in);
            def.joint.kind = (in.byte() & 1u) != 0 ? ingot::JointKind::servo : ingot::JointKind::ball_servo;
            def.axis = unit(in);
            const Result<ingot::JointId> added = world_.add_joint(def);
            refused_joint(added.status);
            if (added.ok() && !(def.body_A == BodyId{})) servos_between_bodies_ = true;
        }
    }

    void remove_joint(Bytes& in) {
        const ingot::JointId id = pick_joint(in);
        const bool lived = world_.is_alive(id);
        const Status status = world_.remove(id);
        refused(status);
        demand(lived == (status == Status::ok), "remove takes out what lives, and nothing else");
        demand(!world_.is_alive(id) && world_.remove(id) != Status::ok, "a removed joint is gone");
        const int left = before_.joint_count() - (lived ? 1 : 0);
        demand(S::joints::has_drives ? world_.joint_count() <= left : world_.joint_count() == left, "remove takes out one joint, and its gears");
        if (lived) let_meet();
    }
    /// What a joint kept from touching may be in each other.
    void let_meet() {
        if (ingot::stacks<S>) sane_ = false;
    }
    void remove_body(Bytes& in) {
        const BodyId id = pick_body(in);
        const Status status = world_.remove(id);
        refused(status);
        for (int slot = 0; slot < S::max_joints && status == Status::ok; ++slot) {
            const ingot::JointId joint = before_.joint_at(slot);
            if (joint == ingot::JointId{}) continue;
            demand(world_.is_alive(joint) || world_.joint_gap(joint).status == Status::stale_id, "joints go with their bodies");
        }
    }

    /// An impulse, or a spin that turns the body by up to two radians in a step.
    void push(Bytes& in) {
        const BodyId id = pick_body(in);
        const scalar M = world_.is_alive(id) ? world_.mass(id).value : scalar(1);
        const Status status = (in.byte() & 1u) != 0 ? world_.apply_central_impulse(id, aside(in, 3) * M)
                                                     : world_.apply_angular_impulse(id, aside(in, 1) * (M * scalar(size * size * 0.2)));
        refused(status);
    }

    void steps(Bytes& in) {
        const int count = 1 + in.byte() % 16;
        double last = energy(), before = steps_on_ ? energy_before_ : last;
        for (int step_i = 0; step_i < count; ++step_i) {
            memcpy(static_cast<void*>(&before_), &world_, sizeof world_);
            const StepReport report = INGOT_FUZZ_STEP(world_, h_);
            demand(report.status == Status::ok, "a step is taken");
            see(&report.sweeps, sizeof report.sweeps);
            stepped(report);
            demand_sound();
            double now = energy();
            if (fuzz_fault == 5) now = 2 * now + 10 * mass();
            // Beside its motion, not beside its height: that counts from where the world has its origin, and no step knows of it.
            const double motion = static_cast<double>(before_.kinetic_energy());
            if (sane_ && !fast())
                demand(now <= (last > before ? last : before) + 0.01 * (9.81 * mass() + motion), "joints give no energy");
            before = last;
            last = now;
        }
        energy_before_ = before;
        steps_on_ = true;
    }
    void copy() {
        memcpy(static_cast<void*>(&other_), &world_, sizeof world_);
        (void)ingot::step(other_, h_);
        demand(same_bytes(&world_, &before_, sizeof world_), "worlds share nothing");
        (void)ingot::step(world_, h_);
        if (fuzz_fault == 1) flip(&other_);
        demand(same_bytes(&world_, &other_, sizeof world_), "a copy steps to the same bytes");
    }
    void save() {
        static uint8_t bytes[ingot::snapshot_size<S>()];
        const Result<size_t> length = ingot::save_snapshot(world_, bytes, sizeof bytes);
        demand(length.ok(), "a world is saved");
        memset(static_cast<void*>(&other_), 0, sizeof other_);
        demand(ingot::load_snapshot(other_, bytes, length.value) == Status::ok, "what was saved is loaded");
        (void)ingot::step(other_, h_);
        (void)ingot::step(world_, h_);
        demand(other_.state_hash() == world_.state_hash(), "a loaded world steps to the same bits");
    }

    BodyId pick_body(Bytes& in) const {
        const uint8_t which = in.byte();
        if (which == 255) return {static_cast<ingot::Index>(in.byte()), in.raw<uint16_t>(), in.raw<uint32_t>()};
        return world_.body_at(which % (N + 1));
    }
    ingot::JointId pick_joint(Bytes& in) const {
        const uint8_t which = in.byte();
        if (which == 255) return {static_cast<ingot::Index>(in.byte()), in.raw<uint16_t>(), in.raw<uint32_t>()};
        return world_.joint_at(which % (S::max_joints + 1));
    }

};

} }  // namespace fuzz
