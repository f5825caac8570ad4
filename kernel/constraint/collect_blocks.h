// SPDX-License-Identifier: MIT
// The manifolds of a block, collected lane by lane from records and tiles, before vectors work on them.
#pragma once

#include "contact.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // see lanes.h

namespace ingot { inline namespace INGOT_ABI {

/// Numbers that are collected lane by lane, before vectors work on them.
struct Collected {
    CollectedBodies A, B;
    scalar n[3][lanes], P[block_rows][3][lanes], used[block_rows][lanes], separation[block_rows][lanes];
};

/// Collects the bodies of a block. Body 0 of the solver cannot move: it is all zero here too. Between two of them there is nothing to
/// solve, and the lane is left as if it had no points.
void collect(const SolverView& solver, const BodyView& bodies, ContactBlock& block, Collected& in);

/// The same of bodies without joints. Two balls that come from apart are seen where they meet within the step, as they fly, or are nearest to each
/// other: with the normal and the levers of that moment. So an impulse that acts then goes through both centres, and friction acts on both where they
/// touch, which changes no angular momentum: with those of the begin of the step, a glancing blow at 10 m/s and 60 Hz was off by a tenth. Along that
/// normal the plane of the row touches no more than the ball: those that pass each other do not feel it.
/// Cost: three comparisons a manifold; of balls that are apart 20 flops, and where they fly towards each other 80 and two square roots more.
void collect_free(const SolverView& solver, const BodyView& bodies, ContactBlock& block, Collected& in);

/// What the rows of a block are made of.
template <class Contacts, class View>
INGOT_INLINE Contacts vectors_of(const View& solver, const ContactBlock& block, const Collected& in) {
    const int rows = View::points_max == 1 ? 1 : block.rows;
    Contacts contacts;
    contacts.response.A = in.A.loaded();
    contacts.response.B = in.B.loaded();
    contacts.response.inv_M = contacts.response.A.inv_M + contacts.response.B.inv_M;
    contacts.n = load(in.n);
    tangents(contacts.n, contacts.t_1, contacts.t_2);
    for (int row = 0; row < rows; ++row) {  // bound: 4: block_rows
        contacts.P[row] = load(in.P[row]);
        contacts.used[row] = load(in.used[row]);
        contacts.separation[row] = load(in.separation[row]);
    }
    find_middle<View::points_max>(contacts, rows, scale_of(solver, block) * splat<lane>(limits::contact_margin));
    return contacts;
}

} }  // namespace ingot

#pragma GCC diagnostic pop
