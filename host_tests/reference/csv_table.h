// SPDX-License-Identifier: MIT
// Reads a table of reference/ by the names of its columns. See README.md for the tables.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace ingot_reference {

/// A comma-separated table whose first line names its columns; cells hold no commas and no quotes.
///
///     const CsvTable table("free_symmetric.csv");
///     for (std::size_t row : table.rows_with("case", "disc")) check(table.number<long double>(row, "t"), ...);
///
/// Every mistake (no such file, column or row, a cell that is not a number) is a std::runtime_error that names the place: a
/// test on a table that cannot be read fails.
class CsvTable {
public:
    /// Reads reference/<file_name>.
    explicit CsvTable(const std::string& file_name) : CsvTable(INGOT_REFERENCE_DIR, file_name) {}

    CsvTable(const std::string& folder, const std::string& file_name) : file_name_(file_name) {
        std::ifstream file(folder + "/" + file_name);
        std::string line;
        if (!std::getline(file, line)) throw std::runtime_error(file_name + ": cannot be read, or is empty");
        columns_ = cells_of(line);
        while (std::getline(file, line)) {
            std::vector<std::string> cells = cells_of(line);
            if (cells.size() == 1 && cells[0].empty()) continue;
            if (cells.size() != columns_.size())
                throw std::runtime_error(place(rows_.size()) + ": not as many cells as columns");
            rows_.push_back(cells);
        }
    }

    /// Rows below the names; they are counted from 0.
    std::size_t row_count() const { return rows_.size(); }

    const std::vector<std::string>& columns() const { return columns_; }

    /// The cell as it is written.
    const std::string& text(std::size_t row, const std::string& column) const {
        if (row >= rows_.size()) throw std::runtime_error(place(row) + ": the table ends before");
        return rows_[row][index_of(column)];
    }

    /// True for a cell without a value.
    bool is_empty(std::size_t row, const std::string& column) const { return text(row, column).empty(); }

    /// The cell as the number next to it in Real: float, double or long double. It is rounded once, from the decimal digits.
    template <class Real = double>
    Real number(std::size_t row, const std::string& column) const {
        const std::string& cell = text(row, column);
        char* end = nullptr;
        const Real value = parsed<Real>(cell.c_str(), &end);
        if (cell.empty() || end != cell.c_str() + cell.size())
            throw std::runtime_error(place(row) + ", column " + column + ": '" + cell + "' is not a number");
        return value;
    }

    /// The numbers of several columns, in the order of their names.
    template <class Real = double>
    std::vector<Real> numbers(std::size_t row, const std::vector<std::string>& columns) const {
        std::vector<Real> values;
        for (const std::string& column : columns) values.push_back(number<Real>(row, column));
        return values;
    }

    /// The rows whose cell in a column reads so, in the order of the table.
    std::vector<std::size_t> rows_with(const std::string& column, const std::string& value) const {
        std::vector<std::size_t> found;
        for (std::size_t row = 0; row < rows_.size(); ++row)
            if (text(row, column) == value) found.push_back(row);
        return found;
    }

    /// The only row whose cell in a column reads so.
    std::size_t row_with(const std::string& column, const std::string& value) const {
        const std::vector<std::size_t> found = rows_with(column, value);
        if (found.size() != 1)
            throw std::runtime_error(file_name_ + ": " + std::to_string(found.size()) + " rows have " + column + " = " + value);
        return found.front();
    }

private:
    /// strtof, strtod and strtold round correctly (C11 F.5 asks for it, glibc and musl do it).
    template <class Real>
    static Real parsed(const char* from, char** end) {
        static_assert(std::is_floating_point_v<Real>, "a table holds numbers: float, double or long double");
        if constexpr (std::is_same_v<Real, float>) return std::strtof(from, end);
        else if constexpr (std::is_same_v<Real, double>) return std::strtod(from, end);
        else return std::strtold(from, end);
    }

    static std::vector<std::string> cells_of(const std::string& line) {
        std::vector<std::string> cells(1);
        for (const char c : line) {
            if (c == ',') cells.emplace_back();
            else if (c != '\r') cells.back() += c;
        }
        return cells;
    }

    std::size_t index_of(const std::string& column) const {
        for (std::size_t column_i = 0; column_i < columns_.size(); ++column_i)
            if (columns_[column_i] == column) return column_i;
        throw std::runtime_error(file_name_ + ": has no column " + column);
    }

    std::string place(std::size_t row) const { return file_name_ + ", row " + std::to_string(row); }

    std::string file_name_;
    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace ingot_reference
