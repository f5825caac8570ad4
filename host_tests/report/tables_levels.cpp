// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "page.h"

namespace report {

namespace {

/// Of all rates and bodies; NaN where nothing was measured.
double worst_of(const Rows& rows, const std::string& ground, const std::string& scalar, const std::string& metric) {
    double worst = std::nan("");
    for (const Row& row : rows.all())
        if (row.suite == "levels" && row.case_name == ground && row.scalar == scalar && row.metric == metric)
            worst = std::isnan(worst) ? row.value : std::max(worst, row.value);
    return worst;
}

double of_ground(const Rows& rows, const std::string& ground, const std::string& scalar, const char* metric) {
    return rows.value("levels", ground, "default", scalar, 0, 0, metric, std::nan(""));
}

}  // namespace

Table seams_table(const Rows& rows) {
    Table table{"Over seams",
                "A ball, a box, a wheel, a roller, a coin and a hull, of 0.05 to 0.8 m and 1 to 20 m/s, over a plane that is cut up, beside the same "
                "over a half space: the worst of all, at 30 to 1000 steps a second.",
                {{"ground", "scalar", "way, %", "velocity, %", "hop, mm", "impulses, %"}},
                "engines"};
    for (const char* ground : {"grid", "fan", "slivers", "flush boxes", "field"}) {
        bool first = true;
        for (const char* scalar : {"float", "double"}) {
            const auto cell = [&](const char* metric, double unit) { return number_text(unit * worst_of(rows, ground, scalar, metric), "%.2g"); };
            if (std::isnan(worst_of(rows, ground, scalar, "hop"))) continue;
            table.cells.push_back({first ? ground : "", scalar, cell("way_error", 100), cell("speed_error", 100), cell("hop", 1000),
                                   cell("impulse_error", 100)});
            first = false;
        }
    }
    return table;
}

Table ground_table(const Rows& rows) {
    Table table{"What ground takes",
                "Of a box that slides over cells of a metre, 64 beside each other; of a box of two metres that asks for its triangles, and of a ray "
                "from above. A hill of 18,818 triangles, 900 houses, and a field of 200 by 200 heights; the boxes slide over a plane.",
                {{"ground", "bytes a triangle", "bytes a height", "ns a box and step, float", "double", "ns a walk", "ns a ray"}},
                "engines"};
    for (const char* ground : {"slab", "terrain", "village", "field", "field in bytes"}) {
        const auto cell = [&](const char* scalar, const char* metric, const char* format) {
            return number_text(of_ground(rows, ground, scalar, metric), format);
        };
        table.cells.push_back({ground, cell("float", "bytes_per_triangle", "%.1f"), cell("float", "bytes_per_sample", "%.2f"),
                               cell("float", "box_ns", "%.0f"), cell("double", "box_ns", "%.0f"), cell("float", "walk_ns", "%.0f"),
                               cell("float", "ray_ns", "%.0f")});
    }
    return table;
}

}  // namespace report
