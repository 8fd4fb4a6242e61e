// Tables of numbers over time as CSV files that spreadsheets, pandas and tools/plot_curves.py read.
#pragma once

#include <imbibe/output/file.hpp>

#include <array>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace imbibe {

/// What one column of a table holds.
struct Column {
    /// What it is called.
    std::string name;
    /// Its SI unit; empty for a pure number.
    std::string unit = {};
};

/// What stands in one place of a table: a number, or words.
using Cell = std::variant<double, std::string>;

/// A CSV file that grows by one row at a time. The first line names the columns as `name [unit]`; every row is on disk
/// when row() returns, and numbers have as many digits as it takes to read the same double back.
/// <!-- tests/output/test_pictures.cpp -->
/// ```
/// imbibe::Table table(folder / "run.csv", {{"time", "s"}, {"displacement", "m"}});
/// for (int i = 0; i < 20; ++i)
///     table.row({i * 0.01, i * i * 1e-5});
/// ```
class Table {
public:
    /// Starts the file anew. Throws Error if it cannot be written, or for a column with no name, a name twice, or a
    /// line break or quotation mark in it.
    Table(std::filesystem::path path, std::vector<Column> columns) : Table(std::move(path), std::move(columns), false) {
        write(first_line(columns_) + "\n");
    }

    /// Continues the file of an earlier run, as after a restart: keeps its first `rows` rows and drops what follows.
    /// Throws Error if it has other columns or fewer rows.
    static Table resume(std::filesystem::path path, std::vector<Column> columns, std::size_t rows) {
        const auto expected = first_line(columns);
        std::string kept, line;
        std::ifstream in(path, std::ios::binary);
        require(static_cast<bool>(std::getline(in, line)) && line == expected, "cannot continue the table ",
                path.string(), ": its first line is '", line, "' where this run writes '", expected, "'");
        std::size_t found = 0;
        for (kept = line + "\n"; found < rows && std::getline(in, line) && !in.eof(); ++found)
            kept += line + "\n";
        require(found == rows, "cannot continue the table ", path.string(), " after ", rows, " rows: it has ", found);
        in.close();
        AtomicFile whole(path);
        whole << kept;
        whole.commit();
        return Table(std::move(path), std::move(columns), true);
    }

    /// Appends one row. Throws Error unless it has one number for each column, and when the disk refuses it; the rows
    /// before it stay.
    void row(std::span<const double> values) {
        std::string line;
        for (const double value : values)
            line += number(value) + ',';
        write_row(line, values.size());
    }
    /// Appends one row.
    void row(std::initializer_list<double> values) { row(std::span<const double>(values.begin(), values.size())); }
    /// Appends one row of numbers and words. Throws Error for words with a line break or quotation mark in them, too.
    void row(std::initializer_list<Cell> cells) {
        std::string line;
        for (const Cell& cell : cells) {
            if (const auto* words = std::get_if<std::string>(&cell)) {
                require(words->find_first_of("\"\r\n") == std::string::npos, "table ", path_.string(), ": '", *words,
                        "' cannot stand in a row; it must not contain \" or a line break");
                line += quoted(*words) + ',';
            } else {
                line += number(std::get<double>(cell)) + ',';
            }
        }
        write_row(line, cells.size());
    }

    /// The columns, in order.
    [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

private:
    Table(std::filesystem::path path, std::vector<Column> columns, bool append)
        : path_(std::move(path)), columns_(std::move(columns)) {
        require(!columns_.empty(), "table ", path_.string(), ": it has no columns");
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const auto& [name, unit] = columns_[i];
            require(!name.empty() && (name + unit).find_first_of("\"\r\n[]") == std::string::npos, "table ",
                    path_.string(), ": '", name, " [", unit,
                    "]' cannot head a column; a name must not be empty or contain \" [ ] or a line break");
            for (std::size_t j = 0; j < i; ++j)
                require(columns_[j].name != name, "table ", path_.string(), ": two columns are called ", name);
        }
        out_.open(path_, append ? std::ios::binary | std::ios::app : std::ios::binary);
        require(out_.is_open(), "cannot write the table ", path_.string(),
                ": the file cannot be opened; check that its folder exists and may be written by you");
    }

    static std::string first_line(const std::vector<Column>& columns) {
        std::string line;
        for (const auto& [name, unit] : columns)
            line += quoted(unit.empty() ? name : name + " [" + unit + "]") + ',';
        line.pop_back();
        return line;
    }
    static std::string quoted(const std::string& words) {
        return words.find(',') == std::string::npos ? words : '"' + words + '"';
    }
    static std::string number(double value) {
        std::array<char, 32> digits{};
        return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
    }
    void write_row(std::string& line, std::size_t cells) { // each of its cells ends with a comma
        require(cells == columns_.size(), "table ", path_.string(), ": a row has ", cells, " cells for ",
                columns_.size(), " columns");
        line.back() = '\n';
        write(line);
    }
    void write(const std::string& line) {
        out_.write(line.data(), static_cast<std::streamsize>(line.size()));
        out_.flush();
        require(out_.good(), "cannot write the table ", path_.string(),
                ": the disk refused a row; free space there or choose another folder, then continue the run");
    }

    std::filesystem::path path_;
    std::vector<Column> columns_;
    std::ofstream out_;
};

} // namespace imbibe
