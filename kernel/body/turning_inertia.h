// SPDX-License-Identifier: MIT
// A body that turns shows impulses another inertia from substep to substep. Where that is left out, its contacts give energy: a box with e = 1 in a
// closed room had four thousand times its energy after 20 s.
#pragma once

#include "../math/rotation.h"
#include "../math/sym3.h"

namespace ingot { inline namespace INGOT_ABI {

/// True where a turn, rad, changes the inertia: by more than limits::inertia_turn, as the energy feels it. Never for a body that is the same about
/// all axes. inv_I_ratio: of its inverse moments, the largest 1.
bool turns_inertia(const Vector& inv_I_ratio, const Vector& turn);

/// Turns A as a free body with this L does in h seconds, to second order in parts of limits::turn_of_part. Its energy stays what it is to rounding:
/// see return_energy. Returns the turn, rad in world axes. Cost: about 700 flops a part.
Vector turn_freely(Matrix& A, const Vector& inv_I_body, const Vector& L, scalar h);

/// A turned by a vector, rad in world axes, as a rotation however far (Cayley's formula: by an angle that is short by its cube / 12).
Matrix turned_about(const Matrix& A, const Vector& turn);

/// Turns A until a body with this L has an energy of twice_energy / 2, J, again. The turn is about omega x L, along which the energy changes fastest
/// and L does not, and tiny where only the error of an integration is to be taken back. Returns A itself where it has that energy already.
/// Source: as the energy return of MoserVeselov, in full at once; the idea is that of Buss 2000.
Matrix return_energy(const Matrix& A, const Vector& inv_I_body, const Vector& L, scalar twice_energy);

} }  // namespace ingot
