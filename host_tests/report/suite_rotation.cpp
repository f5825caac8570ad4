// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "cases.h"
#include "reference/eigen_free_body.h"
#include "reference/measure.h"
#include "suites.h"

namespace report {

std::vector<const Variant*> one_per_scalar(const std::vector<Variant>& variants) {
    std::vector<const Variant*> chosen;
    for (const char* scalar : {"double", "float"})
        for (const Variant& variant : variants)
            if (variant.scalar == scalar && variant.lanes == 1) chosen.push_back(&variant);
    return chosen;
}

void add_errors(const FlightErrors& e, Row row, Rows& rows) {
    const auto add = [&](const char* metric, double value, const char* unit) {
        row.metric = metric;
        row.value = value;
        row.unit = unit;
        rows.add(row);
    };
    add("attitude_error", e.attitude, "rad");
    add("energy_error", e.energy, "1");
    add("L_error", e.L, "1");
    add("L_direction_error", e.L_direction, "rad");
    add("orthogonality", e.orthogonality, "1");
    add("flips", e.flips, "1");
    add("flips_of_table", e.flips_of_table, "1");
}

namespace {

void add_flight(const FreeCase& free_case, const Method& method, const Variant& variant, int rate, Rows& rows) {
    add_errors(method.fly(free_case.body, rate),
               {"rotation", free_case.name, method.name, variant.scalar, variant.lanes, "host", 1.0 / rate, "", 0, ""}, rows);
}

/// Every case, method and rate. Lanes do not change a bit: a quick run flies all cases with one lane and the book at 60 Hz
/// with all lane counts, a full run everything with all.
void add_flights(const Settings& settings, const std::vector<Variant>& variants, const std::vector<FreeCase>& cases,
                 Progress& progress, Rows& rows) {
    for (const Variant& variant : variants) {
        for (const FreeCase& free_case : cases) {
            progress.begin("rotation " + variant.scalar + " x " + std::to_string(variant.lanes) + " " + free_case.name);
            if (settings.quick && variant.lanes > 1 && free_case.name != "book") continue;
            for (const Method& method : variant.methods) {
                if (method.symmetric_only && !free_case.symmetric) continue;
                for (const int rate : free_case.rates) {
                    if (free_case.spin_max / rate > method.angle_max) continue;
                    if (settings.quick && variant.lanes > 1 && rate != 60) continue;
                    if (settings.quick && (free_case.duration * rate > 300000 || (rate > 256 && free_case.name != "book")))
                        continue;
                    add_flight(free_case, method, variant, rate, rows);
                }
            }
        }
    }
}

void add_costs(const Settings& settings, const std::vector<Variant>& variants, const FreeCase& book, Progress& progress,
               Rows& rows) {
    for (const Variant& variant : variants) {
        progress.begin("rotation cost " + variant.scalar + " x " + std::to_string(variant.lanes));
        for (const Method& method : variant.methods) {
            const auto add = [&](const std::string& case_name, int rate, double ns) {
                rows.add({"rotation", case_name, method.name, variant.scalar, variant.lanes, "host", 1.0 / rate,
                          "ns_per_body_step", ns, "ns"});
            };
            for (const int rate : book.rates)
                if (!settings.quick || variant.lanes == 4 || rate == 60)
                    add(book.name, rate, method.ns_of_case(book.body, rate, settings.quick ? 20 : 200));
            add("bodies_1024", 60, method.ns_of_crowd(settings.quick ? 4 : 60));
        }
    }
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

void add_orders(const std::vector<const Variant*>& chosen, const FreeCase& book, Rows& rows) {
    for (const Variant* variant : chosen) {
        if (variant->scalar != "double") continue;
        for (const Method& method : variant->methods) {
            // Options do not change the order: it is measured once, with all of them.
            const bool has_options =
                method.name.find("_plain") != std::string::npos || method.name.find("_compensated") != std::string::npos;
            if (method.order == 0 || method.name == "default" || has_options) continue;
            const double order = measured_order(method, book.body);
            if (!std::isnan(order)) rows.add({"rotation", book.name, method.name, "double", 1, "host", 0, "order", order, "1"});
        }
    }
}

/// One hour of the book case in float. The table ends after a minute; beyond it the reference is the Taylor series of
/// reference/eigen_free_body.h in long double, which holds no line of the kernel and is itself checked against the table.
void add_hour(const Settings& settings, const std::vector<const Variant*>& chosen, const FreeCase& book, Progress& progress,
              Rows& rows) {
    const int every = settings.quick ? 60 : 10;
    progress.begin("rotation one hour, exact solution");
    std::vector<Orientation> exact;
    ingot_reference::FreeBody reference(book.body.I, book.body.A_0, book.body.L);
    for (int t = 0; t <= 3600; t += every) {
        exact.push_back(reference.A());
        reference.advance(every);
    }
    for (const Variant* variant : chosen) {
        if (variant->scalar != "float") continue;
        for (const Method& method : variant->methods) {
            progress.begin("rotation one hour, " + method.name);
            if (method.symmetric_only || (method.order > 0 && method.order < 4)) continue;
            for (const int rate : {15, 30, 60, 64, 120, 240, 960})
                if (!settings.quick || (rate <= 60 && (method.order <= 6)))
                    rows.add({"rotation", "book_hour", method.name, "float", 1, "host", 1.0 / rate, "attitude_error",
                              method.fly_long(book.body, rate, every, exact), "rad"});
        }
    }
}

}  // namespace

void run_rotation(const Settings& settings, const std::vector<Variant>& variants, Rows& rows) {
    const std::vector<FreeCase> cases = free_cases();
    const std::vector<const Variant*> chosen = one_per_scalar(variants);
    const FreeCase& book = *std::find_if(cases.begin(), cases.end(), [](const FreeCase& c) { return c.name == "book"; });
    Progress progress(static_cast<int>(variants.size() * (cases.size() + 1) + 2 + chosen[0]->methods.size()));
    add_flights(settings, variants, cases, progress, rows);
    add_costs(settings, variants, book, progress, rows);
    progress.begin("rotation order");
    add_orders(chosen, book, rows);
    add_hour(settings, chosen, book, progress, rows);
}

}  // namespace report
