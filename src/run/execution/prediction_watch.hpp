#pragma once

#include <algorithm>
#include <optional>

#include "limber/run/executor.hpp"

namespace limber {

/// Compares the tip with where a plan has it, frame by frame.
class PredictionWatch {
 public:
  void compare(const Plan& plan, std::size_t frame, const BackboneD& shape) {
    const Backbone& predicted = plan.frames[frame].backbone;
    const Eigen::Index last = predicted.rows() - 1;
    const double distance_m =
        (predicted.row(last).head<2>().cast<double>() - shape.row(last).head<2>()).norm();
    error_.max_m = std::max(error_.max_m, distance_m);
    error_.final_m = distance_m;
    sum_m_ += distance_m;
    ++count_;
    if (static_cast<int>(frame) < plan.frame_count() - plan.hold_frame_count) {
      error_.before_hold_m = sum_m_ / count_;
    }
  }

  /// None if nothing was compared.
  std::optional<ExecutedError> error() const {
    if (count_ == 0) {
      return std::nullopt;
    }
    ExecutedError error = error_;
    error.mean_m = sum_m_ / count_;
    return error;
  }

 private:
  ExecutedError error_;
  double sum_m_ = 0.0;
  int count_ = 0;
};

}  // namespace limber
