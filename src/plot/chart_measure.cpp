#include "chart_measure.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace limber {

namespace {

/// Share of a step by which a tick may lie outside the range, for rounding alone.
constexpr double kSlack = 1e-9;
/// If a range is narrower than this share of its values, doubles can't tell its ticks apart.
constexpr double kNarrowest = 1e-9;
/// Values below this are drawn as zero: their steps would be none.
constexpr double kLeast = 1e-290;

double magnitude_of(double low, double high) {
  return std::max(std::abs(low), std::abs(high));
}

/// @pre low ≤ high
bool is_narrow(double low, double high) {
  const double magnitude = magnitude_of(low, high);
  return magnitude < kLeast || high - low <= kNarrowest * magnitude;
}

std::string tick_label(double value, double step) {
  const double magnitude = std::abs(value);
  if (step >= 1e6 || (step < 1e-4 && magnitude < 1.0)) {
    return value == 0.0 ? "0" : fmt::format("{:.3g}", value);
  }
  const int decimals = std::max(0, int(-std::floor(std::log10(step) + kSlack)));
  return fmt::format("{:.{}f}", value, decimals);
}

std::string power_of_ten_label(double value) {
  return value >= 1e-3 && value < 1e5 ? fmt::format("{:g}", value) : fmt::format("{:.0e}", value);
}

/// Beyond this, differences and squares of values would overflow.
constexpr double kMax = 1e150;

/// Lowest and highest of the values seen.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool empty() const { return low > high; }
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Looks at every series once and gathers what the axes must span.
class Measurer {
 public:
  explicit Measurer(const ChartSettings& settings) : log_y_(settings.y.logarithmic) {}

  void operator()(const LineSeries& series) { points(series.x, series.y); }
  void operator()(const PointSeries& series) {
    points(series.x, series.y);
    padded = true;
  }
  void operator()(const BandSeries& series) {
    points(series.x, series.low);
    points(series.x, series.high);
  }
  void operator()(const BarSeries& series) {
    from_zero = true;
    for (std::size_t i = 0; i < series.values.size(); ++i) {
      const double error = series.errors.empty() ? 0.0 : series.errors[i];
      if (!is_drawable(series.values[i], log_y_) || !is_drawable(error)) {
        ++undrawable;
        continue;
      }
      value(series.values[i] + error);
      value(series.values[i] - error);
    }
  }
  void operator()(const HistogramSeries& series) {
    for (const double each : series.values) {
      include_or_count(binned, each, false);
    }
  }
  void operator()(const DistributionSeries& series) {
    for (const double each : series.values) {
      include_or_count(y, each, log_y_);
    }
  }
  void operator()(const ReferenceLine& series) {
    include_or_count(series.horizontal ? y : x, series.at, series.horizontal && log_y_);
  }

  void value(double each) {
    if (is_drawable(each, log_y_)) {
      y.include(each);
    }
  }

  Extent x, y, binned;
  int undrawable = 0;
  bool from_zero = false;
  bool padded = false;

 private:
  void include_or_count(Extent& extent, double each, bool logarithmic) {
    if (is_drawable(each, logarithmic)) {
      extent.include(each);
    } else {
      ++undrawable;
    }
  }

  void points(const std::vector<double>& xs, const std::vector<double>& ys) {
    for (std::size_t i = 0; i < xs.size(); ++i) {
      if (is_drawable(xs[i]) && is_drawable(ys[i], log_y_)) {
        x.include(xs[i]);
        y.include(ys[i]);
      } else {
        ++undrawable;
      }
    }
  }

  bool log_y_;
};

std::vector<double> even_edges(const Extent& extent) {
  constexpr int kBins = 40;  // each about 12 px wide in a chart of the usual size
  double low = extent.low;
  double high = extent.high;
  if (low == high) {
    const double half = low == 0.0 ? 0.5 : 0.05 * std::abs(low);
    low -= half;
    high += half;
  }
  std::vector<double> edges(kBins + 1);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double share = double(i) / kBins;
    edges[i] = low + share * (high - low);
  }
  edges.back() = high;
  return edges;
}

NiceRange x_range(const ChartSettings& settings, const Measurer& measured) {
  if (!settings.categories.empty()) {
    return {-0.5, double(settings.categories.size()) - 0.5};
  }
  if (settings.x.range) {
    return {settings.x.range->first, settings.x.range->second};
  }
  if (measured.x.empty()) {
    return {0.0, 1.0};
  }
  const double width = measured.x.high - measured.x.low;
  if (is_narrow(measured.x.low, measured.x.high)) {
    return nice_range(measured.x.low, measured.x.high);
  }
  const double margin = measured.padded ? 0.03 * width : 0.0;
  return {measured.x.low - margin, measured.x.high + margin};
}

NiceRange y_range(const ChartSettings& settings, const Measurer& measured) {
  if (settings.y.range) {
    const auto [low, high] = *settings.y.range;
    return settings.y.logarithmic && low <= 0.0
               ? NiceRange{high > 0.0 ? high * 1e-3 : 1e-3, high > 0.0 ? high : 1.0}
               : NiceRange{low, high};
  }
  if (measured.y.empty()) {
    return settings.y.logarithmic ? NiceRange{0.1, 1.0} : NiceRange{0.0, 1.0};
  }
  double low = measured.y.low;
  double high = measured.y.high;
  if (settings.y.logarithmic) {
    return nice_logarithmic_range(low, high);
  }
  // Quantities that cannot be negative read best from zero.
  if (measured.from_zero || (low >= 0.0 && low < 0.5 * high)) {
    low = std::min(low, 0.0);
    high = std::max(high, 0.0);
  }
  return nice_range(low, high, std::max(2, settings.height_px / 60));
}

}  // namespace

double nice_step(double low, double high, int count) {
  assert(low < high && count >= 1);
  // Divided first: the difference of two huge doubles overflows.
  const double rough =
      std::max(high / count - low / count, std::numeric_limits<double>::min());  // else no power
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double digit = rough / power;
  if (digit < 1.5) {
    return power;
  }
  if (digit < 3.5) {
    return 2.0 * power;
  }
  return digit < 7.5 ? 5.0 * power : 10.0 * power;
}

NiceRange nice_range(double low, double high, int count) {
  if (low > high) {
    std::swap(low, high);
  }
  if (is_narrow(low, high)) {
    const double magnitude = magnitude_of(low, high);
    const double half = magnitude < kLeast ? 1.0 : 0.1 * magnitude;
    low -= half;
    high += half;
  }
  const double step = nice_step(low, high, count);
  return {std::floor(low / step + kSlack) * step, std::ceil(high / step - kSlack) * step};
}

AxisTicks linear_ticks(double low, double high, int count) {
  const double step = nice_step(low, high, count);
  const double first = std::ceil(low / step - kSlack);
  const int tick_count = 1 + int(std::floor(high / step + kSlack) - first);
  AxisTicks ticks;
  for (int i = 0; i < tick_count; ++i) {
    const double index = first + i;
    const double value = index == 0.0 ? 0.0 : index * step;  // never −0
    ticks.values.push_back(value);
    ticks.labels.push_back(tick_label(value, step));
  }
  return ticks;
}

NiceRange nice_logarithmic_range(double low, double high) {
  assert(low > 0.0 && low <= high);
  NiceRange range{low, high};
  const double below = std::pow(10.0, std::floor(std::log10(low)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * below <= low * (1.0 + kSlack)) {
      range.low = digit * below;
    }
  }
  const double power = std::pow(10.0, std::floor(std::log10(high)));
  for (const double digit : {10.0, 5.0, 2.0, 1.0}) {
    if (digit * power >= high * (1.0 - kSlack)) {
      range.high = digit * power;
    }
  }
  if (range.high <= range.low * (1.0 + kSlack)) {
    range.low /= 2.0;
    range.high *= 2.0;
  }
  return range;
}

AxisTicks logarithmic_ticks(double low, double high) {
  assert(low > 0.0 && low < high);
  const int first = int(std::floor(std::log10(low)));
  const int last = int(std::ceil(std::log10(high)));
  const int decades = last - first;
  const bool few = std::log10(high / low) < 3.0;
  const int stride = std::max(1, decades / 8);
  AxisTicks ticks;
  for (int exponent = first; exponent <= last; exponent += stride) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double value = digit * std::pow(10.0, exponent);
      if (value < low * (1.0 - kSlack) || value > high * (1.0 + kSlack) || (digit > 1.0 && !few)) {
        continue;
      }
      ticks.values.push_back(value);
      ticks.labels.push_back(power_of_ten_label(value));
    }
  }
  return ticks;
}

bool is_drawable(double value, bool logarithmic) {
  return std::isfinite(value) && std::abs(value) <= kMax && (!logarithmic || value >= 1.0 / kMax);
}

std::vector<int> bin_counts(const std::vector<double>& values, const std::vector<double>& edges) {
  std::vector<int> counts(edges.size() - 1, 0);
  for (const double value : values) {
    if (!is_drawable(value) || value < edges.front() || value > edges.back()) {
      continue;
    }
    const auto above = std::upper_bound(edges.begin(), edges.end(), value);
    const auto bin = std::size_t(std::max<std::ptrdiff_t>(0, above - edges.begin() - 1));
    ++counts[std::min(bin, counts.size() - 1)];
  }
  return counts;
}

ChartMeasure measure_chart(const ChartSettings& settings, const std::vector<Series>& series) {
  Measurer measured(settings);
  for (const Series& each : series) {
    std::visit(measured, each);
  }
  ChartMeasure out;
  out.undrawable = measured.undrawable;
  if (!measured.binned.empty()) {
    out.bin_edges = even_edges(measured.binned);
    measured.x.include(out.bin_edges.front());
    measured.x.include(out.bin_edges.back());
    measured.value(settings.y.logarithmic ? 0.5 : 0.0);
    for (const Series& each : series) {
      if (const auto* histogram = std::get_if<HistogramSeries>(&each)) {
        for (const int count : bin_counts(histogram->values, out.bin_edges)) {
          measured.value(count);
        }
      }
    }
  }
  out.has_data = !measured.x.empty() || !measured.y.empty();
  out.x = x_range(settings, measured);
  out.y = y_range(settings, measured);
  return out;
}

}  // namespace limber
