// SPDX-License-Identifier: MIT
#include "bounds.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

Vector r_CM_of(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    return lane_of(bodies.translation[at.tile].r_CM, at.lane);
}

bool can_move(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    return bodies.translation[at.tile].inv_M[at.lane] > 0;
}

bool sphere_meets_half_space(const BodyView& bodies, const SurfaceView& surfaces, int sphere, int half_space, scalar margin) {
    const Place at = place_of(half_space);
    const Shape& shape = surfaces.surfaces[half_space].shape;
    const Vector n = lane_of(bodies.rotation[at.tile].A, at.lane) * shape.size;
    const scalar height = dot(n, r_CM_of(bodies, sphere) - r_CM_of(bodies, half_space)) - shape.offset;
    return height <= surfaces.surfaces[sphere].bounding_radius * (1 + limits::flatness) + margin;
}

}  // namespace

bool may_touch(const BodyView& bodies, const SurfaceView& surfaces, int slot_A, int slot_B) {
    return may_touch(bodies, surfaces, slot_A, slot_B, 0);
}

bool may_touch(const BodyView& bodies, const SurfaceView& surfaces, int slot_A, int slot_B, scalar margin) {
    const Surface &A = surfaces.surfaces[slot_A], &B = surfaces.surfaces[slot_B];
    if (A.shape.kind == ShapeKind::none || B.shape.kind == ShapeKind::none) return false;
    if (!can_move(bodies, slot_A) && !can_move(bodies, slot_B)) return false;
    if (A.shape.kind == ShapeKind::half_space) return sphere_meets_half_space(bodies, surfaces, slot_B, slot_A, margin);
    if (B.shape.kind == ShapeKind::half_space) return sphere_meets_half_space(bodies, surfaces, slot_A, slot_B, margin);

    const Vector r_A = r_CM_of(bodies, slot_A), r_B = r_CM_of(bodies, slot_B);
    const scalar reach = (A.bounding_radius + B.bounding_radius) * (1 + limits::flatness) + margin;
    const scalar dx = r_A.x - r_B.x;
    if (abs(dx) > reach) return false;
    const scalar dy = r_A.y - r_B.y, dz = r_A.z - r_B.z;
    return dx * dx + dy * dy + dz * dz <= reach * reach;
}

} }  // namespace ingot
