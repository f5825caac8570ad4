// SPDX-License-Identifier: MIT
// Contacts that no array has room for: a plain impulse before the step and one after it keep bodies from falling through each other.
#pragma once

#include "../body/body_tiles.h"
#include "contact.h"

namespace ingot { inline namespace INGOT_ABI {

/// Where two bodies touch, or nearly do.
struct TouchPoints {
    static constexpr int points_max = 8;
    Vector n{};                       ///< unit, from B to A
    int count = 0;
    Vector P[points_max]{};           ///< m, world
    scalar separation[points_max]{};  ///< m, along n
    scalar mu = 0;                    ///< coefficient of friction
};

/// The step that they are held in.
struct HeldStep {
    BodyView bodies;
    scalar h;     ///< s
    scalar push;  ///< m, that two bodies that can both move are moved apart by, at most; 0: nobody takes back overlap that was there before
    bool is_over;  ///< bodies have been moved
};

/// Of the two, one cannot move.
inline bool meets_fixed(const BodyView& bodies, int A, int B) { return !is_dynamic(bodies, A) || !is_dynamic(bodies, B); }

/// Before a step, what would come further than the points are apart is stopped there: by impulses of Fig. 4 with e = 0, one at the middle of the
/// points, so that what lies flat gets no spin, and one at each; and friction at the middle, as far as mu times what was given along n.
///
/// After it, what approaches is stopped in the same way, and overlap is taken back: all of it where one of them cannot move; else
/// limits::position_share as far as `push` allows, and no less than what a force that stops them would have spared them. Friction counts as such a
/// force too: so what rests stays where it is, on a slope as well.
///
/// Impulses are equal and opposite, and none adds energy: each makes two points rest on each other.
/// Needs:   body slots. A body that cannot move keeps still; a kinematic one shows how it moves.
/// Errors:  a body whose motion would not be finite is marked bad.
/// Returns: the deepest separation there was, m.
scalar hold_apart(const HeldStep& step, int A, int B, const TouchPoints& points);

/// Moves two bodies apart along n, from B to A, by so much, m, each as far as it is light. Not where that is below zero.
void push_out(const HeldStep& step, int A, int B, const Vector& n, scalar way);

/// Points of a pair that the array of a scene of impacts without friction holds. Cost: a look at all of it.
int kept_contacts(const ContactView& contacts, int body_A, int body_B);

/// Contacts of one pair as hold_apart sees them: a lever says where P is but for what lies along n.
TouchPoints touch_points(const BodyView& bodies, const Contact* contacts, int count);

} }  // namespace ingot
