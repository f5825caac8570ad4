// SPDX-License-Identifier: MIT
// A world as lines, for whoever has a display. It reads what every user may read, writes nothing, and keeps nothing; a program that does not call it
// has none of it.
//
//     struct Pen { void line(const ingot::Vector& a, const ingot::Vector& b, ingot::DrawColor color) { ... } } pen;
//     ingot::draw<ingot::Draw::shapes | ingot::Draw::contacts>(world, pen);
#pragma once

#include "../draw/pen.h"
#include "world.h"

namespace ingot { inline namespace INGOT_ABI {

/// What is drawn; with | between them. What a scene has not is not drawn, and what a call does not name is not linked for it.
struct Draw {
    static constexpr unsigned shapes   = 1u << 0;  ///< a wireframe each, in the colour of what its body is
    static constexpr unsigned sleep    = 1u << 1;  ///< shapes of bodies that sleep have a colour of their own
    static constexpr unsigned axes     = 1u << 2;  ///< principal axes, from the centre of mass
    static constexpr unsigned centres  = 1u << 3;  ///< a point at the centre of mass
    static constexpr unsigned bounds   = 1u << 4;  ///< boxes by which the last step looked for pairs
    static constexpr unsigned L        = 1u << 5;  ///< angular momentum, from the centre of mass
    static constexpr unsigned omega    = 1u << 6;  ///< angular velocity
    static constexpr unsigned contacts = 1u << 7;  ///< a point where two shapes touched in the last step
    static constexpr unsigned impulses = 1u << 8;  ///< what A got there: along the normal, and by friction
    static constexpr unsigned joints   = 1u << 9;  ///< arms from the centres to the joint, and its axis
    static constexpr unsigned islands  = 1u << 10; ///< from each centre to that of the body that stands for its island
    static constexpr unsigned all      = (1u << 11) - 1;  ///< everything there is
    static constexpr unsigned of_movable = axes | centres | L | omega | islands;  ///< of these, what immovable bodies have not
};

/// How large things are that have no length of their own.
struct DrawScale {
    scalar axis = scalar(0.5);         ///< m, of an axis, of a body or of a joint
    scalar point = scalar(0.05);       ///< m, of half of the cross that stands for a point
    scalar cell = 1;                   ///< m, of the net that stands for a half space
    scalar impulse = scalar(0.05);     ///< m for 1 N s
    scalar L = scalar(0.1);            ///< m for 1 kg m^2/s
    scalar omega = scalar(0.1);        ///< m for 1 rad/s
};

/// Draws a world by the calls of its parts; a part is a question to World for each body, shape, contact or joint.
template <unsigned named, class S, class Pen>
class WorldDrawing {
public:
    WorldDrawing(const World<S>& world, Pen& pen, const DrawScale& scale) : world_(world), pen_(pen), scale_(scale) {}

    void draw_bodies() const {
        for (int slot = 0; slot < S::max_bodies; ++slot)  // bound: max_bodies
            if (const BodyId id = world_.body_at(slot); id.generation != 0) draw_body(id);
    }
    void draw_contacts() const {
        if constexpr (has_shapes<S> && has(Draw::contacts | Draw::impulses))
            for (const ContactInfo& contact : world_.contacts()) draw_contact(contact);  // bound: max_manifolds, or max_contacts
    }
    void draw_joints() const {
        if constexpr (has_joints<S> && has(Draw::joints))
            for (int slot = 0; slot < S::max_joints; ++slot)  // bound: max_joints
                if (const Result<JointPlace> joint = world_.joint_place(world_.joint_at(slot)); joint.ok()) draw_joint(joint.value);
    }

private:
    static constexpr bool has(unsigned flags) { return (named & flags) != 0; }
    void line(const Vector& a, const Vector& b, DrawColor color) const { pen_.line(a, b, color); }
    void point(const Vector& P, DrawColor color) const { draw_point(pen_, P, scale_.point, color, 0); }

    void draw_body(BodyId id) const {
        if constexpr (has_shapes<S> && has(Draw::shapes | Draw::bounds))
            for (int shape_i = 0; shape_i < S::max_shapes_of_body; ++shape_i) draw_shape_of(id, shape_i);  // bound: max_shapes_of_body
        if constexpr (has(Draw::of_movable))
            if (world_.is_movable(id)) draw_motion(id, world_.state(id).value);
    }
    void draw_motion(BodyId id, const BodyState& state) const {
        const Vector& at = state.r_CM;
        if constexpr (has(Draw::axes)) {
            line(at, at + state.A.c0 * scale_.axis, DrawColor::axis_x);
            line(at, at + state.A.c1 * scale_.axis, DrawColor::axis_y);
            line(at, at + state.A.c2 * scale_.axis, DrawColor::axis_z);
        }
        if constexpr (has(Draw::centres)) point(at, DrawColor::centre);
        if constexpr (has(Draw::L)) line(at, at + state.L * scale_.L, DrawColor::L);
        if constexpr (has(Draw::omega)) line(at, at + world_.omega(id).value * scale_.omega, DrawColor::omega);
        if constexpr (S::sleeps && has(Draw::islands))
            if (const BodyId root = world_.island_of(id).value; root != id) line(at, world_.state(root).value.r_CM, DrawColor::island);
    }

    void draw_shape_of(BodyId id, int shape_i) const {
        const Result<PlacedShape> shape = world_.placed_shape(id, shape_i);
        if (!shape.ok()) return;
        if constexpr (has(Draw::shapes)) draw_shape(pen_, shape.value, scale_.cell, color_of(id, shape_i), 0);
        if constexpr (stacks<S> && has(Draw::bounds)) draw_bounds(world_.search_bounds(id, shape_i).value);
    }
    DrawColor color_of(BodyId id, [[maybe_unused]] int shape_i) const {
        if constexpr (has_sensors<S>)
            if (world_.is_sensor(id, shape_i).value) return DrawColor::sensor;
        if (world_.is_frozen(id)) return DrawColor::frozen;
        if constexpr (S::kinematic_bodies)
            if (world_.is_kinematic(id)) return DrawColor::kinematic;
        if (!world_.is_movable(id)) return DrawColor::immovable;
        if constexpr (S::sleeps && has(Draw::sleep))
            if (world_.is_asleep(id)) return DrawColor::asleep;
        return DrawColor::awake;
    }
    void draw_bounds(const BoundsInfo& bounds) const {
        const Vector extent = bounds.high - bounds.low;
        const scalar most = max(extent.x, max(extent.y, extent.z)), least = min(extent.x, min(extent.y, extent.z));
        if (!(least >= 0 && most < limits::unbounded)) return;  // empty, or a half space
        for (int line_i = 0; line_i < lines_of_box; ++line_i) {  // bound: lines_of_box
            const Line edge = line_of_bounds(bounds.low, bounds.high, line_i);
            line(edge.a, edge.b, DrawColor::bounds);
        }
    }

    void draw_contact(const ContactInfo& contact) const {
        Vector middle = {};
        for (int point_i = 0; point_i < contact.point_count; ++point_i) {  // bound: Manifold::points_max
            const ContactPoint& at = contact.points[point_i];
            if (has(Draw::contacts)) point(at.P, DrawColor::contact);
            if (has(Draw::impulses)) line(at.P, at.P + contact.n * (at.j * scale_.impulse), DrawColor::impulse);
            middle += at.P * (1 / static_cast<scalar>(contact.point_count));
        }
        if (has(Draw::impulses) && contact.point_count > 0) line(middle, middle + contact.j_friction * scale_.impulse, DrawColor::friction);
    }

    void draw_joint(const JointPlace& joint) const {
        if (world_.is_alive(joint.A)) line(world_.state(joint.A).value.r_CM, joint.P_A, DrawColor::joint);
        if (world_.is_alive(joint.B)) line(world_.state(joint.B).value.r_CM, joint.P_B, DrawColor::joint);
        line(joint.P_A, joint.P_B, DrawColor::joint);  // a rod, a rope; else what the joint has given
        if (joint.kind == JointKind::ball || is_tie(joint.kind)) return point(joint.P_A, DrawColor::joint);
        line(joint.P_A, joint.P_A + joint.axis_A * scale_.axis, DrawColor::joint_axis);
    }

    const World<S>& world_;
    Pen& pen_;
    const DrawScale& scale_;
};

/// Draws a world by a pen of the user's: see draw/pen.h. Bodies in the order of slots, then contacts, then joints. What a key switches on and off is
/// a call of its own: if (shows_contacts) draw<Draw::contacts>(world, pen).
///
/// Calls:  no more lines than lines_of_capsule (or the edges of a hull) and lines_of_box for each shape, 9 for each body, 17 for each contact and 6
///         for each joint. Before the first step there are no bounds, contacts and islands.
/// Flash:  shapes as lines 1.7 KB on a Cortex-M4F, all there is 5.6 KB; 0 where it is not called.
template <unsigned what = Draw::shapes, class User, class Pen>
void draw(const World<User>& world, Pen& pen, const DrawScale& scale = {}) {
    const WorldDrawing<what, SceneOf<User>, Pen> drawing(world, pen, scale);
    drawing.draw_bodies();
    drawing.draw_contacts();
    drawing.draw_joints();
}

} }  // namespace ingot
