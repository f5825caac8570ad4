// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include "contact_peers.h"
#include "contact_race.h"
#include "effort_cases.h"
#include "suites.h"

namespace report {

namespace {

constexpr int rate = 60;

Row row_of(const ContactCase& scene, const EffortLevel& level, const std::string& metric, double value, const std::string& unit) {
    return {"effort", scene.name, method_of(level), "float", 4, "host", 1.0 / rate, metric, value, unit};
}

/// All levels take turns, and Box3D with them where the report is built with it.
void race(const EffortCase& at, const std::vector<PeerEngine>& peers, const Settings& settings, Rows& rows) {
    std::vector<BeginRun> begins(at.begins.begin(), at.begins.end());
    for (const PeerEngine& peer : peers) begins.push_back([&] { return peer.begin(at.scene); });
    const std::vector<double> us = raced(at.scene, begins, rate, timed_seconds(at.scene, settings.quick), settings.quick ? 1 : 3);
    for (std::size_t i = 0; i < at.begins.size(); ++i) {
        if (std::isnan(us[i])) continue;
        const auto add = [&](const std::string& metric, double value, const char* unit) {
            rows.add(row_of(at.scene, effort_levels[i], metric, value, unit));
        };
        add("us_per_step", us[i], "us");
        for (std::size_t peer_i = 0; peer_i < peers.size(); ++peer_i)
            add("time_ratio_to_" + peers[peer_i].name, us[i] / us[at.begins.size() + peer_i], "1");
    }
}

}  // namespace

void run_effort(const Settings& settings, Rows& rows) {
    std::vector<PeerEngine> peers = contact_peers();
    peers.erase(std::remove_if(peers.begin(), peers.end(), [](const PeerEngine& peer) { return peer.name != "box3d"; }), peers.end());
    const std::vector<EffortCase> cases = effort_cases();
    Progress progress(static_cast<int>(cases.size()));
    for (const EffortCase& at : cases) {
        progress.begin("effort " + at.scene.name);
        if (settings.quick && !at.in_quick_runs) continue;
        const double seconds = settings.quick ? std::min(at.scene.seconds, 3.0) : at.scene.seconds;
        for (std::size_t i = 0; i < at.begins.size(); ++i)
            for (const Metric& metric : followed(at.scene, at.begins[i], rate, seconds))
                rows.add(row_of(at.scene, effort_levels[i], metric.name, metric.value, metric.unit));
        race(at, peers, settings, rows);
    }
}

}  // namespace report
