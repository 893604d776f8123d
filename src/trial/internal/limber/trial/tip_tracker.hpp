#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "limber/common/random_stream.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "limber/hardware/executor.hpp"
#include "limber/trial/tip_path.hpp"

namespace limber {

struct TipTrackerSettings {
  /// Model queries in each frame; a number, so that runs in simulated time can be repeated.
  int queries = 3000;
  int knots = 4;            ///< set points that are searched for, straight motions between them
  int frames_per_knot = 3;  ///< the horizon is knots × frames_per_knot
  double spread_kpa = 3.0;  ///< standard deviation of sampled knots, > 0
  /// What a knot's step costs: metres of tip error that are as bad as a step of 1 kPa.
  double effort_m_per_kpa = 2e-5;
  double max_bias_m = 0.05;                 ///< bound of the disturbance estimate
  double blind_s = 0.5;                     ///< bridged by prediction, then the run stops
  std::vector<PressureLimits> limits = {};  ///< narrower than the arm's; empty: the arm's
};

/// Keeps the tip on a path over time by receding horizon (docs/tracking.md). In
/// each frame, from the measured state:
///
/// 1. Rollouts of sampled knots, side by side, say how the tip's next positions depend on the
///    knots: a linear fit by ridge regression.
/// 2. The knots of least squared error by that fit, at several lengths of the step, are rolled out
///    beside the best samples; the best of all are kept, and their first set points commanded.
///
/// What the model misses within 0.25 s, measured minus predicted tip, is low-passed, bounded, and
/// added to predictions in proportion to how far ahead they are. Chance comes from a stream of
/// (seed, frame): simulated runs repeat.
///
/// Starts with an approach: straight to `start_kpa`, then the path's first point for 2 s; the
/// path's time 0 is `path_start_frame`.
class TipTracker final : public FrameController {
 public:
  /// Borrows what the model borrows. @param start_kpa  as find_track_start has them
  TipTracker(const ArmDescription& arm, const MotionModel& model, const TipPath& path,
             const Pressures& start_kpa, const TipTrackerSettings& settings, std::uint64_t seed);

  std::optional<Pressures> next(const ArmState& state) override;
  std::string stop_reason() const override { return stop_reason_; }

  /// Frame of the run, counted as ExecutionResult::frames, at which the path's time is 0.
  int path_start_frame() const { return path_start_frame_; }
  std::uint64_t queries() const { return queries_; }

 private:
  /// Tips along a rollout of some knots: 2·horizon numbers.
  struct Candidates {
    Eigen::MatrixXd knots_kpa;  // n·knots × k
    Eigen::MatrixXd tips_m;     // 2·horizon × k
  };

  int horizon() const { return settings_.knots * settings_.frames_per_knot; }
  Eigen::Index segments() const { return model_.segment_count(); }
  double path_time_s(int frame) const;
  bool take_in(const ArmState& state);
  void learn_bias();
  Eigen::Vector2d bias_ahead_m(int frames) const;
  void roll_out(Candidates& candidates);
  Eigen::VectorXd wanted_tips() const;
  double cost(const Eigen::Ref<const Eigen::VectorXd>& knots_kpa,
              const Eigen::Ref<const Eigen::VectorXd>& tips_m, const Eigen::VectorXd& wanted) const;
  Eigen::VectorXd within_rule(Eigen::VectorXd knots_kpa) const;
  Eigen::VectorXd fitted_step(const Candidates& samples, const Eigen::VectorXd& wanted) const;
  Eigen::VectorXd knots_one_frame_on() const;
  void search();
  Pressures decide();

  ArmDescription arm_;
  MotionModel model_;
  MotionModel::Workspace workspace_;
  RolloutBatch rollouts_;
  TipPath path_;
  TipTrackerSettings settings_;
  std::uint64_t seed_;
  std::vector<Pressures> approach_;
  int path_start_frame_ = 0;
  int frame_ = 0;      // set points commanded
  int blind_ = 0;      // frames without tracking, in a row
  MotionState state_;  // measured, or predicted while nothing tracks the arm
  Eigen::VectorXd knots_kpa_;
  std::deque<MotionState> states_;                    // measured, the last frames, without a gap
  std::deque<Pressures> commanded_;                   // after each of them
  Eigen::Vector2d bias_m_ = Eigen::Vector2d::Zero();  // missed within kBiasFrames
  std::string stop_reason_;
  std::uint64_t queries_ = 0;
};

/// Set points at which the model has the settled tip nearest to `tip_m`, from rest.
struct TrackStart {
  Pressures setpoint_kpa;
  double distance_m = 0.0;  ///< of the tip that the model then predicts
};
TrackStart find_track_start(const ArmDescription& arm, const MotionModel& model,
                            const Eigen::Vector2d& tip_m, std::uint64_t seed);

}  // namespace limber
