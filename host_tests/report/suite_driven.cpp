// SPDX-License-Identifier: MIT
#include <limits>

#include "cases.h"
#include "suites.h"

namespace report {

void run_driven(const Settings& settings, const std::vector<Variant>& variants, Rows& rows) {
    const std::vector<std::string> tops = top_names(), driven = driven_names();
    const std::vector<const Variant*> chosen = one_per_scalar(variants);
    Progress progress(static_cast<int>(chosen.size() * (tops.size() + driven.size()) + variants.size()));
    for (const Variant* variant : chosen) {
        const auto run = [&](const std::string& name, const auto& body, auto fly) {
            progress.begin("driven " + variant->scalar + " " + name);
            for (const Flight& flight : variant->flights) {
                for (const int rate : {32, 64, 128, 256, 512}) {
                    if (settings.quick && rate > 256) continue;
                    const double error = fly(flight, body, rate);
                    rows.add({"driven", name, flight.name, variant->scalar, variant->lanes, "host", 1.0 / rate,
                              "attitude_error", error < 0 ? std::numeric_limits<double>::infinity() : error, "rad"});
                }
            }
        };
        for (const std::string& name : tops)
            run(name, TopCase(name), [](const Flight& f, const TopCase& top, int rate) { return f.fly_top(top, rate); });
        for (const std::string& name : driven)
            run(name, DrivenCase(name),
                [](const Flight& f, const DrivenCase& body, int rate) { return f.fly_driven(body, rate); });
    }
    for (const Variant& variant : variants) {
        progress.begin("driven cost, " + variant.scalar + " x " + std::to_string(variant.lanes));
        for (const Flight& flight : variant.flights)
            rows.add({"driven", "bodies_1024", flight.name, variant.scalar, variant.lanes, "host", 1.0 / 60, "ns_per_body_step",
                      flight.ns_of_crowd(settings.quick ? 2 : 30), "ns"});
    }
}

}  // namespace report
