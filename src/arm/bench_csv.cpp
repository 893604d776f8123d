#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/characterisation.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"

namespace limber {

namespace {

struct Cell {
  std::string_view text;
  std::size_t column = 1;  // of its first character, from 1
};

std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_space(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && is_space(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  std::size_t begin = 0;
  while (true) {
    const std::size_t comma = line.find(',', begin);
    const std::string_view raw = line.substr(begin, comma - begin);
    const std::string_view text = trimmed(raw);
    const std::size_t lead = text.empty() ? 0 : std::size_t(text.data() - raw.data());
    cells.push_back({text, begin + lead + 1});
    if (comma == std::string_view::npos) {
      return cells;
    }
    begin = comma + 1;
  }
}

/// Reads the file line by line and knows where it is.
class BenchCsv {
 public:
  BenchCsv(const std::filesystem::path& path, const ArmDescription& arm)
      : name_(path.string()), text_(read_file(path)), segments_(arm.segment_count()) {
    double limit = 0.0;
    for (const Segment& segment : arm.segments) {
      limit = std::max(limit, segment.pressure_limit_kpa);
    }
    lowest_kpa_ = -kBenchNoiseAroundZero * limit;
  }

  BenchData read() {
    std::string_view rest = text_;
    if (rest.starts_with("\xEF\xBB\xBF")) {  // byte order mark of spreadsheets
      rest.remove_prefix(3);
    }
    BenchData data(static_cast<std::size_t>(segments_));
    bool header_read = false;
    while (!rest.empty()) {
      const std::size_t end = rest.find('\n');
      const std::string_view line = rest.substr(0, end);
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
      ++line_;
      if (trimmed(line).empty() || trimmed(line).starts_with('#')) {
        continue;
      }
      if (header_read) {
        read_row(cells_of(line), data);
      } else {
        read_header(cells_of(line));
        header_read = true;
      }
    }
    require_rows(header_read, data);
    return data;
  }

 private:
  [[noreturn]] void refuse(std::size_t column, const std::string& message) const {
    throw InputError(fmt::format("{}:{}:{}: {}", name_, line_, column, message));
  }

  void read_header(const std::vector<Cell>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      std::optional<std::size_t>* place = cells[i].text == "pressure_kpa" ? &pressure_
                                          : cells[i].text == "strain"     ? &strain_
                                          : cells[i].text == "segment"    ? &segment_
                                                                          : nullptr;
      if (place == nullptr) {
        refuse(cells[i].column,
               fmt::format("column '{}'; expected the header pressure_kpa,strain and optionally "
                           "segment, separated by commas",
                           cells[i].text));
      }
      if (*place) {
        refuse(cells[i].column, fmt::format("column '{}' occurs twice", cells[i].text));
      }
      *place = i;
    }
    if (!pressure_ || !strain_) {
      refuse(1, fmt::format("column '{}' is missing; expected the header pressure_kpa,strain",
                            pressure_ ? "strain" : "pressure_kpa"));
    }
    columns_ = cells.size();
  }

  void read_row(const std::vector<Cell>& cells, BenchData& data) const {
    if (cells.size() != columns_) {
      refuse(cells.back().column,
             fmt::format("{} values; expected {} as in the header (decimal point, not comma)",
                         cells.size(), columns_));
    }
    const Cell& pressure_cell = cells[*pressure_];
    const Cell& strain_cell = cells[*strain_];
    const double pressure = number(pressure_cell, "a gauge pressure in kPa");
    if (pressure < lowest_kpa_) {
      refuse(pressure_cell.column,
             fmt::format("pressure_kpa {}; expected the gauge pressure of the inflated side, ≥ 0",
                         pressure));
    }
    const double strain = number(strain_cell, "a strain, a fraction, negative in contraction");
    if (std::abs(strain) >= 1.0) {
      refuse(strain_cell.column,
             fmt::format("strain {}; expected a fraction between -1 and 1 (per cent: divide by "
                         "100)",
                         strain));
    }
    if (!segment_) {
      for (std::vector<BenchPoint>& points : data) {
        points.push_back({pressure, strain});
      }
      return;
    }
    const Cell& segment_cell = cells[*segment_];
    const double segment = number(segment_cell, "a segment's number, 0 at the base");
    if (segment != std::floor(segment) || segment < 0.0 || segment >= segments_) {
      refuse(segment_cell.column, fmt::format("segment {}; expected a whole number from 0 to {}",
                                              segment, segments_ - 1));
    }
    data[std::size_t(segment)].push_back({pressure, strain});
  }

  double number(const Cell& cell, const char* expected) const {
    const char* end = cell.text.data() + cell.text.size();
    double value = 0.0;
    const auto [stop, error] = std::from_chars(cell.text.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value)) {
      refuse(cell.column,
             fmt::format("'{}' found; expected {}, a plain finite number", cell.text, expected));
    }
    return value;
  }

  void require_rows(bool header_read, const BenchData& data) {
    line_ = std::max<std::size_t>(line_, 1);
    if (!header_read) {
      refuse(1, "an empty file; expected the header pressure_kpa,strain and rows below it");
    }
    for (std::size_t i = 0; i < data.size(); ++i) {
      if (data[i].empty()) {
        refuse(1, segment_ ? fmt::format("no row for segment {}; the arm has segments 0 to {}", i,
                                         segments_ - 1)
                           : std::string("no rows below the header"));
      }
    }
  }

  std::string name_;
  std::string text_;
  int segments_;
  double lowest_kpa_ = 0.0;
  std::size_t line_ = 0;
  std::size_t columns_ = 0;
  std::optional<std::size_t> pressure_;
  std::optional<std::size_t> strain_;
  std::optional<std::size_t> segment_;
};

}  // namespace

BenchData read_bench_csv(const std::filesystem::path& path, const ArmDescription& arm) {
  return BenchCsv(path, arm).read();
}

}  // namespace limber
