#include "rest_forecast.hpp"

#include <limits>

namespace limber {

RestForecast forecast(const MotionModel& model, const CollisionChecker& checker, MotionState state,
                      const std::vector<Pressures>& setpoints_kpa, double needed_m) {
  RestForecast result;
  result.clearance_m = std::numeric_limits<double>::infinity();
  MotionModel::Workspace workspace;
  Backbone before = state.backbone;
  for (std::size_t k = 0; k < setpoints_kpa.size(); ++k) {
    before = state.backbone;
    model.step(setpoints_kpa[k], state, workspace);
    ++result.queries;
    const Clearance clearance =
        checker.motion_clearance(before, state.backbone, result.clearance_m);
    result.clearance_m = clearance.value_m;
    if (result.is_safe() && !(clearance.value_m >= needed_m)) {
      result.unsafe_frame = static_cast<int>(k);
      result.unsafe_obstacle = clearance.obstacle;
    }
  }
  result.end = tip_pose(state.backbone);
  return result;
}

}  // namespace limber
