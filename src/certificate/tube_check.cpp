#include "tube_check.hpp"

#include <cmath>

#include <fmt/format.h>

#include "limber/arm/names.hpp"

namespace limber {

namespace {

constexpr double kRounding = 1e-12;  // of a radius that was multiplied once

bool is_room(double value) {
  return std::isfinite(value) && value >= 0.0;
}

/// Why these are no radii of the arm; empty: they are.
std::string why_no_radii(const PlanTube& tube, const ArmDescription& arm) {
  if (static_cast<int>(tube.plate_radius_m.size()) != arm.point_count()) {
    return fmt::format("{} radii; the arm has {} plates", tube.plate_radius_m.size(),
                       arm.point_count());
  }
  for (const double radius : tube.plate_radius_m) {
    if (!is_room(radius)) {
      return fmt::format("a radius of {} m; expected at least 0", radius);
    }
  }
  const double share = tube.growth.start_share;
  if (!(share > 0.0 && share <= 1.0) || !is_room(tube.growth.full_after_m)) {
    return fmt::format(
        "{} of its width at the start, all of it after {} m; expected a share of "
        "more than 0 and at most 1, and at least 0 m",
        share, tube.growth.full_after_m);
  }
  return is_room(tube.end_radius_m) && is_room(tube.end_heading_rad)
             ? ""
             : "a width of its end that is not at least 0";
}

/// Why the network does not promise that; empty: it does.
std::string why_not_promised(const PlanTube& tube, const CompensationModel* network) {
  const TubeLevel* promised =
      network != nullptr && network->tube ? network->tube->find(tube.level) : nullptr;
  if (promised == nullptr) {
    return fmt::format("the model promises no tube of {:.6g} % of runs", 100.0 * tube.level);
  }
  const auto is_narrower = [&](double radius, double scale) {
    return radius < promised->factor * scale - kRounding;
  };
  const std::vector<double>& scale_m = network->tube->plate_scale_m;
  for (std::size_t i = 0; i < scale_m.size() && i < tube.plate_radius_m.size(); ++i) {
    if (is_narrower(tube.plate_radius_m[i], scale_m[i])) {
      return fmt::format("{} has {:.3f} mm; the model promises {:.3f} mm",
                         plate_name(static_cast<int>(i)), tube.plate_radius_m[i] * 1e3,
                         promised->factor * scale_m[i] * 1e3);
    }
  }
  const RoomGrowth& growth = network->tube->growth;
  if (!growth.is_constant() ? tube.growth.start_share < growth.start_share - kRounding ||
                                  tube.growth.full_after_m > growth.full_after_m + kRounding
                            : !tube.growth.is_constant()) {
    return fmt::format(
        "it grows from {:.3g} of its width over {:.3g} m; the model promises no "
        "less than {:.3g}, and all of it after {:.3g} m",
        tube.growth.start_share, tube.growth.full_after_m, growth.start_share, growth.full_after_m);
  }
  return is_narrower(tube.end_radius_m, network->tube->end_scale_m) ||
                 is_narrower(tube.end_heading_rad, network->tube->end_heading_scale_rad)
             ? "its end is narrower than the model promises"
             : "";
}

}  // namespace

void check_tube(const Plan& plan, const CompensationModel* network, const ArmDescription& arm,
                Certificate& certificate) {
  if (!plan.tube) {
    return;
  }
  std::string why = why_no_radii(*plan.tube, arm);
  if (why.empty()) {
    why = why_not_promised(*plan.tube, network);
  }
  if (!why.empty()) {
    certificate.failures.push_back({"tube", -1, std::move(why)});
  }
}

}  // namespace limber
