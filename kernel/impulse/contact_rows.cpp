// SPDX-License-Identifier: MIT
#include "contact_rows.h"

#include "../base/checks.h"
#include "../base/limits.h"
#include "../body/kinematic_motion.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

using Motion = BodyMotionNow;

Motion motion_of(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    return {lane_of(bodies.translation[at.tile].v_CM, at.lane), lane_of(bodies.rotation[at.tile].L, at.lane)};
}

void set_motion(const BodyView& bodies, int slot, const Motion& motion, bool turned) {
    const Place at = place_of(slot);
    set_lane(bodies.translation[at.tile].v_CM, at.lane, motion.v_CM);
    if (!turned) return;  // a central impulse leaves L, and the free flight that hangs on it, alone
    RotationTile& tile = bodies.rotation[at.tile];
    set_lane(tile.L, at.lane, motion.L);
    tile.kicked = static_cast<uint16_t>(tile.kicked | (1u << at.lane));
}

scalar inv_M_of(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    return bodies.translation[at.tile].inv_M[at.lane];
}

/// Nothing where it cannot move: an impulse out of the range is nothing to it.
void mark_bad_body(const BodyView& bodies, int slot) {
    if (!(inv_M_of(bodies, slot) > 0)) return;
    const Place at = place_of(slot);
    uint16_t& bad = bodies.rotation[at.tile].bad;
    bad = static_cast<uint16_t>(bad | (1u << at.lane));
}

SymmetricMatrix inv_I_world_of(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    return lane_of(bodies.translation[at.tile].inv_I_world, at.lane);
}

scalar magnitude_of(const Vector& a, const Vector& b) { return abs(a.x * b.x) + abs(a.y * b.y) + abs(a.z * b.z); }

}  // namespace

template <bool sees_kinematic>
void prepare_contact_row(Contact& c, const BodyView& bodies) {
    const scalar inv_M_A = inv_M_of(bodies, c.body_A), inv_M_B = inv_M_of(bodies, c.body_B);
    [[maybe_unused]] const Vector lever_A = c.lever_A, lever_B = c.lever_B;
    if (!(inv_M_A > 0)) c.lever_A = {};
    if (!(inv_M_B > 0)) c.lever_B = {};
    c.k_A = inv_I_world_of(bodies, c.body_A) * c.lever_A;
    c.k_B = inv_I_world_of(bodies, c.body_B) * c.lever_B;
    c.inv_K = 1 / (length_sq(c.n) * (inv_M_A + inv_M_B) + dot(c.k_A, c.lever_A) + dot(c.k_B, c.lever_B));
    // Of a corner that is followed through very many turns the compliance may leave the range: it takes all but no impulse then.
    if (!(c.inv_K > 0)) c.inv_K = epsilon * epsilon * epsilon * epsilon;
    if constexpr (sees_kinematic) {
        if (shows_kinematic_motion(bodies, c.body_A)) c.k_A = -lever_A;
        if (shows_kinematic_motion(bodies, c.body_B)) c.k_B = -lever_B;
    }
    c.active = false;
    c.tolerance = c.j = 0;
}

// The linker takes the one that the scene calls.
template void prepare_contact_row<false>(Contact&, const BodyView&);
template void prepare_contact_row<true>(Contact&, const BodyView&);

int manifold_end(const ContactView& contacts, int first) {
    const Contact& c = contacts.contacts[first];
    int end = first + 1;
    // bound: max_contacts: ++end
    while (end < *contacts.count && contacts.contacts[end].body_A == c.body_A && contacts.contacts[end].body_B == c.body_B) ++end;
    return end;
}

namespace {

INGOT_SHARED NormalSpeed speed_of(const Contact& c, const Motion& A, const Motion& B) {
    const scalar u = dot(c.n, A.v_CM - B.v_CM) + dot(A.L, c.k_A) - dot(B.L, c.k_B);
    return {u, magnitude_of(c.n, A.v_CM) + magnitude_of(c.n, B.v_CM) + magnitude_of(A.L, c.k_A) + magnitude_of(B.L, c.k_B)};
}

}  // namespace

NormalSpeed normal_speed(const Contact& c, const BodyView& bodies) {
    return speed_of(c, motion_of(bodies, c.body_A), motion_of(bodies, c.body_B));
}
NormalSpeed normal_speed(const Contact& c, const Motion& A, const Motion& B) { return speed_of(c, A, B); }

scalar tolerance_of(const Contact& c, const NormalSpeed& speed) {
    const scalar rounding = limits::contact_roundings * epsilon * speed.magnitude;
    return rounding > c.tolerance ? rounding : c.tolerance;
}

bool apply_impulse(const Contact& c, scalar j, const BodyView& bodies) {
    Motion A = motion_of(bodies, c.body_A), B = motion_of(bodies, c.body_B);
    A.v_CM += c.n * (j * inv_M_of(bodies, c.body_A));
    A.L += c.lever_A * j;
    B.v_CM -= c.n * (j * inv_M_of(bodies, c.body_B));
    B.L -= c.lever_B * j;
    const bool good_A = is_finite(A.v_CM) && is_finite(A.L), good_B = is_finite(B.v_CM) && is_finite(B.L);
    if (!good_A) mark_bad_body(bodies, c.body_A);
    if (!good_B) mark_bad_body(bodies, c.body_B);
    if (!good_A || !good_B) return false;
    set_motion(bodies, c.body_A, A, length_sq(c.lever_A) > 0);
    set_motion(bodies, c.body_B, B, length_sq(c.lever_B) > 0);
    return true;
}

void take_back(const Contact& c, scalar j, scalar t, const BodyView& bodies) {
    if (!(t > 0)) return;
    const auto move = [&](int slot, scalar by) {
        const Place at = place_of(slot);
        const Vector r = r_CM_of(bodies, slot) - c.n * (by * inv_M_of(bodies, slot) * t);
        constexpr scalar most = limits::position_max;
        if (!(abs(r.x) <= most && abs(r.y) <= most && abs(r.z) <= most)) return mark_bad_body(bodies, slot);
        set_lane(bodies.translation[at.tile].r_CM, at.lane, r);
    };
    move(c.body_A, j);
    move(c.body_B, -j);
}

namespace {

/// One Gauss-Seidel visit: j becomes what makes n.(v_AP - v_BP) the target, or 0 where that would pull. Returns: true if the row
/// was off by more than slack times its tolerance.
bool visit(Contact& c, scalar slack, const BodyView& bodies) {
    c.change = 0;
    ++c.visits;
    const scalar missing = c.target - normal_speed(c, bodies).u;
    if (abs(missing) <= c.tolerance * slack && c.j >= 0) return false;
    const scalar wanted = c.j + missing * c.inv_K;
    const scalar j = wanted > 0 ? wanted : 0;
    if (j == c.j) return false;
    if (!apply_impulse(c, j - c.j, bodies)) {
        c.active = false;
        if (!(c.j > 0)) c.j = 0;  // gone on too far, and the body is past taking it back
        return false;
    }
    INGOT_ASSERT(j >= 0);
    c.change = j - c.j;
    c.j = j;
    return true;
}

/// Goes on by beta in the direction of the sweeps before; the next visit takes back what went too far.
void extrapolate(Contact& c, scalar beta, const BodyView& bodies) {
    c.direction = c.change + beta * c.direction;
    const scalar further = beta * c.direction;
    if (further != 0 && apply_impulse(c, further, bodies)) c.j += further;
}

/// Sweeps over the contacts of one pair, joined by conjugate gradients, until they agree. Returns: the sweeps it took; 1 when
/// they agreed already. `kept`: visits that contacts after it need in this sweep.
template <class Left>
int settle_manifold(Contact* first, int count, scalar slack, const BodyView& bodies, Left& left, int kept) {
    // bound: max_contacts: those of one pair: of a box up to its 8 corners, and where impulses are read a corner may have several
    for (int contact_i = 0; contact_i < count; ++contact_i) first[contact_i].direction = 0;
    scalar size_before = 0, beta = 0;
    for (int sweep_i = 1; sweep_i <= limits::contact_sweeps_max && (sweep_i == 1 ? left.take(count) : left.take_spare(count, kept)); ++sweep_i) {
        // Only where a visit follows: what goes too far may pull. One contact is exact after one visit.
        for (int contact_i = 0; contact_i < count && sweep_i > 1 && count > 1; ++contact_i)
            if (first[contact_i].active) extrapolate(first[contact_i], beta, bodies);
        if (sweep_i > limits::contact_sweeps_max / 4) slack = limits::contact_slack;
        bool settled = true;
        scalar size = 0;  // of the sweep, in units of energy
        for (int contact_i = 0; contact_i < count; ++contact_i) {
            if (!first[contact_i].active) continue;
            if (visit(first[contact_i], slack, bodies)) settled = false;
            size += first[contact_i].change * first[contact_i].change / first[contact_i].inv_K;
        }
        if (settled) return sweep_i;
        beta = size_before > 0 && size <= size_before ? size / size_before : 0;  // 0 too when squares underflow
        size_before = size;
    }
    return limits::contact_sweeps_max + 1;
}

}  // namespace

template <class Left>
SweepOutcome solve_active_contacts(const ContactView& contacts, const BodyView& bodies, Left& left) {
    for (int contact_i = 0; contact_i < *contacts.count; ++contact_i) contacts.contacts[contact_i].j = 0;  // bound: max_contacts
    int sweeps = 0;
    for (int sweep_i = 0; sweep_i < limits::contact_sweeps_max && left.some(); ++sweep_i) {
        const scalar slack = slack_after(sweep_i);
        bool settled = true;
        // bound: max_contacts: end is after first: each pair has a contact
        for (int first = 0, end = 0; first < *contacts.count; first = end) {
            end = manifold_end(contacts, first);
            if (settle_manifold(&contacts.contacts[first], end - first, slack, bodies, left, *contacts.count - end) > 1) settled = false;
        }
        ++sweeps;
        if (settled) return {sweeps, true};
    }
    return {sweeps, false};
}

// The linker takes the one that the scene calls.
template SweepOutcome solve_active_contacts(const ContactView&, const BodyView&, AnyVisits&);
template SweepOutcome solve_active_contacts(const ContactView&, const BodyView&, VisitsLeft&);

} }  // namespace ingot
