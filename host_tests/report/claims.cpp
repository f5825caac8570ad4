// SPDX-License-Identifier: MIT
#include "claims.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "method_info.h"

namespace report {

namespace {

const double missing = std::nan("");

/// The largest of some values; NaN where one is missing.
double largest(const std::vector<double>& values) {
    double found = 0;
    for (const double value : values) {
        if (std::isnan(value)) return missing;
        found = std::max(found, value);
    }
    return values.empty() ? missing : found;
}

class Figures {
public:
    explicit Figures(const Rows& rows) : rows_(rows) {}

    double error(const std::string& case_name, const std::string& method, const std::string& scalar, int rate) const {
        return rows_.value("rotation", case_name, method, scalar, 0, 1.0 / rate, "attitude_error", missing);
    }
    double worst_error(const std::string& case_name, const std::string& scalar, const std::vector<int>& rates) const {
        std::vector<double> errors;
        for (const int rate : rates) errors.push_back(error(case_name, "default", scalar, rate));
        return largest(errors);
    }
    double ns(const std::string& method, const std::string& scalar, int lanes) const {
        return rows_.value("rotation", "bodies_1024", method, scalar, lanes, 0, "ns_per_body_step", missing);
    }
    double throughput(int bodies, const std::string& scalar, int lanes, const char* metric = "ns_per_body_step") const {
        return rows_.value("throughput", "bodies_" + std::to_string(bodies), "default", scalar, lanes, 0, metric, missing);
    }
    double peer(const std::string& engine, const std::string& scalar, int lanes) const {
        return rows_.value("peers", "bodies_4096", engine, scalar, lanes, 0, "ns_per_body_step", missing);
    }
    double driven(const std::string& case_name, const std::string& flight, int rate) const {
        return rows_.value("driven", case_name, flight, "double", 0, 1.0 / rate, "attitude_error", missing);
    }
    double on_core(const std::string& method, const std::string& core, const std::string& metric) const {
        for (const Row& row : rows_.all())
            if (row.suite == "mcu" && row.case_name == "book" && row.method == method && row.target == core &&
                row.metric == metric)
                return row.value;
        return missing;
    }
    /// The order that strays furthest from its name.
    double order_deviation() const {
        double worst = missing;
        for (const Row& row : rows_.all()) {
            if (row.metric != "order") continue;
            const double deviation = std::abs(row.value - std::round(row.value / 2) * 2);
            const double of_euler = row.method == "listing1_euler" ? std::abs(row.value - 1) : deviation;
            if (!(worst >= of_euler)) worst = of_euler;
        }
        return worst;
    }
    /// Errors that are not the same, bit by bit, in builds of another lane count; NaN if there was one lane count only.
    double differing_between_lanes() const {
        std::map<std::string, std::pair<int, double>> first;
        int compared = 0, differing = 0;
        for (const Row& row : rows_.all()) {
            if (row.suite != "rotation" || row.unit == "ns") continue;
            const std::string key =
                row.case_name + ' ' + row.method + ' ' + row.scalar + ' ' + std::to_string(row.h) + ' ' + row.metric;
            const auto known = first.emplace(key, std::make_pair(row.lanes, row.value)).first;
            if (known->second.first == row.lanes) continue;
            ++compared;
            if (known->second.second != row.value) ++differing;
        }
        return compared == 0 ? missing : differing;
    }
    /// The default's cost over that of the cheapest method of order 2.
    double cost_over_second_order(const std::string& scalar, int lanes) const {
        double least = missing;
        for (const char* method : {"lie_midpoint", "moser_veselov_2", "symmetric_top_splitting_2"})
            if (!(least <= ns(method, scalar, lanes))) least = ns(method, scalar, lanes);
        return ns("default", scalar, lanes) / least;
    }
    double error_below_second_order() const {
        double least = missing;
        for (const char* method : {"lie_midpoint", "moser_veselov_2", "symmetric_top_splitting_2"})
            if (!(least <= error("book", method, "double", 60))) least = error("book", method, "double", 60);
        return least / error("book", "default", "double", 60);
    }
    double drift(const std::string& scalar, const std::string& metric) const {
        std::vector<double> all;
        for (const Row& row : rows_.all())
            if (row.suite == "drift" && row.method == "default" && row.scalar == scalar && row.metric == metric)
                all.push_back(row.value);
        return largest(all);
    }

private:
    const Rows& rows_;
};

}  // namespace

std::vector<Claim> claims(const Rows& rows) {
    const Figures of(rows);
    const double growth = of.throughput(65536, "float", 8) / of.throughput(64, "float", 8);
    return {
        {"Free asymmetric body, one minute, double, at 15 and 60 Hz: attitude error",
         of.worst_error("book", "double", {15, 60}), 1e-12, false, true, "rad"},
        {"The same in float, at 15, 30 and 60 Hz", of.worst_error("book", "float", {15, 30, 60}), 1e-5, false, true, "rad"},
        {"One hour in float, at 15 and 60 Hz", largest({of.worst_error("book_hour", "float", {15, 60})}), 3e-4, false, true,
         "rad"},
        {"One hour in float, at 30 Hz", of.error("book_hour", "default", "float", 30), 3e-4, false, true, "rad"},
        {"Body that flips (dzhanibekov), one minute, double, at 15 Hz", of.error("dzhanibekov", "default", "double", 15), 1e-5,
         false, true, "rad"},
        {"Measured order of every method: largest distance from its nominal order", of.order_deviation(), 0.3, false, true, ""},
        {"Errors that differ between 1, 4 and 8 lanes, of all methods", of.differing_between_lanes(), 0, false, true, ""},
        {"Chaotic heavy top, 10 s, double, at 64 Hz, with the schemes of order 4",
         largest(
             {of.driven("asymmetric_chaotic", "blanes_moan_4", 64), of.driven("asymmetric_chaotic", "commutator_free_4", 64)}),
         1e-4, false, true, "rad"},
        {"Looping heavy top, 20 s, double, at 64 Hz, with the default", of.driven("looping", "kick_drift_kick", 64), 2e-3,
         false, true, "rad"},
        {"Default method against the cheapest of order 2: cost, float, 4 lanes", of.cost_over_second_order("float", 4), 1.3,
         false, false, "times"},
        {"The same with 8 lanes", of.cost_over_second_order("float", 8), 1.3, false, false, "times"},
        {"Default method against the best of order 2: error, double, at 60 Hz", of.error_below_second_order(), 1e4, true, true,
         "times less"},
        {"Whole step of 4096 bodies, float, 8 lanes, against the floor of two vector operations a cycle",
         of.throughput(4096, "float", 8) / of.throughput(4096, "float", 8, "floor_ns"), 1.6, false, false, "times"},
        {"Cost of a body among 65536 against one among 64, float, 8 lanes", growth, 2, false, false, "times"},
        {"Bullet's cost of a body among 4096 against ours, float, 8 lanes",
         of.peer("bullet", "float", 1) / of.peer("default", "float", 8), 25, true, false, "times"},
        {"The same for Bullet's bodies without shapes",
         of.peer("bullet_no_shapes", "float", 1) / of.peer("default", "float", 8), 25, true, false, "times"},
        {"Whole step of one body on a Cortex-M4F", of.on_core("default", "cortex-m4f", "instructions_per_body_step"), 650,
         false, true, "instructions"},
        {"RAM of the world of one satellite", of.on_core("default", "cortex-m0", "world_ram"), 200, false, true, "bytes"},
        {"Flash of one satellite on a Cortex-M0, with soft float", of.on_core("default", "cortex-m0", "flash"), 6 * 1024, false,
         true, "bytes"},
        {"Long flight, double: energy error", of.drift("double", "energy_error"), 1e-11, false, true, ""},
        {"Long flight, float: energy error", of.drift("float", "energy_error"), 1e-5, false, true, ""},
        {"Long flight, double: largest entry of |A^T A - 1|", of.drift("double", "orthogonality"), 1e-14, false, true, ""},
        {"Long flight, float: largest entry of |A^T A - 1|", of.drift("float", "orthogonality"), 3e-7, false, true, ""},
    };
}

}  // namespace report
