// SPDX-License-Identifier: MIT
#pragma once

#include "config.h"

namespace ingot { inline namespace INGOT_ABI {

/// Answer of every call that can be refused. A refused call has left the world bitwise unchanged.
enum class [[nodiscard]] Status : uint8_t {
    ok = 0,
    no_room,            ///< an array is full: raise max_bodies, or max_shapes_of_body; of a snapshot, give snapshot_size bytes
    stale_id,           ///< no living body has this id: null, removed, or never given out
    foreign_id,         ///< the id carries the tag of another world
    not_finite,         ///< NaN or infinity
    out_of_range,       ///< beyond base/limits.h
    bad_mass,           ///< mass zero, negative, or beyond limits::mass_min .. mass_max
    bad_inertia,        ///< no solid has these moments: not positive, or I1 + I2 < I3
    not_a_rotation,     ///< A^T A is further from 1 than limits::orthogonality, or det A < 0
    bad_direction,      ///< a normal or axis that is not of unit length
    bad_restitution,    ///< outside 0 .. 1
    bad_friction,       ///< a coefficient outside 0 .. limits::friction_max
    bad_shape,          ///< a radius or extent that is not positive, a mesh that is not closed
    not_in_scene,       ///< the scene names no such shape, has no contacts to keep one for, or does not translate
    immovable,          ///< the call needs a body that can move
    frozen,             ///< the body was driven out of range and stands still until it is removed
    bad_step,           ///< h outside limits::step_min .. step_max
    not_empty,          ///< the call is for a world to which no body was ever added
    not_converged,      ///< an iteration stopped at its bound
    wrong_rounding,     ///< check_floating_point: not to nearest, or products not rounded before they are added
    flushes_denormals,  ///< check_floating_point: the unit takes small numbers for zero
    bad_snapshot,       ///< not a snapshot, not whole, damaged, or of a state that no world has
    other_version,      ///< a snapshot of another version of the kernel
    other_scene,        ///< a snapshot of a world of another scalar or scene
    bad_joint,          ///< a body with itself, axes that are not at right angles, limits the wrong way round; loops, of read_dynamics
};

/// A status in words, for people to read: its name, and what it says above. In flash where it is called.
constexpr const char* name(Status status) {
    switch (status) {
        case Status::ok: return "ok";
        case Status::no_room: return "no_room: an array is full: raise max_bodies, or max_shapes_of_body; of a snapshot, give snapshot_size bytes";
        case Status::stale_id: return "stale_id: no living body has this id: null, removed, or never given out";
        case Status::foreign_id: return "foreign_id: the id carries the tag of another world";
        case Status::not_finite: return "not_finite: NaN or infinity";
        case Status::out_of_range: return "out_of_range: beyond base/limits.h";
        case Status::bad_mass: return "bad_mass: mass zero, negative, or beyond limits::mass_min .. mass_max";
        case Status::bad_inertia: return "bad_inertia: no solid has these moments: not positive, or I1 + I2 < I3";
        case Status::not_a_rotation: return "not_a_rotation: A^T A is further from 1 than limits::orthogonality, or det A < 0";
        case Status::bad_direction: return "bad_direction: a normal or axis that is not of unit length";
        case Status::bad_restitution: return "bad_restitution: outside 0 .. 1";
        case Status::bad_friction: return "bad_friction: a coefficient outside 0 .. limits::friction_max";
        case Status::bad_shape: return "bad_shape: a radius or extent that is not positive, a mesh that is not closed";
        case Status::not_in_scene: return "not_in_scene: the scene names no such shape, has no contacts to keep one for, or does not translate";
        case Status::immovable: return "immovable: the call needs a body that can move";
        case Status::frozen: return "frozen: the body was driven out of range and stands still until it is removed";
        case Status::bad_step: return "bad_step: h outside limits::step_min .. step_max";
        case Status::not_empty: return "not_empty: the call is for a world to which no body was ever added";
        case Status::not_converged: return "not_converged: an iteration stopped at its bound";
        case Status::wrong_rounding: return "wrong_rounding: check_floating_point: not to nearest, or products not rounded before they are added";
        case Status::flushes_denormals: return "flushes_denormals: check_floating_point: the unit takes small numbers for zero";
        case Status::bad_snapshot: return "bad_snapshot: not a snapshot, not whole, damaged, or of a state that no world has";
        case Status::other_version: return "other_version: a snapshot of another version of the kernel";
        case Status::other_scene: return "other_scene: a snapshot of a world of another scalar or scene";
        case Status::bad_joint: return "bad_joint: a body with itself, axes that are not at right angles, limits the wrong way round";
    }
    return "no status";
}

/// A value, or the reason why there is none (the value is then all zero).
template <class T>
struct [[nodiscard]] Result {
    Status status{};  ///< ok, or why there is none
    T value{};        ///< all zero where there is none

    constexpr bool ok() const { return status == Status::ok; }  ///< there is a value
    /// The value, or this one where there is none: for who does not ask why.
    constexpr T value_or(const T& other) const { return ok() ? value : other; }
};

} }  // namespace ingot
