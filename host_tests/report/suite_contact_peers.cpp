// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "contact_peers.h"
#include "suites.h"

namespace report {

namespace {

struct Entrant {
    Row row;
    BeginRun begin;
};

/// The engines, and the kernel in float with 4 and 8 lanes. Every engine is given the bodies of the build in double.
std::vector<Entrant> entrants(std::size_t case_i, const std::vector<Variant>& variants, const ContactCase& scene) {
    std::vector<Entrant> all;
    for (const PeerEngine& engine : contact_peers())
        all.push_back({{"peers", scene.name, engine.name, engine.scalar, 1, "host", 0, "", 0, ""},
                       [engine, &scene] { return engine.begin(scene); }});
    for (const Variant& variant : variants)
        if (variant.scalar == "float" && variant.lanes > 1)
            all.push_back({{"peers", scene.name, "default", "float", variant.lanes, "host", 0, "", 0, ""},
                           variant.contacts[case_i].begin});
    return all;
}

void add(Row row, const char* metric, double value, const char* unit, Rows& rows) {
    row.metric = metric;
    row.value = value;
    row.unit = unit;
    rows.add(row);
}

void race_entrants(const ContactCase& scene, const std::vector<Entrant>& all, int rate, const Settings& settings, Rows& rows) {
    std::vector<BeginRun> begins;
    for (const Entrant& entrant : all) begins.push_back(entrant.begin);
    const int repetitions = settings.quick || rate != 60 || scene.bodies.size() > 1000 ? 1 : 3;
    const std::vector<double> us = raced(scene, begins, rate, timed_seconds(scene, settings.quick), repetitions);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (std::isnan(us[i])) continue;
        Row row = all[i].row;
        row.h = 1.0 / rate;
        add(row, "us_per_step", us[i], "us", rows);
        add(row, "ns_per_body_step", us[i] * 1e3 / scene.moving_count(), "ns", rows);
        add(row, "time_ratio_to_bullet", us[i] / us[0], "1", rows);
    }
}

/// Errors of the peers; those of the kernel are in the suite `contact`.
void follow_peers(const ContactCase& scene, int rate, const Settings& settings, Rows& rows) {
    for (const PeerEngine& engine : contact_peers()) {
        const double seconds = settings.quick ? std::min(scene.seconds, scene.bodies.size() > 100 ? 3.0 : 10.0) : scene.seconds;
        for (const Metric& metric : followed(
                 scene, [&] { return engine.begin(scene); }, rate, seconds))
            add({"peers", scene.name, engine.name, engine.scalar, 1, "host", 1.0 / rate, "", 0, ""}, metric.name, metric.value,
                metric.unit, rows);
    }
}

}  // namespace

void run_contact_peers(const Settings& settings, const std::vector<Variant>& variants, Progress& progress, Rows& rows) {
    const Variant* exact = nullptr;
    for (const Variant& variant : variants)
        if (variant.scalar == "double" && exact == nullptr) exact = &variant;
    for (std::size_t case_i = 0; exact != nullptr && case_i < exact->contacts.size(); ++case_i) {
        const ContactCase& scene = exact->contacts[case_i];
        progress.begin("peers " + scene.name);
        if (scene.name == "tower_20_searched" || (settings.quick && scene.name == "pile_4096")) continue;
        const std::vector<Entrant> all = entrants(case_i, variants, scene);
        for (const int rate : contact_rates(scene.name, settings.quick, true)) {
            follow_peers(scene, rate, settings, rows);
            race_entrants(scene, all, rate, settings, rows);
        }
        for (const PeerEngine& engine : contact_peers())
            if (stands_still(scene.name))
                add_approach(approach_to_rest(
                                 scene, [&] { return engine.begin(scene); }, 60),
                             {"peers", scene.name, engine.name, engine.scalar, 1, "host", 1.0 / 60, "", 0, ""}, rows);
    }
}

}  // namespace report
