#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/tube_shape.hpp"

namespace limber {

/// What PredictionError is made of: the errors of runs, also of several models.
class RunErrors {
 public:
  /// The runs of `measure_prediction_error` on `unseen`.
  /// @return whether all predictions are finite; where they are not, nothing was added
  bool add(const ArmDescription& arm, const CompensationModel& model,
           const std::vector<Episode>& unseen, int jobs);
  /// `frames` are those after the run's first; `mean_kpa` says where the run was.
  void add(double max_m, double off_path_m, const GrowingErrors& errors, int frames,
           const Pressures& mean_kpa);
  /// None without a run.
  std::optional<PredictionError> result(double frame_period_s) const;
  /// A tube that holds the plates of 95 % of the runs, its shape by the first half of them and its
  /// factor by the second; tip and heading at the end, of 95 % too, by themselves. None of too few
  /// for a quantile. It grows from where plates start as makes it narrowest at the tip.
  std::optional<Tube> tube(double arm_length_m) const;
  /// Where runs err more than all of them: which third of a segment's range, in a sentence that
  /// says what to record. Empty: nowhere. @param unit  of the arm's command
  std::string widest_where(const std::string& unit) const;

 private:
  /// None where no run has a number.
  std::optional<double> largest_at_end(double MotionErrors::*value, double tail) const;

  std::vector<double> max_m_, off_path_m_;
  std::vector<GrowingErrors> motions_;
  std::vector<Pressures> mean_kpa_;
  double frames_ = 0.0;
};

}  // namespace limber
