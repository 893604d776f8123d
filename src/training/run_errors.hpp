#pragma once

#include <optional>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// What PredictionError is made of: the errors of runs, also of several models.
class RunErrors {
 public:
  /// The runs of `measure_prediction_error` on `unseen`.
  /// @return whether all predictions are finite; where they are not, nothing was added
  bool add(const ArmDescription& arm, const CompensationModel& model,
           const std::vector<Episode>& unseen, int jobs);
  /// One frame's error of a run ends it; `frames` are those after its first.
  void add(double max_m, double off_path_m, double end_m, double end_rad, int frames);
  /// None without a run.
  std::optional<PredictionError> result(double frame_period_s) const;

 private:
  std::vector<double> max_m_, off_path_m_, end_m_, end_rad_;
  double frames_ = 0.0;
};

}  // namespace limber
