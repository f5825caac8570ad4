// SPDX-License-Identifier: MIT
#include "collide_shapes.h"

#include "../base/checks.h"
#include "../base/report.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Of the one rather than of the other there is no room.
bool gives_way(const BodyView* bodies, const Contact& a, const Contact& b) {
    const auto on_fixed = [bodies](const Contact& c) {
        return bodies != nullptr && (!is_dynamic(*bodies, c.body_A) || !is_dynamic(*bodies, c.body_B));
    };
    return on_fixed(a) == on_fixed(b) ? a.separation > b.separation : on_fixed(b);
}

}  // namespace

void ContactSink::add(const Vector& n, const Vector& lever_A, const Vector& lever_B, scalar separation) {
    INGOT_ASSERT(*contacts.count <= contacts.capacity);
    INGOT_ASSERT(slot_A != slot_B);
    int index = *contacts.count;
    if (index < contacts.capacity) {
        ++*contacts.count;
    } else {
        count(*lost);
        index = 0;
        // bound: max_contacts
        for (int contact_i = 1; contact_i < contacts.capacity; ++contact_i)
            if (gives_way(bodies, contacts.contacts[contact_i], contacts.contacts[index])) index = contact_i;
        Contact next{};
        next.body_A = static_cast<Index>(slot_A);
        next.body_B = static_cast<Index>(slot_B);
        next.separation = separation;
        if (!gives_way(bodies, contacts.contacts[index], next)) return;
    }
    Contact& contact = contacts.contacts[index];
    contact.body_A = static_cast<Index>(slot_A);
    contact.body_B = static_cast<Index>(slot_B);
    contact.n = n;
    contact.lever_A = lever_A;
    contact.lever_B = lever_B;
    contact.separation = separation;
    contact.e = e;
    contact.j_total = 0;
}

namespace {

/// A half space in the world: all points with n . r <= d.
struct WorldFace {
    Vector n;
    scalar d;
};

WorldFace face_of(const Placed& half_space) {
    const Vector n = half_space.A * half_space.shape.size;
    return {n, dot(n, half_space.r_CM) + half_space.shape.offset};
}

}  // namespace

void collide_sphere_sphere(const Placed& A, const Placed& B, ContactSink& sink) {
    const Vector d = A.r_CM - B.r_CM;
    const scalar distance = sqrt(length_sq(d)), reach = A.shape.size.x + B.shape.size.x;
    if (distance > reach * (1 + limits::flatness)) return;
    const Vector n = distance > epsilon * reach ? d * (1 / distance) : Vector{1, 0, 0};
    sink.add(n, {}, {}, distance - reach);
}

void collide_sphere_half_space(const Placed& A, const Placed& B, ContactSink& sink) {
    const WorldFace face = face_of(B);
    const scalar separation = dot(face.n, A.r_CM) - face.d - A.shape.size.x;
    if (separation <= limits::flatness * A.shape.size.x) sink.add(face.n, {}, {}, separation);
}

void collide_box_half_space(const Placed& A, const Placed& B, ContactSink& sink) {
    const WorldFace face = face_of(B);
    const Vector half = A.shape.size;
    const Vector edge_x = A.A.c0 * half.x, edge_y = A.A.c1 * half.y, edge_z = A.A.c2 * half.z;
    const scalar height = dot(face.n, A.r_CM) - face.d, margin = limits::flatness * bounding_radius(A.shape);
    const auto corner = [&](int corner_i) {
        const Vector x = (corner_i & 1) != 0 ? edge_x : -edge_x;
        const Vector y = (corner_i & 2) != 0 ? edge_y : -edge_y;
        const Vector z = (corner_i & 4) != 0 ? edge_z : -edge_z;
        return x + y + z;
    };
    scalar separations[8], deepest = scalar_max;
    for (int corner_i = 0; corner_i < 8; ++corner_i) {
        separations[corner_i] = height + dot(face.n, corner(corner_i));
        deepest = separations[corner_i] < deepest ? separations[corner_i] : deepest;
    }
    if (deepest > margin) return;

    // All corners as deep as the deepest but for the margin come together, so no rounding parts them.
    const scalar least = deepest > 0 ? deepest + margin : margin;
    for (int corner_i = 0; corner_i < 8; ++corner_i)
        if (separations[corner_i] <= least) sink.add(face.n, cross(corner(corner_i), face.n), {}, separations[corner_i]);
}

} }  // namespace ingot
