#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "limber/arm/no_load_model.hpp"
#include "limber/run/tip_path.hpp"

namespace limber {

/// Set points for a whole lap of a path: many shapes have the same tip, and a search that looks a
/// fraction of a second ahead may choose one from which the path's end is out of reach. The no-load
/// model's inverse kinematics (docs/model.md (14)) say what shapes there are at points along the
/// lap; of all ways through them the one is taken whose set points move least and keep away from
/// their limits (Viterbi's algorithm). A lap that closes ends in the shape it began with. A better
/// model then moves them (`fitted_to`).
class LapPosture {
 public:
  /// @param limits  of set points, one for each segment
  LapPosture(const NoLoadModel& model, const TipPath& path,
             const std::vector<PressureLimits>& limits, std::uint64_t seed);

  /// Whether the no-load model bends at all: one of `no_load: straight` knows no shapes, and all
  /// set points are zero then.
  bool is_known() const { return is_known_; }

  /// Set points n at a time of the path, any lap; before the path those of its start, and after one
  /// that does not close those of its end.
  Eigen::VectorXd at(double seconds) const;

  /// At equal times over a lap, its first and last point included.
  const std::vector<Eigen::VectorXd>& points_kpa() const { return points_kpa_; }
  /// The same lap with others, as many.
  LapPosture with_points(std::vector<Eigen::VectorXd> points_kpa) const {
    LapPosture other = *this;
    other.points_kpa_ = std::move(points_kpa);
    return other;
  }

 private:
  double lap_s_;
  bool closes_;
  bool is_known_ = false;
  std::vector<Eigen::VectorXd> points_kpa_;  // at equal times over a lap, first and last included
};

}  // namespace limber
