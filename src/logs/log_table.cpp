#include "log_table.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/names.hpp"
#include "limber/common/csv_reader.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/printable.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr std::size_t kNamesInMessages = 40;

/// What other programs write where they have no number, in letters of any case. Infinity is none
/// either: it comes of a division by 0, or of a sensor that is not there.
bool is_missing(std::string_view text) {
  constexpr std::string_view kWords[] = {"",     "-",    "nan",  "na",  "n/a",     "#n/a",
                                         "<na>", "null", "none", "inf", "infinity"};
  if (text.size() > 1 && (text.front() == '-' || text.front() == '+')) {
    text.remove_prefix(1);
  }
  const auto is_equal = [](char letter, char typed) {
    return letter == std::tolower(static_cast<unsigned char>(typed));
  };
  return std::ranges::any_of(
      kWords, [&](std::string_view word) { return std::ranges::equal(word, text, is_equal); });
}

/// One log, its header read.
class LogFile {
 public:
  LogFile(const fs::path& path, const ImportMapping& mapping)
      : mapping_(mapping), csv_(CsvReader::from_file(path, mapping.separator)) {
    std::vector<CsvCell> row;
    for (int i = 0; i < mapping.skip_lines; ++i) {
      csv_.skip_line();
    }
    if (!mapping.columns.empty()) {
      names_ = mapping.columns;
      return;
    }
    while (next_line(row)) {
      if (!is_comment(row)) {
        read_header(row);
        return;
      }
    }
    csv_.refuse(1, "an empty file; expected a header line with the columns' names");
  }

  const std::vector<std::string>& names() const { return names_; }

  /// Index of a column. @throws InputError if it is missing or there twice.
  std::size_t find(const std::string& name) const {
    const auto first = std::find(names_.begin(), names_.end(), name);
    if (first == names_.end()) {
      std::vector<std::string> shown = names_;
      shown.resize(std::min(shown.size(), kNamesInMessages));
      throw InputError(fmt::format(
          "{}: there is no column '{}'; the file has: {}{}. Name the right one in the mapping",
          csv_.name(), name, fmt::join(shown, ", "),
          names_.size() > shown.size() ? fmt::format(" and {} more", names_.size() - shown.size())
                                       : ""));
    }
    const auto second = std::find(first + 1, names_.end(), name);
    if (second != names_.end()) {
      throw InputError(fmt::format(
          "{}: column '{}' is there twice, as {} and {}; give them names of their own", csv_.name(),
          name, column_name(first - names_.begin()), column_name(second - names_.begin())));
    }
    return std::size_t(first - names_.begin());
  }

  bool has(const std::string& name) const {
    return std::find(names_.begin(), names_.end(), name) != names_.end();
  }

  /// The next row that is neither blank nor a comment. Where rows are the clock, one without
  /// anything in its cells is a moment in which nothing was logged.
  bool next(std::vector<CsvCell>& row) {
    while (next_line(row)) {
      const bool is_moment = mapping_.time.column.empty() && row.size() > 1;
      if (!is_comment(row) || (is_moment && is_blank(row))) {
        width_ = rows_read_++ == 0 ? number_count(row) : width_;
        return true;
      }
    }
    return false;
  }

  /// By `next`, those that can't be read among them.
  std::size_t rows_read() const { return rows_read_; }
  /// Cells with numbers that the first row has, at least as many as there are columns.
  std::size_t width() const { return width_; }

  /// Cells of a row up to its last number, at least as many as there are columns: text beyond them
  /// is a remark.
  std::size_t number_count(const std::vector<CsvCell>& row) const {
    std::size_t count = std::max(row.size(), names_.size());
    double ignored = 0.0;
    while (count > names_.size() && !parse(row[count - 1].text, ignored)) {
      --count;
    }
    return count;
  }

  bool parse(std::string_view text, double& value) const {
    if (!mapping_.decimal_comma) {
      return parse_number(text, value);
    }
    std::string plain(text);
    std::replace(plain.begin(), plain.end(), ',', '.');
    return parse_number(plain, value);
  }

  const CsvReader& csv() const { return csv_; }

 private:
  /// A quote in a comment begins no cell.
  bool next_line(std::vector<CsvCell>& row) {
    csv_.skip_lines_with('#');
    return csv_.next(row);
  }

  static bool is_comment(const std::vector<CsvCell>& row) {
    return is_blank(row) || row.front().text.starts_with('#');
  }

  void read_header(const std::vector<CsvCell>& row) {
    double ignored = 0.0;
    if (parse_number(row.front().text, ignored)) {
      csv_.refuse(1, fmt::format("'{}' where a header line should be; for a file without one, name "
                                 "its {} columns in the mapping: 'columns: [time_s, …]'",
                                 row.front().text, row.size()));
    }
    if (row.size() == 1 && mapping_.separator == ',' &&
        row.front().text.find_first_of(";\t") != std::string_view::npos) {
      csv_.refuse(1,
                  "one single column; is it separated by semicolons or tabs? Say so in the "
                  "mapping: 'separator: \";\"' or 'separator: tab'");
    }
    for (const CsvCell& cell : row) {
      names_.emplace_back(cell.text);
    }
  }

  const ImportMapping& mapping_;
  CsvReader csv_;
  std::vector<std::string> names_;
  std::size_t rows_read_ = 0;
  std::size_t width_ = 0;
};

struct Column {
  std::size_t index = 0;
  double sign = 1.0;
  bool present = true;
  bool counts_rows = false;
  double largest = std::numeric_limits<float>::max();  // what recordings hold
};

Column column_of(const LogFile& file, const std::string& name) {
  if (name.empty()) {
    return {0, 1.0, false, true};
  }
  if (!file.has(name) && name.starts_with('-')) {
    return {file.find(name.substr(1)), -1.0, true};
  }
  return {file.find(name), 1.0, true};
}

std::vector<Column> columns_of(const LogFile& file, const WantedColumns& wanted,
                               const ImportMapping& mapping) {
  std::vector<Column> columns;
  for (const std::string& name : wanted.names) {
    columns.push_back(column_of(file, name));
    if (name == mapping.time.column || name == mapping.commands.time.column ||
        name == mapping.motion) {
      columns.back().largest = std::numeric_limits<double>::max();  // clocks are judged as such
    }
  }
  const bool all = std::all_of(wanted.optional.begin(), wanted.optional.end(),
                               [&](const std::string& name) { return file.has(name); });
  for (const std::string& name : wanted.optional) {
    columns.push_back(all ? column_of(file, name) : Column{0, 1.0, false, false});
  }
  return columns;
}

/// Why a row can't be read; empty if it was.
std::string read_row(const LogFile& file, const std::vector<CsvCell>& row,
                     const std::vector<Column>& columns, std::vector<double>& values) {
  values.clear();
  if (const std::size_t count = file.number_count(row); count > file.width()) {
    return fmt::format("line {}: {} cells; expected {}", file.csv().line(), count, file.width());
  }
  for (const Column& column : columns) {
    double value = std::numeric_limits<double>::quiet_NaN();
    if (column.counts_rows) {
      value = double(file.rows_read() - 1);
    }
    if (column.present) {
      if (column.index >= row.size()) {
        return fmt::format("line {}: {} cells; expected {}", file.csv().line(), row.size(),
                           file.names().size());
      }
      const CsvCell& cell = row[column.index];
      if (!is_missing(cell.text) && !file.parse(cell.text, value)) {
        return fmt::format("line {}, column '{}': '{}' is not a number", file.csv().line(),
                           file.names()[column.index], in_one_line(cell.text));
      }
      if (std::abs(value) > column.largest) {
        return fmt::format("line {}, column '{}': {:.6g} found; expected at most {:.3g} in size",
                           file.csv().line(), file.names()[column.index], value, column.largest);
      }
    }
    values.push_back(column.sign * value);
  }
  return {};
}

}  // namespace

LogTable read_log_table(const fs::path& path, const ImportMapping& mapping,
                        const WantedColumns& wanted, RunReport& report) {
  LogFile file(path, mapping);
  const std::vector<Column> columns = columns_of(file, wanted, mapping);
  const std::size_t label = wanted.label.empty() ? 0 : file.find(wanted.label);
  LogTable table;
  table.file = path.string();
  table.columns.resize(columns.size());
  std::vector<CsvCell> row;
  std::vector<double> values;
  std::size_t bad = 0;
  std::string first_bad;
  while (file.next(row)) {
    std::string reason = read_row(file, row, columns, values);
    if (reason.empty() && !wanted.label.empty() && label >= row.size()) {
      reason = fmt::format("line {}: no cell '{}'", file.csv().line(), wanted.label);
    }
    if (!reason.empty()) {
      first_bad = bad++ == 0 ? reason : first_bad;
      continue;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      table.columns[i].push_back(values[i]);
    }
    table.lines.push_back(file.csv().line());
    if (!wanted.label.empty()) {
      const bool is_of_before = is_blank(row) && !table.labels.empty();
      table.labels.emplace_back(is_of_before ? table.labels.back() : std::string(row[label].text));
    }
  }
  if (are_too_many(bad, table.row_count() + bad)) {
    throw InputError(fmt::format("{}: {} of {} rows can't be read; first {}", table.file, bad,
                                 table.row_count() + bad, first_bad));
  }
  if (bad > 0) {
    report.note("rows left out that can't be read",
                fmt::format("{}: {}", path.filename().string(), first_bad), std::int64_t(bad));
  }
  if (file.width() > file.names().size()) {
    report.note(
        "rows hold more numbers than the header has names: those beyond are left out",
        fmt::format("{} and {}; has the first column no name?", file.width(), file.names().size()));
  }
  refuse_if(table.row_count() == 0, "{}: no rows below the header", table.file);
  return table;
}

bool are_too_many(std::size_t bad_rows, std::size_t rows) {
  constexpr double kMaxBadRows = 0.01;
  constexpr std::size_t kBadRowsAlwaysLeftOut = 3;
  return double(bad_rows) > kMaxBadRows * double(rows) && bad_rows > kBadRowsAlwaysLeftOut;
}

std::vector<std::string> log_columns(const fs::path& path, const ImportMapping& mapping) {
  return LogFile(path, mapping).names();
}

}  // namespace limber
