#include "shared_base.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"
#include "limber/data/log_units.hpp"

namespace limber {

namespace {

// Headings of a base that is bolted down: taken from an arm that bends now this way, now that, they
// differ by less; a base that was mounted anew may differ by more.
constexpr double kSameHeading_rad = 0.05;
// Root mean square of the turn about its mean, below which noise would choose the share.
constexpr double kLeastTurn_rad = 0.05;

/// How much of the turn at the second point lies before it, by all logs: as much as the direction
/// to that point changes with it.
double arc_share_of(const std::vector<BaseSighting>& sightings) {
  double rows = 0.0;
  double squares = 0.0;
  double products = 0.0;
  for (const BaseSighting& sighting : sightings) {
    rows += sighting.rows;
    squares += sighting.turn_squares;
    products += sighting.turn_products;
  }
  return squares > rows * kLeastTurn_rad * kLeastTurn_rad ? std::clamp(products / squares, 0.0, 1.0)
                                                          : sightings.front().arc_share;
}

Pose base_with(const BaseSighting& sighting, double arc_share) {
  Pose base = sighting.base;
  base.theta_rad = std::remainder(base.theta_rad - arc_share * sighting.turn_rad, 2.0 * M_PI);
  return base;
}

double heading_off_rad(const Pose& base, const Pose& other) {
  return std::remainder(base.theta_rad - other.theta_rad, 2.0 * M_PI);
}

double off_m(const Pose& base, const Pose& other) {
  return std::hypot(base.x_m - other.x_m, base.y_m - other.y_m);
}

bool is_same(const Pose& base, const Pose& other) {
  return off_m(base, other) < kBaseStandsStill_m &&
         std::abs(heading_off_rad(base, other)) < kSameHeading_rad;
}

Pose median_of(const std::vector<Pose>& bases) {
  std::vector<double> x_m;
  std::vector<double> y_m;
  std::vector<double> off_rad;
  for (const Pose& base : bases) {
    x_m.push_back(base.x_m);
    y_m.push_back(base.y_m);
    off_rad.push_back(heading_off_rad(base, bases.front()));
  }
  return {median(std::move(x_m)), median(std::move(y_m)),
          std::remainder(bases.front().theta_rad + median(std::move(off_rad)), 2.0 * M_PI)};
}

}  // namespace

Pose base_of(const BaseSighting& sighting) {
  return base_with(sighting, arc_share_of({sighting}));
}

SharedBase share_base(const std::vector<BaseSighting>& sightings) {
  const double arc_share = arc_share_of(sightings);
  std::vector<Pose> alone;
  for (const BaseSighting& sighting : sightings) {
    alone.push_back(base_with(sighting, arc_share));
  }
  const Pose middle = median_of(alone);
  SharedBase shared;
  std::vector<Pose> same;
  for (const Pose& base : alone) {
    shared.bases.push_back({base, is_same(base, middle)});
    if (shared.bases.back().is_shared) {
      same.push_back(base);
    }
  }
  if (same.size() < 2 || 2 * same.size() <= alone.size()) {
    return shared;
  }
  LogsBase& report = shared.report.emplace();
  report.base = median_of(same);
  report.logs = int(same.size());
  for (auto& [base, is_shared] : shared.bases) {
    if (is_shared) {
      report.most_off_m = std::max(report.most_off_m, off_m(base, report.base));
      report.most_off_rad =
          std::max(report.most_off_rad, std::abs(heading_off_rad(base, report.base)));
      base = report.base;
    }
  }
  return shared;
}

nlohmann::ordered_json to_json(const LogsBase& shared) {
  return {{"x_m", shared.base.x_m},
          {"y_m", shared.base.y_m},
          {"heading_rad", shared.base.theta_rad},
          {"logs", shared.logs},
          {"most_off_m", shared.most_off_m},
          {"most_off_rad", shared.most_off_rad}};
}

std::string to_text(const LogsBase& shared, std::ptrdiff_t runs) {
  return fmt::format(
      "base: one for {} of {} logs, each of which alone has it within {:.1f} mm and {:.4f} rad of "
      "there. For later logs: 'alignment: {{x_m: {:.5f}, y_m: {:.5f}, heading_rad: {:.5f}}}'\n",
      shared.logs, runs, kMmPerM * shared.most_off_m, shared.most_off_rad, shared.base.x_m,
      shared.base.y_m, shared.base.theta_rad);
}

}  // namespace limber
