// SPDX-License-Identifier: MIT
#include "reference/csv_table.h"
#include "suites.h"
#include "tables_on_disk.h"

namespace report {

using ingot_reference::CsvTable;

std::vector<FlopCount> read_flops() {
    const CsvTable table(INGOT_TABLES_DIR, "flops.csv");
    std::vector<FlopCount> counts;
    for (std::size_t row = 0; row < table.row_count(); ++row) {
        counts.push_back({table.text(row, "method"), table.text(row, "scalar"), static_cast<int>(table.number(row, "rate")),
                          table.number(row, "adds"), table.number(row, "muls"), table.number(row, "divs"),
                          table.number(row, "roots")});
    }
    return counts;
}

void run_mcu(Rows& rows) {
    const CsvTable scenes(INGOT_TABLES_DIR, "budgets.csv");
    const CsvTable methods(INGOT_TABLES_DIR, "methods.csv");
    const auto add_columns = [&](const CsvTable& table, std::size_t row, const std::string& case_name,
                                 const std::string& method) {
        for (const std::string& column : table.columns()) {
            if (column == "scene" || column == "method" || column == "core") continue;
            const bool counted = column.find("instructions") == 0;
            rows.add({"mcu", case_name, method, "float", 1, table.text(row, "core"), 1.0 / 60, column,
                      table.number(row, column), counted ? "instructions" : "bytes"});
        }
    };
    for (std::size_t row = 0; row < scenes.row_count(); ++row) add_columns(scenes, row, scenes.text(row, "scene"), "default");
    for (std::size_t row = 0; row < methods.row_count(); ++row) add_columns(methods, row, "book", methods.text(row, "method"));
    for (const FlopCount& count : read_flops()) {
        if (count.method == "default_moving") continue;  // of the throughput suite
        const auto add = [&](const char* metric, double value) {
            rows.add({"mcu", "book", count.method, count.scalar, 1, "any", 1.0 / count.rate, metric, value, "1"});
        };
        add("flops", count.adds + count.muls);
        add("divisions", count.divs);
        add("square_roots", count.roots);
    }
}

}  // namespace report
