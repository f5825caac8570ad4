// SPDX-License-Identifier: MIT
// The tables of cost: throughput, cores, peers; and the names.
#include <cmath>

#include "method_info.h"
#include "page.h"

namespace report {

namespace {

const double missing = std::nan("");

/// A figure of the mcu suite.
double on_core(const Rows& rows, const std::string& case_name, const std::string& method, const std::string& core,
               const std::string& metric) {
    for (const Row& row : rows.all())
        if (row.suite == "mcu" && row.case_name == case_name && row.method == method && row.target == core &&
            row.metric == metric)
            return row.value;
    return missing;
}

/// "4 / 4": counted, and those of the table.
std::string flips_text(double flips, double of_table) {
    return std::isnan(flips) ? "" : number_text(flips, "%.0f") + " / " + number_text(of_table, "%.0f");
}

}  // namespace

Table throughput_table(const Rows& rows) {
    Table table{"Cost of a body as their number grows",
                "ns of one body in one step of the default method: status checks, gravity, momentum, rotation, translation. "
                "Floor: the "
                "operations of that step at two vector operations a cycle of this core's measured clock, on vectors of at most "
                "32 bytes; memory: what a body "
                "takes in the world of 4096, which is read once and for the most part written once a step.",
                {{"build", "1 body", "64", "1024", "4096", "65536", "floor", "4096 over floor", "65536 over 64", "operations",
                  "bytes a body"}}};
    for (const char* scalar : {"float", "double"}) {
        for (const int lanes : {1, 4, 8}) {
            const auto value = [&](int bodies, const char* metric) {
                return rows.value("throughput", "bodies_" + std::to_string(bodies), "default", scalar, lanes, 0, metric,
                                  missing);
            };
            std::vector<std::string> line = {std::string(scalar) + ", " + std::to_string(lanes) +
                                             (lanes == 1 ? " lane" : " lanes")};
            for (const int bodies : {1, 64, 1024, 4096, 65536})
                line.push_back(number_text(value(bodies, "ns_per_body_step"), "%.1f"));
            const double ns = value(4096, "ns_per_body_step"), floor = value(4096, "floor_ns");
            line.push_back(number_text(floor, "%.1f"));
            line.push_back(number_text(ns / floor, "%.2f"));
            line.push_back(number_text(value(65536, "ns_per_body_step") / value(64, "ns_per_body_step"), "%.2f"));
            line.push_back(number_text(value(4096, "operations"), "%.0f"));
            line.push_back(number_text(value(4096, "bytes_per_body"), "%.0f"));
            if (!std::isnan(ns)) table.cells.push_back(line);
        }
    }
    return table;
}

Table cores_table(const Rows& rows) {
    Table table{"One body on two cores",
                "One body that only turns (book case, 60 Hz), the whole public step, float. Instructions a step: mean, and on "
                "the Cortex-M4F the worst of 1000. Flash and RAM in bytes; the world is all the "
                "RAM there is but the stack.",
                {{"method", "instructions, M0", "M4F", "M4F, worst", "flash, M0", "M4F", "RAM of the world"}}};
    for (const MethodInfo& info : method_infos()) {
        const auto at = [&](const char* core, const char* metric) {
            return number_text(on_core(rows, "book", info.name, core, metric), "%.0f");
        };
        const char* const mean = "instructions_per_body_step";
        if (at("cortex-m4f", mean).empty()) continue;
        table.cells.push_back({info.name, at("cortex-m0", mean), at("cortex-m4f", mean), at("cortex-m4f", "instructions_worst"),
                               at("cortex-m0", "flash"), at("cortex-m4f", "flash"), at("cortex-m4f", "world_ram")});
    }
    return table;
}

Table scenes_table(const Rows& rows) {
    Table table{
        "Scenes as firmware",
        "The scenes of the demo, whole: flash beyond a firmware of nothing, in bytes.",
        {{"scene", "core", "instructions a step, mean", "worst step", "flash", "of it kernel", "RAM of the world", "stack"}}};
    for (const Row& row : rows.all()) {
        if (row.suite != "mcu" || row.metric != "instructions_mean") continue;
        std::vector<std::string> line = {row.case_name, row.target};
        for (const char* metric :
             {"instructions_mean", "instructions_worst", "flash", "kernel_flash", "world_ram", "stack_computed"})
            line.push_back(number_text(on_core(rows, row.case_name, "default", row.target, metric), "%.0f"));
        table.cells.push_back(line);
    }
    return table;
}

Table peers_table(const Rows& rows) {
    Table table{"Peers, in this run",
                "Attitude error in rad over one minute, energy error relative, and ns of one body in one step among 4096. The "
                "rows of the kernel are its default method.",
                {{"engine", "scalar", "book, 15 Hz", "book, 60 Hz", "book, 240 Hz", "energy, 60 Hz", "|L|, 60 Hz",
                  "dzhanibekov, 60 Hz", "flips / table", "ns per body-step"}}};
    for (const char* engine : {"bullet", "bullet_no_shapes", "ode"}) {
        for (const char* scalar : {"float", "double"}) {
            const std::string flown = engine == std::string("bullet_no_shapes") ? "bullet" : engine;
            const auto at = [&](const char* case_name, int rate, const char* metric) {
                return rows.value("peers", case_name, flown, scalar, 0, 1.0 / rate, metric, missing);
            };
            const double ns = rows.value("peers", "bodies_4096", engine, scalar, 0, 0, "ns_per_body_step", missing);
            if (std::isnan(ns)) continue;
            table.cells.push_back(
                {engine, scalar, error_text(at("book", 15, "attitude_error")), error_text(at("book", 60, "attitude_error")),
                 error_text(at("book", 240, "attitude_error")), error_text(at("book", 60, "energy_error")),
                 error_text(at("book", 60, "L_error")), error_text(at("dzhanibekov", 60, "attitude_error")),
                 flips_text(at("dzhanibekov", 60, "flips"), at("dzhanibekov", 60, "flips_of_table")), number_text(ns, "%.1f")});
        }
    }
    if (table.cells.size() == 1) return table;
    for (const char* scalar : {"float", "double"}) {
        for (const int lanes : {1, 4, 8}) {
            const auto at = [&](const char* case_name, int rate, const char* metric) {
                return rows.value("rotation", case_name, "default", scalar, 0, 1.0 / rate, metric, missing);
            };
            const double ns = rows.value("peers", "bodies_4096", "default", scalar, lanes, 0, "ns_per_body_step", missing);
            if (std::isnan(ns)) continue;
            table.cells.push_back({"ingot, " + std::to_string(lanes) + (lanes == 1 ? " lane" : " lanes"), scalar,
                                   error_text(at("book", 15, "attitude_error")), error_text(at("book", 60, "attitude_error")),
                                   error_text(at("book", 240, "attitude_error")), error_text(at("book", 60, "energy_error")),
                                   error_text(at("book", 60, "L_error")), error_text(at("dzhanibekov", 60, "attitude_error")),
                                   flips_text(at("dzhanibekov", 60, "flips"), at("dzhanibekov", 60, "flips_of_table")),
                                   number_text(ns, "%.1f")});
        }
    }
    return table;
}

Table names_table() {
    Table table{"The names", "", {{"in this report", "in a scene", "what it is"}}};
    for (const MethodInfo& info : method_infos())
        table.cells.push_back({info.name, info.type.empty() ? "" : "`" + info.type + "`", info.sentence});
    table.look = "words";
    return table;
}

}  // namespace report
