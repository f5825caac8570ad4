// SPDX-License-Identifier: MIT
#include "plots_contact.h"

#include <algorithm>
#include <cmath>

namespace report {

namespace {

const double missing = std::nan("");

struct Look {
    std::string method, scalar, title, color;
};

const std::vector<Look>& looks() {
    static const std::vector<Look> all = {
        {"default", "float", "ingot, float", "#e63946"}, {"default", "double", "ingot, double", "#8c1d27"},
        {"bullet", "float", "Bullet, float", "#2684c9"}, {"bullet", "double", "Bullet, double", "#0b2f66"},
        {"ode", "float", "ODE, float", "#1b9e77"},       {"ode", "double", "ODE, double", "#1b9e77"},
        {"box3d", "float", "Box3D, float", "#7b4fb3"},   {"jolt", "float", "Jolt, float", "#d98e04"}};
    return all;
}

/// us of a step; the kernel's with 4 lanes, from the race with the peers where there was one.
double us_of(const Rows& rows, const std::string& scene, const Look& look, double h) {
    const int lanes = look.method == "default" ? 4 : 1;
    const double alone = rows.value("contact", scene, look.method, look.scalar, lanes, h, "us_per_step", missing);
    return rows.value("peers", scene, look.method, look.scalar, lanes, h, "us_per_step", alone);
}

constexpr double fallen = 2000;  ///< mm; what goes further has fallen, and how far tells nothing

/// Adds the line of a metric over the rates at which each engine ran the scene.
void add_over_rates(Sheet& sheet, const Rows& rows, const std::string& scene, const std::string& metric,
                    const std::string& suffix, Line::Look style) {
    for (const Look& look : looks()) {
        for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
            const double h = 1 / rate;
            const char* const suite = look.method == "default" ? "contact" : "peers";
            const double error = rows.value(suite, scene, look.method, look.scalar, 0, h, metric, missing);
            Line& line = sheet.line(look.title + suffix, look.color);
            line.look = style;
            Sheet::add_point(line, us_of(rows, scene, look, h) * rate / 60, std::min(error, fallen));
        }
    }
}

const char* const over_rates =
    "Each point is a rate: 30, 60, 120, 240 steps a second, from left to right (a quick run leaves some out). Left is cheaper, "
    "lower "
    "is more accurate.";
const char* const plain_ticks = "set format x '%g'";

Sheet pyramid(const Rows& rows, const std::string& metric, const std::string& title) {
    Sheet sheet;
    sheet.name = "contact_pyramid_" + metric;
    sheet.title = title;
    sheet.x_label = "µs for 1/60 s, ingot with 4 lanes";
    sheet.y_label = metric + " of 210 cubes, mm";
    sheet.how_to_read = std::string(over_rates) + " The exact solution does not move at all.";
    sheet.more = plain_ticks;
    add_over_rates(sheet, rows, "pyramid_210", metric, "", Line::Look::plain);
    return sheet;
}

Sheet tower(const Rows& rows) {
    Sheet sheet;
    sheet.name = "contact_tower_sink";
    sheet.title = "Does a tower of 20 cubes sink, or drift?";
    sheet.x_label = "µs for 1/60 s, ingot with 4 lanes";
    sheet.y_label = "way of the topmost cube within 60 s, mm";
    sheet.how_to_read = std::string(over_rates) +
                        " Solid: how far the topmost cube comes down; dashed: how far it goes sideways. At 2000 mm the tower "
                        "has fallen.";
    sheet.more = "set format x '%g'\nset yrange [0.0001:10000]";
    add_over_rates(sheet, rows, "tower_20", "sink", "", Line::Look::plain);
    add_over_rates(sheet, rows, "tower_20", "drift", ", drift", Line::Look::dashed);
    return sheet;
}

/// ns a body and step as scenes grow.
Sheet growth(const Rows& rows) {
    Sheet sheet;
    sheet.name = "contact_bodies";
    sheet.title = "Cost of a body that touches others as their number grows";
    sheet.x_label = "bodies";
    sheet.y_label = "ns per body-step, 60 Hz";
    sheet.how_to_read =
        "Solid: pyramids of 55, 210, 465 cubes. Dashed: piles of 512 and 4096 balls. A body of a pyramid has 8 to 16 points of "
        "contact, a ball about 6.";
    sheet.more =
        "set format x '%g'\nset format y '%g'\nset xrange [40:6000]\nset yrange [200:20000]\nset xtics (50, 100, 200, 500, "
        "1000, 2000, 4000)\nset ytics (200, 500, 1000, "
        "2000, 5000, 10000, 20000)";
    struct Build {
        const char *method, *scalar, *title, *color;
        int lanes;
    };
    struct Scene {
        const char* name;
        int bodies;
    };
    for (const bool piles : {false, true}) {
        for (const Build& build :
             {Build{"default", "float", "ingot, 1 lane", "#f2a1a8", 1},
              Build{"default", "float", "ingot, 4 lanes", "#e63946", 4},
              Build{"default", "float", "ingot, 8 lanes", "#8c1d27", 8}, Build{"bullet", "float", "Bullet", "#2684c9", 1},
              Build{"ode", "double", "ODE", "#1b9e77", 1}, Build{"box3d", "float", "Box3D", "#7b4fb3", 1},
              Build{"jolt", "float", "Jolt", "#d98e04", 1}}) {
            const std::vector<Scene> scenes =
                piles ? std::vector<Scene>{{"pile_512", 512}, {"pile_4096", 4096}}
                      : std::vector<Scene>{{"pyramid_55", 55}, {"pyramid_210", 210}, {"pyramid_465", 465}};
            for (const Scene& scene : scenes) {
                const auto in = [&](const char* suite, double otherwise) {
                    return rows.value(suite, scene.name, build.method, build.scalar, build.lanes, 1.0 / 60, "ns_per_body_step",
                                      otherwise);
                };
                Line& line = sheet.line(std::string(build.title) + (piles ? ", balls" : ", cubes"), build.color);
                if (piles) line.look = Line::Look::dashed;
                Sheet::add_point(line, scene.bodies, in("peers", in("contact", missing)));
            }
        }
    }
    return sheet;
}

/// Distance from the exact solution against the time spent since a cold start.
Sheet to_exact(const Rows& rows, const std::string& scene, const std::string& title) {
    Sheet sheet;
    sheet.name = "contact_exact_" + scene;
    sheet.title = title;
    sheet.x_label = "µs since the scene was set down";
    sheet.y_label = "distance from the exact velocities, m/s";
    sheet.how_to_read =
        "The scene is set down without any memory of contacts and stepped at 60 Hz; points are 1, 2, 4, ... 256 steps. The "
        "exact "
        "solution is rest, from the first step on: the single point is the reference that finds it (Eigen, double), after the "
        "time "
        "it took. Distance: the speed that holds the kinetic energy of the whole scene.";
    const std::string prefix = scene + "_steps_";
    const auto add = [&](const std::string& suite, const std::string& method, const std::string& scalar, Line& line) {
        for (const Row& row : rows.all()) {
            if (row.suite != suite || row.method != method || row.scalar != scalar || row.metric != "distance_to_exact" ||
                row.case_name.rfind(prefix, 0) != 0)
                continue;
            const double us = rows.value(suite, row.case_name, method, scalar, row.lanes, row.h, "us_since_start", missing);
            Sheet::add_point(line, us, row.value);
        }
    };
    for (const Look& look : looks())
        add(look.method == "default" ? "contact" : "peers", look.method, look.scalar, sheet.line(look.title, look.color));
    for (const char* scalar : {"float", "double"})
        add("contact", "chosen", scalar,
            sheet.line(std::string("ingot, ChosenSolver, ") + scalar, std::string(scalar) == "float" ? "#d95f02" : "#7570b3"));
    add("contact", "exact", "double", sheet.line("exact solution", "#000000"));
    return sheet;
}

}  // namespace

std::vector<Sheet> contact_sheets(const Rows& rows) {
    return {pyramid(rows, "shift", "Does a pyramid of 210 cubes shift?"),
            pyramid(rows, "settling", "Does it settle?"),
            tower(rows),
            growth(rows),
            to_exact(rows, "pyramid_210", "A pyramid of 210 cubes comes to rest"),
            to_exact(rows, "tower_20", "A tower of 20 cubes comes to rest"),
            to_exact(rows, "mass_ratio_1000", "1000 kg on 1 kg come to rest"),
            to_exact(rows, "mass_ratio_1e6", "1000 t on 1 kg come to rest")};
}

}  // namespace report
