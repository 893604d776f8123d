#include "limber/run/tip_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "limber/arm/damped_solve.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/run/executor.hpp"
#include "limber/world/pressure_box.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

constexpr double kApproachHoldS = 1.0;
constexpr double kFirstPointS = 2.0;  // for the path's first point before its time 0
constexpr int kRounds = 2;            // of sampling and fitting, in each frame
constexpr double kRidge = 1e-3;       // of the fit, over the samples' own variance
constexpr double kStepShares[] = {0.25, 0.5, 0.75, 1.0};
constexpr int kMinSamples = 8;
constexpr int kKnots = 4;  // set points that are searched for, straight motions between them
constexpr int kFramesPerKnot = 3;
constexpr int kHorizon = kKnots * kFramesPerKnot;
constexpr double kSpreadKpa = 3.0;  // standard deviation of sampled knots
/// What a knot's step costs: metres of tip error that are as bad as a step of 1 kPa.
constexpr double kStepCostMPerKpa = 2e-5;
/// What a knot costs that lies off the lap's posture by half of its limits' width: metres of tip
/// error. Many shapes have the same tip; without it the arm drifts into bends from which a short
/// horizon finds no way back.
constexpr double kPostureM = 3e-2;
constexpr double kBlindS = 0.5;  // bridged by prediction, then the run stops

}  // namespace

TipTracker::TipTracker(const ArmDescription& arm, const MotionModel& model, const TipPath& path,
                       const TrackStart& start, const TipTrackerSettings& settings,
                       std::uint64_t seed)
    : arm_(arm),
      model_(model),
      rollouts_(model),
      path_(path),
      settings_(settings),
      laps_(std::max(1, int(std::lround(path.lap_s() / arm.frame_period_s()))),
            path.laps > 1 ? settings.lap_share : 0.0),
      posture_(start.posture),
      command_per_kpa_(command_per_kpa(arm)),
      seed_(seed) {
  const Pressures& start_kpa = start.setpoint_kpa;
  const Pressures vented_kpa = Pressures::Zero(arm.channel_count());
  approach_ = straight_setpoints(vented_kpa, start_kpa, arm.pressure_step_limit_kpa());
  approach_.insert(approach_.end(), std::size_t(arm.frames_in(kApproachHoldS)), start_kpa);
  path_start_frame_ = int(approach_.size()) + arm.frames_in(kFirstPointS);
  knots_kpa_ = start_kpa.cast<double>().replicate(kKnots, 1);
  const double posture_m = posture_.is_known() ? kPostureM : 0.0;
  posture_weight_m_per_kpa_.resize(knots_kpa_.size());
  for (Eigen::Index i = 0; i < knots_kpa_.size(); ++i) {
    posture_weight_m_per_kpa_[i] = posture_m / limits_of_knot(i).half_width_kpa();
  }
}

const PressureLimits& TipTracker::limits_of_knot(Eigen::Index i) const {
  return arm_.segments[i % channels()].pressure_limit_kpa;
}

double TipTracker::path_time_s(int frame) const {
  return (frame - path_start_frame_) * arm_.frame_period_s();
}

/// Empty: the run goes on.
std::string TipTracker::why_stopped(const ArmEstimate& arm) const {
  if (!arm.has_state()) {
    return "nothing tracks the arm; to keep its tip on a path, its shape has to be measured";
  }
  const int blind = arm.frames_unseen();
  return blind > arm_.frames_in(kBlindS) ? fmt::format("nothing has tracked the arm for {:.2f} s",
                                                       blind * arm_.frame_period_s())
                                         : "";
}

/// Where the arm is, where it was asked to be, and what this lap's frame teaches the next.
void TipTracker::take_in(const ArmEstimate& arm) {
  state_ = arm.state();
  queries_ += std::uint64_t(1 + arm.lag_frames());
  const int seen = frame_ - arm.lag_frames();
  const int since = seen - path_start_frame_;
  if (since > 0 && arm.frames_unseen() == 0) {  // the lap's first frame is the approach's
    laps_.learn(since, path_.at(path_time_s(seen)) - tip_position_m(*arm.measured().backbone));
  }
}

Eigen::VectorXd TipTracker::wanted_tips(const ArmEstimate& arm) const {
  Eigen::VectorXd wanted(2 * kHorizon);
  for (int h = 1; h <= kHorizon; ++h) {
    wanted.segment<2>(2 * (h - 1)) = path_.at(path_time_s(frame_ + h)) -
                                     settings_.missed_share * arm.missed_ahead_m(h) +
                                     laps_.shift_m(frame_ + h - path_start_frame_);
  }
  return wanted;
}

void TipTracker::roll_out(Candidates& candidates) {
  const Eigen::Index n = channels();
  const auto knot = [&](Eigen::Index candidate, int k) {
    return Pressures(candidates.knots_kpa.col(candidate).segment(k * n, n).cast<float>());
  };
  candidates.tips_m.resize(2 * kHorizon, candidates.knots_kpa.cols());
  rollouts_.clear();
  for (Eigen::Index c = 0; c < candidates.knots_kpa.cols(); ++c) {
    rollouts_.add(int(c), state_, knot(c, 0), kFramesPerKnot);
  }
  for (int h = 0; h < kHorizon; ++h) {
    rollouts_.step();
    for (int column = 0; column < rollouts_.size(); ++column) {
      candidates.tips_m.col(rollouts_.label(column)).segment<2>(2 * h) =
          tip_position_m(rollouts_.now(column));
    }
    const int next_knot = (h + 1) / kFramesPerKnot;
    if ((h + 1) % kFramesPerKnot == 0 && next_knot < kKnots) {
      for (int column = 0; column < rollouts_.size(); ++column) {
        rollouts_.go_on(column, knot(rollouts_.label(column), next_knot), kFramesPerKnot);
      }
    }
  }
  queries_ += std::uint64_t(kHorizon * candidates.knots_kpa.cols());
}

Eigen::VectorXd TipTracker::posture_of_knots() const {
  Eigen::VectorXd kpa(knots_kpa_.size());
  for (int k = 0; k < kKnots; ++k) {
    kpa.segment(k * channels(), channels()) =
        posture_.at(path_time_s(frame_ + (k + 1) * kFramesPerKnot));
  }
  return kpa;
}

Eigen::VectorXd TipTracker::off_posture(const Eigen::Ref<const Eigen::VectorXd>& knots_kpa) const {
  return posture_weight_m_per_kpa_.cwiseProduct(knots_kpa - posture_kpa_);
}

double TipTracker::cost(const Eigen::Ref<const Eigen::VectorXd>& knots_kpa,
                        const Eigen::Ref<const Eigen::VectorXd>& tips_m,
                        const Eigen::VectorXd& wanted) const {
  const Eigen::Index n = channels();
  Eigen::VectorXd steps = knots_kpa;
  steps.tail(knots_kpa.size() - n) -= knots_kpa.head(knots_kpa.size() - n);
  steps.head(n) -= state_.setpoint_kpa().cast<double>();
  return (tips_m - wanted).squaredNorm() + off_posture(knots_kpa).squaredNorm() +
         std::pow(kStepCostMPerKpa / command_per_kpa_, 2) * steps.squaredNorm();
}

/// Knots as near as limits and frame rule allow.
Eigen::VectorXd TipTracker::within_rule(Eigen::VectorXd knots_kpa) const {
  const Eigen::Index n = channels();
  const double step_kpa = kFramesPerKnot * arm_.pressure_step_limit_kpa();
  for (Eigen::Index i = 0; i < knots_kpa.size(); ++i) {
    const double before = i < n ? double(state_.setpoint_kpa()[i]) : knots_kpa[i - n];
    knots_kpa[i] =
        limits_of_knot(i).clamped(std::clamp(knots_kpa[i], before - step_kpa, before + step_kpa));
  }
  return knots_kpa;
}

/// From the first sample, the knots' change of least squared error as a linear fit has it.
Eigen::VectorXd TipTracker::fitted_step(const Candidates& samples,
                                        const Eigen::VectorXd& wanted) const {
  const Eigen::Index n = channels();
  const Eigen::Index size = samples.knots_kpa.rows();
  const Eigen::MatrixXd knots = samples.knots_kpa.colwise() - samples.knots_kpa.rowwise().mean();
  const Eigen::MatrixXd tips = samples.tips_m.colwise() - samples.tips_m.rowwise().mean();
  const Eigen::MatrixXd square = knots * knots.transpose();
  const double ridge = kRidge * square.trace() / double(size) + 1e-9;
  const Eigen::MatrixXd slope = damped_solve(square, knots * tips.transpose(), ridge).transpose();
  // Differences of successive knots, the first from the set points in force.
  Eigen::MatrixXd difference = Eigen::MatrixXd::Identity(size, size);
  difference.bottomLeftCorner(size - n, size - n).diagonal().array() -= 1.0;
  Eigen::VectorXd steps = difference * samples.knots_kpa.col(0);
  steps.head(n) -= state_.setpoint_kpa().cast<double>();
  const double effort = std::pow(kStepCostMPerKpa / command_per_kpa_, 2);
  Eigen::MatrixXd left = slope.transpose() * slope + effort * difference.transpose() * difference;
  left.diagonal() += posture_weight_m_per_kpa_.cwiseAbs2();
  const Eigen::VectorXd right =
      slope.transpose() * (wanted - samples.tips_m.col(0)) -
      effort * difference.transpose() * steps -
      posture_weight_m_per_kpa_.cwiseProduct(off_posture(samples.knots_kpa.col(0)));
  return left.ldlt().solve(right);
}

Eigen::VectorXd TipTracker::knots_one_frame_on() const {
  const Eigen::Index n = channels();
  const Eigen::Index rest = knots_kpa_.size() - n;
  Eigen::VectorXd slope(knots_kpa_.size());
  slope.head(rest) = (knots_kpa_.tail(rest) - knots_kpa_.head(rest)) / kFramesPerKnot;
  slope.tail(n) = slope.segment(rest - n, n);
  return knots_kpa_ + slope;
}

void TipTracker::search(const ArmEstimate& arm) {
  const Eigen::VectorXd wanted = wanted_tips(arm);
  const int samples =
      std::max(kMinSamples, settings_.queries / kHorizon / kRounds - int(std::size(kStepShares)));
  RandomStream random(seed_, std::uint64_t(frame_));
  knots_kpa_ = within_rule(knots_kpa_);
  posture_kpa_ = posture_of_knots();
  const double spread_kpa = kSpreadKpa * command_per_kpa_;
  for (int round = 0; round < kRounds; ++round) {
    Candidates sampled;
    sampled.knots_kpa.resize(knots_kpa_.size(), samples);
    sampled.knots_kpa.col(0) = knots_kpa_;
    for (int c = 1; c < samples; ++c) {
      sampled.knots_kpa.col(c) = within_rule(
          knots_kpa_.unaryExpr([&](double kpa) { return kpa + spread_kpa * random.normal(); }));
    }
    roll_out(sampled);
    const Eigen::VectorXd step = fitted_step(sampled, wanted);
    Candidates steps;
    steps.knots_kpa.resize(knots_kpa_.size(), Eigen::Index(std::size(kStepShares)));
    for (Eigen::Index k = 0; k < steps.knots_kpa.cols(); ++k) {
      steps.knots_kpa.col(k) = within_rule(knots_kpa_ + kStepShares[k] * step);
    }
    roll_out(steps);
    double min_cost = std::numeric_limits<double>::infinity();
    for (const Candidates* tried : {&sampled, &steps}) {
      for (Eigen::Index c = 0; c < tried->knots_kpa.cols(); ++c) {
        const double found = cost(tried->knots_kpa.col(c), tried->tips_m.col(c), wanted);
        if (found < min_cost) {
          min_cost = found;
          knots_kpa_ = tried->knots_kpa.col(c);
        }
      }
    }
  }
}

/// The first frame of the way to the first knot.
Pressures TipTracker::decide(const ArmEstimate& arm) {
  if (frame_ < int(approach_.size())) {
    return approach_[frame_];
  }
  search(arm);
  const Eigen::VectorXd now = state_.setpoint_kpa().cast<double>();
  const Eigen::VectorXd next = now + (knots_kpa_.head(channels()) - now) / kFramesPerKnot;
  knots_kpa_ = knots_one_frame_on();
  return within_frame_rule(arm_, state_.setpoint_kpa(), next);
}

Decision TipTracker::step(const Moment& now) {
  Decision decision;
  decision.reason = why_stopped(now.arm);
  if (!decision.reason.empty() || path_time_s(frame_) >= path_.duration_s()) {
    return decision;
  }
  take_in(now.arm);
  decision.setpoint_kpa = decide(now.arm);
  ++frame_;
  return decision;
}

}  // namespace limber
