// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>

#include "write.h"

namespace report {

namespace {

std::string text_of(double value, const char* format) {
    if (std::isnan(value)) return "";
    if (std::isinf(value)) return "lost";
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// Names of a column, in the order in which they came.
template <class Get>
std::vector<std::string> names_of(const Rows& rows, const std::string& suite, Get get) {
    std::vector<std::string> names;
    std::set<std::string> seen;
    for (const Row& row : rows.all())
        if (row.suite == suite && seen.insert(get(row)).second) names.push_back(get(row));
    return names;
}

const double missing = std::nan("");

/// Largest |omega| of the case is what a step is to be measured by; the tables have their own rates.
Table methods_table(const Rows& rows, const std::string& scalar) {
    Table table{"Free rotation, " + scalar + ": error after one minute, and cost",
                "A free asymmetric body, I = (1, 2, 3) kg m^2, about 1.5 rad/s. Attitude error in rad, the largest over the minute; energy error relative. "
                "ns per body-step with 1, 4 and 8 lanes, of 1024 bodies that only turn; compare them with each other, not with another run. "
                "`default` is the method a scene gets that names none. Operations are counted in the machine code of the rotation stage, for the book case at 60 Hz.",
                {{"method", "order (measured)", "15 Hz", "60 Hz", "240 Hz", "energy, 60 Hz", "| A^T A - 1 |", "ns, 1 lane", "ns, 4", "ns, 8", "+ and *", "/", "sqrt"}}};
    for (const std::string& method : names_of(rows, "rotation", [](const Row& row) { return row.method; })) {
        const auto at = [&](int rate, const char* metric) { return rows.value("rotation", "book", method, scalar, 0, 1.0 / rate, metric, missing); };
        const std::string counted = method == "default" && scalar == "double" ? "moser_veselov_10" : method;
        const auto flops = [&](const char* metric) { return text_of(rows.value("rotation", "book", counted, "float", 0, 0, metric, missing), "%.0f"); };
        const auto ns = [&](int lanes) { return text_of(rows.value("rotation", "bodies_1024", method, scalar, lanes, 0, "ns_per_body_step", missing), "%.1f"); };
        table.cells.push_back({method, text_of(rows.value("rotation", "book", method, "double", 0, 0, "order", missing), "%.2f"),
                               text_of(at(15, "attitude_error"), "%.1e"), text_of(at(60, "attitude_error"), "%.1e"), text_of(at(240, "attitude_error"), "%.1e"),
                               text_of(at(60, "energy_error"), "%.1e"), text_of(at(60, "orthogonality"), "%.1e"), ns(1), ns(4), ns(8), flops("additions_and_multiplications"), flops("divisions"),
                               flops("square_roots")});
    }
    return table;
}

Table cases_table(const Rows& rows) {
    Table table{"Every case, with the default method",
                "Each case is a table of 32 digits. Double and float at the case's rates next to 15 and 60 Hz (16 and 64 Hz where samples ask for it). Attitude "
                "error in rad. Flips: how often the middle axis changed its sign, counted from sample to sample, of the run in double and of the table.",
                {{"case", "double, 15 Hz", "double, 60 Hz", "float, 15 Hz", "float, 60 Hz", "energy, float, 60 Hz", "flips / table"}}};
    for (const std::string& name : names_of(rows, "rotation", [](const Row& row) { return row.case_name; })) {
        if (name == "bodies_1024" || name == "book_hour") continue;
        const auto at = [&](const char* scalar, int rate, const char* metric) {
            const double value = rows.value("rotation", name, "default", scalar, 0, 1.0 / rate, metric, missing);
            return std::isnan(value) ? rows.value("rotation", name, "default", scalar, 0, 1.0 / (rate == 15 ? 16 : 64), metric, missing) : value;
        };
        table.cells.push_back({name, text_of(at("double", 15, "attitude_error"), "%.1e"), text_of(at("double", 60, "attitude_error"), "%.1e"),
                               text_of(at("float", 15, "attitude_error"), "%.1e"), text_of(at("float", 60, "attitude_error"), "%.1e"),
                               text_of(at("float", 60, "energy_error"), "%.1e"),
                               text_of(at("double", 60, "flips"), "%.0f") + " / " + text_of(at("double", 60, "flips_of_table"), "%.0f")});
    }
    return table;
}

Table hour_table(const Rows& rows) {
    Table table{"One hour in float", "The same body for 3600 s; attitude error in rad, the largest of each minute, against the default in double.",
                {{"method", "15 Hz", "30 Hz", "60 Hz", "240 Hz"}}};
    for (const std::string& method : names_of(rows, "rotation", [](const Row& row) { return row.method; })) {
        const auto at = [&](int rate) { return rows.value("rotation", "book_hour", method, "float", 0, 1.0 / rate, "attitude_error", missing); };
        if (!std::isnan(at(60)))
            table.cells.push_back({method, text_of(at(15), "%.1e"), text_of(at(30), "%.1e"), text_of(at(60), "%.1e"), text_of(at(240), "%.1e")});
    }
    return table;
}

Table driven_table(const Rows& rows, const std::string& scalar) {
    Table table{"Driven bodies, " + scalar, "Heavy tops about a fixed point and swinging torques. Largest attitude error in rad, at 64 and 256 Hz.", {{"case"}}};
    const std::vector<std::string> flights = names_of(rows, "driven", [](const Row& row) { return row.method; });
    for (const std::string& flight : flights) {
        table.cells[0].push_back(flight + ", 64 Hz");
        table.cells[0].push_back("256 Hz");
    }
    for (const std::string& name : names_of(rows, "driven", [](const Row& row) { return row.case_name; })) {
        std::vector<std::string> line = {name};
        for (const std::string& flight : flights) {
            for (const int rate : {64, 256}) {
                const double error = rows.value("driven", name, flight, scalar, 0, 1.0 / rate, "attitude_error", missing);
                line.push_back(error < 0 ? "lost" : text_of(error, "%.1e"));
            }
        }
        if (name != "bodies_1024") table.cells.push_back(line);
    }
    std::vector<std::string> cost = {"ns per body-step, 4 lanes"};
    for (const std::string& flight : flights) {
        cost.push_back(text_of(rows.value("driven", "bodies_1024", flight, scalar, 4, 0, "ns_per_body_step", missing), "%.1f"));
        cost.push_back("");
    }
    table.cells.push_back(cost);
    return table;
}

Table throughput_table(const Rows& rows) {
    Table table{"Throughput of the whole step, default method",
                "ns per body-step: status checks, forces, rotation, translation, omega and inverse inertia. The floor of one step in float is 208 additions, 249 "
                "multiplications, 3 divisions and about 300 bytes of memory a body; at two vector operations a cycle and 3.75 GHz that is 61, 15 and 8 ns for 1, "
                "4 and 8 lanes.",
                {{"scalar, lanes", "1 body", "64", "1024", "4096", "65536"}}};
    for (const char* scalar : {"float", "double"}) {
        for (const int lanes : {1, 4, 8}) {
            std::vector<std::string> line = {std::string(scalar) + " x " + std::to_string(lanes)};
            for (const int bodies : {1, 64, 1024, 4096, 65536})
                line.push_back(text_of(rows.value("throughput", "bodies_" + std::to_string(bodies), "default", scalar, lanes, 0, "ns_per_body_step", missing), "%.1f"));
            table.cells.push_back(line);
        }
    }
    for (const std::string& peer : names_of(rows, "peers", [](const Row& row) { return row.method; })) {
        std::vector<std::string> line = {peer};
        for (const int bodies : {1, 64, 1024, 4096, 65536}) {
            double value = missing;
            for (const Row& row : rows.all())
                if (row.suite == "peers" && row.method == peer && row.case_name == "bodies_" + std::to_string(bodies)) value = row.value;
            line.push_back(text_of(value, "%.1f"));
        }
        table.cells.push_back(line);
    }
    return table;
}

Table cores_table(const Rows& rows) {
    Table table{"Microcontrollers", "Emulated with an instruction counter: exact, and the same from run to run. Float; sizes in bytes, of the scene as firmware.",
                {{"scene", "core", "instructions a step, mean", "worst", "flash", "of it kernel", "world in RAM", "stack"}}};
    for (const Row& row : rows.all()) {
        if (row.suite != "mcu" || row.metric != "instructions_mean" || row.case_name == "one_body") continue;
        const auto at = [&](const char* metric) {
            for (const Row& other : rows.all())
                if (other.suite == "mcu" && other.case_name == row.case_name && other.target == row.target && other.metric == metric) return text_of(other.value, "%.0f");
            return std::string();
        };
        table.cells.push_back({row.case_name, row.target, text_of(row.value, "%.0f"), at("instructions_worst"), at("flash"), at("kernel_flash"), at("world_ram"), at("stack_computed")});
    }
    return table;
}

Table method_cores_table(const Rows& rows) {
    Table table{"Methods on microcontrollers", "One body that turns, at 60 Hz: instructions of the whole public step, and the code of the method's stage in bytes.",
                {{"method", "core", "instructions", "code"}}};
    for (const Row& row : rows.all()) {
        if (row.suite != "mcu" || row.case_name != "one_body" || row.metric != "instructions_per_body_step") continue;
        std::string code;
        for (const Row& other : rows.all())
            if (other.suite == "mcu" && other.method == row.method && other.target == row.target && other.metric == "code") code = text_of(other.value, "%.0f");
        table.cells.push_back({row.method, row.target, text_of(row.value, "%.0f"), code});
    }
    return table;
}

Table peers_table(const Rows& rows) {
    Table table{"Peers, in this run", "The distribution's Bullet and ODE on the same bodies: attitude error in rad after one minute, and energy error, relative.",
                {{"engine", "case", "rate", "attitude error", "energy error"}}};
    for (const Row& row : rows.all()) {
        if (row.suite != "peers" || row.metric != "attitude_error") continue;
        table.cells.push_back({row.method, row.case_name, text_of(1 / row.h, "%.0f Hz"), text_of(row.value, "%.1e"),
                               text_of(rows.value("peers", row.case_name, row.method, row.scalar, 0, row.h, "energy_error", missing), "%.1e")});
    }
    return table;
}

}  // namespace

std::vector<Table> summary_tables(const Rows& rows) {
    std::vector<Table> all = {methods_table(rows, "double"), methods_table(rows, "float"), cases_table(rows), hour_table(rows), driven_table(rows, "double"),
                              driven_table(rows, "float"), throughput_table(rows), peers_table(rows), cores_table(rows), method_cores_table(rows)};
    std::vector<Table> filled;
    for (const Table& table : all) {
        bool any = false;
        for (std::size_t line = 1; line < table.cells.size(); ++line)
            for (std::size_t cell = 1; cell < table.cells[line].size(); ++cell) any = any || !table.cells[line][cell].empty();
        if (any) filled.push_back(table);
    }
    return filled;
}

void write_md(const Rows& rows, const std::string& dir) {
    std::ofstream file(dir + "/report.md");
    file << "# ingot: speed against error\n\n" << machine_line() << "\n";
    for (const Table& table : summary_tables(rows)) {
        file << "\n## " << table.title << "\n\n" << table.note << "\n\n";
        for (std::size_t line = 0; line < table.cells.size(); ++line) {
            for (const std::string& cell : table.cells[line]) file << "| " << cell << " ";
            file << "|\n";
            if (line > 0) continue;
            for (std::size_t column = 0; column < table.cells[0].size(); ++column) file << (column == 0 ? "|---" : "|---:");
            file << "|\n";
        }
    }
}

}  // namespace report
