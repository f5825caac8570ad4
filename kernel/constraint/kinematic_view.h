// SPDX-License-Identifier: MIT
// What the solver works on in scenes with kinematic bodies.
//
// A contact with one sees a solver body of its own in its place: infinitely heavy, and moving as the partner would if it were stuck to the kinematic
// body. With R from the centre of the kinematic body to that of its partner, r_P and J = r_P x d of the partner, and u = v + omega x R,
//
//     d . (v_A - v_kinematic at P) + L_A . k_A  =  d . (v_A - u) + L_A . k_A - omega . J_A
//
// so a row reads v_CM = u and L = omega of that body by its k = -J of the partner; its own J and inverse mass are 0, and it is never changed. u is
// taken along with the turn of each substep: what stands still on a turntable stands still to rounding, for all its points at once.
#pragma once

#include "../body/kinematic_motion.h"
#include "material_view.h"

namespace ingot { inline namespace INGOT_ABI {

/// A contact of a body with a kinematic one.
struct KinematicContact {
    Vector v_CM, omega;  ///< m/s, rad/s, of the kinematic body as the substep begins
    Vector a, alpha;     ///< m s^-2, rad s^-2; 0 but for bodies on the way from goal to goal
    Vector begin;        ///< m, from its centre to that of the partner as the step begins
    Vector R;            ///< m, the same as the substep begins
    Vector way;          ///< m, of its centre since the step began
    Index position;   ///< of the manifold in the blocks: see manifold_at
    Index partner;    ///< of SolverBody
    Index is_A;       ///< 1: the kinematic body is A of the manifold; 0: B
    Index unused;     ///< no gap
};

/// Those of the batch at hand. The solver body of contact i is body_begin + i.
struct KinematicContacts {
    KinematicContact* contacts;      ///< room for a manifold each
    const KinematicBody* of_slots;   ///< how bodies move; null: evenly
    int body_begin, count;
};

/// View: any other.
template <class View>
struct KinematicViewOf : View {
    using PlainView = View;
    KinematicContacts kinematic;
};

template <class View>
inline constexpr bool sees_kinematic = false;
template <class View>
inline constexpr bool sees_kinematic<KinematicViewOf<View>> = true;

template <class View>
struct PlainOf {
    using Type = View;
};
template <class View>
struct PlainOf<KinematicViewOf<View>> {
    using Type = View;
};
/// The view for stages that need not know which bodies are kinematic.
template <class View>
using PlainViewOf = typename PlainOf<View>::Type;

} }  // namespace ingot
