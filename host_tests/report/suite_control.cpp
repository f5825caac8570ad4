// SPDX-License-Identifier: MIT
#include "control_cases.h"
#include "suites.h"

namespace report {

void run_control(const Settings& settings, Rows& rows) {
    Progress progress(2);
    const double seconds = settings.quick ? 5 : 60;
    const int paths = settings.quick ? 2 : 12;
    const auto add = [&rows](const ControlFigures& figures) {
        for (const OfMachine& of : figures.of)
            rows.add({"control", of.machine, "default", figures.scalar, figures.lanes, "host", 1 / of.rate, of.metric, of.value, of.unit});
    };
    progress.begin("control, float");
    add(control_figures_of_float(seconds, paths));
    progress.begin("control, double");
    add(control_figures_of_double(seconds, paths));
}

}  // namespace report
