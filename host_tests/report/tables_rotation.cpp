// SPDX-License-Identifier: MIT
// The tables of errors: free rotation, an hour, force fields.
#include <cmath>

#include "method_info.h"
#include "page.h"

namespace report {

namespace {

const double missing = std::nan("");

}  // namespace

Table methods_table(const Rows& rows, const std::string& scalar) {
    Table table{"Every method in " + scalar + ", book case",
                "Order as measured. Attitude error in rad, the largest over one minute; energy error relative; `|A^T A - 1|` "
                "its largest entry; L is kept bitwise by every "
                "method. Operations: + - * / and roots of one whole step. ns: of one body in one step, 1024 bodies that each "
                "turn in their own way.",
                {{"method", "order", "15 Hz", "60 Hz", "240 Hz", "960 Hz", "energy, 60 Hz", "|A^T A - 1|", "operations",
                  "ns, 1 lane", "4 lanes", "8 lanes"}}};
    for (const MethodInfo& info : method_infos()) {
        const auto at = [&](int rate, const char* metric) {
            return error_text(rows.value("rotation", "book", info.name, scalar, 0, 1.0 / rate, metric, missing));
        };
        const auto ns = [&](int lanes) {
            return number_text(rows.value("rotation", "bodies_1024", info.name, scalar, lanes, 0, "ns_per_body_step", missing),
                               "%.1f");
        };
        if (ns(1).empty()) continue;
        double operations = 0;
        for (const char* metric : {"flops", "divisions", "square_roots"})
            operations += rows.value("mcu", "book", info.name, scalar, 0, 1.0 / 60, metric, missing);
        table.cells.push_back(
            {info.name, number_text(rows.value("rotation", "book", info.name, "double", 0, 0, "order", missing), "%.2f"),
             at(15, "attitude_error"), at(60, "attitude_error"), at(240, "attitude_error"), at(960, "attitude_error"),
             at(60, "energy_error"), at(60, "orthogonality"), number_text(operations, "%.0f"), ns(1), ns(4), ns(8)});
    }
    return table;
}

Table cases_table(const Rows& rows) {
    Table table{"Every case, with the default method",
                "Each case is a trajectory known to 32 digits. Attitude error in rad over its whole time, at 15 and 60 Hz, or "
                "16 and 64 Hz where its samples lie "
                "between whole seconds. Energy and |L| relative, direction of L in rad, in float at the second rate. Flips: "
                "how often the spin about the middle axis changed its sign "
                "from sample to sample, in double at the second rate, and in the table. Near a separatrix (dzhanibekov, "
                "near_separatrix) the time between flips grows with the digits "
                "carried, so in float the attitude is beyond prediction and the invariants are what can be asked for; so it is "
                "for a needle of 1:1000000.",
                {{"case", "double, 15 Hz", "double, 60 Hz", "float, 15 Hz", "float, 60 Hz", "energy", "|L|", "direction of L",
                  "|A^T A - 1|", "flips", "of the table"}}};
    for (const std::string& name : names_of(rows, "rotation", &Row::case_name)) {
        if (name == "bodies_1024" || name == "book_hour") continue;
        const auto value = [&](const char* scalar, int rate, const char* metric) {
            const double found = rows.value("rotation", name, "default", scalar, 0, 1.0 / rate, metric, missing);
            return std::isnan(found)
                       ? rows.value("rotation", name, "default", scalar, 0, 1.0 / (rate == 15 ? 16 : 64), metric, missing)
                       : found;
        };
        const auto at = [&](const char* scalar, int rate, const char* metric) {
            return error_text(value(scalar, rate, metric));
        };
        table.cells.push_back(
            {name, at("double", 15, "attitude_error"), at("double", 60, "attitude_error"), at("float", 15, "attitude_error"),
             at("float", 60, "attitude_error"), at("float", 60, "energy_error"), at("float", 60, "L_error"),
             at("float", 60, "L_direction_error"), at("float", 60, "orthogonality"),
             number_text(value("double", 60, "flips"), "%.0f"), number_text(value("double", 60, "flips_of_table"), "%.0f")});
    }
    return table;
}

Table hour_table(const Rows& rows) {
    Table table{"One hour in float",
                "The book case for 3600 s; the largest attitude error in rad, against a Taylor series in 64-bit-significand "
                "arithmetic that shares no code with the kernel.",
                {{"method"}}};
    std::vector<int> rates;
    for (const int rate : {15, 30, 60, 64, 120, 240, 960})
        if (!std::isnan(rows.value("rotation", "book_hour", "default", "float", 0, 1.0 / rate, "attitude_error", missing)))
            rates.push_back(rate);
    for (const int rate : rates) table.cells[0].push_back(std::to_string(rate) + " Hz");
    for (const MethodInfo& info : method_infos()) {
        std::vector<std::string> line = {info.name};
        bool any = false;
        for (const int rate : rates) {
            line.push_back(
                error_text(rows.value("rotation", "book_hour", info.name, "float", 0, 1.0 / rate, "attitude_error", missing)));
            any = any || !line.back().empty();
        }
        if (any) table.cells.push_back(line);
    }
    return table;
}

Table driven_table(const Rows& rows, const std::string& scalar) {
    Table table{"Force fields, " + scalar,
                "Heavy tops about a fixed point, and torques that stay with the body or swing in the world. Largest attitude "
                "error in rad, at 64 and 256 Hz; "
                "ns of one body in one step, 4 lanes, 1024 bodies.",
                {{"case"}}};
    const std::vector<std::string> flights = names_of(rows, "driven", &Row::method);
    for (const std::string& flight : flights)
        for (const char* rate : {" 64 Hz", " 256 Hz"}) table.cells[0].push_back(flight + rate);
    for (const std::string& name : names_of(rows, "driven", &Row::case_name)) {
        std::vector<std::string> line = {name};
        for (const std::string& flight : flights)
            for (const int rate : {64, 256})
                line.push_back(
                    error_text(rows.value("driven", name, flight, scalar, 0, 1.0 / rate, "attitude_error", missing)));
        if (name != "bodies_1024") table.cells.push_back(line);
    }
    std::vector<std::string> cost = {"ns per body-step"};
    for (const std::string& flight : flights) {
        cost.push_back(
            number_text(rows.value("driven", "bodies_1024", flight, scalar, 4, 0, "ns_per_body_step", missing), "%.1f"));
        cost.push_back("");
    }
    table.cells.push_back(cost);
    return table;
}

}  // namespace report
