// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "contact_exact.h"
#include "contact_race.h"
#include "suites.h"

namespace report {

std::vector<int> contact_rates(const std::string& name, bool quick, bool beside_peers) {
    if (quick && !beside_peers && (name == "pyramid_210" || name == "tower_20")) return {30, 60, 120};
    if (quick || name == "pile_4096" || name.rfind("pile_boxes", 0) == 0 || name.rfind("pile_mixed", 0) == 0) return {60};
    if (name.rfind("bounce", 0) == 0) return {30, 60, 240, 1000};
    return {30, 60, 120, 240};
}

double timed_seconds(const ContactCase& scene, bool quick) { return std::min(scene.seconds, quick ? 3.0 : 10.0); }

namespace {

/// The builds of one scalar take turns.
void race(const ContactCase& first, std::size_t case_i, const std::vector<const Variant*>& builds, int rate,
          const Settings& settings, Rows& rows) {
    std::vector<BeginRun> begins;
    for (const Variant* build : builds) begins.push_back(build->contacts[case_i].begin);
    const int repetitions = settings.quick || rate != 60 || first.bodies.size() > 1000 ? 1 : 3;
    const std::vector<double> us = raced(first, begins, rate, timed_seconds(first, settings.quick), repetitions);
    for (std::size_t i = 0; i < builds.size(); ++i) {
        if (std::isnan(us[i])) continue;
        const auto add = [&](const char* metric, double value, const char* unit) {
            rows.add({"contact", first.name, "default", builds[i]->scalar, builds[i]->lanes, "host", 1.0 / rate, metric, value,
                      unit});
        };
        add("us_per_step", us[i], "us");
        add("ns_per_body_step", us[i] * 1e3 / first.moving_count(), "ns");
    }
}

void follow(const ContactCase& scene, const char* method, const BeginRun& begin, const Variant& build, int rate, Rows& rows) {
    for (const Metric& metric : followed(scene, begin, rate, scene.seconds))
        rows.add({"contact", scene.name, method, build.scalar, build.lanes, "host", 1.0 / rate, metric.name, metric.value,
                  metric.unit});
}

/// The way to the exact solution, and what finding that takes.
void approach(const ContactCase& scene, const Variant& build, const Settings& settings, Rows& rows) {
    if (!stands_still(scene.name)) return;
    add_approach(approach_to_rest(scene, scene.begin, 60),
                 {"contact", scene.name, "default", build.scalar, build.lanes, "host", 1.0 / 60, "", 0, ""}, rows);
    if (scene.begin_chosen)
        add_approach(approach_to_rest(scene, scene.begin_chosen, 60),
                     {"contact", scene.name, "chosen", build.scalar, build.lanes, "host", 1.0 / 60, "", 0, ""}, rows);
    if (build.scalar == "float" || (settings.quick && scene.bodies.size() > 100)) return;
    const ExactStep exact = exact_first_step(scene.name);
    if (exact.known)
        add_approach({{1, exact.us, exact.distance}},
                     {"contact", scene.name, "exact", "double", 1, "host", 1.0 / 60, "", 0, ""}, rows);
}

/// A quick run leaves out what takes seconds.
bool skipped(const ContactCase& scene, const std::string& scalar, bool quick) {
    return quick && (scene.name == "pile_4096" || (scalar == "double" && scene.bodies.size() > 100));
}

}  // namespace

void run_contact(const Settings& settings, const std::vector<Variant>& variants, Rows& rows) {
    const std::size_t cases = variants.front().contacts.size();
    Progress progress(static_cast<int>(cases) * 2);
    for (std::size_t case_i = 0; case_i < cases; ++case_i) {
        for (const char* scalar : {"float", "double"}) {
            std::vector<const Variant*> builds;
            for (const Variant& variant : variants)
                if (variant.scalar == scalar) builds.push_back(&variant);
            const Variant* const four = builds[builds.size() / 2];  // its times are what errors are plotted against
            const ContactCase& scene = builds.front()->contacts[case_i];
            progress.begin("contact " + scene.name + ", " + scalar);
            if (skipped(scene, scalar, settings.quick)) continue;
            for (const int rate : contact_rates(scene.name, settings.quick, false)) {
                // The bits do not depend on lanes: seen at 60 Hz (in a quick run on small scenes), taken for granted at other
                // rates.
                for (const Variant* build : builds)
                    if (build == builds.front() || (rate == 60 && (!settings.quick || scene.bodies.size() < 15)))
                        follow(build->contacts[case_i], "default", build->contacts[case_i].begin, *build, rate, rows);
                if (scene.begin_chosen) follow(scene, "chosen", four->contacts[case_i].begin_chosen, *four, rate, rows);
                if (settings.quick && std::string(scalar) == "double") continue;
                race(scene, case_i, rate == 60 ? builds : std::vector<const Variant*>{four}, rate, settings, rows);
            }
            approach(four->contacts[case_i], *four, settings, rows);
        }
    }
}

}  // namespace report
