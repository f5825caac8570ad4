// SPDX-License-Identifier: MIT
#include "surface.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

bool can_move(const BodyView& bodies, int slot) {
    const Place at = place_of(slot);
    return bodies.translation[at.tile].inv_M[at.lane] > 0;
}

/// The face of a half space in the world: all points with n . r <= d.
struct Face {
    Vector n;
    scalar d;
};

Face face_of(const BodyView& bodies, const SurfaceView& surfaces, int slot) {
    const Place at = place_of(slot);
    const Shape& shape = surfaces.surfaces[slot].shape;
    const Vector n = lane_of(bodies.rotation[at.tile].A, at.lane) * shape.size;
    return {n, dot(n, r_CM_of(bodies, slot)) + shape.offset};
}

/// Whether the sphere about a body may touch a face on its way.
bool reaches(const Face& face, const BodyView& bodies, int slot, scalar radius, const Ways& ways) {
    const scalar gap = dot(face.n, r_CM_of(bodies, slot)) - face.d - radius * (1 + limits::flatness);
    if (!(gap <= ways.most)) return false;
    return !(ways.most > 0) || gap <= max(-dot(face.n, v_CM_of(bodies, slot)) * ways.h, scalar(0)) + ways.fall;
}

/// next_touchable for a half space.
int next_at_face(const BodyView& bodies, const SurfaceView& surfaces, const Ways& ways, const Face& face, int from) {
    for (int slot_B = from; slot_B < surfaces.slot_count; ++slot_B) {  // bound: max_bodies
        const Surface& B = surfaces.surfaces[slot_B];
        if (B.shape.kind == ShapeKind::none || B.shape.kind == ShapeKind::half_space) continue;
        if (reaches(face, bodies, slot_B, B.bounding_radius, ways) && can_move(bodies, slot_B)) return slot_B;
    }
    return surfaces.slot_count;
}

}  // namespace

int next_touchable(const BodyView& bodies, const SurfaceView& surfaces, const Ways& ways, int slot_A, int from) {
    const Surface& A = surfaces.surfaces[slot_A];
    if (A.shape.kind == ShapeKind::none) return surfaces.slot_count;
    if (A.shape.kind == ShapeKind::half_space) return next_at_face(bodies, surfaces, ways, face_of(bodies, surfaces, slot_A), from);

    const bool A_moves = can_move(bodies, slot_A);
    const Vector r_A = r_CM_of(bodies, slot_A);
    for (int slot_B = from; slot_B < surfaces.slot_count; ++slot_B) {
        const Surface& B = surfaces.surfaces[slot_B];
        if (B.shape.kind == ShapeKind::half_space) {
            if (A_moves && reaches(face_of(bodies, surfaces, slot_B), bodies, slot_A, A.bounding_radius, ways)) return slot_B;
            continue;
        }
        const Vector r_B = r_CM_of(bodies, slot_B);
        const scalar touch = (A.bounding_radius + B.bounding_radius) * (1 + limits::flatness), reach = touch + ways.most;
        const scalar dx = r_A.x - r_B.x;
        if (abs(dx) > reach) continue;
        const scalar dy = r_A.y - r_B.y, dz = r_A.z - r_B.z;
        const scalar distance_sq = dx * dx + dy * dy + dz * dz;
        if (!(distance_sq <= reach * reach)) continue;
        if (ways.most > 0) {  // near enough for the fastest bodies: for these two?
            const Vector v = v_CM_of(bodies, slot_A) - v_CM_of(bodies, slot_B);
            const scalar own = touch + ways.fall + (abs(v.x) + abs(v.y) + abs(v.z)) * ways.h;
            if (!(distance_sq <= own * own)) continue;
        }
        if (B.shape.kind != ShapeKind::none && (A_moves || can_move(bodies, slot_B))) return slot_B;
    }
    return surfaces.slot_count;
}

} }  // namespace ingot
