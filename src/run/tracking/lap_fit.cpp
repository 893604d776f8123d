#include "lap_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limber/arm/damped_solve.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/pressure_box.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

/// One after another: in a lap that is run fast, then as it will be run. In kPa (command_per_kpa).
struct Stage {
  bool is_fast;
  double slope_kpa;          ///< of finite differences: far beyond a network's kinks
  double damping_per_frame;  ///< m² per kPa²
};
constexpr Stage kStages[] = {{true, 8.0, 2e-8}, {true, 4.0, 1e-8}, {false, 4.0, 1e-8}};
constexpr int kFastFrames = 4;  // from point to point
constexpr int kMaxSteps = 40;
constexpr int kPatienceOfFit = 6;     // steps without a gain
constexpr double kGainOfStep = 0.01;  // of the cost: less is none
constexpr double kFitDampings[] = {1.0, 10.0, 100.0};
constexpr double kFitShares[] = {1.0, 0.5, 0.25};
constexpr double kFittedOfLimits = 0.95;  // what tracking corrects needs room
constexpr double kEffortMPerKpa = 1e-4;   // tip error that is as bad as a step between two points
constexpr double kSettlingS = 1.5;

class LapFit {
 public:
  LapFit(const TipPath& path, const ArmDescription& arm, const MotionModel& model,
         const std::vector<Eigen::VectorXd>& points_kpa, const Stage& stage)
      : arm_(arm),
        model_(model),
        rollouts_(model),
        is_periodic_(path.closes() && path.laps > 1),
        stage_(in_unit_of(arm, stage)),
        effort_m_per_kpa_(kEffortMPerKpa / command_per_kpa(arm)),
        intervals_(int(points_kpa.size()) - 1),
        frames_(
            std::min(int(std::lround(path.lap_s() / arm.frame_period_s())),
                     stage.is_fast ? kFastFrames * intervals_ : std::numeric_limits<int>::max())),
        wanted_m_(2 * frames_) {
    for (int k = 1; k <= frames_; ++k) {
      wanted_m_.segment<2>(2 * (k - 1)) = path.at(path.lap_s() * k / frames_);
    }
    knots_kpa_.resize(channels() * knots());
    for (int k = 0; k < knots(); ++k) {
      knots_kpa_.segment(k * channels(), channels()) = points_kpa[k];
    }
    knots_kpa_ = within_limits(knots_kpa_);
  }

  /// Where a step leads, laps begin in another state than the one that it was made for: so not
  /// every step is a gain.
  void run() {
    double min_cost = std::numeric_limits<double>::infinity();
    Eigen::VectorXd best_kpa = knots_kpa_;
    int in_vain = 0;
    for (int step = 0; step < kMaxSteps && in_vain < kPatienceOfFit; ++step) {
      throw_if_interrupted();
      start_ = lap_start();
      const Eigen::VectorXd from_kpa = knots_kpa_;
      const double cost = take_step();
      in_vain = cost < (1.0 - kGainOfStep) * min_cost ? 0 : in_vain + 1;
      if (cost < min_cost) {
        min_cost = cost;
        best_kpa = from_kpa;
      }
    }
    knots_kpa_ = best_kpa;
  }

  std::vector<Eigen::VectorXd> points_kpa() const {
    std::vector<Eigen::VectorXd> points;
    for (int k = 0; k <= intervals_; ++k) {
      points.emplace_back(knots_kpa_.segment((k % knots()) * channels(), channels()));
    }
    return points;
  }

 private:
  static Stage in_unit_of(const ArmDescription& arm, Stage stage) {
    stage.slope_kpa *= command_per_kpa(arm);
    stage.damping_per_frame /= command_per_kpa(arm) * command_per_kpa(arm);
    return stage;
  }

  Eigen::Index channels() const { return model_.channel_count(); }
  /// Points that are free: the last one of a lap that goes on is its first.
  int knots() const { return is_periodic_ ? intervals_ : intervals_ + 1; }

  Eigen::VectorXd within_limits(Eigen::VectorXd knots_kpa) const {
    for (Eigen::Index i = 0; i < knots_kpa.size(); ++i) {
      const PressureLimits& of = arm_.segments[i % channels()].pressure_limit_kpa;
      knots_kpa[i] =
          std::clamp(knots_kpa[i], kFittedOfLimits * of.lower_kpa, kFittedOfLimits * of.upper_kpa);
    }
    return knots_kpa;
  }

  Pressures point_kpa(const Eigen::Ref<const Eigen::VectorXd>& knots_kpa, int point) const {
    return knots_kpa.segment((point % knots()) * channels(), channels()).cast<float>();
  }

  int frame_of(int point) const { return int(std::lround(double(frames_) * point / intervals_)); }

  /// Rest at the first point, or what the lap before ends in.
  MotionState lap_start() {
    const ArmStart vented = start_state(Environment{}, arm_);
    MotionState state = model_.settled_state(vented.pressures_kpa, vented.backbone);
    const Pressures first_kpa = point_kpa(knots_kpa_, 0);
    for (const Pressures& setpoint_kpa :
         straight_setpoints(vented.pressures_kpa, first_kpa, arm_.pressure_step_limit_kpa())) {
      model_.step(setpoint_kpa, state, workspace_);
    }
    for (int k = 0; k < arm_.frames_in(kSettlingS); ++k) {
      model_.step(first_kpa, state, workspace_);
    }
    if (is_periodic_) {
      start_ = std::move(state);
      (void)tips_of(knots_kpa_);
      state = end_;
    }
    return state;
  }

  /// 2·frames × k, of laps from the start; the state in which the first one ends stays in `end_`.
  Eigen::MatrixXd tips_of(const Eigen::MatrixXd& knots_kpa) {
    Eigen::MatrixXd tips_m(2 * frames_, knots_kpa.cols());
    rollouts_.clear();
    for (Eigen::Index c = 0; c < knots_kpa.cols(); ++c) {
      rollouts_.add(int(c), start_, point_kpa(knots_kpa.col(c), 1), frame_of(1));
    }
    int point = 1;
    for (int frame = 0; frame < frames_; ++frame) {
      rollouts_.step();
      for (int column = 0; column < rollouts_.size(); ++column) {
        tips_m.col(rollouts_.label(column)).segment<2>(2 * frame) =
            tip_position_m(rollouts_.now(column));
      }
      if (frame + 1 < frame_of(point)) {
        continue;
      }
      ++point;
      for (int column = 0; point <= intervals_ && column < rollouts_.size(); ++column) {
        rollouts_.go_on(column, point_kpa(knots_kpa.col(rollouts_.label(column)), point),
                        frame_of(point) - frame_of(point - 1));
      }
    }
    end_ = rollouts_.state(0);
    return tips_m;
  }

  /// Steps between successive points; of a lap that goes on, from its last one to its first too.
  Eigen::VectorXd steps_of(const Eigen::Ref<const Eigen::VectorXd>& knots_kpa) const {
    Eigen::VectorXd steps(channels() * intervals_);
    for (int k = 0; k < intervals_; ++k) {
      steps.segment(k * channels(), channels()) =
          knots_kpa.segment(((k + 1) % knots()) * channels(), channels()) -
          knots_kpa.segment(k * channels(), channels());
    }
    return steps;
  }

  double cost(const Eigen::Ref<const Eigen::VectorXd>& knots_kpa,
              const Eigen::Ref<const Eigen::VectorXd>& tips_m) const {
    return (tips_m - wanted_m_).squaredNorm() +
           effort_m_per_kpa_ * effort_m_per_kpa_ * steps_of(knots_kpa).squaredNorm();
  }

  /// The best of some damped steps, or none. @return the cost of where it starts
  double take_step() {
    const Eigen::Index size = knots_kpa_.size();
    Eigen::MatrixXd varied = knots_kpa_.replicate(1, size + 1);
    varied.rightCols(size).diagonal().array() += stage_.slope_kpa;
    const Eigen::MatrixXd tips_m = tips_of(varied);
    const Eigen::MatrixXd slope =
        (tips_m.rightCols(size).colwise() - tips_m.col(0)) / stage_.slope_kpa;
    Eigen::MatrixXd differences(channels() * intervals_, size);
    for (Eigen::Index i = 0; i < size; ++i) {
      differences.col(i) = steps_of(Eigen::VectorXd::Unit(size, i));
    }
    const double effort = effort_m_per_kpa_ * effort_m_per_kpa_;
    const Eigen::MatrixXd square =
        slope.transpose() * slope + effort * differences.transpose() * differences;
    const Eigen::VectorXd downhill = slope.transpose() * (wanted_m_ - tips_m.col(0)) -
                                     effort * differences.transpose() * steps_of(knots_kpa_);
    Eigen::MatrixXd tried(size, std::size(kFitDampings) * std::size(kFitShares));
    Eigen::Index next = 0;
    for (const double damping : kFitDampings) {
      const Eigen::VectorXd step =
          damped_solve(square, downhill, damping * stage_.damping_per_frame * frames_);
      for (const double share : kFitShares) {
        tried.col(next++) = within_limits(knots_kpa_ + share * step);
      }
    }
    const Eigen::MatrixXd led_to_m = tips_of(tried);
    double min_cost = std::numeric_limits<double>::infinity();
    for (Eigen::Index c = 0; c < tried.cols(); ++c) {
      const double found = cost(tried.col(c), led_to_m.col(c));
      if (found < min_cost) {
        min_cost = found;
        knots_kpa_ = tried.col(c);
      }
    }
    return cost(varied.col(0), tips_m.col(0));
  }

  const ArmDescription& arm_;
  const MotionModel& model_;
  MotionModel::Workspace workspace_;
  RolloutBatch rollouts_;
  bool is_periodic_;
  Stage stage_;
  double effort_m_per_kpa_;
  int intervals_;
  int frames_;
  Eigen::VectorXd wanted_m_;
  Eigen::VectorXd knots_kpa_;
  MotionState start_;
  MotionState end_;
};

}  // namespace

LapPosture fitted_to(const TipPath& path, const ArmDescription& arm, const MotionModel& model,
                     const LapPosture& posture) {
  const double points = double(posture.points_kpa().size()) - 1.0;
  if (!posture.is_known() || path.lap_s() < points * arm.frame_period_s()) {
    return posture;
  }
  std::vector<Eigen::VectorXd> points_kpa = posture.points_kpa();
  for (const Stage& stage : kStages) {
    LapFit fit(path, arm, model, points_kpa, stage);
    fit.run();
    points_kpa = fit.points_kpa();
  }
  return posture.with_points(std::move(points_kpa));
}

}  // namespace limber
