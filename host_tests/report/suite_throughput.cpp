// SPDX-License-Identifier: MIT
#include <algorithm>

#include "crowd.h"
#include "suites.h"
#include "tables_on_disk.h"

namespace report {

namespace {

/// Cycles a nanosecond: the time of a chain of additions that each wait for the one before, one cycle each.
double cycles_per_ns() {
    constexpr int additions = 1000000;
    std::uint64_t sum = 1, summand = 3;
    const double ns = least_ns(5, [&] {
        for (int i = 0; i < additions / 16; ++i) {
            for (int k = 0; k < 16; ++k) {
                sum += summand;
                asm volatile("" : "+r"(sum), "+r"(summand));
            }
        }
    });
    return additions / ns;
}

}  // namespace

void run_throughput(const Settings& settings, const std::vector<Variant>& variants, Rows& rows) {
    Progress progress(static_cast<int>(variants.size()) * 5 + 1);
    progress.begin("throughput clock of this core");
    // Between the other measurements too: what takes time from this core takes it from a chain of additions as well.
    double clock = cycles_per_ns();
    const std::vector<FlopCount> flops = read_flops();
    for (const Variant& variant : variants) {
        const auto add = [&](const std::string& case_name, const char* metric, double value, const char* unit) {
            rows.add(
                {"throughput", case_name, "default", variant.scalar, variant.lanes, "host", 1.0 / 60, metric, value, unit});
        };
        for (const int bodies : {1, 64, 1024, 4096, 65536}) {
            const std::string name = "bodies_" + std::to_string(bodies);
            progress.begin("throughput " + variant.scalar + " x " + std::to_string(variant.lanes) + ", " + name);
            add(name, "ns_per_body_step", variant.throughput(bodies, settings.quick), "ns");
            clock = std::max(clock, cycles_per_ns());
        }
        add("bodies_4096", "bytes_per_body", variant.bytes_per_body, "bytes");
    }
    rows.add({"throughput", "machine", "none", "float", 1, "host", 0, "cycles_per_ns", clock, "1/ns"});
    for (const Variant& variant : variants) {
        // Two vector operations a cycle, on vectors as wide as the build's instructions: at most 32 bytes.
        const int width = std::min(variant.lanes, variant.scalar == "float" ? 8 : 4);
        for (const FlopCount& count : flops) {
            if (count.method != "default_moving" || count.scalar != variant.scalar || count.rate != 60) continue;
            const auto add = [&](const char* metric, double value, const char* unit) {
                rows.add({"throughput", "bodies_4096", "default", variant.scalar, variant.lanes, "host", 1.0 / 60, metric,
                          value, unit});
            };
            add("operations", count.all(), "1");
            add("floor_ns", count.all() / 2 / width / clock, "ns");
        }
    }
}

}  // namespace report
