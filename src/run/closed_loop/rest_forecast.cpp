#include "rest_forecast.hpp"

#include <limits>

namespace limber {

RestForecast forecast(
    const MotionModel& model, const CollisionChecker& checker, MotionState state,
    std::size_t frames,
    const std::function<Pressures(std::size_t k, const MotionState& before)>& setpoint_kpa,
    double needed_m) {
  RestForecast result;
  double smallest_m = std::numeric_limits<double>::infinity();  // clearance so far
  MotionModel::Workspace workspace;
  Backbone before = state.backbone;
  for (std::size_t k = 0; k < frames; ++k) {
    before = state.backbone;
    model.step(setpoint_kpa(k, state), state, workspace);
    const Clearance clearance = checker.motion_clearance(before, state.backbone, smallest_m);
    smallest_m = clearance.value_m;
    if (result.is_safe() && !(clearance.value_m >= needed_m)) {
      result.unsafe_frame = int(k);
      result.unsafe_obstacle = clearance.obstacle;
    }
  }
  result.end = tip_pose(state.backbone);
  return result;
}

}  // namespace limber
