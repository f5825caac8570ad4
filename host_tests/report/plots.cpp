// SPDX-License-Identifier: MIT
#include "plots.h"

#include <cmath>
#include <cstdlib>

#include "gnuplot.h"
#include "method_info.h"
#include "plots_contact.h"
#include "plots_effort.h"

namespace report {

namespace {

const double missing = std::nan("");

/// Options of one method are compared among themselves, not on the plots of all methods.
bool is_option(const std::string& method) {
    return method.find("_plain") != std::string::npos || method.find("_compensated") != std::string::npos;
}

/// `default` first, as a wide band: the method it stands for is drawn on it.
Line& line_of(Sheet& sheet, const std::string& method) {
    Line& line = sheet.line(method, color_of(method));
    if (method == "default") line.look = Line::Look::band;
    return line;
}

enum class Cost { ns_of_second, ns_of_step, operations, instructions };

/// Error of the book case after a minute against cost; a line a method, a point a rate.
Sheet work_precision(const Rows& rows, const std::string& scalar, Cost cost) {
    Sheet sheet;
    sheet.y_label = "attitude error within 60 s, rad";
    const std::string reading =
        "Each line is a method, each point a rate: 15, 30, 60, 120, 240, 960 steps a second from top to bottom. ";
    if (cost == Cost::ns_of_second) {
        sheet.name = "rotation_" + scalar + "_second";
        sheet.title = "Error against the cost of a simulated second, " + scalar;
        sheet.x_label = "ns for one simulated second of one body, 4 lanes";
        sheet.how_to_read =
            "The plot to choose by. Each line is a method, each point a rate: 15, 30, 60, 120, 240, 960 steps a second from "
            "left to right. Lower is more accurate, left is "
            "cheaper. Where a line runs flat, the rounding of " +
            scalar + " is all that is left, and smaller steps buy nothing. The wide band is the default.";
    } else if (cost == Cost::ns_of_step) {
        sheet.name = "rotation_" + scalar + "_step";
        sheet.title = "Error against the cost of a step, " + scalar;
        sheet.x_label = "ns per body-step, 4 lanes";
        sheet.how_to_read = reading +
                            "What a step costs hardly depends on its length, so lines stand upright; a few bend left because "
                            "shorter steps need fewer sweeps.";
        sheet.more = "set format x '%g'\nset xtics (5, 10, 20, 50, 100, 200, 500)\nset xrange [5:1000]";
    } else if (cost == Cost::operations) {
        sheet.name = "rotation_" + scalar + "_operations";
        sheet.title = "Error against operations, " + scalar;
        sheet.x_label = "operations per body-step (+ - * / and roots, counted)";
        sheet.how_to_read = reading + "The same as the plot of ns, without a machine: the operations of the whole public step.";
        sheet.more = "set format x '%g'\nset xtics (100, 200, 500, 1000, 2000, 4000)\nset xrange [90:4000]";
    } else {
        sheet.name = "mcu_m4f";
        sheet.title = "Error against instructions on a Cortex-M4F";
        sheet.x_label = "instructions for one simulated second of one body";
        sheet.how_to_read =
            "Float, book case, 15 Hz (left) to 960 Hz (right): the error that a core's time buys. The cost of a step is that "
            "at 60 Hz.";
    }
    for (const Row& row : rows.all()) {
        if (row.suite != "rotation" || row.case_name != "book" || row.scalar != scalar || row.lanes != 1 ||
            row.metric != "attitude_error" || is_option(row.method))
            continue;
        const auto value = [&](const char* suite, int lanes, const char* metric, double h) {
            return rows.value(suite, "book", row.method, scalar, lanes, h, metric, missing);
        };
        double x = missing;
        if (cost == Cost::ns_of_step)
            x = value("rotation", 4, "ns_per_body_step", row.h);
        else if (cost == Cost::ns_of_second)
            x = value("rotation", 4, "ns_per_body_step", row.h) / row.h;
        else if (cost == Cost::operations)
            x = value("mcu", 0, "flops", row.h) + value("mcu", 0, "divisions", row.h) + value("mcu", 0, "square_roots", row.h);
        else
            for (const Row& core : rows.all())
                if (core.suite == "mcu" && core.case_name == "book" && core.method == row.method &&
                    core.target == "cortex-m4f" && core.metric == "instructions_per_body_step")
                    x = core.value / row.h;
        Sheet::add_point(line_of(sheet, row.method), x, row.value);
    }
    return sheet;
}

/// Attitude error in float against the rate, of the book case or of its hour.
Sheet float_floor(const Rows& rows, bool hour) {
    Sheet sheet;
    sheet.name = hour ? "float_hour" : "float_floor";
    sheet.title = hour ? "The floor of float after an hour" : "The floor of float after a minute";
    sheet.x_label = "step, s";
    sheet.y_label = hour ? "attitude error within 3600 s, rad" : "attitude error within 60 s, rad";
    sheet.how_to_read =
        hour ? "The same over an hour. Compensation alone leaves the walk of the energy, energy return takes it back. What is "
               "left is of the size of what the numbers "
               "themselves make: 1/15 s and its halves are off by 5e-8 in float, which is 2.5e-4 rad in this hour."
             : "Long steps are on the right: there the error of the method shows. On the left every method meets its floor, "
               "the roundings of very many steps. A method of "
               "order 6 is there already at 15 Hz, and compensation keeps it there.";
    sheet.more = "set format x '%g'\nset xtics (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1)";
    for (const Row& row : rows.all()) {
        if (row.suite != "rotation" || row.case_name != (hour ? "book_hour" : "book") || row.scalar != "float" ||
            row.lanes != 1 || row.metric != "attitude_error")
            continue;
        if (!hour && (row.method == "moser_veselov_8" || row.method == "moser_veselov_10" ||
                      row.method == "moser_veselov_10_plain" || row.method == "moser_veselov_4_plain"))
            continue;
        if (hour && (row.method == "moser_veselov_8" || row.method == "moser_veselov_10")) continue;
        if (row.h == 1.0 / 64) continue;  // exact in float, unlike the others: beside 60 Hz the line would jump
        Sheet::add_point(line_of(sheet, row.method), row.h, row.value);
    }
    return sheet;
}

Sheet driven(const Rows& rows, const std::string& case_name, const std::string& what) {
    Sheet sheet;
    sheet.name = "driven_" + case_name;
    sheet.title = what + ", double";
    sheet.x_label = "ns for one simulated second of one body, 4 lanes";
    sheet.y_label = "attitude error, rad";
    sheet.how_to_read =
        "Each line is a scheme, each point a rate: 32, 64, 128, 256 steps a second and up, from left to right. Twice the rate "
        "is 4 times less error with order 2, 16 times with order 4.";
    for (const Row& row : rows.all()) {
        if (row.suite != "driven" || row.case_name != case_name || row.scalar != "double" || row.metric != "attitude_error")
            continue;
        const double ns = rows.value("driven", "bodies_1024", row.method, "double", 4, 0, "ns_per_body_step", missing);
        Sheet::add_point(sheet.line(row.method, color_of(row.method)), ns / row.h, row.value);
    }
    return sheet;
}

Sheet drift(const Rows& rows, const std::string& metric, const std::string& scalar) {
    const bool orthogonality = metric == "orthogonality";
    Sheet sheet;
    sheet.name = "drift_" + metric + "_" + scalar;
    sheet.title = std::string(orthogonality ? "Does A stay a rotation? " : "Does the energy drift? ") +
                  (scalar == "float" ? "Float" : "Double");
    sheet.x_label = "steps of 1/60 s";
    sheet.y_label = orthogonality ? "largest entry of |A^T A - 1|" : "relative energy error";
    sheet.how_to_read = orthogonality ? "Flat: the matrix is kept orthonormal, to a few roundings."
                                      : "The worst of each stretch of the flight. Flat: the method keeps the energy. Slope "
                                        "1/2: roundings add up like a random walk. Slope 1: the method loses it.";
    for (const Row& row : rows.all()) {
        if (row.suite != "drift" || row.metric != metric || row.scalar != scalar) continue;
        Sheet::add_point(line_of(sheet, row.method), std::atof(row.case_name.c_str() + std::string("book_steps_").size()),
                         row.value);
    }
    return sheet;
}

Sheet throughput(const Rows& rows) {
    Sheet sheet;
    sheet.name = "throughput_bodies";
    sheet.title = "Cost of a body as their number grows";
    sheet.x_label = "bodies in the world";
    sheet.y_label = "ns per body-step";
    sheet.how_to_read =
        "One body costs as much as a vector of them. From there on the cost stays level, in the caches and beyond. Dashed: the "
        "floor of two vector operations a cycle, in float.";
    sheet.more =
        "set format x '%g'\nset format y '%g'\nset xtics (1, 64, 1024, 4096, 65536)\nset ytics (5, 10, 20, 50, 100, 200, 500, "
        "1000)\nset yrange [5:1000]";
    struct Build {
        const char *scalar, *color;
        int lanes;
    };
    for (const Build& build : {Build{"float", "#f2a1a8", 1}, Build{"float", "#e63946", 4}, Build{"float", "#8c1d27", 8},
                               Build{"double", "#a8d5f2", 1}, Build{"double", "#2684c9", 4}, Build{"double", "#0b2f66", 8}}) {
        const std::string title =
            std::string(build.scalar) + ", " + std::to_string(build.lanes) + (build.lanes == 1 ? " lane" : " lanes");
        const auto value = [&](int bodies, const char* metric) {
            return rows.value("throughput", "bodies_" + std::to_string(bodies), "default", build.scalar, build.lanes, 0, metric,
                              missing);
        };
        for (const int bodies : {1, 64, 1024, 4096, 65536})
            Sheet::add_point(sheet.line(title, build.color), bodies, value(bodies, "ns_per_body_step"));
        if (std::string(build.scalar) == "double") continue;
        Line& floor = sheet.line("floor, " + title, build.color);
        floor.look = Line::Look::dashed;
        for (const int bodies : {64, 65536}) Sheet::add_point(floor, bodies, value(4096, "floor_ns"));
    }
    return sheet;
}

Sheet peers(const Rows& rows) {
    Sheet sheet;
    sheet.name = "peers_book";
    sheet.title = "The same tumbling body through three engines";
    sheet.x_label = "step, s";
    sheet.y_label = "attitude error within 60 s, rad";
    sheet.how_to_read =
        "Book case, each engine in the scalar of its package. Above 1 rad the orientation has nothing to do with the body's.";
    sheet.more = "set format x '%g'\nset xtics (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1)";
    bool any = false;
    for (const Row& row : rows.all()) {
        if (row.suite != "peers" || row.case_name != "book" || row.metric != "attitude_error") continue;
        Sheet::add_point(sheet.line(row.method + ", " + row.scalar, color_of(row.method)), row.h, row.value);
        any = true;
    }
    if (!any) return sheet;
    for (const char* scalar : {"float", "double"})
        for (const Row& row : rows.all())
            if (row.suite == "rotation" && row.case_name == "book" && row.method == "default" && row.lanes == 1 &&
                row.scalar == scalar && row.metric == "attitude_error")
                Sheet::add_point(
                    sheet.line(std::string("ingot, ") + scalar, scalar == std::string("float") ? "#e63946" : "#8c1d27"), row.h,
                    row.value);
    return sheet;
}

}  // namespace

bool can_draw_plots() { return can_draw(); }

std::vector<Plot> draw_plots(const Rows& rows, const std::string& dir) {
    std::vector<Plot> plots;
    const bool drawing = can_draw();
    std::vector<Sheet> sheets = {
             work_precision(rows, "double", Cost::ns_of_second), work_precision(rows, "float", Cost::ns_of_second),
             work_precision(rows, "double", Cost::ns_of_step), work_precision(rows, "float", Cost::ns_of_step),
             work_precision(rows, "double", Cost::operations), work_precision(rows, "float", Cost::operations),
             float_floor(rows, false), float_floor(rows, true), driven(rows, "looping", "Looping heavy top, 20 s"),
             driven(rows, "asymmetric_chaotic", "Chaotic heavy top, 10 s"), drift(rows, "energy_error", "double"),
             drift(rows, "energy_error", "float"), drift(rows, "orthogonality", "double"),
             drift(rows, "orthogonality", "float"), throughput(rows), work_precision(rows, "float", Cost::instructions),
             peers(rows)};
    for (Sheet& sheet : contact_sheets(rows)) sheets.push_back(std::move(sheet));
    sheets.push_back(effort_sheet(rows));
    for (Sheet& sheet : sheets) {
        std::vector<Line> filled;
        for (Line& line : sheet.lines)
            if (!line.points.empty()) filled.push_back(std::move(line));
        sheet.lines = std::move(filled);
        if (!sheet.lines.empty())
            plots.push_back({sheet.name, sheet.title, sheet.how_to_read, drawing ? draw(sheet, dir) : ""});
    }
    return plots;
}

}  // namespace report
