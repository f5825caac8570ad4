// SPDX-License-Identifier: MIT
// ingot_report [--out DIR] [--quick] [--suite NAME]...: speed against error of everything the kernel offers, in one run.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "suites.h"
#include "write.h"

namespace report {

std::string machine_line() {
    std::ifstream file("/proc/cpuinfo");
    std::string model = "an unnamed processor";
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("model name", 0) != 0) continue;
        model = line.substr(line.find(':') + 2);
        break;
    }
    return "Built with " INGOT_COMPILER ", run on " + model + ". Errors and instruction counts are exact; times are the least of several repetitions on a machine that may have had "
           "other work, so compare them within this run only.";
}

}  // namespace report

int main(int argc, char** argv) try {
    using namespace report;
    Settings settings;
    if (!read_arguments(argc, argv, settings)) return 2;
    std::filesystem::create_directories(settings.out);

    const std::vector<Variant> all = variants();
    Rows rows;
    if (settings.wants("rotation")) run_rotation(settings, all, rows);
    if (settings.wants("driven")) run_driven(settings, all, rows);
    if (settings.wants("drift")) run_drift(settings, all, rows);
    if (settings.wants("throughput")) run_throughput(settings, all, rows);
#ifdef INGOT_PEERS
    if (settings.wants("peers")) run_peers(settings, rows);
#else
    if (!settings.suites.empty() && settings.wants("peers")) std::fprintf(stderr, "this build has no peers: configure with -DINGOT_PEERS=ON\n");
#endif
    if (settings.wants("mcu")) run_mcu(rows);

    write_csv(rows, settings.out);
    write_md(rows, settings.out);
    write_html(rows, draw_plots(rows, settings.out), settings.out);
    std::printf("report  file://%s/index.html\n", std::filesystem::absolute(settings.out).lexically_normal().c_str());
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "ingot_report: %s\n", error.what());
    return 1;
}
