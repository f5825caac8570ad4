// SPDX-License-Identifier: MIT
// The tables of contact scenes: one for each kind, every engine a line.
#include <cmath>

#include "page.h"

namespace report {

namespace {

const double missing = std::nan("");
constexpr double frame = 1.0 / 60;

/// A line of a table: who ran a scene.
struct Engine {
    std::string title, method, scalar;
};

const std::vector<Engine>& engines() {
    static const std::vector<Engine> all = {{"ingot, float", "default", "float"}, {"ingot, double", "default", "double"},
                                            {"Bullet, float", "bullet", "float"}, {"Bullet, double", "bullet", "double"},
                                            {"ODE, float", "ode", "float"},       {"ODE, double", "ode", "double"},
                                            {"Box3D, float", "box3d", "float"},   {"Jolt, float", "jolt", "float"}};
    return all;
}

bool is_time(const std::string& metric) {
    return metric == "us_per_step" || metric == "ns_per_body_step" || metric == "time_ratio_to_bullet";
}

/// A figure of a scene at 60 Hz. Times are of the race with the peers where there was one; errors do not depend on lanes (0).
double figure(const Rows& rows, const std::string& scene, const Engine& engine, int lanes, const std::string& metric) {
    const auto in = [&](const char* suite, double otherwise) {
        return rows.value(suite, scene, engine.method, engine.scalar, lanes, frame, metric, otherwise);
    };
    return engine.method != "default" ? in("peers", missing) : in("peers", in("contact", missing));
}

struct Column {
    std::string title, metric;
};

std::string text_of(const std::string& metric, double value) {
    if (metric == "us_per_step" || metric == "ns_per_body_step")
        return number_text(value, value < 10 ? "%.2f" : value < 100 ? "%.1f" : "%.0f");
    if (metric == "time_ratio_to_bullet" || metric == "stood" || metric == "rest_time") return number_text(value, "%.3g");
    if (metric == "escaped" || metric == "frozen") return number_text(value, "%.0f");
    if (metric == "sweeps") return number_text(value, "%.1f");
    if (metric == "world_bytes") return number_text(value / 1024, value < 10240 ? "%.1f" : "%.0f");
    if (value != 0 && (std::abs(value) < 0.01 || std::abs(value) >= 1e5)) return error_text(value);
    return number_text(value, std::abs(value) < 999.5 ? "%.3g" : "%.0f");
}

/// A stack that came down before its run was over: where its bodies lie then tells nothing.
bool fell(const Rows& rows, const std::string& scene, const Engine& engine) {
    return figure(rows, scene, engine, 0, "stood") < figure(rows, scene, engine, 0, "seconds") - frame / 2;
}

/// Of the kernel's times those with 1, 4 and 8 lanes.
std::string cell_of(const Rows& rows, const std::string& scene, const Engine& engine, const std::string& metric) {
    const bool froze = figure(rows, scene, engine, 0, "frozen") > 0;
    if (froze && metric != "frozen" && metric != "world_bytes") return "froze";
    const bool way = metric == "sink" || metric == "drift" || metric == "max_overlap" || metric == "mean_overlap";
    if (way && fell(rows, scene, engine)) return "fell";
    if (engine.method != "default" || !is_time(metric)) return text_of(metric, figure(rows, scene, engine, 0, metric));
    std::string all;
    for (const int lanes : {1, 4, 8}) {
        const std::string one = text_of(metric, figure(rows, scene, engine, lanes, metric));
        if (!one.empty()) all += (all.empty() ? "" : " / ") + one;
    }
    return all;
}

/// Without the columns of which no line has anything.
Table without_empty_columns(Table table) {
    for (std::size_t column = table.cells[0].size(); column-- > 2;) {
        bool filled = false;
        for (std::size_t line = 1; line < table.cells.size(); ++line) filled = filled || !table.cells[line][column].empty();
        if (filled) continue;
        for (std::vector<std::string>& cells : table.cells) cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(column));
    }
    return table;
}

/// Scenes one after another, each with a line for every engine that ran it.
Table table_of(const Rows& rows, const std::string& title, const std::string& note, const std::vector<Column>& scenes,
               const std::vector<Column>& columns) {
    Table table{title, note, {{"scene", "engine"}}, "engines"};
    for (const Column& column : columns) table.cells[0].push_back(column.title);
    for (const Column& scene : scenes) {
        bool first = true;
        for (const Engine& engine : engines()) {
            if (std::isnan(figure(rows, scene.metric, engine, 0, "seconds"))) continue;
            std::vector<std::string> line = {first ? scene.title : "", engine.title};
            for (const Column& column : columns) line.push_back(cell_of(rows, scene.metric, engine, column.metric));
            table.cells.push_back(line);
            first = false;
        }
    }
    return without_empty_columns(std::move(table));
}

const Column us = {"µs per step, 1/4/8 lanes", "us_per_step"}, ratio = {"time by Bullet's, 4/8 lanes", "time_ratio_to_bullet"},
             gain = {"largest energy gain of a step", "energy_gain"}, residual = {"residual, m/s", "residual"},
             sweeps = {"sweeps per step", "sweeps"}, bytes = {"world, KB", "world_bytes"};

}  // namespace

std::vector<Table> contact_tables(const Rows& rows) {
    const Column mean = {"mean overlap, mm", "mean_overlap"}, deepest = {"largest overlap, mm", "max_overlap"};
    return {
        table_of(rows, "Pyramids",
                 "Walls of 1 m, 1 kg cubes, 10 s at 60 Hz. Shift: the largest way of any cube sideways, at any time; settling: "
                 "the same downwards; settled: what is left of it after 10 s. All are 0 in the exact solution.",
                 {{"55 cubes", "pyramid_55"}, {"210 cubes", "pyramid_210"}, {"465 cubes", "pyramid_465"}},
                 {{"shift, mm", "shift"},
                  {"settling, mm", "settling"},
                  {"settled, mm", "settled"},
                  mean,
                  deepest,
                  residual,
                  sweeps,
                  us,
                  ratio,
                  bytes}),
        table_of(
            rows, "Towers and heavy loads",
            "One cube on another: 20 and 40 of 1 kg for 60 s, and light ones under a heavy one for 10 s. It stood until any "
            "cube had left its place by 0.5 m. Searched: no manifold is carried over from step to step. "
            "Times of an engine whose cubes have fallen are those of scattered cubes.",
            {{"20 cubes", "tower_20"},
             {"20, searched", "tower_20_searched"},
             {"40 cubes", "tower_40"},
             {"1000 kg on 1 kg", "mass_ratio_1000"},
             {"1000 t on 1 kg", "mass_ratio_1e6"},
             {"1000 kg on nine of 1 kg", "mass_ratio_ten"}},
            {{"stood, s", "stood"},
             {"top sinks, mm", "sink"},
             {"top drifts, mm", "drift"},
             deepest,
             residual,
             sweeps,
             us,
             ratio,
             bytes}),
        table_of(
            rows, "Piles",
            "Balls dropped into a box, and 125 boxes of mixed sizes dropped 4 m into a pit; 10 s at 60 Hz. Overlaps are of "
            "the last 5 s, the mean over pairs that overlap. Speed: the largest of any body at the end. Beside peers also boxes of random "
            "sizes and attitudes, and mixed piles: balls, capsules and boxes in turns.",
            {{"512 balls", "pile_512"},
             {"4096 balls", "pile_4096"},
             {"125 boxes", "pit_125"},
             {"512 boxes", "pile_boxes_512"},
             {"2048 boxes", "pile_boxes_2048"},
             {"512 mixed", "pile_mixed_512"},
             {"2048 mixed", "pile_mixed_2048"}},
            {mean,
             deepest,
             {"escaped", "escaped"},
             {"frozen", "frozen"},
             {"speed, mm/s", "rest_speed"},
             gain,
             sweeps,
             {"ns per body-step, 1/4/8 lanes", "ns_per_body_step"},
             ratio,
             bytes}),
        table_of(
            rows, "Slopes",
            "A cube on 30 degrees. With friction 0.7 it should stay for 10 s; with 0.4 it slides, and after 2 s its distance "
            "is known.",
            {{"friction 0.7", "incline_mu07"}, {"friction 0.4", "incline_mu04"}},
            {{"creeps, mm", "creep"}, {"distance error, %", "distance_error"}, {"leaves the plane by, mm", "lift"}, us, ratio}),
        table_of(
            rows, "Bounces",
            "A ball dropped 2 m with e = 1 for 10 s: its energy should stay. The same with e = 0.5: the last of its bounces "
            "ends after 1.916 s. A box that lands flat with e = 0.5 should not turn.",
            {{"ball, e = 1", "bounce_e1"}, {"ball, e = 0.5", "bounce_e05"}, {"flat box, e = 0.5", "box_dropped_flat"}},
            {{"energy error", "energy_error"},
             gain,
             {"moved until, s", "rest_time"},
             {"spin, rad/s", "spin"},
             deepest,
             us,
             ratio}),
    };
}

}  // namespace report
