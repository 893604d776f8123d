#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/characterisation.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/csv_reader.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/printable.hpp"

namespace limber {

namespace {

/// Bench data row by row.
class BenchCsv {
 public:
  BenchCsv(const fs::path& path, const ArmDescription& arm)
      : csv_(CsvReader::from_file(path)), segments_(arm.segment_count()) {
    double limit = 0.0;
    for (const Segment& segment : arm.segments) {
      limit = std::max(limit, segment.pressure_limit_kpa.largest_kpa());
    }
    lowest_kpa_ = -kBenchNoiseAroundZero * limit;
  }

  BenchData read() {
    BenchData data(segments_);
    bool header_read = false;
    std::vector<CsvCell> row;
    for (csv_.skip_lines_with('#'); csv_.next(row); csv_.skip_lines_with('#')) {
      if (is_blank(row)) {
        continue;
      }
      if (header_read) {
        read_row(row, data);
      } else {
        read_header(row);
        header_read = true;
      }
    }
    require_rows(header_read, data);
    return data;
  }

 private:
  void read_header(const std::vector<CsvCell>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      std::optional<std::size_t>* column = cells[i].text == "pressure_kpa" ? &pressure_
                                           : cells[i].text == "strain"     ? &strain_
                                           : cells[i].text == "segment"    ? &segment_
                                                                           : nullptr;
      if (column == nullptr) {
        csv_.refuse(
            cells[i].column,
            fmt::format("column '{}'; expected the header pressure_kpa,strain and optionally "
                        "segment, separated by commas",
                        in_one_line(cells[i].text)));
      }
      if (*column) {
        csv_.refuse(cells[i].column, fmt::format("column '{}' occurs twice", cells[i].text));
      }
      *column = i;
    }
    if (!pressure_ || !strain_) {
      csv_.refuse(1, fmt::format("column '{}' is missing; expected the header pressure_kpa,strain",
                                 pressure_ ? "strain" : "pressure_kpa"));
    }
    columns_ = cells.size();
  }

  void read_row(const std::vector<CsvCell>& cells, BenchData& data) const {
    if (cells.size() != columns_) {
      csv_.refuse(cells.back().column,
                  fmt::format("{} values; expected {} as in the header (decimal point, not comma)",
                              cells.size(), columns_));
    }
    const CsvCell& pressure_cell = cells[*pressure_];
    const CsvCell& strain_cell = cells[*strain_];
    const double pressure = csv_.number(pressure_cell, "a gauge pressure in kPa");
    if (pressure < lowest_kpa_) {
      csv_.refuse(
          pressure_cell.column,
          fmt::format("pressure_kpa {}; expected the gauge pressure of the inflated side, ≥ 0",
                      pressure));
    }
    const double strain = csv_.number(strain_cell, "a strain, a fraction, negative in contraction");
    if (std::abs(strain) >= 1.0) {
      csv_.refuse(
          strain_cell.column,
          fmt::format("strain {}; expected a fraction between -1 and 1 (per cent: divide by 100)",
                      strain));
    }
    if (!segment_) {
      for (std::vector<BenchPoint>& points : data) {
        points.push_back({pressure, strain});
      }
      return;
    }
    const CsvCell& segment_cell = cells[*segment_];
    const double segment = csv_.number(segment_cell, "a segment's number, 0 at the base");
    if (segment != std::floor(segment) || segment < 0.0 || segment >= segments_) {
      csv_.refuse(segment_cell.column,
                  fmt::format("segment number {}; expected a whole number from 0 to {}", segment,
                              segments_ - 1));
    }
    data[std::size_t(segment)].push_back({pressure, strain});
  }

  void require_rows(bool header_read, const BenchData& data) const {
    if (!header_read) {
      csv_.refuse(1, "an empty file; expected the header pressure_kpa,strain and rows below it");
    }
    for (std::size_t i = 0; i < data.size(); ++i) {
      if (data[i].empty()) {
        csv_.refuse(1, segment_ ? fmt::format("no row for {}; the arm has segments 0 to {}",
                                              segment_name(i), segments_ - 1)
                                : std::string("no rows below the header"));
      }
    }
  }

  CsvReader csv_;
  int segments_;
  double lowest_kpa_ = 0.0;
  std::size_t columns_ = 0;
  std::optional<std::size_t> pressure_;
  std::optional<std::size_t> strain_;
  std::optional<std::size_t> segment_;
};

}  // namespace

BenchData read_bench_csv(const fs::path& path, const ArmDescription& arm) {
  return BenchCsv(path, arm).read();
}

}  // namespace limber
