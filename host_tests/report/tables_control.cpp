// SPDX-License-Identifier: MIT
#include <cmath>

#include "page.h"

namespace report {

namespace {

double value_of(const Rows& rows, const char* machine, const char* scalar, int rate, const char* metric) {
    return rows.value("control", machine, "default", scalar, 0, 1.0 / rate, metric, std::nan(""));
}

}  // namespace

Table walkers_table(const Rows& rows) {
    Table table{"Walkers",
                "Seven bodies in the plane, thirteen in space, that walk by servos of their joints, without a limit of torque or with one: until "
                "they fall, or for the whole run. Gaps are of hips, knees and ankles, depths of feet; a step is one of the controller and one of the "
                "world.",
                {{"walker", "scalar", "steps a second", "walked, s", "distance, m", "steps not settled", "gap, mm", "depth, mm", "us a step"}},
                "engines"};
    for (const char* machine : {"walker in the plane", "walker in the plane, 100 N m", "walker in the plane, 150 N m", "walker in the plane, 200 N m",
                                "walker in space", "walker in space, 100 N m", "walker in space, 150 N m", "walker in space, 200 N m"}) {
        bool first = true;
        for (const char* scalar : {"float", "double"})
            for (const int rate : {30, 60, 120, 240}) {
                const auto cell = [&](const char* metric, double unit, const char* format) {
                    return number_text(unit * value_of(rows, machine, scalar, rate, metric), format);
                };
                if (std::isnan(value_of(rows, machine, scalar, rate, "walked"))) continue;
                table.cells.push_back({first ? machine : "", scalar, std::to_string(rate), cell("walked", 1, "%.0f"), cell("distance", 1, "%.2f"),
                                       cell("unsettled", 1, "%.0f"), cell("gap", 1000, "%.2g"),
                                       cell("depth", 1000, "%.2g"), cell("us_per_step", 1, "%.1f")});
                first = false;
            }
    }
    return table;
}

Table servos_table(const Rows& rows) {
    Table table{"Servos",
                "A body of 0.001 kg m^2. Four steps after its target went by 1 rad, of a ball joint by 2.5 rad, with kp 1e6; how long it "
                "takes with 0.1, 1 and 10 N m at most, of what the law takes; how far what is tuned to 1 to 5 Hz is off the exact swing, at "
                "damping ratios of 0.1 to 2; a motor off its rate; a load off torque over stiffness; and the angular momentum of a pair that "
                "floats, of what turns. The worst of each.",
                {{"scalar", "steps a second", "four steps, rad", "of a ball, rad", "to settle", "tuned, rad", "motor", "load", "momentum"}}};
    for (const char* scalar : {"float", "double"})
        for (const int rate : {30, 60, 120, 240}) {
            const auto cell = [&](const char* metric) { return error_text(value_of(rows, "servo", scalar, rate, metric)); };
            table.cells.push_back({scalar, std::to_string(rate), cell("off_after_four_steps"), cell("ball_off_after_four_steps"),
                                   number_text(value_of(rows, "servo", scalar, rate, "settling_ratio"), "%.2f"), cell("tuned_off"), cell("motor_off"),
                                   cell("load_off"), cell("momentum_off")});
        }
    return table;
}

Table arm_table(const Rows& rows) {
    Table table{"An arm that follows paths",
                "Six hinges swing along paths drawn at random for three seconds, by torques computed from the equations of motion, held over a step, "
                "and by servos of kp 1e6: rad, of the worst joint of all paths.",
                {{"steps a second", "by torques, float", "double", "by servos, float", "double"}}};
    for (const int rate : {30, 60, 120, 240}) {
        const auto cell = [&](const char* scalar, const char* metric) {
            return error_text(value_of(rows, "arm of six hinges", scalar, rate, metric));
        };
        table.cells.push_back({std::to_string(rate), cell("float", "off_by_torques"), cell("double", "off_by_torques"),
                               cell("float", "off_by_servos"), cell("double", "off_by_servos")});
    }
    return table;
}

}  // namespace report
