#include "limber/run/tip_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "limber/common/csv_reader.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"

namespace limber {

namespace {

constexpr std::array kColumns = {"time_s", "x_m", "y_m"};
constexpr double kFarthestM = 100.0;  // a path in other units than metres is refused
constexpr double kLongestS = 3600.0;  // one in milliseconds too: each frame is planned

/// Position of each of kColumns in the file's rows.
using ColumnOrder = std::array<std::size_t, kColumns.size()>;

ColumnOrder read_header(CsvReader& csv, std::vector<CsvCell>& row) {
  do {
    if (!csv.next(row)) {
      csv.refuse(1, "empty; expected the columns time_s, x_m and y_m");
    }
  } while (is_blank(row));
  ColumnOrder order{};
  for (std::size_t k = 0; k < kColumns.size(); ++k) {
    const auto found = std::find_if(row.begin(), row.end(),
                                    [&](const CsvCell& cell) { return cell.text == kColumns[k]; });
    if (found == row.end()) {
      csv.refuse(1, fmt::format("no column {}; expected time_s, x_m and y_m", kColumns[k]));
    }
    order[k] = std::size_t(found - row.begin());
  }
  if (row.size() != kColumns.size()) {
    csv.refuse(1, fmt::format("{} columns; expected time_s, x_m and y_m alone", row.size()));
  }
  return order;
}

}  // namespace

std::string TipPath::source_of(const std::string& file, std::size_t point) const {
  return fmt::format("{}:{}", file, line[point]);
}

void TipPath::require_within(double arm_length_m, const std::string& file) const {
  for (std::size_t i = 0; i < point_m.size(); ++i) {
    if (point_m[i].norm() > arm_length_m) {
      throw InputError(fmt::format(
          "{}: ({:.3f}, {:.3f}) m is {:.3f} m from the base; the arm is {:.3f} m long",
          source_of(file, i), point_m[i].x(), point_m[i].y(), point_m[i].norm(), arm_length_m));
    }
  }
}

double TipPath::length_m() const {
  double length = 0.0;
  for (std::size_t i = 1; i < point_m.size(); ++i) {
    length += (point_m[i] - point_m[i - 1]).norm();
  }
  return length;
}

bool TipPath::closes() const {
  constexpr double kClosedM = 0.001;
  return (point_m.front() - point_m.back()).norm() <= kClosedM;
}

Eigen::Vector2d TipPath::at(double seconds) const {
  if (seconds <= 0.0) {
    return point_m.front();
  }
  if (seconds >= duration_s()) {
    return point_m.back();
  }
  const double in_lap_s = std::fmod(seconds, lap_s());
  const auto after = std::upper_bound(time_s.begin(), time_s.end(), in_lap_s);
  const auto i = std::size_t(
      std::clamp<std::ptrdiff_t>(after - time_s.begin(), 1, std::ptrdiff_t(time_s.size()) - 1));
  const double share = (in_lap_s - time_s[i - 1]) / (time_s[i] - time_s[i - 1]);
  return point_m[i - 1] + share * (point_m[i] - point_m[i - 1]);
}

TipPath read_tip_path(const fs::path& path) {
  CsvReader csv = CsvReader::from_file(path);
  std::vector<CsvCell> row;
  const ColumnOrder order = read_header(csv, row);
  TipPath result;
  double start_s = 0.0;
  while (csv.next(row)) {
    if (is_blank(row)) {
      continue;
    }
    if (row.size() != kColumns.size()) {
      csv.refuse(1, fmt::format("{} cells; the header has {}", row.size(), kColumns.size()));
    }
    std::array<double, kColumns.size()> values{};
    for (std::size_t k = 0; k < kColumns.size(); ++k) {
      const CsvCell& cell = row[order[k]];
      values[k] = csv.number(cell, fmt::format("a number for {}", kColumns[k]));
      if (k > 0 && std::abs(values[k]) > kFarthestM) {
        csv.refuse(cell.column, fmt::format("{} = {}; expected metres, at most {} from the base",
                                            kColumns[k], values[k], kFarthestM));
      }
    }
    start_s = result.time_s.empty() ? values[0] : start_s;
    const double time_s = values[0] - start_s;
    if (!result.time_s.empty() && !(time_s > result.time_s.back())) {
      csv.refuse(row[order[0]].column,
                 fmt::format("time_s = {} is not later than {} before it; times have to increase",
                             values[0], result.time_s.back() + start_s));
    }
    if (time_s > kLongestS) {
      csv.refuse(
          row[order[0]].column,
          fmt::format("time_s = {} is {:.6g} s after the first; expected seconds, at most {} "
                      "of them",
                      values[0], time_s, kLongestS));
    }
    result.line.push_back(csv.line());
    result.time_s.push_back(time_s);
    result.point_m.emplace_back(values[1], values[2]);
  }
  if (result.time_s.size() < 2) {
    csv.refuse(1, fmt::format("{} points; expected at least 2", result.time_s.size()));
  }
  return result;
}

}  // namespace limber
