// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "claims.h"

namespace report {

namespace {

const double missing = std::nan("");

/// The larger; NaN where one is missing.
double largest(double a, double b) { return std::isnan(a) || std::isnan(b) ? missing : std::max(a, b); }

class ContactFigures {
public:
    explicit ContactFigures(const Rows& rows) : rows_(rows) {}

    /// At 60 Hz, float. A scene whose bodies were frozen has failed, whatever it showed until then.
    double error(const char* scene, const std::string& metric, const char* method = "default") const {
        const auto value = [&](const std::string& name) {
            return rows_.value("contact", scene, method, "float", 0, 1.0 / 60, name, missing);
        };
        if (value("frozen") > 0) return metric == "stood" ? 0 : std::numeric_limits<double>::infinity();
        return value(metric);
    }
    double ratio(const char* scene, int lanes) const {
        return rows_.value("peers", scene, "default", "float", lanes, 1.0 / 60, "time_ratio_to_bullet", missing);
    }
    double bounce_energy(const std::string& scalar) const {
        double worst = missing;
        for (const Row& row : rows_.all())
            if (row.suite == "contact" && row.case_name == "bounce_e1" && row.scalar == scalar &&
                row.metric == "energy_error" && !(worst >= row.value))
                worst = row.value;
        return worst;
    }
    /// s, between the end of the bounces and 3 sqrt(2 h / g).
    double late_rest() const { return std::abs(error("bounce_e05", "rest_time") - 3 * std::sqrt(2 * 2 / 9.81)); }
    double growth(int lanes) const {
        const auto ns = [&](const char* scene) {
            return rows_.value("contact", scene, "default", "float", lanes, 1.0 / 60, "ns_per_body_step", missing);
        };
        return ns("pile_4096") / ns("pile_512");
    }
    /// Bodies frozen, and bodies, pairs and contacts without room, of all scenes.
    double lost() const {
        double sum = missing;
        for (const Row& row : rows_.all())
            if (row.suite == "contact" && (row.metric == "lost" || row.metric == "frozen"))
                sum = (std::isnan(sum) ? 0 : sum) + row.value;
        return sum;
    }
    /// Errors that are not the same, bit by bit, in builds of another lane count; NaN if there was one lane count only.
    double differing_between_lanes() const {
        std::map<std::string, std::pair<int, double>> first;
        int compared = 0, differing = 0;
        for (const Row& row : rows_.all()) {
            if (row.suite != "contact" || row.unit == "ns" || row.unit == "us" || row.unit == "bytes") continue;
            const auto known = first
                                   .emplace(row.case_name + ' ' + row.method + ' ' + row.scalar + ' ' + std::to_string(row.h) +
                                                ' ' + row.metric,
                                            std::make_pair(row.lanes, row.value))
                                   .first;
            if (known->second.first == row.lanes) continue;
            ++compared;
            if (known->second.second != row.value) ++differing;
        }
        return compared == 0 ? missing : differing;
    }

private:
    const Rows& rows_;
};

}  // namespace

std::vector<Claim> contact_claims(const Rows& rows) {
    const ContactFigures of(rows);
    const auto below = [](const std::string& what, double measured, double bound, const char* unit) {
        return Claim{what, measured, bound, false, true, unit};
    };
    const auto faster = [](const std::string& what, double measured, double bound) {
        return Claim{what, measured, bound, false, false, "of Bullet's time"};
    };
    return {
        below("Pyramid of 210 cubes, 10 s: shift", of.error("pyramid_210", "shift"), 1.5, "mm"),
        below("Pyramid of 210 cubes, after 10 s: settled", of.error("pyramid_210", "settled"), 0.5, "mm"),
        below("Pyramid of 465 cubes, 10 s: shift", of.error("pyramid_465", "shift"), 3, "mm"),
        faster("Pyramid of 210 cubes, float, 4 lanes", of.ratio("pyramid_210", 4), 0.22),
        faster("The same with 8 lanes", of.ratio("pyramid_210", 8), 0.18),
        faster("Pyramid of 55 cubes, float, 4 lanes", of.ratio("pyramid_55", 4), 0.35),
        below("Pile of 512 balls at rest: mean overlap", of.error("pile_512", "mean_overlap"), 0.01, "mm"),
        below("Pile of 512 balls: balls that escaped", of.error("pile_512", "escaped"), 0, ""),
        faster("Pile of 512 balls, float, 4 lanes", of.ratio("pile_512", 4), 0.40),
        {"Cost of a ball among 4096 against one among 512, float, 4 and 8 lanes", largest(of.growth(4), of.growth(8)), 1.4,
         false, false, "times"},
        {"Tower of 20 cubes: stands", of.error("tower_20", "stood"), 60, true, true, "s"},
        below("Tower of 20 cubes, 60 s: the top sinks", of.error("tower_20", "sink"), 0.2, "mm"),
        below("Tower of 20 cubes, 60 s: the top drifts", of.error("tower_20", "drift"), 0.1, "mm"),
        below("The same, manifolds searched in every step: sinks", of.error("tower_20_searched", "sink"), 0.2, "mm"),
        below("The same, manifolds searched in every step: drifts", of.error("tower_20_searched", "drift"), 0.1, "mm"),
        {"Tower of 40 cubes: stands", of.error("tower_40", "stood"), 60, true, true, "s"},
        below("1000 kg on 1 kg: largest overlap", of.error("mass_ratio_1000", "max_overlap"), 0.1, "mm"),
        {"1000 t on 1 kg, ChosenSolver: stands", of.error("mass_ratio_1e6", "stood", "chosen"), 10, true, true, "s"},
        {"1000 kg on nine cubes of 1 kg: stands", of.error("mass_ratio_ten", "stood"), 10, true, true, "s"},
        below("Cube on 30 degrees, friction 0.7, 10 s: creeps", of.error("incline_mu07", "creep"), 1e-3, "mm"),
        below("Cube on 30 degrees, friction 0.4, 2 s: distance error", of.error("incline_mu04", "distance_error"), 1e-3, "%"),
        below("Bouncing ball, e = 1, 10 s, every rate, float: energy error", of.bounce_energy("float"), 1e-6, ""),
        below("The same in double", of.bounce_energy("double"), 1e-6, ""),
        below("Bouncing ball, e = 0.5: end of its bounces, off 1.916 s by", of.late_rest(), 2.0 / 60, "s"),
        below("125 boxes dropped 4 m: largest energy gain of a step", of.error("pit_125", "energy_gain"), 1e-4, ""),
        below("Contact scenes: contacts without room, and bodies driven out of range", of.lost(), 0, ""),
        below("Contact scenes: errors that differ between 1, 4 and 8 lanes", of.differing_between_lanes(), 0, ""),
    };
}

}  // namespace report
