#pragma once

#include <algorithm>
#include <optional>

#include "limber/run/executor.hpp"

namespace limber {

/// Compares the tip with where a plan has it, frame by frame.
class PredictionWatch {
 public:
  void compare(const Plan& plan, std::size_t frame, const BackboneD& shape) {
    const double distance_m =
        (tip_position_m(plan.frames[frame].backbone) - tip_position_m(shape)).norm();
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
