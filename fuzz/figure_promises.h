// SPDX-License-Identifier: MIT
// Promises about bodies with joints: what fuzz_joints.cpp asks for after each call.
#pragma once

#include "bytes.h"
#include "fuzz_world.h"

namespace fuzz { inline namespace INGOT_ABI {

template <class S>
class FigurePromises {
protected:
    FigurePromises() {
        memset(static_cast<void*>(&world_), 0, sizeof world_);
        memset(static_cast<void*>(&before_), 0, sizeof before_);
        memset(static_cast<void*>(&other_), 0, sizeof other_);
    }

    static constexpr int N = S::max_bodies;
    static constexpr double size = 0.5;  ///< m

    double mass() const {
        double M = 0;
        for (int slot = 0; slot < N; ++slot)
            if (moves(slot)) M += static_cast<double>(world_.mass(world_.body_at(slot)).value);
        return M;
    }
    /// J: of motion and of height.
    double energy() const {
        double E = static_cast<double>(world_.kinetic_energy());
        for (int slot = 0; slot < N && heavy_; ++slot) {
            const BodyId id = world_.body_at(slot);
            if (moves(slot)) E += 9.81 * static_cast<double>(world_.mass(id).value) * static_cast<double>(world_.state(id).value.r_CM.z);
        }
        return E;
    }
    bool moves(int slot) const { return world_.body_at(slot) != BodyId{} && world_.mass(world_.body_at(slot)).value > 0; }

    void stepped(const StepReport& report) {
        if (report.bodies_frozen > 0 || report.spins_clamped > 0) sane_ = floats_ = false;
        if (report.contacts > 0) touches_ = true;
        if (sane_ && !fast()) demand_closed(touches_ ? gap_in_contact : gap_max);
        if (floats_ && !touches_) demand_momentum();
        demand_dynamics(world_.body_at(static_cast<int>(world_.step_count() % N)));
    }

    /// What its equations of motion say of any figure: what floats is held by its weight. It goes for worlds that went bad, too.
    void demand_dynamics(BodyId id) {
        static ingot::FigureDynamics<N> figure;
        static scalar torques[3 * N + 6];
        const Status status = world_.read_dynamics(id, figure);
        demand((status == Status::ok) == (figure.body_count() > 0), "a figure is read or refused");
        if (status != Status::ok) return;
        const int count = figure.direction_count();
        demand(figure.gravity_torques(torques, count) == Status::ok, "torques of what was read are told");
        for (int i = 0; i < count; ++i) demand(ingot::is_finite(torques[i]), "a torque is finite");
        if (count > 0) demand(figure.effective_inertia(count - 1).value > 0, "what moves is heavy");
        if (!figure.floats()) return;
        scalar M = 0;
        for (int i = 0; i < figure.body_count(); ++i) M += world_.mass(figure.body(i)).value;
        const scalar force = torques[2] + (fuzz_fault == 6 ? 1 : 0), weight = -M * world_.gravity().z;
        demand(ingot::abs(force - weight) <= 4 * N * ingot::epsilon * ingot::abs(weight), "what floats is held by its weight");
    }

    /// Some body turns by more than two radians a step: its joints are closed in the end, but not in every step.
    bool fast() const {
        for (int slot = 0; slot < N; ++slot) {
            const BodyId id = world_.body_at(slot);
            if (id == BodyId{} || world_.is_frozen(id)) continue;
            const Result<Vector> was = before_.omega(id), is = world_.omega(id);
            const scalar most = 2 / h_;
            if (was.ok() && ingot::length_sq(was.value) > most * most) return true;
            if (is.ok() && ingot::length_sq(is.value) > most * most) return true;
        }
        return false;
    }

    static constexpr scalar gap_max = scalar(1e-3) * scalar(size), gap_in_contact = scalar(2e-2) * scalar(size);
    void demand_closed(scalar most) {
        for (int slot = 0; slot < S::max_joints; ++slot) {
            const ingot::JointId id = world_.joint_at(slot);
            if (id == ingot::JointId{}) continue;
            if (!works(id)) continue;
            scalar gap = world_.joint_gap(id).value;
            if (fuzz_fault == 2) gap += 1;
            demand(gap <= most, "joints are closed");
        }
    }

    bool works([[maybe_unused]] ingot::JointId id) const {
        if constexpr (S::joints::may_break) return world_.is_joint_enabled(id).value;
        return true;
    }

    void demand_momentum() {
        double was[3] = {}, is[3] = {}, rounding = 0;
        // A body that is pushed has more energy as the step begins than all have once its joints have passed it on.
        const double E_0 = static_cast<double>(before_.kinetic_energy()), E_1 = static_cast<double>(world_.kinetic_energy());
        for (int slot = 0; slot < N; ++slot) {
            const BodyId id = world_.body_at(slot);
            if (id == BodyId{}) continue;
            const double M = static_cast<double>(world_.mass(id).value);
            const Vector v_0 = before_.state(id).value.v_CM, v = world_.state(id).value.v_CM;
            const scalar of_0[] = {v_0.x, v_0.y, v_0.z}, of[] = {v.x, v.y, v.z};
            for (int axis = 0; axis < 3; ++axis) {
                was[axis] += M * static_cast<double>(of_0[axis]);
                is[axis] += M * static_cast<double>(of[axis]);
            }
            const double fastest = __builtin_sqrt(2 * (E_0 > E_1 ? E_0 : E_1) / M);
            // What places are rounded by is a gap, which a substep closes and leaves again.
            const double far = __builtin_sqrt(static_cast<double>(ingot::length_sq(world_.state(id).value.r_CM))) + size;
            const double closing = far * static_cast<double>(ingot::epsilon) * 36 / static_cast<double>(h_);
            rounding += M * (fastest + closing) * static_cast<double>(ingot::epsilon);
        }
        if (fuzz_fault == 3) is[0] += 1;
        for (int axis = 0; axis < 3; ++axis)
            demand(__builtin_fabs(is[axis] - was[axis]) <= 36 * 8 * 4 * rounding + 1e-30, "what floats keeps its momentum");
    }

    void demand_sound() {
        for (int slot = 0; slot < N; ++slot) {
            const BodyId id = world_.body_at(slot);
            if (id == BodyId{}) continue;
            const BodyState s = world_.state(id).value;
            see(&s, sizeof s);
            demand(ingot::is_finite(s.r_CM) && ingot::is_finite(s.v_CM) && ingot::is_finite(s.L) && ingot::is_finite(s.A.c0) &&
                       ingot::is_finite(s.A.c1) && ingot::is_finite(s.A.c2),
                   "every number is finite");
            demand(ingot::orthogonality_error(s.A) <= limits::orthogonality, "A is orthonormal");
        }
    }

    void refused(Status status) {
        see(&status, sizeof status);
        if (fuzz_fault == 4 && status != Status::ok) flip(&world_);
        if (status != Status::ok) demand(same_bytes(&world_, &before_, sizeof world_), "a refused call leaves the world bitwise unchanged");
    }
    /// Whether a joint closes a loop is found in the memory in which figures are built in each step: no call and no snapshot tells what is there.
    void refused_joint(Status status) {
        if (status != Status::no_room || world_.joint_count() == S::max_joints) return refused(status);
        see(&status, sizeof status);
        static uint8_t bytes[2][ingot::snapshot_size<S>()];
        const Result<size_t> was = ingot::save_snapshot(before_, bytes[0], sizeof bytes[0]);
        const Result<size_t> is = ingot::save_snapshot(world_, bytes[1], sizeof bytes[1]);
        demand(was.ok() && is.ok() && was.value == is.value && same_bytes(bytes[0], bytes[1], is.value), "a refused joint leaves no trace");
    }
    static void flip(void* world) { static_cast<unsigned char*>(world)[40] ^= 1; }

    void see(const void* data, size_t length) {
        const unsigned char* bytes = static_cast<const unsigned char*>(data);
        for (size_t byte_i = 0; byte_i < length; ++byte_i) seen_ = (seen_ ^ bytes[byte_i]) * 0x100000001b3u;
    }

    static World<S> world_, before_, other_;
    scalar h_ = scalar(1) / 60;
    bool sane_ = true, floats_ = true, touches_ = false, heavy_ = false;
    scalar reach_[N] = {};
    uint64_t seen_ = ingot::state_hash_seed;
};
template <class S>
World<S> FigurePromises<S>::world_;
template <class S>
World<S> FigurePromises<S>::before_;
template <class S>
World<S> FigurePromises<S>::other_;

} }  // namespace fuzz
