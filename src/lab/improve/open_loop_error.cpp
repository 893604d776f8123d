#include "open_loop_error.hpp"

#include <algorithm>
#include <cmath>

#include "limber/arm/plate_distance.hpp"

namespace limber {

namespace {

/// Takes in runs one by one; sums in their order.
class ErrorOfRuns {
 public:
  explicit ErrorOfRuns(const MotionModel& model) : model_(model) {}

  /// The frames after `first`, up to and without `end`, predicted from frame `first`.
  void add(const Episode& episode, int first, int end) {
    if (!episode.was_tracked(first)) {
      return;
    }
    MotionState state = model_.settled_state(episode.setpoint_kpa.row(first).transpose(),
                                             backbone_at(episode.backbone, first));
    double sum_m = 0.0;
    double largest_m = 0.0;
    int plates = 0;
    for (int t = first + 1; t < end; ++t) {
      model_.step(episode.setpoint_kpa.row(t).transpose(), state, workspace_);
      if (!episode.was_tracked(t)) {
        continue;
      }
      const Eigen::VectorXd distance_m =
          plate_distances_m(state.backbone, backbone_at(episode.backbone, t));
      sum_m += distance_m.sum();
      largest_m = std::max(largest_m, distance_m.maxCoeff());
      plates += static_cast<int>(distance_m.size());
    }
    if (plates > 0 && std::isfinite(sum_m)) {
      ++runs_;
      mean_sum_m_ += sum_m / plates;
      largest_sum_m_ += largest_m;
    }
  }

  OpenLoopError result() const {
    const double runs = std::max(runs_, 1);
    return {runs_, mean_sum_m_ / runs, largest_sum_m_ / runs};
  }

 private:
  const MotionModel& model_;
  MotionModel::Workspace workspace_;
  int runs_ = 0;
  double mean_sum_m_ = 0.0;
  double largest_sum_m_ = 0.0;
};

}  // namespace

OpenLoopError error_on_plans(const MotionModel& model, const std::vector<Episode>& plans) {
  ErrorOfRuns errors(model);
  for (const Episode& plan : plans) {
    errors.add(plan, 0, plan.frame_count());
  }
  return errors.result();
}

OpenLoopError error_on_motions(const MotionModel& model, const std::vector<Episode>& motions) {
  ErrorOfRuns errors(model);
  for (const Episode& episode : motions) {
    const auto motion_of = [&](int t) { return episode.motion_index[static_cast<std::size_t>(t)]; };
    int first = 0;
    for (int t = 1; t <= episode.frame_count(); ++t) {
      if (t == episode.frame_count() || motion_of(t) != motion_of(first + 1)) {
        errors.add(episode, first, t);
        first = t - 1;
      }
    }
  }
  return errors.result();
}

}  // namespace limber
