#include "limber/run/arm_estimate.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "forecast_check.hpp"
#include "limber/arm/plate_distance.hpp"
#include "limber/run/rest_average.hpp"
#include "limber/run/rest_miss.hpp"
#include "limber/run/state_lag.hpp"
#include "pressure_loss.hpp"
#include "shape_filter.hpp"

namespace limber {

namespace {

constexpr double kForecastS = 0.5;  // most of what an arm that is held still moves is over by then
/// Of the arm's length, per frame: 2 mm of the arm of the paper. An arm that slid on at 1.4 cm per
/// frame was led to the goal by where it was, and struck what its plan passed.
constexpr double kMovingShare = 0.00284;
/// Of the arm's length: what a plate is measured beside where the filter believes the arm can have
/// it. 2 mm of the arm of the paper, four times a tracker's noise: with 0.5 and 1 mm a noise of
/// 0.5 mm still moved the arm (docs/experiments.md, Disturbances).
constexpr double kMeasuredShare = 0.00284;
constexpr double kTipForecastS = 0.25;  // whose misses of the tip are low-passed
constexpr double kMaxFarther = 2.0;     // times that: the farthest they are extrapolated

Eigen::VectorXd gap_lengths_m(const ArmDescription& arm) {
  Eigen::VectorXd lengths_m(arm.point_count() - 1);
  for (int gap = 0; gap < lengths_m.size(); ++gap) {
    const Segment& segment = arm.segments[arm.segment_of_gap(gap)];
    lengths_m[gap] = segment.length_m / segment.gaps;
  }
  return lengths_m;
}

}  // namespace

/// The arm as a model has it, from frame to frame.
class PredictedState {
 public:
  PredictedState(const ArmDescription& arm, const EstimateModel& with)
      : model_(*with.model),
        pressure_lag_(model_.valves()),
        losses_(arm, model_.valves()),
        start_(with.filter_from),
        check_(std::size_t(arm.frames_in(kForecastS)), std::size_t(arm.frames_in(kTipForecastS))) {
    if (start_) {
      filter_.emplace(gap_lengths_m(arm), kMeasuredShare * arm.length_m());
    }
  }

  int pressure_lag(const Pressures& setpoint_kpa, const Pressures& measured_kpa) {
    const int frames = pressure_lag_.note(setpoint_kpa, measured_kpa);
    if (!model_.valves().is_ideal()) {
      losses_.observe(pressure_lag_.expected_kpa(), measured_kpa);
    }
    return frames;
  }
  const std::vector<PressureLoss>& losses() const { return losses_.found(); }

  /// @param lag  frames that `measured` is behind `setpoint_kpa`
  void observe(const Pressures& setpoint_kpa, const ArmState& measured, std::size_t lag) {
    bool is_later = true;
    if (valves_.size() == 0) {
      valves_ = model_.valves().settled_state(setpoint_kpa);
    } else {
      coming_kpa_.push_back(setpoint_kpa);
      is_later = coming_kpa_.size() > lag;
      while (coming_kpa_.size() > lag) {
        take_next(measured.pressure_kpa);
      }
    }
    if (measured.backbone) {
      correct(*measured.backbone, is_later);
    }
    look_ahead();
  }

  const std::optional<MotionState>& ahead() const { return ahead_; }
  const std::optional<MotionState>& shown() const { return state_; }
  double moved_m() const { return moved_m_; }
  const ModelMiss& miss() const { return miss_; }
  /// A network starts from the measured shape, and errs more the farther ahead; the no-load model
  /// errs as much in the next frame.
  Eigen::Vector2d missed_ahead_m(int frames) const {
    const double times = std::min(double(frames) / double(check_.tip_frames()), kMaxFarther);
    return (model_.has_network() ? times : 1.0) * check_.missed_tip_m();
  }
  void forget_miss() {
    miss_ = {};
    check_.forget();
  }

 private:
  void take_next(const Pressures& pressure_kpa);
  void correct(const Backbone& measured, bool is_later);
  void look_ahead();

  MotionModel model_;
  MotionModel::Workspace workspace_;
  Eigen::VectorXf valves_;  // followed from the start on, tracked or not
  PressureLag pressure_lag_;
  PressureLossWatch losses_;
  std::deque<Pressures> coming_kpa_;  // set points whose frames no state has shown yet
  std::optional<MotionState> state_;  // in the frame that the last state shows
  std::optional<MotionState> ahead_;  // after those that are coming
  std::optional<ShapeFilter> filter_;
  std::optional<Backbone> start_;
  double moved_m_ = 0.0;
  ModelMiss miss_;
  ForecastCheck check_;
};

/// The frame of the set points that are next. @param pressure_kpa  measured in it
void PredictedState::take_next(const Pressures& pressure_kpa) {
  const Pressures& setpoint_kpa = coming_kpa_.front();
  const Eigen::Index n = setpoint_kpa.size();
  miss_.travelled_kpa += double((setpoint_kpa - valves_.segment(n, n)).cwiseAbs().sum());
  const Pressures before_kpa = valves_.head(n);
  model_.valves().step(setpoint_kpa, valves_);
  if (!model_.valves().is_ideal()) {
    valves_.head(n) = pressure_kpa;
  }
  if (filter_) {
    filter_->predict();
  }
  check_.step(model_, before_kpa, valves_.head(n), workspace_);
  if (state_) {
    model_.step_shape(before_kpa, valves_.head(n), state_->before, state_->backbone, workspace_);
    state_->valves = valves_;
  }
  coming_kpa_.pop_front();
}

/// @param is_later  than the shape before
void PredictedState::correct(const Backbone& measured, bool is_later) {
  if (state_ && is_later) {
    miss_.sum += numbers_of(tip_pose(measured)) - numbers_of(tip_pose(state_->backbone));
  }
  // What it had a frame ago was corrected then, and has been kept by the prediction since.
  const Backbone before = state_ ? state_->before : measured;
  const Backbone* predicted = state_ ? &state_->backbone : start_ ? &*start_ : nullptr;
  const Backbone now = filter_ ? filter_->corrected(*predicted, measured) : measured;
  state_ = model_.moving_state(valves_, now, state_ ? before : now);
  if (is_later) {
    check_.compare(*state_);
    miss_.plate_m = check_.missed_m();
  }
}

void PredictedState::look_ahead() {
  const std::optional<MotionState> before = std::exchange(ahead_, state_);
  if (ahead_) {
    for (const Pressures& setpoint_kpa : coming_kpa_) {
      model_.step(setpoint_kpa, *ahead_, workspace_);
    }
    moved_m_ = before ? largest_plate_distance_m(before->backbone, ahead_->backbone) : 0.0;
  }
}

ArmStart start_at(const MotionState& state) {
  ArmStart start{state.pressure_kpa(), state.backbone};
  const Eigen::Index n = state.segments;
  for (Eigen::Index at = n; at + n <= state.valves.size(); at += n) {
    start.setpoints_kpa.emplace_back(state.valves.segment(at, n));
  }
  start.before = state.before;
  return start;
}

struct ArmEstimate::Parts {
  explicit Parts(const ArmDescription& arm)
      : moving_m(kMovingShare * arm.length_m()), rest(arm.frames_in(RestAverage::kRestS)) {}

  double moving_m;  // in a frame: more is no rest
  int frames = -1;  // the start is none
  int frames_unseen = 0;
  int lag_frames = 0;
  Pressures setpoint_kpa;
  ArmState measured;
  StateLag said_lag;
  RestAverage rest;
  RestMiss rest_miss;
  std::optional<PredictedState> predicted;
};

ArmEstimate::ArmEstimate(const ArmDescription& arm, const EstimateModel& with)
    : parts_(std::make_unique<Parts>(arm)) {
  if (with.model != nullptr) {
    require_model_of_arm(arm, *with.model, "controller");
    parts_->predicted.emplace(arm, with);
  }
}

ArmEstimate::~ArmEstimate() = default;

void ArmEstimate::observe(const Pressures& setpoint_kpa, const ArmState& measured) {
  Parts& now = *parts_;
  ++now.frames;
  ArmState fresh = measured;
  if (now.frames > 0 && measured.time_s == now.measured.time_s) {
    fresh.backbone.reset();  // the sample of before, passed on again: the arm has gone on
  }
  now.setpoint_kpa = setpoint_kpa;
  now.measured = measured;
  now.frames_unseen = fresh.backbone ? 0 : now.frames_unseen + 1;
  now.rest.observe(measured.backbone);
  now.lag_frames = now.said_lag.note(setpoint_kpa, measured);
  if (now.predicted) {
    const int found = now.predicted->pressure_lag(setpoint_kpa, measured.pressure_kpa);
    now.lag_frames = measured.setpoint_kpa ? now.lag_frames : found;
    now.predicted->observe(setpoint_kpa, fresh, std::size_t(now.lag_frames));
  }
}

int ArmEstimate::frames() const {
  return parts_->frames;
}

const Pressures& ArmEstimate::setpoint_kpa() const {
  return parts_->setpoint_kpa;
}

const ArmState& ArmEstimate::measured() const {
  return parts_->measured;
}

int ArmEstimate::lag_frames() const {
  return parts_->lag_frames;
}

int ArmEstimate::frames_unseen() const {
  return parts_->frames_unseen;
}

std::optional<Backbone> ArmEstimate::rest() const {
  return parts_->rest.backbone();
}

bool ArmEstimate::has_state() const {
  return parts_->predicted && parts_->predicted->ahead();
}

const MotionState& ArmEstimate::state() const {
  return *parts_->predicted->ahead();
}

const MotionState& ArmEstimate::shown_state() const {
  return *parts_->predicted->shown();
}

bool ArmEstimate::is_moving() const {
  return parts_->predicted && parts_->predicted->moved_m() > parts_->moving_m;
}

const std::vector<PressureLoss>& ArmEstimate::pressure_losses() const {
  static const std::vector<PressureLoss> kNone;
  return parts_->predicted ? parts_->predicted->losses() : kNone;
}

const ModelMiss& ArmEstimate::miss() const {
  static const ModelMiss kNone;
  return parts_->predicted ? parts_->predicted->miss() : kNone;
}

Eigen::Vector2d ArmEstimate::missed_ahead_m(int frames) const {
  return parts_->predicted ? parts_->predicted->missed_ahead_m(frames) : Eigen::Vector2d(0.0, 0.0);
}

const RestMiss& ArmEstimate::rest_miss() const {
  return parts_->rest_miss;
}

void ArmEstimate::take(const RestMiss& found) {
  parts_->rest_miss = found;
}

void ArmEstimate::forget_miss() {
  if (parts_->predicted) {
    parts_->predicted->forget_miss();
  }
}

}  // namespace limber
