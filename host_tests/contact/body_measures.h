// SPDX-License-Identifier: MIT
// Spin, energy and overlap of bodies as they stand, in double and apart from the kernel's collision code. A library of its own: what it is made of
// takes longer to compile than a scene.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "scenes/contact/placed_body.h"

namespace ingot_contact {

/// rad/s, world.
Eigen::Vector3d omega_of(const scenes::PlacedBody& body);

/// J; 0 of one that does not move.
double kinetic_energy_of(const scenes::PlacedBody& body);

/// By the faces and centres that keep two bodies apart, m; not positive: apart.
double overlap_by_faces(const scenes::PlacedBody& A, const scenes::PlacedBody& B);

/// The same, boxes by the oracle of the narrow phase, which knows the axes of edges too, m.
double overlap_of(const scenes::PlacedBody& A, const scenes::PlacedBody& B);

/// Overlaps of pairs that overlap and of which one can move, m. Cost: all pairs.
std::vector<double> overlaps_of(const std::vector<scenes::PlacedBody>& bodies);

}  // namespace ingot_contact
