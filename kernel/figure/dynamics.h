// SPDX-License-Identifier: MIT
// The equations of motion of a figure, to ask and not to step: which torques go with which accelerations, what holds it against gravity, what a force
// on a body is at its joints.
//
//     M(q) a + bias = torques          a, torques: one number for each free direction of each joint, and six for the root of what floats
//
// A figure is read from a world into memory of the user's, once between two steps; the calls then work on that alone.
//
// Sources: Featherstone 2008, chapters 5 (recursive Newton-Euler), 6 (composite rigid bodies), 7 (articulated bodies); virtual forces by the
// transposed Jacobian: Pratt 1995; Coros, Beaudoin, van de Panne 2010.
#pragma once

#include "../base/status.h"
#include "../joint/joints.h"
#include "spatial.h"

namespace ingot { inline namespace INGOT_ABI {

/// Which numbers of accelerations, torques and of the mass matrix are of a joint.
struct JointDirections {
    int first{};  ///< its number 0; the others follow
    int count{};  ///< 0 of a fixed joint, 1, 2, or 3
};

/// A body of a figure, and its joint towards the root. Its parent comes before it. Twists and loads are taken at its centre of mass; velocities are
/// those against the centre of mass of the root, or of what the figure is tied to: so speed that all have in common costs no digits.
struct DynamicsBody {
    BodyId body;
    JointId joint;  ///< null: the root of what floats
    int parent;     ///< below zero: the root
    int first;      ///< of its directions
    int count;
    bool is_A;              ///< of its joint
    Vector r, d;            ///< m: its centre of mass, and that seen from its parent's
    scalar M;               ///< kg
    SymmetricMatrix I;      ///< kg m^2, world
    Vector weight;          ///< N
    Spatial<scalar> held;   ///< N m, N: forces of the next step
    Spatial<scalar> s[3];   ///< free directions, of it against its parent, for rates of B against A
    scalar rate[3];         ///< rad/s, m/s
    Spatial<scalar> twist;  ///< rad/s, m/s
    Spatial<scalar> drift;  ///< rad/s^2, m/s^2: of its twist against its parent's at steady rates
    // Of the call at hand.
    Spatial<scalar> change;     ///< rad/s^2, m/s^2: of its twist in a second
    Spatial<scalar> load;       ///< N m, N: what its joint gives it
    Spatial6<scalar> inertia;   ///< with all that hangs on it: see Dynamics::inertias
    Spatial<scalar> pulled[3];  ///< see tree_passes.h
    scalar inv_D[3];
};

/// What `DynamicsBody::inertia` is: nothing yet; as if all joints were locked; as if they all were free.
enum class DynamicsInertias : uint8_t { none, composite, articulated };

/// How much of a figure there is. All zero: nothing was read.
struct DynamicsSize {
    int body_count;
    int direction_count;
    bool floats;
    DynamicsInertias inertias;
    Vector v;  ///< m/s: of the centre of mass that velocities are against
};
/// A figure without its capacity.
struct Dynamics {
    DynamicsBody* bodies;
    int capacity;
    DynamicsSize& size;
};

// All arrays of numbers are direction_count long. See FigureDynamics.
void direction_rates(const Dynamics& of, scalar* rates);
void inverse_dynamics(const Dynamics& of, const scalar* accelerations, scalar* torques);
void gravity_torques(const Dynamics& of, scalar* torques);
void transpose_torques(const Dynamics& of, int body_i, int up_to_i, const Vector& P, const Vector& F, const Vector& tau, scalar* torques);
void mass_matrix(const Dynamics& of, scalar* matrix);
scalar effective_inertia(const Dynamics& of, int direction_i);

/// The dynamics of a figure of up to so many bodies, between two steps: read it with World::read_dynamics, then ask.
///
///     static ingot::FigureDynamics<7> arm;                             // fixed memory: of floats 470 bytes a body
///     if (world.read_dynamics(hand, arm) != Status::ok) return;
///     scalar wanted[6] = {...}, torques[6];                            // arm.direction_count() of them
///     (void)arm.inverse_dynamics(wanted, torques, 6);
///
/// Its numbers. A figure that floats begins with six of its root, the body that it was read by: of accelerations those of the centre of mass,
/// m/s^2, then the angular ones, rad/s^2; of torques the force there, N, and the torque, N m; all in world axes. Then come the free directions of its
/// joints, as directions_of tells: B against A, in the order of `which` of World::joint_rate: the angle of a hinge; the travel of a slider; of a
/// universal joint the angles about the axis of A and of B; of a wheel spin, travel and steering; of a ball joint its three turns in the axes of A,
/// as in World::ball_torque. Units rad/s^2 and N m, of travels m/s^2 and N. So a torque is what JointDrive::feedforward takes.
///
/// Counted are gravity, with the shares of bodies, forces that are held for the next step, velocities, and the motion of a kinematic body that the
/// figure is tied to. Outside, as World does not know what they will give before it steps: contacts, limits, drives, ropes, targets, force fields and
/// damping; add what you know of them to the torques, see transpose_torques.
///
/// Nothing here changes a world. What was read is of the moment: after a step, or an edit, read it again.
template <int max_bodies>
class FigureDynamics {
    static_assert(max_bodies >= 1, "a figure is of one body or more");

public:
    int body_count() const { return size_.body_count; }            ///< 0: nothing was read, or it was refused
    int direction_count() const { return size_.direction_count; }  ///< how long arrays of accelerations and torques are
    bool floats() const { return size_.floats; }                   ///< tied to nothing: the first six numbers are of its root

    /// The null id: it has not so many. Body 0 is the root, and a body comes after the one that its joint leads to.
    BodyId body(int body_i) const { return has(body_i) ? bodies_[body_i].body : BodyId{}; }
    /// Of a body, towards the root; the null id: none.
    JointId joint(int body_i) const { return has(body_i) ? bodies_[body_i].joint : JointId{}; }

    /// Errors: stale_id: the figure, as it was read, has no such joint. Cost: a look at each joint.
    Result<JointDirections> directions_of(JointId id) const {
        for (int i = 0; i < size_.body_count; ++i)  // bound: max_bodies
            if (bodies_[i].joint == id && id != JointId{}) return {Status::ok, {bodies_[i].first, bodies_[i].count}};
        return {Status::stale_id, {}};
    }

    /// How fast each of its numbers goes, rad/s, m/s: of a root that floats v_CM and omega, of joints as World::joint_rate and joint_speed tell.
    /// Errors: out_of_range (count is not direction_count()).
    Status direction_rates(scalar* rates, int count) {
        if (!fits(count)) return Status::out_of_range;
        ingot::direction_rates(view(), rates);
        return Status::ok;
    }
    /// The torques with which the figure would accelerate so: M a + bias. For accelerations of 0 they are the bias: what velocities, gravity and
    /// held forces ask for.
    /// Errors: out_of_range (count is not direction_count()), not_finite. Cost, on x86-64: 290 instructions a body.
    Status inverse_dynamics(const scalar* accelerations, scalar* torques, int count) {
        if (!fits(count)) return Status::out_of_range;
        for (int i = 0; i < count; ++i)  // bound: direction_count
            if (!is_finite(accelerations[i])) return Status::not_finite;
        ingot::inverse_dynamics(view(), accelerations, torques);
        return Status::ok;
    }
    /// The torques that hold the figure as it is against gravity alone, at rest.
    /// Errors: out_of_range (count is not direction_count()). Cost: 95 instructions a body.
    Status gravity_torques(scalar* torques, int count) {
        if (!fits(count)) return Status::out_of_range;
        ingot::gravity_torques(view(), torques);
        return Status::ok;
    }
    /// The torques that do what a force F, N, at a point P of a body, m, world, and a torque tau, N m, on it would do: J^T (F, tau). Taken off the
    /// torques of inverse_dynamics, they leave a force that acts from without; added to them, joints press with it.
    /// up_to: a body between this one and the root, against which the force is meant: joints of that body and behind it get 0. The null id: the root.
    /// Errors: out_of_range (count is not direction_count(); up_to is not on the way), stale_id (the figure has no such body), not_finite.
    /// Cost: a look at each body, and 70 instructions for each on the way.
    Status transpose_torques(BodyId id, const Vector& P, const Vector& F, const Vector& tau, scalar* torques, int count, BodyId up_to = {}) {
        const int body_i = number_of(id), up_to_i = up_to == BodyId{} ? -1 : number_of(up_to);
        if (!fits(count)) return Status::out_of_range;
        if (body_i < 0 || (up_to != BodyId{} && up_to_i < 0)) return Status::stale_id;
        if (!is_finite(P) || !is_finite(F) || !is_finite(tau)) return Status::not_finite;
        int way_i = body_i;
        while (way_i != up_to_i && way_i >= 0) way_i = bodies_[way_i].parent;  // bound: max_bodies
        if (way_i != up_to_i) return Status::out_of_range;
        ingot::transpose_torques(view(), body_i, up_to_i, P, F, tau, torques);
        return Status::ok;
    }
    /// The mass matrix M, symmetric, row after row.
    /// Errors: out_of_range (count is not direction_count() squared).
    /// Cost: 480 instructions a body, and 76 for each two numbers of which one lies on the way of the other to the root; the others are 0.
    Status mass_matrix(scalar* matrix, int count) {
        if (size_.body_count == 0 || count != size_.direction_count * size_.direction_count) return Status::out_of_range;
        ingot::mass_matrix(view(), matrix);
        return Status::ok;
    }
    /// How heavy one of its numbers is, kg m^2 or kg, while all others are free to give way: 1 / (M^-1)_ii. It is what a TunedDrive is tuned for, but
    /// for that of a ball joint, which takes one for its three, and of the travel of a wheel.
    /// Errors: out_of_range (not 0 <= direction_i < direction_count()).
    /// Cost: 700 instructions a body the first time since it was read, or since its mass matrix was asked for; then 130 for each on the way.
    Result<scalar> effective_inertia(int direction_i) {
        if (direction_i < 0 || direction_i >= size_.direction_count) return {Status::out_of_range, 0};
        return {Status::ok, ingot::effective_inertia(view(), direction_i)};
    }

    /// For World::read_dynamics.
    Dynamics view() { return {bodies_, max_bodies, size_}; }

private:
    bool has(int body_i) const { return body_i >= 0 && body_i < size_.body_count; }
    bool fits(int count) const { return size_.body_count > 0 && count == size_.direction_count; }
    int number_of(BodyId id) const {
        for (int i = 0; i < size_.body_count; ++i)  // bound: max_bodies
            if (bodies_[i].body == id) return i;
        return -1;
    }

    DynamicsBody bodies_[static_cast<unsigned>(max_bodies)] = {};
    DynamicsSize size_ = {};
};

}}  // namespace ingot::INGOT_ABI
