// Tables of numbers over time as CSV files that spreadsheets, pandas and tools/plot_curves.py read.
#pragma once

#include <imbibe/core/number_in_text.hpp>
#include <imbibe/output/file.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
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

/// One cell of a table: a number of any kind, or words.
struct Cell : std::variant<double, std::string> {
    /// A number. Whole numbers are exact up to 2^53.
    template <class Number>
    requires std::is_arithmetic_v<Number> Cell(Number number) : variant(static_cast<double>(number)) {}
    /// Words.
    Cell(std::string words) : variant(std::move(words)) {}
    /// Words.
    Cell(const char* words) : variant(std::string(words)) {}
};

/// A CSV file that grows by one row at a time. The first line names the columns as `name [unit]`. Every row is on disk
/// when row() returns, and numbers have enough digits to read the same double back.
///
/// In a table over time, whose first column is `{"time", "s"}`, a row replaces those that are not earlier, as when a
/// run has gone back to a checkpoint. The first row of an object, if its time is above 0 s, continues the existing file
/// after the rows before that time, as after a restart; at or before 0 s it starts the file anew. Times that differ by
/// a billionth are the same. Any other table starts its file anew at once, as does one over time without an existing
/// file; resume() overrides this.
/// <!-- tests/output/test_pictures.cpp -->
/// ```
/// imbibe::Table table(folder / "run.csv", {{"time", "s"}, {"displacement", "m"}});
/// for (int i = 0; i < 20; ++i)
///     table.row({i * 0.01, i * i * 1e-5});
/// ```
class Table {
public:
    /// Starts the file anew; an existing table over time stays until the first row decides whether it is continued.
    /// Throws Error if it cannot be written, or for a column without a name, a repeated name, or a line break or
    /// quotation mark in a name.
    Table(std::filesystem::path path, std::vector<Column> columns)
        : Table(std::move(path), std::move(columns), Begin::as_the_first_row_says) {
        std::error_code none_there;
        if (!over_time_ || std::filesystem::file_size(path_, none_there) == 0 || none_there) {
            start_anew();
        } else {
            open(std::ios::app);
            begun_ = false;
        }
    }

    /// Continues the file of an earlier run, for any time of the next row: keeps its first `rows` rows and drops the
    /// rest. Throws Error if it has other columns or fewer rows, or a row has another number of cells.
    static Table resume(std::filesystem::path path, std::vector<Column> columns, std::size_t rows) {
        const std::string kept = first_rows(path, columns, rows);
        AtomicFile whole(path);
        whole << kept;
        whole.commit();
        return Table(std::move(path), std::move(columns), Begin::behind_what_is_there);
    }
    /// Throws Error if resume() would for the existing file, and changes nothing: check this before giving anything up
    /// for the state from which the table is continued.
    static void require_resumable(const std::filesystem::path& path, const std::vector<Column>& columns,
                                  std::size_t rows) {
        first_rows(path, columns, rows);
    }

    /// Appends one row. Throws Error unless it has one number for each column, and when the disk refuses it; earlier
    /// rows stay. A table over time also throws for a time that is not finite, and if the file to be continued has
    /// other columns, or a row that does not begin with a time or has another number of cells.
    void row(std::span<const double> values) {
        std::string line;
        for (const double value : values)
            line += number(value) + ',';
        write_row(line, values.size(), values.empty() ? std::nullopt : std::optional(values.front()));
    }
    /// Appends one row of numbers and words: `table.row({scene.time(), scene.steps(), "wet"})`. Also throws Error for
    /// words with a line break or quotation mark, and for words in place of a time.
    void row(std::initializer_list<Cell> cells) { row(std::span<const Cell>(cells.begin(), cells.size())); }
    /// The same from a range.
    void row(std::span<const Cell> cells) {
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
        const auto* time = cells.empty() ? nullptr : std::get_if<double>(&cells.front());
        write_row(line, cells.size(), time != nullptr ? std::optional(*time) : std::nullopt);
    }

    /// The columns, in order.
    [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

private:
    enum class Begin { as_the_first_row_says, behind_what_is_there };

    Table(std::filesystem::path path, std::vector<Column> columns, Begin begin)
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
        over_time_ = columns_.front().name == "time" && columns_.front().unit == "s";
        if (begin == Begin::behind_what_is_there)
            open(std::ios::app);
    }

    // The first line and `rows` rows of the file to be continued.
    static std::string first_rows(const std::filesystem::path& path, const std::vector<Column>& columns,
                                  std::size_t rows) {
        const auto expected = first_line(columns);
        std::string kept, line;
        std::ifstream in(path, std::ios::binary);
        require(in.is_open(), "cannot continue the table ", path.string(),
                ": there is no such file, or it may not be read");
        require(static_cast<bool>(std::getline(in, line)) && line == expected, "cannot continue the table ",
                path.string(), ": its first line is '", line, "' where this run writes '", expected, "'");
        std::size_t found = 0;
        for (kept = line + "\n"; found < rows && std::getline(in, line) && !in.eof(); ++found) {
            require_whole(line, columns.size(), path);
            kept += line + "\n";
        }
        require(found == rows, "cannot continue the table ", path.string(), " after ", rows, " rows: it has ", found,
                "; continue after at most so many, as from an earlier state of the run, or put back the whole file");
        return kept;
    }

    void open(std::ios::openmode how) {
        out_.close();
        out_.clear();
        out_.open(path_, std::ios::binary | how);
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
        return std::find(words.begin(), words.end(), ',') == words.end() ? words : '"' + words + '"';
    }
    static void require_whole(const std::string& row, std::size_t columns, const std::filesystem::path& path) {
        bool in_words = false;
        std::size_t cells = 1;
        for (const char c : row) {
            in_words ^= c == '"';
            cells += c == ',' && !in_words ? 1 : 0;
        }
        require(cells == columns, "cannot continue the table ", path.string(), ": its row '", row, "' has ", cells,
                " cells for ", columns, " columns; give this table another name, or move that one away");
    }
    static std::string number(double value) {
        std::array<char, 32> digits{};
        return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
    }
    void write_row(std::string& line, std::size_t cells, std::optional<double> time) {
        require(cells == columns_.size(), "table ", path_.string(), ": a row has ", cells, " cells for ",
                columns_.size(), " columns");
        line.back() = '\n'; // each of its cells ends with a comma
        if (over_time_) {
            require(time && std::isfinite(*time), "table ", path_.string(), ": a row at the time ",
                    time ? number(*time) : "(words)", "; it must be a finite number of seconds");
            keep_earlier_than(*time);
        }
        write(line);
        if (over_time_)
            last_ = *time;
    }

    void start_anew() {
        open(std::ios::trunc);
        write(first_line(columns_) + "\n");
    }
    void keep_earlier_than(double seconds) {
        if (!begun_ && !(seconds > 0))
            start_anew();
        else if (!begun_ || !detail::earlier(last_, seconds))
            cut_off_at(seconds);
        begun_ = true;
    }
    // Removes the rows from `seconds` on from the file, in one step, so that it is complete whenever the program ends.
    void cut_off_at(double seconds) {
        const auto expected = first_line(columns_);
        const auto remedy = "; give this table another name, or move that one away";
        std::string line;
        std::ifstream in(path_, std::ios::binary);
        require(static_cast<bool>(std::getline(in, line)) && line == expected, "the first row of the table ",
                path_.string(), ", at ", seconds, " s, would continue the file that is there, whose first line is '",
                line, "' where this run writes '", expected, "'", remedy);
        std::string kept = line + "\n";
        while (std::getline(in, line) && !in.eof()) { // a kill cut off a last line without its end
            const auto time = detail::number_in_text(line);
            require(time.has_value(), "cannot continue the table ", path_.string(), ": its row '", line,
                    "' does not begin with a time", remedy);
            require_whole(line, columns_.size(), path_);
            if (!detail::earlier(time->value, seconds))
                break;
            kept += line + "\n";
        }
        in.close();
        AtomicFile whole(path_);
        whole << kept;
        whole.commit();
        open(std::ios::app);
    }
    // A partly written row is removed, so that the next one begins a line.
    void write(const std::string& line) {
        std::error_code unknown;
        const auto before = std::filesystem::file_size(path_, unknown);
        out_.write(line.data(), static_cast<std::streamsize>(line.size()));
        out_.flush();
        if (out_.good())
            return;
        out_.close();
        if (!unknown)
            std::filesystem::resize_file(path_, before, unknown);
        out_.open(path_, std::ios::binary | std::ios::app);
        throw Error(text("cannot write the table ", path_.string(),
                         ": the disk refused a row; free space there or choose another folder, then continue the run"));
    }

    std::filesystem::path path_;
    std::vector<Column> columns_;
    std::ofstream out_;
    bool over_time_ = false;
    bool begun_ = true;                                      ///< has it been decided what the file continues?
    double last_ = -std::numeric_limits<double>::infinity(); ///< the time of the row written last, s
};

} // namespace imbibe
