// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "contact_peers.h"
#include "contact_race.h"
#include "suites.h"

namespace report {

namespace {

/// A scene that peers and the kernel in float, with 4 and 8 lanes, run side by side. All are given the bodies that stand in `scene`.
struct Contest {
    ContactCase scene;
    std::vector<std::pair<int, BeginRun>> builds;  ///< by lanes
};

/// The contact scenes with the bodies of the build in double, and the piles that only peers are run beside.
std::vector<Contest> contests(const std::vector<Variant>& variants) {
    std::vector<Contest> all, piles;
    for (const Variant& variant : variants) {
        if (variant.scalar != "double" || !all.empty()) continue;
        for (const ContactCase& scene : variant.contacts) all.push_back({scene, {}});
    }
    for (const Variant& variant : variants) {
        if (variant.scalar != "float" || variant.lanes == 1) continue;
        for (std::size_t i = 0; i < all.size(); ++i) all[i].builds.emplace_back(variant.lanes, variant.contacts[i].begin);
        const std::vector<ContactCase> added = pile_cases(variant.lanes);
        for (std::size_t i = 0; i < added.size(); ++i) {
            if (piles.size() == i) piles.push_back({added[i], {}});
            piles[i].builds.emplace_back(variant.lanes, added[i].begin);
        }
    }
    all.insert(all.end(), piles.begin(), piles.end());
    return all;
}

struct Entrant {
    Row row;
    BeginRun begin;
};

/// The engines, then the builds of the kernel.
std::vector<Entrant> entrants(const Contest& contest) {
    const ContactCase& scene = contest.scene;
    std::vector<Entrant> all;
    for (const PeerEngine& engine : contact_peers())
        all.push_back({{"peers", scene.name, engine.name, engine.scalar, 1, "host", 0, "", 0, ""},
                       [engine, &scene] { return engine.begin(scene); }});
    for (const auto& [lanes, begin] : contest.builds)
        all.push_back({{"peers", scene.name, "default", "float", lanes, "host", 0, "", 0, ""}, begin});
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
        for (std::size_t peer_i = 0; peer_i < contact_peers().size(); ++peer_i)
            add(row, ("time_ratio_to_" + all[peer_i].row.method).c_str(), us[i] / us[peer_i], "1", rows);
    }
}

/// Errors of the peers, and of one build of the kernel, whose bits do not depend on lanes, over the same time.
void follow(const ContactCase& scene, const std::vector<Entrant>& all, int rate, const Settings& settings, Rows& rows) {
    const double seconds = settings.quick ? std::min(scene.seconds, scene.bodies.size() > 100 ? 3.0 : 10.0) : scene.seconds;
    for (const Entrant& entrant : all) {
        Row row = entrant.row;
        row.h = 1.0 / rate;
        for (const Metric& metric : followed(scene, entrant.begin, rate, seconds)) add(row, metric.name, metric.value, metric.unit, rows);
        if (entrant.row.method == "default") break;
    }
}

}  // namespace

void run_contact_peers(const Settings& settings, const std::vector<Variant>& variants, Progress& progress, Rows& rows) {
    for (const Contest& contest : contests(variants)) {
        const ContactCase& scene = contest.scene;
        progress.begin("peers " + scene.name);
        if (scene.name == "tower_20_searched") continue;
        const std::vector<Entrant> all = entrants(contest);
        for (const int rate : contact_rates(scene.name, settings.quick, true)) {
            follow(scene, all, rate, settings, rows);
            race_entrants(scene, all, rate, settings, rows);
        }
        for (const PeerEngine& engine : contact_peers())
            if (stands_still(scene.name))
                add_approach(approach_to_rest(
                                 scene, [&] { return engine.begin(scene); }, 60),
                             {"peers", scene.name, engine.name, engine.scalar, 1, "host", 1.0 / 60, "", 0, ""}, rows);
    }
}

void run_peers(const Settings& settings, const std::vector<Variant>& variants, Rows& rows) {
    Progress progress(11 + static_cast<int>(variants.size() + variants.front().contacts.size()));
    fly_peers(settings, variants, progress, rows);
    run_contact_peers(settings, variants, progress, rows);
}

}  // namespace report
