// SPDX-License-Identifier: MIT
// ingot_report [--out DIR] [--quick] [--suite NAME]...: speed against error of everything the kernel offers, in one run.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "suites.h"
#include "write.h"

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
    if (settings.wants("contact")) run_contact(settings, all, rows);
    if (settings.wants("effort")) run_effort(settings, rows);
    if (settings.wants("simbenchmark")) run_simbenchmark(settings, all, rows);
    if (settings.wants("levels")) run_levels(settings, rows);
    if (settings.wants("control")) run_control(settings, rows);
    if (settings.wants("peers")) run_peers(settings, all, rows);
    if (settings.wants("mcu")) run_mcu(rows);

    write_csv(rows, settings.out);
    if (!can_draw_plots()) std::fprintf(stderr, "gnuplot is not installed: tables, and no plots\n");
    const Page page = page_of(rows, draw_plots(rows, settings.out), settings);
    write_md(page, settings.out);
    write_html(page, settings.out);
    std::printf("report  file://%s/index.html\n", std::filesystem::absolute(settings.out).lexically_normal().c_str());
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "ingot_report: %s\n", error.what());
    return 1;
}
