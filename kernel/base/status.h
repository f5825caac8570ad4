// SPDX-License-Identifier: MIT
#pragma once

#include "config.h"

namespace ingot { inline namespace INGOT_ABI {

/// Answer of every call that can be refused. A refused call has left the world bitwise unchanged.
enum class [[nodiscard]] Status : uint8_t {
    ok = 0,
    no_room,            ///< the array is full; raise the capacity the scene names
    stale_id,           ///< no living body has this id: null, removed, or never given out
    foreign_id,         ///< the id carries the tag of another world
    not_finite,         ///< NaN or infinity
    out_of_range,       ///< beyond base/limits.h
    bad_mass,           ///< mass zero, negative, or beyond limits::mass_min .. mass_max
    bad_inertia,        ///< no solid has these moments: not positive, or I1 + I2 < I3
    not_a_rotation,     ///< A^T A is further from 1 than limits::orthogonality, or det A < 0
    bad_direction,      ///< a normal or axis that is not of unit length
    bad_restitution,    ///< outside 0 .. 1
    bad_shape,          ///< a radius or extent that is not positive, a mesh that is not closed
    not_in_scene,       ///< the scene names no such shape, or does not translate
    immovable,          ///< the call needs a body that can move
    frozen,             ///< the body was driven out of range and stands still until it is removed
    bad_step,           ///< h outside limits::step_min .. step_max
    not_empty,          ///< the call is for a world to which no body was ever added
    not_converged,      ///< an iteration stopped at its bound
    wrong_rounding,     ///< check_floating_point: not to nearest, or products not rounded before they are added
    flushes_denormals,  ///< check_floating_point: the unit takes small numbers for zero
};

/// A value, or the reason why there is none (the value is then all zero).
template <class T>
struct [[nodiscard]] Result {
    Status status;
    T value;

    constexpr bool ok() const { return status == Status::ok; }
};

} }  // namespace ingot
