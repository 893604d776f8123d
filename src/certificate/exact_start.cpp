#include "exact_start.hpp"

#include "shape_comparison.hpp"

namespace limber {

namespace {

std::vector<double> in_double(const Pressures& kpa) {
  return {kpa.begin(), kpa.end()};
}

}  // namespace

ExactStart exact_start(const Environment& environment, const ArmDescription& arm,
                       const ExactArm& model) {
  ExactStart result;
  if (!environment.start) {
    result.pressure_kpa.assign(arm.segments.size(), 0.0);
    result.setpoint_kpa = result.pressure_kpa;
    result.shape = model.no_load(result.pressure_kpa);
    result.before = result.shape;
    return result;
  }
  const ArmStart& start = *environment.start;
  result.pressure_kpa = in_double(start.pressures_kpa);
  result.setpoint_kpa = result.pressure_kpa;
  result.shape = shape_of(start.backbone);
  result.before = start.before.rows() > 0 ? shape_of(start.before) : result.shape;
  for (std::size_t back = 0; back < start.setpoints_kpa.size(); ++back) {
    std::vector<double> setpoint_kpa = in_double(start.setpoints_kpa[back]);
    if (back == 0) {
      result.setpoint_kpa = std::move(setpoint_kpa);
    } else {
      result.before_kpa.push_back(std::move(setpoint_kpa));
    }
  }
  return result;
}

}  // namespace limber
