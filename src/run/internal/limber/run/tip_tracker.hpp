#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "limber/forward/motion_model.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "limber/run/controller.hpp"
#include "limber/run/lap_memory.hpp"
#include "limber/run/lap_posture.hpp"
#include "limber/run/tip_path.hpp"

namespace limber {

/// Where a lap begins, and the shapes that it goes through.
struct TrackStart {
  LapPosture posture;
  Pressures setpoint_kpa;   ///< the model's settled tip is near the path's first point then
  double distance_m = 0.0;  ///< of that tip from the point
};

/// Within the arm's limits. Near the lap's posture, if the model's tip comes to within 1 cm of the
/// path's first point from there; else wherever it comes nearest.
TrackStart find_track_start(const ArmDescription& arm, const MotionModel& model,
                            const TipPath& path, std::uint64_t seed);

struct TipTrackerSettings {
  /// Model queries in each frame; a number, so that runs in simulated time can be repeated.
  int queries = 3000;
  /// Of what a lap missed, what the next one is asked for less; 0: nothing is learnt from laps.
  double lap_share = 0.25;
  double missed_share = 1.0;  ///< of what the estimate has the model miss: allowed for
};

/// Keeps the tip on a path over time by receding horizon (docs/tracking.md). In
/// each frame, from the measured state:
///
/// 1. Rollouts of sampled knots, side by side, say how the tip's next positions depend on the
///    knots: a linear fit by ridge regression.
/// 2. The knots of least squared error by that fit, at several lengths of the step, are rolled out
///    beside the best samples; the best of all are kept, and their first set points commanded.
///
/// What the model misses ahead, by the estimate, is added to predictions. Chance comes from a
/// stream of (seed, frame): simulated runs repeat. A path that is run several times teaches: where
/// the tip was beside it, the next lap is asked for that much less (LapMemory).
///
/// Starts with an approach: straight to the start's set points, then the path's first point for
/// 2 s; the path's time 0 is `path_start_frame`.
class TipTracker final : public Controller {
 public:
  /// Borrows what the model borrows. Set points stay within the arm's limits.
  TipTracker(const ArmDescription& arm, const MotionModel& model, const TipPath& path,
             const TrackStart& start, const TipTrackerSettings& settings, std::uint64_t seed);

  EstimateModel estimate_with() const override { return {&model_, std::nullopt}; }
  Decision step(const Moment& now) override;

  /// Frame of the run, counted as ExecutionResult::frames, at which the path's time is 0.
  int path_start_frame() const { return path_start_frame_; }
  std::uint64_t queries() const { return queries_; }

 private:
  /// Tips along a rollout of some knots: 2·horizon numbers.
  struct Candidates {
    Eigen::MatrixXd knots_kpa;  // n·knots × k
    Eigen::MatrixXd tips_m;     // 2·horizon × k
  };

  Eigen::Index channels() const { return model_.channel_count(); }
  /// Of the segment that entry `i` of the knots is a set point of.
  const PressureLimits& limits_of_knot(Eigen::Index i) const;
  double path_time_s(int frame) const;
  std::string why_stopped(const ArmEstimate& arm) const;
  void take_in(const ArmEstimate& arm);
  void roll_out(Candidates& candidates);
  Eigen::VectorXd wanted_tips(const ArmEstimate& arm) const;
  double cost(const Eigen::Ref<const Eigen::VectorXd>& knots_kpa,
              const Eigen::Ref<const Eigen::VectorXd>& tips_m, const Eigen::VectorXd& wanted) const;
  Eigen::VectorXd posture_of_knots() const;
  /// The knots' distances from the lap's posture, as kPostureM counts them.
  Eigen::VectorXd off_posture(const Eigen::Ref<const Eigen::VectorXd>& knots_kpa) const;
  Eigen::VectorXd within_rule(Eigen::VectorXd knots_kpa) const;
  Eigen::VectorXd fitted_step(const Candidates& samples, const Eigen::VectorXd& wanted) const;
  Eigen::VectorXd knots_one_frame_on() const;
  void search(const ArmEstimate& arm);
  Pressures decide(const ArmEstimate& arm);

  ArmDescription arm_;
  MotionModel model_;
  RolloutBatch rollouts_;
  TipPath path_;
  TipTrackerSettings settings_;
  LapMemory laps_;
  LapPosture posture_;
  double command_per_kpa_;
  Eigen::VectorXd posture_kpa_;               // of each knot, in this frame
  Eigen::VectorXd posture_weight_m_per_kpa_;  // what a knot costs off it
  std::uint64_t seed_;
  std::vector<Pressures> approach_;
  int path_start_frame_ = 0;
  int frame_ = 0;      // set points commanded
  MotionState state_;  // after them, as the estimate has it
  Eigen::VectorXd knots_kpa_;
  std::uint64_t queries_ = 0;
};

}  // namespace limber
