// SPDX-License-Identifier: MIT
#include <cmath>

#include "page.h"
#include "simbenchmark.h"

namespace report {

const std::vector<SimBenchmarkTest>& simbenchmark_tests() {
    static const std::vector<SimBenchmarkTest> all = {
        {"simbenchmark_rolling_diagonal", "rolling, diagonal", "m² s⁻²", "Bullet 5.7e-9 in 0.56 s", ""},
        {"simbenchmark_rolling_along_y", "rolling, along y", "m² s⁻²", "ODE 7.7e-9", ""},
        {"simbenchmark_bouncing", "bouncing", "J²", "RaiSim 1.9e-2 in 0.235 s", "RaiSim 186 in 0.025 s"},
        {"simbenchmark_666", "666", "m²", "RaiSim 1.35e-4 in 1.51 s", "RaiSim 1.5e-2 in 0.17 s"},
        {"simbenchmark_elastic_666", "elastic 666", "J²", "RaiSim 8.4 in 0.66 s", "RaiSim 5.2e6"},
    };
    return all;
}

const std::vector<int>& simbenchmark_rates() {
    static const std::vector<int> all = {1000, 500, 250, 125, 100};
    return all;
}

Table simbenchmark_table(const Rows& rows) {
    Table table{
        "SimBenchmark",
        "Errors by the definitions of the benchmark (Kang and Hwangbo, 2018); times are CPU time of the step call, 4 lanes. The best on record "
        "is of runs in double on an i7-class desktop of 2018. Float ends where velocities round: 27 impulses a substep on a box of 3 m/s.",
        {{"test", "step, ms", "unit", "error, float", "error, double", "µs per step, float", "µs per step, double", "CPU s of the run, float",
          "best on record"}},
        "engines"};
    for (const SimBenchmarkTest& test : simbenchmark_tests()) {
        bool first = true;
        for (const int rate : simbenchmark_rates()) {
            const auto value = [&](const char* scalar, const char* metric) {
                return rows.value("simbenchmark", test.name, "default", scalar, 0, 1.0 / rate, metric, std::nan(""));
            };
            if (std::isnan(value("float", "error"))) continue;
            table.cells.push_back({first ? test.title : "", number_text(1e3 / rate, "%.0f"), test.unit, error_text(value("float", "error")),
                                   error_text(value("double", "error")), number_text(value("float", "us_per_step"), "%.1f"),
                                   number_text(value("double", "us_per_step"), "%.1f"), number_text(value("float", "cpu_seconds"), "%.3f"),
                                   rate == 1000 ? test.best_at_1_ms : rate == 100 ? test.best_at_10_ms : ""});
            first = false;
        }
    }
    return table;
}

}  // namespace report
