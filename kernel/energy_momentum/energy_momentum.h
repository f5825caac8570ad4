// SPDX-License-Identifier: MIT
// `using figure_motion = ingot::EnergyMomentum<>;` of a scene: how figures that touch nothing get from one state to the next.
//
// An implicit step whose unknowns are where all bodies of a figure are at its end. Joints push along the mean of their arms and axes at both ends of
// the step. So their work over it is the impulse times the change of what they lock, which is nothing where they hold at both ends: energy, momentum
// and angular momentum stay to rounding, at any step, tension and mass.
//
// Source: energy and momentum by discrete gradients, Gonzalez 1996, "Time integration and discrete Hamiltonian systems"; for bodies with joints
//         Betsch and Leyendecker 2006, "The discrete null space method for the energy consistent integration of constrained mechanical systems".
#pragma once

#include "../base/config.h"

namespace ingot { inline namespace INGOT_ABI {

/// What becomes of the energy of a snap, as when a slack chain is pulled taut: that of the motion which the joints do not allow.
enum class Snap : uint8_t {
    keep,  ///< it goes back to all that the joints do allow, as if nothing had been lost: energy stays to rounding
    lose,  ///< it is gone, as if it had become heat and sound: energy never grows
};

/// Figures move by the substeps that contacts are solved in, which gains and loses some energy: `figure_motion` of a scene that names none.
struct ArticulatedSubsteps {
    static constexpr bool is_implicit = false;
};

/// Figures that touch nothing move by the energy-momentum step; those that touch something, and those that close loops, by substeps. For chains, tops
/// and pendulums whose way matters; the step of a figure that spins fast, or snaps, is cut into up to eight.
///
/// order: 2, or 4: five steps for one, of which the third goes back in time (Suzuki 1990). For smooth motion in double, at 30 to 120 Hz.
/// Cost:  two to four passes a step, of about 700 flops a ball joint; of order 4 five times that. A step whose passes do not settle is cut, into
///        eighths at most; then the substeps take the figure: see StepReport::figures. Figures of one form that were added one after the other go
///        side by side, a lane each.
template <Snap snap_of_scene = Snap::keep, int order_of_scene = 2>
struct EnergyMomentum {
    static_assert(order_of_scene == 2 || order_of_scene == 4,
                  "the energy-momentum step has order 2, or 4 by composition: EnergyMomentum<Snap::keep, 4>");
    static constexpr bool is_implicit = true;
    static constexpr Snap snap = snap_of_scene;
    static constexpr int order = order_of_scene;  ///< of the error in h
};

} }  // namespace ingot
