// SPDX-License-Identifier: MIT
#include "page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "commit.h"  // made by commit.cmake

namespace report {

namespace {

const double missing = std::nan("");

std::string machine_text(bool quick) {
    std::ifstream file("/proc/cpuinfo");
    std::string model = "an unnamed processor";
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("model name", 0) != 0) continue;
        model = line.substr(line.find(':') + 2);
        break;
    }
    return std::string("Built with " INGOT_COMPILER " from commit " INGOT_COMMIT ", run on ") + model + ". " +
           (quick ? "A quick run: fewer cases and steps. `ingot_report` without `--quick` takes minutes and flies everything. "
                  : "") +
           "Errors and counts are exact and the same on every machine; times are the least of several repetitions on one core, "
           "good for ratios within this run only.";
}

std::vector<Headline> headlines(const Rows& rows) {
    const auto error = [&](const char* scalar, int rate) {
        return error_text(rows.value("rotation", "book", "default", scalar, 0, 1.0 / rate, "attitude_error", missing));
    };
    double ns = missing;
    int lanes = 8;
    for (; lanes > 1; lanes /= 2) {
        ns = rows.value("throughput", "bodies_4096", "default", "float", lanes, 0, "ns_per_body_step", missing);
        if (!std::isnan(ns)) break;
    }
    double instructions = missing, ram = missing;
    for (const Row& row : rows.all()) {
        if (row.suite != "mcu" || row.case_name != "book" || row.method != "default" || row.target != "cortex-m4f") continue;
        if (row.metric == "instructions_per_body_step") instructions = row.value;
        if (row.metric == "world_ram") ram = row.value;
    }
    std::vector<Headline> all = {
        {error("double", 15), "rad", "error of orientation after a minute of tumbling: double, 15 steps a second"},
        {error("float", 60), "rad", "the same in float, 60 steps a second: micrometres at the end of a metre"},
        {number_text(ns, "%.1f"), "ns", "for a body's whole step, one of 4096, float, " + std::to_string(lanes) + " lanes"},
        {number_text(instructions, "%.0f"), "instructions",
         "for a body's whole step on a Cortex-M4F, in a world of " + number_text(ram, "%.0f") + " bytes"},
    };
    for (const int wide : {8, 4, 1}) {
        const double us = rows.value("contact", "pyramid_210", "default", "float", wide, 1.0 / 60, "us_per_step", missing);
        if (std::isnan(us)) continue;
        all.push_back(
            {number_text(us, "%.0f"), "µs", "for a step of a pyramid of 210 cubes, float, " + std::to_string(wide) + " lanes"});
        break;
    }
    all.erase(std::remove_if(all.begin(), all.end(), [](const Headline& h) { return h.figure.empty(); }), all.end());
    return all;
}

std::vector<Section> all_sections(const Rows& rows) {
    return {
        {"rotation",
         "Free rotation",
         {"A body that nothing touches keeps its energy and its angular momentum L, and still does not turn evenly: it "
          "tumbles. Its orientation after a minute shows how good a method is. "
          "The body here, `book`, has the moments 1, 2 and 3 kg m^2 and turns at about 1.3 rad/s; the exact solution is known "
          "to 32 digits.",
          "**Attitude error** is the angle between the computed and the exact orientation: 3 rad is lost, 0.01 rad can be "
          "seen, 1e-6 rad is a micrometre at the end of a metre."},
         {},
         {methods_table(rows, "double"), methods_table(rows, "float"), cases_table(rows)}},
        {"float",
         "How far float goes",
         {"A float holds seven digits, and every step rounds. Two options of the default carry further: compensation keeps the "
          "digits that the sum for A loses, "
          "energy return takes back the walk of the energy. Together they hold an hour."},
         {},
         {hour_table(rows)}},
        {"driven",
         "Force fields",
         {"With a torque there is no closed solution to follow; the references are trajectories of heavy tops and swinging "
          "torques, again to 32 digits. Every scheme here "
          "uses the default method for the free flight between kicks."},
         {},
         {driven_table(rows, "double"), driven_table(rows, "float")}},
        {"drift",
         "Long runs",
         {"What becomes of energy, and of A as a rotation, over very many steps of 1/60 s. L is stored, not computed: it stays "
          "to the bit."},
         {},
         {}},
        {"throughput",
         "Throughput",
         {"The whole public step, with everything a game or a constellation of satellites needs of free bodies. Lanes are "
          "bodies that one instruction advances side by side; "
          "the build is chosen at compile time, and the bits of every result are the same in all. Doubles in 8 lanes are 64 "
          "bytes wide, twice what the AVX2 instructions of that build hold."},
         {},
         {throughput_table(rows)}},
        {"contact",
         "Contact",
         {"Stacks, piles, slopes and bounces, with friction: the scenes that games are made of, and in which engines sink, "
          "drift, "
          "creep and gain energy. Each is run by every build of the kernel, and in a build with peers by other engines "
          "(default settings, no sleeping), which take turns with it, step by step, so that ratios hold on a busy machine.",
          "**Errors** are those of whole runs, every step of which is looked at (a quick run follows the peers, and the "
          "kernel in float beside them, for 3 to 10 s only). **Times** are CPU time of the step call alone in the "
          "later "
          "half of a run; of each step the least over three runs (one in a quick run), of the steps the median."},
         {},
         contact_tables(rows)},
        {"effort",
         "Effort",
         {"A scene names how many substeps and sweeps contacts have: `static constexpr Effort effort = low_effort;`, or numbers of its own. "
          "Errors are those of whole runs, times those of the later half, as above."},
         {},
         {effort_table(rows)}},
        {"simbenchmark",
         "SimBenchmark",
         {"Four published tests of rigid-body engines, at steps of 1 to 10 ms: balls that roll on a box that is pushed, balls that bounce, and 216 "
          "balls "
          "that pile up, without and with restitution."},
         {},
         {simbenchmark_table(rows)}},
        {"levels",
         "Levels",
         {"Ground of triangles and of heights. Whatever a plane is cut into, a body goes over it as over one plane: tests demand 0.1 % of way and "
          "velocity, 0.1 mm of height and 1 % of the impulses, of every shape, cut, speed and rate."},
         {},
         {seams_table(rows), ground_table(rows)}},
        {"control",
         "Control",
         {"Figures that are driven: servos aim at the end of the step, so gains have no limit that a rate would set."},
         {},
         {walkers_table(rows), servos_table(rows), arm_table(rows)}},
        {"mcu",
         "Microcontrollers",
         {"The same source as firmware on emulated cores. Instructions are executed ones, counted by the emulator: exact, but "
          "not cycles. Flash counts what the scene adds to a firmware of "
          "nothing, soft float included. Measured by the cross builds and kept in `host_tests/tables/methods.csv`, which their "
          "tests check."},
         {},
         {cores_table(rows), scenes_table(rows)}},
        {"peers",
         "Beside other engines",
         {"Other engines, linked into this program and run on the same bodies in the same minute, with their defaults, on one thread and "
          "without sleep: Bullet (10 iterations) and ODE (quick step, 20 iterations) from the distribution's packages; Box3D (4 substeps) "
          "and Jolt (10 velocity and 2 position steps) as their own CMake builds and installs them."},
         {},
         {shares_table(rows), peers_table(rows)}},
    };
}

Section how_it_was_measured() {
    return {"method",
            "How it was measured",
            {"**Errors.** Each method flies each case in a world of its own, through the public `step()`, and is compared with "
             "the table of `host_tests/reference/` at its samples; the worst counts. "
             "Energy is formed from A and L in extended precision. Steps as 1/60 s are rounded to the scalar like a user's: in "
             "float that alone shifts the phase of a long run.",
             "**Order.** The slope of the error of the book case in double, over the finest four steps at which it stands "
             "above rounding.",
             "**Times.** One thread, a steady clock, the least of 5 to 9 repetitions. `bodies_1024` and `bodies_4096` are "
             "bodies with unequal moments that turn at up to 5 rad/s, each in its own way; "
             "the times against which errors are plotted are of 64 copies of the book body, at the rate in question.",
             "**Operations** are counted, not estimated: on a Cortex-M0 every + - * / on floats and every root is a call, and "
             "the linker leads each call through a counter. They are those of one whole "
             "public step, omega included, as the compiler left them at -O2; mean of 128 "
             "steps. + - and * are the metric `flops`; plots add divisions and roots, one each.",
             "**Columns of report.csv**: `h` is the step in s, 0 where none is meant; `target` is `host`, a core, or `any` for "
             "what is counted once for all; `unit` 1 is a plain number or a ratio.",
             "Nothing here was taken from another run but the tables of cores, which are committed beside the source."},
            {},
            {names_table()}};
}

}  // namespace

std::string number_text(double value, const char* format) {
    if (std::isnan(value)) return "";
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string error_text(double value) {
    if (std::isinf(value)) return "lost";
    if (value == 0) return "0";
    std::string text = number_text(value, "%.1e");
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    const int exponent = std::atoi(text.c_str() + e + 1);
    return exponent == 0 ? text.substr(0, e) : text.substr(0, e) + "e" + std::to_string(exponent);
}

bool Table::has_figures() const {
    for (std::size_t line = 1; line < cells.size(); ++line)
        for (std::size_t cell = 1; cell < cells[line].size(); ++cell)
            if (!cells[line][cell].empty()) return true;
    return false;
}

Table claims_table(const std::vector<Claim>& claims) {
    Table table{
        "What it has to reach, and what this run measured",
        "Bars the project has set itself, the missed ones too. Errors and counts are exact; verdicts on times are of this run.",
        {{"what", "measured", "asked for", "verdict"}}};
    for (const Claim& claim : claims) {
        if (!claim.is_measured()) continue;
        const bool plain = claim.bound >= 0.1 && claim.bound < 1e5;
        const auto text = [&](double value) {
            return (plain ? number_text(value, value < 100 ? "%.3g" : "%.0f") : error_text(value)) +
                   (claim.unit.empty() ? "" : " " + claim.unit);
        };
        const std::string measured = claim.bound == 0 && claim.measured < 1e5 ? number_text(claim.measured, "%.0f")
                                     : claim.measured >= 1e5                  ? error_text(claim.measured) + " " + claim.unit
                                                                              : text(claim.measured);
        table.cells.push_back(
            {claim.what, measured, (claim.at_least ? "≥ " : "≤ ") + text(claim.bound), claim.holds() ? "met" : "missed"});
    }
    return table;
}

Table choice_table(const Rows& rows) {
    Table table{"What to choose",
                "A scene names its method in one line, `using rotation = ingot::...;`. Errors are of the book case, one minute "
                "at 60 Hz; ns of one body in one step, float, 8 lanes (4 where the machine has no 8).",
                {{"you have", "write", "error, float", "error, double", "ns", "instructions, M4F"}}};
    const auto line = [&](const std::string& what, const std::string& type, const std::string& method,
                          const std::string& case_name) {
        const auto error = [&](const char* scalar) {
            return error_text(rows.value("rotation", case_name, method, scalar, 0, 1.0 / 60, "attitude_error", missing));
        };
        double ns = missing;
        for (const int lanes : {4, 8})
            ns = rows.value("rotation", "bodies_1024", method, "float", lanes, 0, "ns_per_body_step", ns);
        std::string instructions;
        for (const Row& row : rows.all())
            if (row.suite == "mcu" && row.method == method && row.target == "cortex-m4f" &&
                row.metric == "instructions_per_body_step")
                instructions = number_text(row.value, "%.0f");
        table.cells.push_back({what, type, error("float"), error("double"), number_text(ns, "%.1f"), instructions});
    };
    line("**anything**", "nothing: it is the default", "default", "book");
    line("a very small microcontroller", "`DiscreteMoserVeselov<4, false, false, 1>`", "moser_veselov_4_plain", "book");
    line("only balls, cylinders, cones (errors: case oblate)", "`SymmetricTop`", "symmetric_top", "oblate");
    line("spin beyond 8 rad a step", "`SymmetricTopSplitting<6>`", "symmetric_top_splitting_6", "book");
    line("a lecture on the article", "`Listing1Euler`", "listing1_euler", "book");
    return table;
}

Page page_of(const Rows& rows, const std::vector<Plot>& plots, const Settings& settings) {
    Page page;
    page.machine = machine_text(settings.quick);
    page.headlines = headlines(rows);
    page.choice = choice_table(rows);
    page.claims = claims(rows);
    page.drawn = can_draw_plots();
    for (Section& section : all_sections(rows)) {
        std::vector<Table> filled;
        for (Table& table : section.tables)
            if (table.has_figures()) filled.push_back(std::move(table));
        section.tables = std::move(filled);
        for (const Plot& plot : plots)
            if (plot.name.rfind(section.id + "_", 0) == 0) section.plots.push_back(plot);
        if (!section.tables.empty() || !section.plots.empty()) page.sections.push_back(std::move(section));
    }
    page.sections.push_back(how_it_was_measured());
    return page;
}

}  // namespace report
