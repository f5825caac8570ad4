// SPDX-License-Identifier: MIT
#include "collide_shapes.h"

#include "../base/checks.h"
#include "../base/report.h"

namespace ingot { inline namespace INGOT_ABI {

namespace {

/// Whether a is dropped rather than b where there is room for one.
bool gives_way(const BodyView* bodies, const Contact& a, const Contact& b) {
    const auto on_fixed = [bodies](const Contact& c) {
        return bodies != nullptr && (!is_dynamic(*bodies, c.body_A) || !is_dynamic(*bodies, c.body_B));
    };
    return on_fixed(a) == on_fixed(b) ? a.separation > b.separation : on_fixed(b);
}

/// Whether a contact that is found again is a new one: where impulses are read, those along another normal are told apart.
bool is_told_apart(const ContactView& contacts, const Contact& c, const Vector& n) {
    constexpr scalar rounding = 16 * epsilon;  // of n
    return contacts.places != nullptr && *contacts.count < contacts.capacity && c.j_total > 0 && length_sq(c.n - n) > rounding * rounding;
}

}  // namespace

ContactPlace ContactSink::find(const Vector& n, int corner) const {
    ContactPlace place = {*contacts.count, false, 0};
    // bound: max_contacts
    for (int index = 0; index < *contacts.count && is_again; ++index) {
        const Contact& c = contacts.contacts[index];
        if (c.body_A != slot_A || c.body_B != slot_B) continue;
        if (c.corner == corner && !is_told_apart(contacts, c, n)) return {index, true, c.tolerance};
        place = {index + 1, false, max(place.tolerance, c.tolerance)};
    }
    return place;
}

void ContactSink::make_room(int index) const {
    // bound: max_contacts
    for (int to = *contacts.count; to > index; --to) {
        contacts.contacts[to] = contacts.contacts[to - 1];
        if (contacts.places != nullptr) contacts.places[to] = contacts.places[to - 1];
    }
}

void ContactSink::add(ContactPlace place, const Vector& n, const Vector& lever_A, const Vector& lever_B, scalar separation, scalar when, int corner) {
    INGOT_ASSERT(*contacts.count <= contacts.capacity);
    INGOT_ASSERT(slot_A != slot_B);
    const bool is_added = !place.is_known && *contacts.count < contacts.capacity;
    if (is_added) {
        make_room(place.index);
        ++*contacts.count;
    } else if (!place.is_known) {
        count(*lost);
        place.index = 0;
        // bound: max_contacts
        for (int contact_i = 1; contact_i < contacts.capacity; ++contact_i)
            if (gives_way(bodies, contacts.contacts[contact_i], contacts.contacts[place.index])) place.index = contact_i;
        Contact next{};
        next.body_A = static_cast<Index>(slot_A);
        next.body_B = static_cast<Index>(slot_B);
        next.separation = separation;
        const Contact& shallowest = contacts.contacts[place.index];
        if (is_at_its_bound(shallowest) || !gives_way(bodies, shallowest, next)) return;
    }
    Contact& contact = contacts.contacts[place.index];
    if (place.is_known && is_at_its_bound(contact)) return;
    contact.n = n;
    contact.lever_A = lever_A;
    contact.lever_B = lever_B;
    contact.separation = separation;
    contact.when = now + when;
    contact.is_new = true;
    contact.touches = false;
    contact.tolerance = place.tolerance;
    if (place.is_known) return;
    contact.body_A = static_cast<Index>(slot_A);
    contact.body_B = static_cast<Index>(slot_B);
    contact.e = e;
    contact.corner = static_cast<uint8_t>(corner) & 7u;
    contact.aside = true;
    contact.at_hand = false;
    if (is_added) contact.impacts = 0;  // else those of the one that was here: so the place has its bounds, whoever takes it
    if (is_added) contact.visits = 0;
    contact.j_impact = contact.j_total = 0;
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

/// A gap that opens and closes: s + u t + a t^2 / 2.
struct Gap {
    scalar s, u, a;

    scalar at(scalar t) const { return s + (u + a * t / 2) * t; }
};

/// When two surfaces meet, s; limits::unbounded: not within `rest`. touch: m, a gap that counts as none. still: m/s, what leaves no faster rests.
scalar when_met(const Gap& gap, scalar touch, scalar still, const ContactSink& sink, scalar rest) {
    const bool touches = gap.s <= touch;
    if (touches && gap.u <= still && (gap.s <= 0 || !(gap.u < -sink.slow))) return 0;
    const scalar never = touches && gap.u > 0 ? scalar(0) : limits::unbounded;  // what touches is a contact, even if it leaves
    const scalar s = max(gap.s, scalar(0)), root_sq = gap.u * gap.u - 2 * gap.a * s;  // what is too deep comes back to where it is
    if (root_sq < 0 || (gap.u >= 0 && gap.a >= 0)) return never;
    const scalar root = sqrt(root_sq), t = gap.u < 0 ? 2 * s / (root - gap.u) : (gap.u + root) / -gap.a;  // the form that loses no digits
    return t <= rest ? t : never;
}

}  // namespace

void collide_sphere_sphere(const Placed& A, const Placed& B, ContactSink& sink) {
    const Vector way = A.r_CM - B.r_CM, v = A.v - B.v, a = A.a - B.a;
    const scalar reach = A.shape.size.x + B.shape.size.x, inv_reach = 1 / reach;
    // (distance^2 - reach^2) / (2 reach): near the impact the distance of the surfaces, and without forces a parabola all the way.
    const Gap gap = {(length_sq(way) * inv_reach - reach) / 2, dot(way, v) * inv_reach, (length_sq(v) + dot(way, a)) * inv_reach};
    scalar t = when_met(gap, limits::flatness * reach, sink.still, sink, sink.rest);
    if (!(t < limits::unbounded)) return;
    for (int pass_i = 0; pass_i <= limits::meeting_passes; ++pass_i) {
        const Vector d = way + (v + a * (t / 2)) * t;
        const scalar distance = sqrt(length_sq(d)), s = distance - reach;
        const Vector n = distance > epsilon * reach ? d * (1 / distance) : Vector{1, 0, 0};
        const scalar u = dot(n, v + a * t);
        // Forces bend it: Newton's method finds the time, of which three digits are right already.
        if (!(t > 0) || !(u < 0) || pass_i == limits::meeting_passes) return sink.add(sink.find(n, 0), n, {}, {}, s, t, 0);
        t = min(max(t - s / u, scalar(0)), sink.rest);
    }
}

void collide_sphere_half_space(const Placed& A, const Placed& B, ContactSink& sink) {
    const WorldFace face = face_of(B);
    const Gap gap = {dot(face.n, A.r_CM) - face.d - A.shape.size.x, dot(face.n, A.v - B.v), dot(face.n, A.a - B.a)};
    const scalar t = when_met(gap, limits::flatness * A.shape.size.x, sink.still, sink, sink.rest);
    if (t < limits::unbounded) sink.add(sink.find(face.n, 0), face.n, {}, {}, gap.at(t), t, 0);
}

namespace {

/// A corner of a box on its way, seen from the centre: c + omega x c t + omega x (omega x c) t^2 / 2, as since the step began.
struct BoxCorner {
    Vector c, rate, bend;

    BoxCorner(const Placed& box, int corner_i, scalar since_begin) {
        const Vector half = box.shape.size;
        const Vector edge_x = box.A.c0 * half.x, edge_y = box.A.c1 * half.y, edge_z = box.A.c2 * half.z;
        const Vector x = (corner_i & 1) != 0 ? edge_x : -edge_x;
        const Vector y = (corner_i & 2) != 0 ? edge_y : -edge_y;
        const Vector z = (corner_i & 4) != 0 ? edge_z : -edge_z;
        c = x + y + z;
        rate = cross(box.omega, c);
        bend = cross(box.omega, rate);
        c = at(since_begin);
        rate += bend * since_begin;
    }
    Gap over(const WorldFace& face, const Gap& centre) const {
        return {centre.s + dot(face.n, c), centre.u + dot(face.n, rate), centre.a + dot(face.n, bend)};
    }
    Vector at(scalar t) const { return c + (rate + bend * (t / 2)) * t; }
};

}  // namespace

void collide_box_half_space(const Placed& A, const Placed& B, ContactSink& sink) {
    const WorldFace face = face_of(B);
    const Gap centre = {dot(face.n, A.r_CM) - face.d, dot(face.n, A.v - B.v), dot(face.n, A.a - B.a)};
    const scalar margin = limits::flatness * bounding_radius(A.shape), spin = sqrt(length_sq(A.omega));
    const scalar still = max(sink.still, corners_still(centre.a, sink.together));
    const scalar rest = spin * sink.rest > limits::corner_turn ? limits::corner_turn / spin : sink.rest;
    Gap gaps[8];
    scalar owns[8], first = limits::unbounded, deepest = scalar_max;
    for (int corner_i = 0; corner_i < 8; ++corner_i) {
        gaps[corner_i] = BoxCorner(A, corner_i, sink.now).over(face, centre);
        owns[corner_i] = when_met(gaps[corner_i], margin, still, sink, rest);
        first = min(first, owns[corner_i]);
    }
    if (!(first < limits::unbounded)) return;
    for (const Gap& gap : gaps) deepest = min(deepest, gap.at(first));

    // Corners as deep as the deepest but for the margin come together, and so do those that follow at once. So no rounding parts them, and a box that
    // falls flat does not begin to turn. Later ones are found after the impact of the first; or here, if the first touches already.
    const scalar least = deepest > 0 ? deepest + margin : margin;
    for (int corner_i = 0; corner_i < 8; ++corner_i) {
        const Gap& gap = gaps[corner_i];
        const scalar own = owns[corner_i];
        const bool leaves = gap.u + gap.a * first > still;
        const bool with_first = own <= first || (!leaves && (gap.at(first) <= least || own <= first + sink.together));
        const scalar t = with_first ? first : own;
        if (!with_first && (first > 0 || !(own < limits::unbounded))) continue;
        const ContactPlace place = sink.find(face.n, corner_i);
        sink.add(place, face.n, cross(BoxCorner(A, corner_i, sink.now).at(t), face.n), {}, gap.at(t), t, corner_i);
    }
}

} }  // namespace ingot
