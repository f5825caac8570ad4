// SPDX-License-Identifier: MIT
#include "level_cases.h"
#include "suites.h"

namespace report {

namespace {

void add(const LevelFigures& figures, Rows& rows) {
    const auto row = [&](const std::string& ground, const std::string& method, double h, const char* metric, double value, const std::string& unit) {
        rows.add({"levels", ground, method, figures.scalar, figures.lanes, "host", h, metric, value, unit});
    };
    for (const OverGround& over : figures.over) {
        row(over.ground, over.body, 1 / over.rate, "way_error", over.way, "1");
        row(over.ground, over.body, 1 / over.rate, "speed_error", over.speed, "1");
        row(over.ground, over.body, 1 / over.rate, "hop", over.hop, "m");
        row(over.ground, over.body, 1 / over.rate, "impulse_error", over.impulse, "1");
    }
    for (const OfGround& of : figures.of) row(of.ground, "default", 0, of.metric.c_str(), of.value, of.unit);
}

}  // namespace

void run_levels(const Settings& settings, Rows& rows) {
    Progress progress(2);
    const int draws = settings.quick ? 1 : 8, repeats = settings.quick ? 1 : 5;
    progress.begin("levels, float");
    add(level_figures_of_float(draws, repeats), rows);
    progress.begin("levels, double");
    add(level_figures_of_double(draws, repeats), rows);
}

}  // namespace report
