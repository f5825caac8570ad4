// SPDX-License-Identifier: MIT
// What contacts cost, and how wrong they are, at several efforts: a table and the curves.
#include <cmath>

#include "effort_cases.h"
#include "page.h"
#include "plots_effort.h"

namespace report {

namespace {

const double missing = std::nan("");
constexpr double frame = 1.0 / 60;

struct Shown {
    const char *title, *scene, *error, *color;
};
const std::vector<Shown>& scenes_shown() {
    static const std::vector<Shown> all = {
        {"wall of 55 cubes: shift, mm", "pyramid_55", "shift", "#f2a1a8"},
        {"wall of 210 cubes: shift, mm", "pyramid_210", "shift", "#e63946"},
        {"wall of 465 cubes: shift, mm", "pyramid_465", "shift", "#8c1d27"},
        {"512 balls: overlap, mm", "pile_512", "mean_overlap", "#2684c9"},
        {"512 random boxes: overlap, mm", "pile_boxes_512", "mean_overlap", "#1b9e77"},
        {"512 mixed: overlap, mm", "pile_mixed_512", "mean_overlap", "#7b4fb3"},
        {"tower of 20 cubes: top sinks, mm", "tower_20", "sink", "#d98e04"}};
    return all;
}

double figure(const Rows& rows, const Shown& shown, const EffortLevel& level, const char* metric) {
    return rows.value("effort", shown.scene, method_of(level), "float", 0, frame, metric, missing);
}

}  // namespace

Table effort_table(const Rows& rows) {
    Table table{"Time and error by effort",
                "60 Hz, float, 4 lanes. µs of a step in the later half of the run, a share of Box3D's time where the report is built with it, and "
                "the error, of overlaps the mean. What is swept more comes to rest sooner, and rest costs little: more effort may take less time.",
                {{"scene"}}};
    for (const EffortLevel& level : effort_levels) table.cells[0].push_back(level.name);
    for (const Shown& shown : scenes_shown()) {
        std::vector<std::string> line = {shown.title};
        for (const EffortLevel& level : effort_levels) {
            const double us = figure(rows, shown, level, "us_per_step"), share = figure(rows, shown, level, "time_ratio_to_box3d");
            const double error = figure(rows, shown, level, shown.error);
            std::string cell = std::isnan(us) ? "" : number_text(us, "%.0f µs");
            if (!std::isnan(share)) cell += number_text(share, " (%.2f)");
            if (!cell.empty()) cell += ": " + (std::abs(error) < 0.01 ? error_text(error) : number_text(error, "%.3g"));
            line.push_back(cell);
        }
        table.cells.push_back(line);
    }
    return table;
}

Sheet effort_sheet(const Rows& rows) {
    Sheet sheet;
    sheet.name = "effort_curves";
    sheet.title = "What does more effort buy?";
    sheet.x_label = "µs of a step, 4 lanes";
    sheet.y_label = "error, mm";
    sheet.how_to_read =
        "Each point is an effort: {2, 3}, {4, 3}, {8, 3}, {8, 6} substeps and sweeps, along the line. Left is cheaper, lower is more "
        "accurate. A line that goes to the left and down has come to rest with more effort.";
    sheet.more = "set format x '%g'";
    for (const Shown& shown : scenes_shown())
        for (const EffortLevel& level : effort_levels)
            Sheet::add_point(sheet.line(shown.title, shown.color), figure(rows, shown, level, "us_per_step"),
                             figure(rows, shown, level, shown.error));
    return sheet;
}

}  // namespace report
