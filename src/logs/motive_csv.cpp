#include "motive_csv.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Core>

#include "limber/arm/names.hpp"
#include "limber/arm/pose_size.hpp"
#include "limber/common/csv_reader.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "log_table.hpp"
#include "motive_plates.hpp"

namespace limber {

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kHowToExport =
    "In Motive's export tick 'Header Information', 'Rigid Bodies' (in Motive 3 'Rigid Body Bones') "
    "or 'Markers', 'Use World Coordinates', rotation 'Quaternion', units 'Meters'";
constexpr double kOldestFormat = 1.2;
constexpr const char* kTypes[] = {
    "Rigid Body", "Rigid Body Marker", "Marker",       "Bone",          "Bone Marker",
    "Unlabeled",  "Unlabeled Marker",  "Other Marker", "Labeled Marker"};
constexpr const char* kComponents[] = {
    "Rotation", "Position", "Mean Marker Error", "Marker Quality", "Speed", "Size", "Marker Error"};

using Texts = std::vector<std::string>;

template <class List>
bool is_one_of(const std::string& text, const List& list) {
  return std::any_of(std::begin(list), std::end(list),
                     [&](const char* word) { return text == word; });
}

/// Motive quotes names inside of CSV's own quotes in some versions.
std::string without_quotes(std::string_view text) {
  while (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = text.substr(1, text.size() - 2);
  }
  return std::string(text);
}

bool is_number(const std::string& text) {
  double ignored = 0.0;
  return parse_number(text, ignored);
}

const std::string& cell(const Texts& row, std::size_t column) {
  static const std::string kEmpty;
  return column < row.size() ? row[column] : kEmpty;
}

/// What one column holds.
struct ColumnMeaning {
  std::size_t object;
  int component;  // 0 … 2: x, y, z of the position; 3 … 6: x, y, z, w of the rotation
};

class MotiveFile {
 public:
  MotiveFile(const fs::path& path, RunReport& report)
      : csv_(CsvReader::from_file(path)), report_(report) {}

  MotiveTake read() {
    read_metadata();
    read_headings();
    find_columns();
    read_rows();
    for (std::size_t i = 0; i < take_.objects.size(); ++i) {
      fill(take_.objects[i], i);
    }
    return std::move(take_);
  }

 private:
  [[noreturn]] void refuse(const std::string& message) const { csv_.refuse(1, message); }

  static Texts texts_of(const std::vector<CsvCell>& cells) {
    Texts texts;
    for (const CsvCell& c : cells) {
      texts.push_back(without_quotes(c.text));
    }
    return texts;
  }

  bool next(Texts& row) {
    std::vector<CsvCell> cells;
    if (!csv_.next(cells)) {
      return false;
    }
    row = texts_of(cells);
    return true;
  }

  // ---- row 1: key, value, key, value, …

  void read_metadata() {
    Texts row;
    if (!next(row)) {
      refuse("an empty file; expected Motive's CSV export");
    }
    if (row.size() == 1 && row.front().find(',') != std::string::npos) {
      CsvReader inner(row.front(), csv_.name());  // the whole line was quoted
      std::vector<CsvCell> cells;
      inner.next(cells);
      row = texts_of(cells);
    }
    require_format(row);
    // Keys by name: an unquoted comma in the take's name shifts everything after it.
    const auto value = [&](const char* key) {
      const auto found = std::find(row.begin(), row.end(), key);
      return found == row.end() || found + 1 == row.end() ? std::string() : *(found + 1);
    };
    take_.rotation_type = value("Rotation Type");
    read_length_unit(value("Length Units"));
    const std::string space = value("Coordinate Space");
    if (!space.empty() && space != "Global" && space != "World") {
      refuse(fmt::format(
          "'Coordinate Space' is {}; expected Global: bones' poses relative to their parents do "
          "not lie in one plane. {}",
          space, kHowToExport));
    }
  }

  void require_format(const Texts& row) {
    const std::string& first = row.front();
    if (first == "Format Version") {
      const std::string version_text = cell(row, 1);
      double version = 0.0;
      if (!parse_number(version_text, version) || version < kOldestFormat) {
        refuse(
            fmt::format("'Format Version' is '{}'; this program reads 1.2 and "
                        "later. Export the take again with a newer Motive, or "
                        "bring it as plain CSV ('limber import csv')",
                        version_text));
      }
      return;
    }
    if (is_number(first)) {
      refuse(
          fmt::format("numbers where the header should be. {}. Without its header the file can be "
                      "read by 'limber import csv', the mapping naming its 'columns'",
                      kHowToExport));
    }
    const bool is_old = is_one_of(
        first, std::array{"comment", "info", "version", "trackable", "rigidbody", "frame"});
    refuse(is_old
               ? std::string("a tracking file of format 1.1 or older; this program reads 1.2 and "
                             "later. Export the take again with a newer Motive")
               : fmt::format("begins with '{}'; Motive's CSV exports begin with 'Format Version'. "
                             "Other CSV files are read by 'limber import csv'",
                             first));
  }

  void read_length_unit(const std::string& unit) {
    std::string lower(unit);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    if (lower.empty()) {
      report_.note("no 'Length Units' in the header: taken for metres");
    } else if (lower == "centimeters") {
      to_metres_ = 0.01;
    } else if (lower == "millimeters") {
      to_metres_ = 0.001;
    } else if (lower != "meters") {
      refuse(
          fmt::format("'Length Units' is {}; expected Meters, Centimeters or Millimeters", unit));
    }
    if (to_metres_ != 1.0) {
      report_.note(fmt::format("lengths turned from {} into metres", lower));
    }
  }

  // ---- heading rows, known by what they hold

  void read_headings() {
    Texts row;
    while (next(row)) {
      if (std::all_of(row.begin(), row.end(), [](const std::string& c) { return c.empty(); })) {
        continue;
      }
      if (is_number(row.front()) && is_number(cell(row, 1))) {
        first_row_ = row;
        break;
      }
      headings_.push_back(row);
      if (row.front() == "Frame") {
        break;
      }
    }
    const auto has = [](const auto& words) {
      return [&words](const Texts& r) {
        return std::any_of(r.begin(), r.end(),
                           [&](const std::string& c) { return is_one_of(c, words); });
      };
    };
    type_row_ = std::find_if(headings_.begin(), headings_.end(), has(kTypes)) - headings_.begin();
    const auto after_name = std::min<std::ptrdiff_t>(type_row_ + 2, std::ssize(headings_));
    component_row_ =
        std::find_if(headings_.begin() + after_name, headings_.end(), has(kComponents)) -
        headings_.begin();
    if (component_row_ + 1 >= std::ssize(headings_)) {
      refuse(
          fmt::format("no heading rows with types, names and components (Rigid Body, …, "
                      "Rotation, Position, …, X, Y, Z) above the data. {}",
                      kHowToExport));
    }
  }

  const Texts& heading(std::ptrdiff_t row) const { return headings_[std::size_t(row)]; }

  void find_columns() {
    const Texts& types = heading(type_row_);
    const Texts& axes = headings_.back();
    const auto is_type = [](const std::string& text) { return is_one_of(text, kTypes); };
    first_column_ = std::size_t(std::find_if(types.begin(), types.end(), is_type) - types.begin());
    for (std::size_t c = 1; c < first_column_; ++c) {
      if (cell(axes, c).starts_with("Time (")) {
        time_column_ = c;
      }
    }
    std::map<std::pair<std::string, std::string>, std::size_t> object_of;
    std::map<std::pair<std::size_t, int>, std::size_t> taken;
    for (std::size_t c = first_column_; c < types.size(); ++c) {
      const int component = component_of(cell(heading(component_row_), c), cell(axes, c));
      if (types[c].empty() || component < 0) {
        continue;
      }
      const std::string& name = cell(heading(type_row_ + 1), c);
      const auto [entry, is_new] =
          object_of.emplace(std::pair(types[c], name), take_.objects.size());
      if (is_new) {
        take_.objects.push_back({types[c], name, {}, {}});
      }
      const auto [other, is_free] = taken.emplace(std::pair(entry->second, component), c);
      if (!is_free) {
        refuse(
            fmt::format("two objects of type '{}' are called '{}' ({} and {}); rename one "
                        "in Motive and export again",
                        types[c], name, column_name(other->second), column_name(c)));
      }
      columns_.emplace_back(c, ColumnMeaning{entry->second, component});
    }
    if (take_.objects.empty()) {
      refuse(fmt::format("no column holds a position. {}", kHowToExport));
    }
  }

  static int component_of(const std::string& component, const std::string& axis) {
    const int coordinate = axis == "X"   ? 0
                           : axis == "Y" ? 1
                           : axis == "Z" ? 2
                           : axis == "W" ? 3
                                         : -1;
    if (component == "Position" && coordinate >= 0 && coordinate < 3) {
      return coordinate;
    }
    return component == "Rotation" && coordinate >= 0 ? 3 + coordinate : -1;
  }

  // ---- data rows

  void read_rows() {
    values_.resize(columns_.size());
    std::size_t bad = 0;
    std::string first_bad;
    Texts row = first_row_;
    for (bool has_row = !row.empty() || next(row); has_row; has_row = next(row)) {
      if (row.size() == 1 && row.front().empty()) {
        continue;
      }
      std::string reason = read_row(row);
      if (!reason.empty()) {
        first_bad = bad++ == 0 ? fmt::format("line {}: {}", csv_.line(), reason) : first_bad;
      }
    }
    if (take_.time_s.empty() || are_too_many(bad, take_.time_s.size() + bad)) {
      refuse(bad > 0 ? fmt::format("{} rows can't be read; first {}", bad, first_bad)
                     : std::string("no data below the headings"));
    }
    if (bad > 0) {
      report_.note("rows left out that can't be read", first_bad, std::int64_t(bad));
    }
  }

  std::string read_row(const Texts& row) {
    double time_s = 0.0;
    if (!parse_number(cell(row, time_column_), time_s)) {
      return fmt::format("'{}' is not a time", cell(row, time_column_));
    }
    std::vector<double> numbers;
    for (const auto& [column, meaning] : columns_) {
      double value = kNoNumber;
      const std::string& text = cell(row, column);
      if (!text.empty() && !parse_number(text, value)) {
        if (text != "nan" && text != "NaN") {
          return fmt::format("{}: '{}' is not a number", column_name(column), text);
        }
        value = kNoNumber;
      }
      numbers.push_back(value);
    }
    take_.time_s.push_back(time_s);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      values_[i].push_back(numbers[i]);
    }
    return {};
  }

  // ---- objects

  void fill(MotiveObject& object, std::size_t index) const {
    const auto rows = Eigen::Index(take_.time_s.size());
    Eigen::MatrixXd numbers = Eigen::MatrixXd::Constant(rows, kSpacePoseSize, kNoNumber);
    std::array<bool, kSpacePoseSize> present{};
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const ColumnMeaning& meaning = columns_[i].second;
      if (meaning.object == index) {
        present[std::size_t(meaning.component)] = true;
        numbers.col(meaning.component) = Eigen::Map<const Eigen::VectorXd>(values_[i].data(), rows);
      }
    }
    object.position_m = to_metres_ * numbers.leftCols<3>();
    if (!present[0] || !present[1] || !present[2]) {
      throw InputError(fmt::format("{}: '{}' ({}) has no X, Y and Z of its position", csv_.name(),
                                   object.name, object.type));
    }
    if (present[6]) {
      object.rotation =
          unit_quaternions(csv_.name(), object.name, take_.time_s, numbers.rightCols<4>());
    } else if (present[3] && present[4] && present[5]) {
      if (!is_euler_order(take_.rotation_type)) {
        throw InputError(
            fmt::format("{}: 'Rotation Type' is '{}'; expected Quaternion "
                        "or an order of Euler angles, XYZ … ZYX. {}",
                        csv_.name(), take_.rotation_type, kHowToExport));
      }
      object.rotation = quaternions_of_euler(numbers.middleCols<3>(3), take_.rotation_type);
    }
  }

  CsvReader csv_;
  RunReport& report_;
  MotiveTake take_;
  double to_metres_ = 1.0;
  std::vector<Texts> headings_;
  Texts first_row_;
  std::ptrdiff_t type_row_ = 0;
  std::ptrdiff_t component_row_ = 0;
  std::size_t first_column_ = 2;
  std::size_t time_column_ = 1;
  std::vector<std::pair<std::size_t, ColumnMeaning>> columns_;
  std::vector<std::vector<double>> values_;  // of each of columns_
};

}  // namespace

MotiveTake read_motive_csv(const fs::path& path, RunReport& report) {
  return MotiveFile(path, report).read();
}

}  // namespace limber
