// SPDX-License-Identifier: MIT
#include <algorithm>

#include "suites.h"

namespace report {

void run_drift(const Settings& settings, const std::vector<Variant>& variants, Rows& rows) {
    const FreeBodyCase book("free_asymmetric", "book");
    const std::vector<const Variant*> chosen = one_per_scalar(variants);
    const std::vector<std::string> names = {
        "default",      "moser_veselov_6_plain", "moser_veselov_6_compensated", "symmetric_top_splitting_2", "rk4_polar",
        "lie_midpoint", "listing1_euler"};
    Progress progress(static_cast<int>(chosen.size() * names.size()));
    for (const Variant* variant : chosen) {
        for (const Method& method : variant->methods) {
            if (std::find(names.begin(), names.end(), method.name) == names.end()) continue;
            progress.begin("drift " + variant->scalar + " " + method.name);
            for (const DriftPoint& point : method.drift(book, 60, settings.quick ? 1000000 : 100000000)) {
                const std::string name = "book_steps_" + std::to_string(static_cast<long>(point.steps));
                const auto add = [&](const char* metric, double value) {
                    rows.add(
                        {"drift", name, method.name, variant->scalar, variant->lanes, "host", 1.0 / 60, metric, value, "1"});
                };
                add("energy_error", point.energy);
                add("orthogonality", point.orthogonality);
                add("L_error", point.L);
            }
        }
    }
}

}  // namespace report
