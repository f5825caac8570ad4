// SPDX-License-Identifier: MIT
// A contact as a row on v_CM and L, and the sweep over rows that both solves share.
#pragma once

#include "../base/work_budget.h"
#include "../body/body_tiles.h"
#include "contact.h"

namespace ingot { inline namespace INGOT_ABI {

/// n.(v_AP - v_BP), m/s, and the sum of the magnitudes it is made of, which its rounding is relative to.
struct NormalSpeed {
    scalar u;
    scalar magnitude;
};

/// Fills k_A, k_B and inv_K = 1 / (n.n (inv_M_A + inv_M_B) + k_A.lever_A + k_B.lever_B) (Hecker 1997, Fig. 4).
/// n.n stands for the rounding of n: with it an elastic impact keeps the energy whatever the last bit of n.
/// sees_kinematic: of a kinematic body, whose tiles show L = -omega, the row reads omega.lever by k = -lever; it takes no impulse.
template <bool sees_kinematic>
void prepare_contact_row(Contact& contact, const BodyView& bodies);

/// Index after the last contact of the pair of bodies that the contact `first` belongs to: a pair's contacts stand together.
int manifold_end(const ContactView& contacts, int first);

/// The rounding of the row's speed, at the largest it was in this step: a ball that an impact has stopped keeps the rounding of
/// the speed it had.
scalar tolerance_of(const Contact& contact, const NormalSpeed& speed);

NormalSpeed normal_speed(const Contact& contact, const BodyView& bodies);
/// Of bodies that move like this.
struct BodyMotionNow {
    Vector v_CM, L;
};
NormalSpeed normal_speed(const Contact& contact, const BodyMotionNow& A, const BodyMotionNow& B);

/// A receives +j n, B receives -j n. Where that would not be finite nothing changes, the body
/// is marked bad, and the answer is false.
bool apply_impulse(const Contact& contact, scalar j, const BodyView& bodies);

/// In the tiles an impulse acts from the begin of the step: takes back the way that one of the time t has made by then. See impact_step.h.
/// A body that this would put beyond limits::position_max is marked bad where it is.
void take_back(const Contact& contact, scalar j, scalar t, const BodyView& bodies);

struct SweepOutcome {
    int sweeps;
    bool finished;
};

/// Of their tolerances, what rows may be off by after so many sweeps: those that rounding keeps from the last digit are taken as they are.
INGOT_INLINE scalar slack_after(int sweeps) {
    return sweeps < limits::contact_sweeps_max / 4 ? 1 : limits::contact_slack;
}

/// Finds j >= 0 for the active contacts together so that n.(v_AP - v_BP) >= target, with j = 0 where it is greater.
///
/// Gauss-Seidel over pairs of bodies, begun at j = 0, until no row is off by more than its tolerance. The contacts of a pair are
/// settled together, by sweeps that nonlinear conjugate gradients join (Silcowitz-Hansen, Niebe and Erleben 2010): a tall box on
/// its corners takes a tenth of the sweeps it takes without. Bodies that no contact connects do not change each other's bits.
/// Bound: limits::contact_sweeps_max sweeps over the pairs, and over the contacts of each; and the visits that are left. Left: VisitsLeft, or
/// AnyVisits.
template <class Left>
SweepOutcome solve_active_contacts(const ContactView& contacts, const BodyView& bodies, Left& left);

} }  // namespace ingot
