// SPDX-License-Identifier: MIT
#pragma once

#include "collide_shapes.h"
#include "manifold.h"

namespace ingot { inline namespace INGOT_ABI {

void collide_sphere_sphere(const Placed& A, const Placed& B, scalar margin, Manifold& manifold);
void collide_sphere_box(const Placed& A, const Placed& B, scalar margin, Manifold& manifold);
void collide_sphere_half_space(const Placed& A, const Placed& B, scalar margin, Manifold& manifold);
void collide_box_half_space(const Placed& A, const Placed& B, scalar margin, Manifold& manifold);
void collide_box_box(const Placed& A, const Placed& B, scalar margin, Manifold& manifold);

} }  // namespace ingot
