// SPDX-License-Identifier: MIT
// Pictures of the guide: what each flag of draw() adds, and what each example does. Bits are those of every target, and so are the pictures.
//
//     guide_pictures draw OUT_DIR              writes OUT_DIR/draw_<flag>.svg
//     guide_pictures <example> OUT_DIR         runs it, and writes OUT_DIR/example_<example>.svg
#include <ingot/ingot.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "../draw/picture.h"
#include "../draw/svg.h"
#include "film.h"

// The examples as they are, but for their step, and for main, which is a function of each.
#define step filmed_step
#define main run_example
#include "../examples/all_examples.cpp"
#undef step
#undef main

namespace {

using ingot::scalar;
using ingot::Vector;

// What each flag adds.

struct Yard : ingot::Scene {
    static constexpr int max_bodies = 9, max_manifolds = 24, max_joints = 2;
    static constexpr bool translates = true, sleeps = true, reads_contacts = true;
    using shapes = ingot::Shapes<ingot::Sphere, ingot::Capsule, ingot::Box, ingot::HalfSpace>;
    using joints = ingot::Joints<ingot::BallJoint, ingot::HingeJoint>;
};
ingot::World<Yard> yard;

bool set_up_yard() {
    bool good = yard.set_gravity({0, 0, scalar(-9.81)}) == ingot::Status::ok;
    const auto solid = [](const ingot::Shape& shape, const Vector& r) {
        ingot::BodyDef def;
        def.mass = ingot::principal(ingot::solid_of_shape(200, shape)).value;
        def.shape = shape;
        def.state.r_CM = r;
        def.friction = scalar(0.5);
        return def;
    };
    const auto add = [&](const ingot::BodyDef& def) {
        const ingot::Result<ingot::BodyId> id = yard.add(def);
        good = good && id.ok();
        return id.value;
    };
    const auto m = [](double x) { return static_cast<scalar>(x); };
    ingot::BodyDef ground;
    ground.immovable = true;
    ground.shape = ingot::HalfSpace{{0, 0, 1}, 0};
    add(ground);
    const ingot::Box crate = {{m(0.5), m(0.5), m(0.5)}};
    add(solid(crate, {m(-2.6), 0, m(0.5)}));  // a heap that sleeps
    add(solid(crate, {m(-1.4), 0, m(0.5)}));
    add(solid(crate, {m(-2), 0, m(1.5)}));
    ingot::BodyDef sliding = solid(ingot::Box{{m(0.6), m(0.4), m(0.3)}}, {m(0.6), 0, m(0.3)});
    sliding.state.v_CM = {m(3.1), 0, 0};
    ingot::BodyDef thrown = solid(ingot::Box{{m(0.5), m(0.3), m(0.15)}}, {m(-0.4), 0, m(1.9)});
    thrown.state.v_CM = {m(0.7), 0, m(4.2)};
    thrown.state.L = ingot::angular_momentum_of_spin(thrown.state.A, thrown.mass.I_body, {2, 3, m(0.4)});
    const ingot::Capsule link = {m(0.15), m(0.35)};
    ingot::BodyId before = {};
    for (int link_i = 0; link_i < 2; ++link_i) {  // a pendulum, its second joint a hinge
        ingot::BodyDef def = solid(link, {m(2.6 + 0.5 * (2 * link_i + 1)), 0, m(2.9)});
        def.state.A = ingot::axis_angle({0, 1, 0}, m(1.5707963));
        const ingot::BodyId id = add(def);
        ingot::JointDef joint;
        joint.body_A = before;
        joint.body_B = id;
        joint.P = {m(2.6 + link_i), 0, m(2.9)};
        joint.axis = {0, 1, 0};
        if (link_i == 0)
            joint.joint = ingot::BallJoint{};
        else
            joint.joint = ingot::HingeJoint{};
        good = good && yard.add_joint(joint).ok();
        before = id;
    }
    for (int step_i = 0; good && step_i < 60; ++step_i) good = ingot::step(yard, scalar(1) / 60).status == ingot::Status::ok;
    add(sliding);
    add(thrown);
    for (int step_i = 0; good && step_i < 24; ++step_i) good = ingot::step(yard, scalar(1) / 60).status == ingot::Status::ok;
    return good;
}

/// Shapes stand back where something else is to be seen.
struct FaintPen {
    draw::SvgPen& pen;
    bool is_faint;
    void line(const Vector& a, const Vector& b, ingot::DrawColor color) {
        pen.line(a, b, is_faint && color <= ingot::DrawColor::sensor ? ingot::DrawColor::immovable : color);
    }
    void point(const Vector& P, ingot::DrawColor color) { pen.point(P, color); }
};

template <unsigned flag>
bool draw_flag(const std::string& out_dir, const char* name) {
    std::FILE* const file = std::fopen((out_dir + "/draw_" + name + ".svg").c_str(), "w");
    if (file == nullptr) return false;
    {
        draw::SvgPen svg(file, 8.5, {scalar(0.4), 0, scalar(1.4)}, 3);
        FaintPen pen = {svg, flag != ingot::Draw::shapes && flag != ingot::Draw::sleep};
        ingot::draw<ingot::Draw::shapes | flag>(yard, pen, {scalar(0.7), scalar(0.05), 1, scalar(0.04), scalar(0.1), scalar(0.4)});
    }
    return std::fclose(file) == 0;
}
bool draw_flags(const std::string& out_dir) {
    using ingot::Draw;
    bool good = set_up_yard() && draw_flag<Draw::shapes>(out_dir, "shapes");
    good = good && draw_flag<Draw::sleep>(out_dir, "sleep") && draw_flag<Draw::axes>(out_dir, "axes") && draw_flag<Draw::centres>(out_dir, "centres");
    good = good && draw_flag<Draw::bounds>(out_dir, "bounds") && draw_flag<Draw::L>(out_dir, "L") && draw_flag<Draw::omega>(out_dir, "omega");
    good = good && draw_flag<Draw::contacts>(out_dir, "contacts") && draw_flag<Draw::impulses>(out_dir, "impulses");
    return good && draw_flag<Draw::joints>(out_dir, "joints") && draw_flag<Draw::islands>(out_dir, "islands");
}

// What each example does.

struct Shot {
    const char* name;
    const char* caption;
    std::vector<double> times;  ///< s: what is drawn, the last one whole, the others as what was before
    double turn = 25, height = 17;
    double margin = 1.25;         ///< of what is in the picture
    double proxy[3] = {0, 0, 0};  ///< m, half extents of what is drawn where bodies have no shape
    bool fields = false;          ///< each time has a field of its own
};
const Shot shots[] = {
    {"crate", "A crate falls, and falls asleep where it lies", {0, 0.3, 0.5, 0.65, 3}},
    {"dominoes", "Thirty dominoes, of which the first was pushed", {0.45}, 35, 22, 1.1},
    {"marble_run", "A marble rolls down two slopes into a cup", {0, 0.3, 0.5, 0.7, 0.9, 1.1, 1.3, 1.5, 1.7, 4}, 10, 10, 1.1},
    {"pinball", "A flipper shoots a ball up the table, seen from above", {0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95, 1}, 0, 89, 1.1},
    {"dice", "Twelve dice are thrown, and sleep", {0.2, 1.5}, 25, 40, 1.05, {}, true},
    {"ray_picking", "A click picks and pushes the crate in front", {0, 0.25, 0.5, 1}, 35, 30},
    {"trigger", "A ball rolls through a gate, a sensor that touches nothing", {0, 0.5, 1, 1.5, 2, 2.5, 3}, 40, 20, 1.1},
    {"conveyor", "A belt carries a crate: it slips, and then goes along", {0, 0.3, 0.6, 0.9, 1.2, 1.5}, 15, 15, 1.1},
    {"lift", "A lift goes up with three crates on it", {0, 2, 4}, 25, 15, 1.1, {}, true},
    {"character", "A character walks up stairs, over a landing and down a ramp", {1.2, 2.4, 4.3}, 20, 15, 1.05, {}, true},
    {"projectile",
     "A bullet stops at a thin plate; another one misses it",
     {0, 0.0167, 0.0333, 0.05, 0.0667, 0.0833, 0.1, 0.1167, 0.1333, 0.15},
     45,
     25,
     1.1},
    {"satellite", "A satellite turns, and flips over again and again", {0, 8, 12, 16, 20, 24}, 25, 17, 1.2, {0.5, 0.3, 0.1}, true},
    {"drone", "A drone flies to a point, and holds it", {0, 0.4, 0.8, 1.2, 1.8, 5}, 20, 12, 1.2, {0.2, 0.2, 0.03}},
    {"balancing_robot", "A robot on a wheel is pushed, and comes back", {0.9, 1.3, 1.8, 9}, 15, 10, 1.2, {}, true},
    {"bridge", "A ball rolls over a bridge of planks on hinges", {0, 1.5, 3}, 15, 20, 1.05, {}, true},
    {"rollback", "Two players push a puck, and both see the same", {0, 0.5, 1, 1.5, 2}, 10, 40},
    {"replay", "A crate leaves the yard, a bug to be played again", {0, 1, 2, 3, 4}, 20, 30, 1.1},
};

const film::Moment& moment_at(double time) {
    const film::Moment* best = &film::moments.front();
    for (const film::Moment& moment : film::moments)
        if (std::fabs(moment.time - time) < std::fabs(best->time - time)) best = &moment;
    return *best;
}
ingot::PlacedShape shape_of(const film::Thing& thing, const Shot& shot) {
    ingot::PlacedShape shape = thing.shape;
    if (!thing.has_shape)
        shape.shape = ingot::Box{{static_cast<scalar>(shot.proxy[0]), static_cast<scalar>(shot.proxy[1]), static_cast<scalar>(shot.proxy[2])}};
    return shape;
}
/// m, of the ball that holds it.
double reach_of(const ingot::Shape& shape) {
    const draw::Point size = draw::point_of(shape.size);
    switch (shape.kind) {
        case ingot::ShapeKind::sphere: return size[0];
        case ingot::ShapeKind::capsule: return size[0] + size[1];
        case ingot::ShapeKind::cylinder: return std::hypot(size[0], size[1]);
        default: return std::sqrt(draw::dot(size, size));
    }
}

bool draw_example(const std::string& path, const Shot& shot) {
    if (film::moments.empty()) return false;
    using draw::operator+;
    using draw::operator*;
    const int fields = shot.fields ? static_cast<int>(shot.times.size()) : 1;
    const double field_width = shot.fields ? 900.0 / fields : 640, field_height = shot.fields ? std::max(200.0, 0.7 * field_width) : 400;
    // All that moves is in the picture, and then what does not and is no larger.
    const draw::Axes axes = draw::axes_of({1, {}, shot.turn, shot.height});
    double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
    const auto hold = [&](bool moving, double most) {
        for (const double time : shot.times)
            for (const film::Thing& thing : moment_at(time).things) {
                const ingot::PlacedShape shape = shape_of(thing, shot);
                const double reach = reach_of(shape.shape),
                             at[2] = {draw::dot(draw::point_of(shape.r), axes.right), draw::dot(draw::point_of(shape.r), axes.up)};
                if (thing.moves != moving || shape.shape.kind == ingot::ShapeKind::half_space || reach > most) continue;
                for (int i = 0; i < 2; ++i) {
                    low[i] = std::min(low[i], at[i] - reach);
                    high[i] = std::max(high[i], at[i] + reach);
                }
            }
    };
    hold(true, 1e9);
    hold(false, std::max(high[0] - low[0], high[1] - low[1]));
    const draw::Point middle = 0.5 * (low[0] + high[0]) * axes.right + 0.5 * (low[1] + high[1]) * axes.up;
    const double width = shot.margin * std::max(high[0] - low[0], (high[1] - low[1]) * field_width / field_height);
    draw::Point below = {};  // the mean of what moves
    double count = 0;
    for (const double time : shot.times)
        for (const film::Thing& thing : moment_at(time).things)
            if (thing.moves) below = below + draw::point_of(thing.shape.r), ++count;
    below = 1 / count * below;
    draw::Picture picture(shot.caption, fields, field_width, field_height);
    const draw::Paint paints[] = {draw::blue, draw::red, draw::ochre, draw::violet, draw::green};
    for (std::size_t moment_i = 0; moment_i < shot.times.size(); ++moment_i) {
        const film::Moment& moment = moment_at(shot.times[moment_i]);
        char note[20] = "";
        if (shot.fields) std::snprintf(note, sizeof note, "%.2g s", moment.time);
        if (shot.fields || moment_i == 0)
            picture.begin_field(shot.fields ? static_cast<int>(moment_i) : 0, {width, middle, shot.turn, shot.height}, note);
        const bool is_last = shot.fields || moment_i + 1 == shot.times.size();
        int number = 0;
        for (const film::Thing& thing : moment.things) {
            ingot::PlacedShape shape = shape_of(thing, shot);
            if (shape.shape.kind == ingot::ShapeKind::sphere)  // to be seen
                shape.shape.size.x = std::max(shape.shape.size.x, static_cast<scalar>(0.009 * width));
            if (shape.shape.kind == ingot::ShapeKind::half_space) {
                const Vector n = shape.shape.size;
                if ((shot.fields || moment_i == 0) && n.z > scalar(0.9))
                    picture.add_floor({below[0], below[1], static_cast<double>(shape.shape.offset)}, 0.9 * width, 0.5 * width);
            } else if (!thing.moves && thing.has_shape) {
                const bool was_here =
                    film::moments.front().things.size() == moment.things.size() &&
                    std::memcmp(&thing.shape.r, &film::moments.front().things[static_cast<std::size_t>(&thing - moment.things.data())].shape.r,
                                sizeof thing.shape.r) == 0;
                if (is_last || moment_i == 0 || !was_here)
                    picture.add(shape, draw::grey, false, shape.shape.kind == ingot::ShapeKind::box || is_last ? 1 : 0.5);
            } else {
                picture.add(shape, paints[number++ % 5], is_last, is_last ? 1 : 0.45);
            }
        }
    }
    return picture.write(path.c_str());
}

/// What a display shows: a stroke for each run of dots that are lit. color_of: of column and row, 0xrrggbb; 0 is dark.
template <class ColorOf>
bool draw_display(const std::string& path, int columns, int rows, ColorOf color_of) {
    std::FILE* const file = std::fopen(path.c_str(), "w");
    if (file == nullptr) return false;
    std::fprintf(
        file, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"480\" viewBox=\"0 0 %d %d\">\n<rect width=\"%d\" height=\"%d\" fill=\"#101820\"/>\n",
        columns, rows, columns, rows);
    for (int row = 0; row < rows; ++row)
        for (int column = 0, end; column < columns; column = end) {
            const unsigned color = color_of(column, row);
            for (end = column + 1; end < columns && color_of(end, row) == color;) ++end;
            if (color != 0) std::fprintf(file, "<path d=\"M%d %d.5h%d\" stroke=\"#%06x\"/>\n", column, row, end - column, color);
        }
    std::fprintf(file, "</svg>\n");
    return std::fclose(file) == 0;
}
unsigned color_of_one_bit(int column, int row) { return one_bit_display::display.pages[row / 8][column] >> (row % 8) & 1 ? 0xd8f0ffu : 0; }
/// Five bits of red, six of green, five of blue.
unsigned color_of_frame(int column, int row) {
    const unsigned dot = frame_buffer::frame.at[row][column];
    return (dot >> 11 & 31) * 255 / 31 << 16 | (dot >> 5 & 63) * 255 / 63 << 8 | (dot & 31) * 255 / 31;
}

bool draw_what_it_did(const std::string& out_dir, const std::string& name) {
    const std::string path = out_dir + "/example_" + name + ".svg";
    if (name == "one_bit_display") return draw_display(path, 128, 64, color_of_one_bit);
    if (name == "frame_buffer") return draw_display(path, 320, 240, color_of_frame);
    for (const Shot& shot : shots)
        if (name == shot.name) return draw_example(path, shot);
    std::fprintf(stderr, "no picture of %s\n", name.c_str());
    return false;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: guide_pictures draw|<example> OUT_DIR\n");
        return 2;
    }
    if (std::strcmp(argv[1], "draw") == 0) return draw_flags(argv[2]) ? 0 : 1;
    char* arguments[] = {argv[0], argv[1], nullptr};
    return run_example(2, arguments) == 0 && draw_what_it_did(argv[2], argv[1]) ? 0 : 1;
}
