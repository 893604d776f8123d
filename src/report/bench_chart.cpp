#include "limber/report/bench_chart.hpp"
#include "limber/arm/names.hpp"

#include <fmt/format.h>

namespace limber {

namespace {

constexpr int kCurvePoints = 100;
constexpr double kPercent = 100.0;

}  // namespace

Chart bench_chart(const CharacterisedArm& result, const BenchData& bench) {
  Chart chart(fmt::format("Characterisation of {}", result.arm.name));
  chart.x_axis("gauge pressure of the inflated side [kPa]");
  chart.y_axis("contraction of that side [% of its length]");
  for (std::size_t i = 0; i < result.fits.size(); ++i) {
    const StrainFit& fit = result.fits[i];
    SeriesStyle style;
    style.color = palette_color(int(i));
    std::vector<double> x;
    std::vector<double> y;
    for (int k = 0; k <= kCurvePoints; ++k) {
      x.push_back(fit.pressure_limit_kpa * k / kCurvePoints);
      y.push_back(kPercent * strain_at(fit.polynomial, x.back()));
    }
    chart.line(fmt::format("{}, quartic{}", segment_name(i), fit.refitted ? " (slope held)" : ""),
               x, y, style);
    std::vector<double> pressures;
    std::vector<double> contractions;
    for (const BenchPoint& point : bench[i]) {
      pressures.push_back(point.pressure_kpa);
      contractions.push_back(-kPercent * point.strain);
    }
    chart.points(fmt::format("{}, bench", segment_name(i)), pressures, contractions, style);
  }
  return chart;
}

}  // namespace limber
