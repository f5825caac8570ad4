// SPDX-License-Identifier: MIT
#include "suites.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace report {

using ingot_reference::DrivenCase;
using ingot_reference::FreeBodyCase;
using ingot_reference::TopCase;

namespace {

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

struct CaseName {
    const char *table, *name;
    bool symmetric;
    std::vector<int> rates;
};

const std::vector<int> whole_rates = {15, 30, 60, 120, 240, 960}, binary_rates = {16, 32, 64, 128, 256, 1024};

std::vector<CaseName> free_cases() {
    std::vector<CaseName> cases;
    for (const bool symmetric : {false, true}) {
        const std::string table = symmetric ? "free_symmetric" : "free_asymmetric";
        const ingot_reference::CsvTable params(table + "_params.csv");
        static std::vector<std::string> names;
        names.reserve(64);
        for (std::size_t row = 0; row < params.row_count(); ++row) {
            names.push_back(params.text(row, "case"));
            const FreeBodyCase body(table, names.back());
            // Samples must fall on steps: those at whole seconds go with any rate.
            const bool whole = std::floor(body.samples[1].t * 15) == body.samples[1].t * 15;
            cases.push_back({symmetric ? "free_symmetric" : "free_asymmetric", names.back().c_str(), symmetric, whole ? whole_rates : binary_rates});
        }
    }
    return cases;
}

double spin_of(const FreeBodyCase& body) {
    double spin = 0;
    for (const FreeBodyCase::Sample& sample : body.samples) spin = std::max(spin, static_cast<double>(sample.w_body.norm()));
    return spin;
}

/// Moments World takes for those of a solid.
bool is_solid(const FreeBodyCase& body) {
    const auto& I = body.I;
    return I.x() + I.y() >= I.z() * (1 - 1e-5L) && I.y() + I.z() >= I.x() * (1 - 1e-5L) && I.z() + I.x() >= I.y() * (1 - 1e-5L) &&
           I.maxCoeff() <= 1e6L * I.minCoeff();
}

/// Of the builds, those that give each result once: the bits do not depend on lanes.
std::vector<const Variant*> one_per_scalar(const std::vector<Variant>& variants) {
    std::vector<const Variant*> chosen;
    for (const char* scalar : {"double", "float"})
        for (const Variant& variant : variants)
            if (variant.scalar == scalar && variant.lanes == 1) chosen.push_back(&variant);
    return chosen;
}

/// The slope of the error over the finest four steps at which it stands above rounding.
double measured_order(const Method& method, const FreeBodyCase& body) {
    std::vector<double> x, y;
    for (const int rate : {3, 4, 5, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 768, 1024, 2048, 4096}) {
        const double error = method.fly(body, rate).attitude;
        if (error > 0.05) continue;
        // Ten times what roundings make of a minute; methods of high order get there in a few, compensated steps.
        if (error < (method.order >= 8 ? 1e-13 : 4e-12)) break;
        x.push_back(-std::log2(static_cast<double>(rate)));
        y.push_back(std::log2(error));
    }
    if (x.size() < 2) return std::nan("");
    const std::size_t first = x.size() > 4 ? x.size() - 4 : 0;
    return (y[first] - y.back()) / (x[first] - x.back());
}

}  // namespace

void run_rotation(const Settings& settings, const std::vector<Variant>& variants, Rows& rows) {
    const std::vector<CaseName> cases = free_cases();
    const std::vector<const Variant*> chosen = one_per_scalar(variants);
    Progress progress(static_cast<int>(cases.size() * chosen.size() + variants.size() + 2));
    for (const Variant* variant : chosen) {
        for (const CaseName& name : cases) {
            progress.begin(std::string("rotation ") + variant->scalar + " " + name.name);
            const FreeBodyCase body(name.table, name.name);
            if (!is_solid(body)) continue;
            const double spin = spin_of(body), time = static_cast<double>(body.samples.back().t);
            for (const Method& method : variant->methods) {
                if (method.symmetric_only && !name.symmetric) continue;
                for (const int rate : name.rates) {
                    if (spin / rate > method.angle_max) continue;
                    if (settings.quick && (time * rate > 20000 || (rate > 240 && std::string(name.name) != "book"))) continue;
                    const FlightErrors e = method.fly(body, rate);
                    const auto add = [&](const char* metric, double value, const char* unit) {
                        rows.add({"rotation", name.name, method.name, variant->scalar, variant->lanes, "host", 1.0 / rate, metric, value, unit});
                    };
                    add("attitude_error", e.attitude, "rad");
                    add("energy_error", e.energy, "1");
                    add("L_error", e.L, "1");
                    add("L_direction_error", e.L_direction, "rad");
                    add("orthogonality", e.orthogonality, "1");
                    add("flips", e.flips, "1");
                    add("flips_of_table", e.flips_of_table, "1");
                }
            }
        }
    }
    for (const Variant& variant : variants) {
        progress.begin("rotation cost, " + variant.scalar + " x " + std::to_string(variant.lanes));
        for (const Method& method : variant.methods)
            rows.add({"rotation", "bodies_1024", method.name, variant.scalar, variant.lanes, "host", 1.0 / 60, "ns_per_body_step",
                      method.ns_per_body_step(settings.quick ? 20 : 200), "ns"});
    }
    std::ifstream file(INGOT_REPORT_DIR "/flops.csv");
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        const std::vector<std::string> cells = cells_of(line);
        const char* const metrics[] = {"", "additions_and_multiplications", "divisions", "square_roots"};
        for (std::size_t column = 1; column < 4 && column < cells.size(); ++column)
            rows.add({"rotation", "book", cells[0], "float", 1, "host", 1.0 / 60, metrics[column], std::stod(cells[column]), "1"});
    }
    progress.begin("rotation order");
    const FreeBodyCase book("free_asymmetric", "book");
    for (const Variant* variant : chosen) {
        if (variant->scalar != "double") continue;
        for (const Method& method : variant->methods)
            if (method.order > 0 && method.name != "default" && method.name.find("plain") == std::string::npos)
                rows.add({"rotation", "book", method.name, "double", 1, "host", 0, "order", measured_order(method, book), "1"});
    }
    progress.begin("rotation one hour, float");
    const double every = 60;
    for (const Variant* exact : chosen) {
        if (exact->scalar != "double") continue;
        const std::vector<FreeBodyCase::Matrix3> A = exact->solution(book, 60, every, 61);
        for (const Variant* variant : chosen) {
            if (variant->scalar != "float") continue;
            for (const Method& method : variant->methods) {
                if (method.order < 6 || method.name.find("splitting") != std::string::npos) continue;
                for (const int rate : {15, 30, 60, 240})
                    if (!settings.quick || rate <= 60)
                        rows.add({"rotation", "book_hour", method.name, "float", 1, "host", 1.0 / rate, "attitude_error",
                                  method.fly_long(book, rate, every, A), "rad"});
            }
        }
    }
}

void run_driven(const Settings& settings, const std::vector<Variant>& variants, Rows& rows) {
    const std::vector<const char*> tops = {"regular_slow", "regular_fast", "cuspidal", "looping", "wavy", "sleeping_stable", "sleeping_unstable",
                                           "asymmetric_chaotic", "hanging_asymmetric"};
    const std::vector<const char*> driven = {"body_spin_up", "body_asymmetric", "world_rotating", "world_mixed"};
    const std::vector<const Variant*> chosen = one_per_scalar(variants);
    Progress progress(static_cast<int>(chosen.size() * (tops.size() + driven.size()) + variants.size()));
    for (const Variant* variant : chosen) {
        const auto run = [&](const char* name, const auto& body, auto fly) {
            progress.begin(std::string("driven ") + variant->scalar + " " + name);
            for (const Flight& flight : variant->flights)
                for (const int rate : {32, 64, 128, 256, 512})
                    if (!settings.quick || rate <= 256)
                        rows.add({"driven", name, flight.name, variant->scalar, variant->lanes, "host", 1.0 / rate, "attitude_error",
                                  fly(flight, body, rate), "rad"});
        };
        for (const char* name : tops) run(name, TopCase(name), [](const Flight& f, const TopCase& top, int rate) { return f.fly_top(top, rate); });
        for (const char* name : driven)
            run(name, DrivenCase(name), [](const Flight& f, const DrivenCase& body, int rate) { return f.fly_driven(body, rate); });
    }
    for (const Variant& variant : variants) {
        progress.begin("driven cost, " + variant.scalar + " x " + std::to_string(variant.lanes));
        for (const Flight& flight : variant.flights)
            rows.add({"driven", "bodies_1024", flight.name, variant.scalar, variant.lanes, "host", 1.0 / 60, "ns_per_body_step",
                      flight.ns_per_body_step(settings.quick ? 10 : 100), "ns"});
    }
}

void run_drift(const Settings& settings, const std::vector<Variant>& variants, Rows& rows) {
    const FreeBodyCase book("free_asymmetric", "book");
    const std::vector<const Variant*> chosen = one_per_scalar(variants);
    const std::vector<std::string> names = {"default", "moser_veselov_6_plain", "symmetric_top_splitting_6", "rk4_polar", "lie_midpoint"};
    Progress progress(static_cast<int>(chosen.size() * names.size()));
    for (const Variant* variant : chosen) {
        for (const Method& method : variant->methods) {
            if (std::find(names.begin(), names.end(), method.name) == names.end()) continue;
            progress.begin("drift " + variant->scalar + " " + method.name);
            for (const DriftPoint& point : method.drift(book, 60, settings.quick ? 200000 : 10000000)) {
                const auto add = [&](const char* metric, double value) {
                    char name[32];
                    std::snprintf(name, sizeof name, "book_%.0f", point.steps);
                    rows.add({"drift", name, method.name, variant->scalar, variant->lanes, "host", 1.0 / 60, metric, value, "1"});
                };
                add("energy_error", point.energy);
                add("orthogonality", point.orthogonality);
                add("L_error", point.L);
            }
        }
    }
}

void run_throughput(const Settings& settings, const std::vector<Variant>& variants, Rows& rows) {
    Progress progress(static_cast<int>(variants.size()) * 5);
    for (const Variant& variant : variants) {
        for (const int bodies : {1, 64, 1024, 4096, 65536}) {
            const std::string name = "bodies_" + std::to_string(bodies);
            progress.begin("throughput " + variant.scalar + " x " + std::to_string(variant.lanes) + ", " + name);
            rows.add({"throughput", name, "default", variant.scalar, variant.lanes, "host", 1.0 / 60, "ns_per_body_step",
                      variant.throughput(bodies, settings.quick), "ns"});
        }
    }
}

namespace {

/// Rows of a committed table whose first two columns are a name and a core; each other column becomes a metric.
void add_table(const char* path, const char* method, Rows& rows) {
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line)) return;
    const std::vector<std::string> columns = cells_of(line);
    while (std::getline(file, line)) {
        const std::vector<std::string> cells = cells_of(line);
        for (std::size_t column = 2; column < cells.size() && column < columns.size(); ++column) {
            const bool bytes = columns[column].find("instructions") == std::string::npos;
            rows.add({"mcu", cells[0], method, "float", 1, cells[1], 1.0 / 60, columns[column], std::stod(cells[column]), bytes ? "bytes" : "instructions"});
        }
    }
}

}  // namespace

void run_mcu(Rows& rows) {
    add_table(INGOT_BUDGETS, "default", rows);
    std::ifstream file(INGOT_REPORT_DIR "/methods.csv");
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> columns = cells_of(line);
    while (std::getline(file, line)) {
        const std::vector<std::string> cells = cells_of(line);
        for (std::size_t column = 2; column < cells.size(); ++column)
            rows.add({"mcu", "one_body", cells[0], "float", 1, cells[1], 1.0 / 60, columns[column], std::stod(cells[column]),
                      columns[column].find("instructions") == 0 ? "instructions" : columns[column].find("flops") == 0 || columns[column].find("div") == 0 ? "1" : "bytes"});
    }
}

}  // namespace report
