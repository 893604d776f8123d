#include "live_arm_fit.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Cholesky>

#include "limber/arm/plate_distance.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/arm_offsets.hpp"
#include "limber/network/physical_traits.hpp"

namespace limber {

namespace {

constexpr int kWindowFrames = 16;  // that are predicted without correction
constexpr std::size_t kWindows = 6;
constexpr int kRolloutsPerFrame = 4;
/// Of the arm's length: what a model of a minute leaves over a window.
constexpr double kUsualErrorShare = 0.003;
constexpr double kSurprising = 8.0;  // times as much, in one frame
constexpr double kStrange = 4.0;     // times as much, over a window …
constexpr int kStrangeWindows = 6;   // … and in so many: no arm of the family is like that
/// Of the arm's length: a window in which no plate came farther tells nothing.
constexpr double kMovedShare = 0.015;
constexpr float kLostM = 1.0F;        // of a prediction that is no number
constexpr float kLongestStep = 1.0F;  // of e, of a family in which it has unit variance

Eigen::ArrayXf lengths(const Eigen::VectorXf& offsets_m) {
  return offsets_m.reshaped(2, offsets_m.size() / 2).colwise().norm();
}

}  // namespace

LiveArmFit::LiveArmFit(const ArmDescription& arm, const CompensationModel& adapted)
    : arm_(arm),
      family_(family_of(adapted)),
      at_start_(*adapted.member_of_family),
      member_(at_start_) {
  family_.family->arms = Eigen::MatrixXf::Zero(family_.family->size(), 1);
  family_.learnt.reset();
  const auto size = member_.e.size();
  before_.precision =
      member_.covariance.cast<double>().ldlt().solve(Eigen::MatrixXd::Identity(size, size));
  before_.pull = before_.precision * member_.e.cast<double>();
  retired_ = {Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
}

/// In the frames that are predicted: an arm that nobody saw in them tells nothing.
bool LiveArmFit::has_moved() const {
  const double moved_m = kMovedShare * arm_.length_m();
  const Backbone& start = *recent_[1].shape;
  return std::any_of(recent_.begin() + 2, recent_.end(), [&](const Frame& frame) {
    return frame.shape && largest_plate_distance_m(*frame.shape, start) > moved_m;
  });
}

bool LiveArmFit::observe(const Pressures& pressure_kpa, const std::optional<Backbone>& shape) {
  recent_.push_back({pressure_kpa, shape});
  look_ahead();
  while (recent_.size() > kWindowFrames + 2 ||
         (recent_.size() >= 2 && !(recent_[0].shape && recent_[1].shape))) {
    recent_.pop_front();
  }
  const bool is_up_to_date = windows_.empty() || windows_.back().is_fitted;
  if (recent_.size() == kWindowFrames + 2 && is_up_to_date && has_moved()) {
    take_window();
  }
  bool has_changed = false;
  for (int k = 0; k < kRolloutsPerFrame && !windows_.empty(); ++k) {
    has_changed |= roll_out();
  }
  return has_changed;
}

void LiveArmFit::lose_track() {
  recent_.clear();
  ahead_.reset();
}

bool LiveArmFit::has_left_family() const {
  return strange_ >= kStrangeWindows;
}

std::vector<ArmChange> LiveArmFit::explained_changes() const {
  Knowledge told = with_windows(retired_);
  told.pull -= told.precision * at_start_.e.cast<double>();
  return limber::explained_changes(*family_.family, at_start_, {told.precision, told.pull});
}

/// Of today's e.
const ForwardModel& LiveArmFit::todays_model() {
  if (!model_) {
    model_.emplace(arm_, model_of_arm(family_, member_));
  }
  return *model_;
}

/// One step per frame, with today's e.
void LiveArmFit::look_ahead() {
  if (recent_.size() < 2 || !recent_.back().shape) {
    ahead_.reset();
    return;
  }
  const Frame& last = recent_[recent_.size() - 2];
  const Backbone& seen = *recent_.back().shape;
  if (!ahead_ || ahead_->frames == kWindowFrames) {
    ahead_ = last.shape ? std::optional(Ahead{*last.shape, seen}) : std::nullopt;
    return;
  }
  Backbone next = ahead_->now;
  todays_model().step(last.pressure_kpa, recent_.back().pressure_kpa, ahead_->before, ahead_->now,
                      next, workspace_);
  ahead_ = Ahead{ahead_->now, next, ahead_->frames + 1};
  const double off_m =
      (next - seen).bottomRows(next.rows() - 1).leftCols<2>().rowwise().norm().mean();
  if (!(off_m <= kSurprising * kUsualErrorShare * arm_.length_m())) {
    is_surprised_ = true;
    times_off_ = kSurprising;
  }
}

/// The oldest window becomes part of what was known before.
void LiveArmFit::take_window() {
  if (windows_.size() == kWindows) {
    add(windows_.front(), before_);
    add(windows_.front(), retired_);
    windows_.pop_front();
  }
  windows_.emplace_back();
  windows_.back().frames.assign(recent_.begin(), recent_.end());
  recent_.erase(recent_.begin(), recent_.end() - 2);  // windows do not overlap
  turn_ = windows_.size() - 1;
  rolled_out_ = 0;
}

/// One of the rollouts that a window asks for. @return whether that was the last, and e is new
bool LiveArmFit::roll_out() {
  const Eigen::Index size = member_.e.size();
  Window& window = windows_[turn_];
  if (rolled_out_ == 0) {
    next_.at = member_.e;
    next_.left_m = offsets(window, todays_model());
    next_.slope.resize(next_.left_m.size(), size);
  } else {
    const Eigen::VectorXf shifted =
        next_.at + kArmStep * Eigen::VectorXf::Unit(size, rolled_out_ - 1);
    const ForwardModel shifted_model(arm_,
                                     model_of_arm(family_, {"", shifted, member_.covariance}));
    next_.slope.col(rolled_out_ - 1) = (offsets(window, shifted_model) - next_.left_m) / kArmStep;
  }
  if (++rolled_out_ <= size) {
    return false;
  }
  if (!window.is_fitted) {
    last_error_m_ = double(lengths(next_.left_m).mean());
    largest_error_m_ = std::max(largest_error_m_, last_error_m_);
    times_off_ = std::max(1.0, last_error_m_ / (kUsualErrorShare * arm_.length_m()));
    strange_ = times_off_ > kStrange ? strange_ + 1 : 0;
    forget(times_off_);
  }
  window.at = next_.at;
  window.left_m.swap(next_.left_m);
  window.slope.swap(next_.slope);
  window.is_fitted = true;
  solve();
  rolled_out_ = 0;
  turn_ = (turn_ + 1) % windows_.size();
  return true;
}

/// In x and y, of all plates but the base in the window's tracked frames.
Eigen::VectorXf LiveArmFit::offsets(const Window& window, const ForwardModel& model) {
  const Eigen::Index plates = arm_.point_count() - 1;
  Eigen::VectorXf result(2 * plates * kWindowFrames);
  Eigen::Index rows = 0;
  const std::vector<Frame>& frames = window.frames;
  Backbone before = *frames[0].shape;
  Backbone now = *frames[1].shape;
  Backbone next = now;
  for (std::size_t t = 2; t < frames.size(); ++t) {
    model.step(frames[t - 1].pressure_kpa, frames[t].pressure_kpa, before, now, next, workspace_);
    before = std::exchange(now, next);
    if (frames[t].shape) {
      result.segment(rows, 2 * plates) =
          (now - *frames[t].shape).bottomRows(plates).leftCols<2>().reshaped<Eigen::RowMajor>();
      rows += 2 * plates;
    }
  }
  result.conservativeResize(rows);
  return result.array().isFinite().select(result, kLostM);
}

/// What a window says of e, about where it was rolled out.
void LiveArmFit::add(const Window& window, Knowledge& known) const {
  const Eigen::ArrayXf length = lengths(window.left_m + window.slope * (member_.e - window.at));
  const double share = offset_share(kUsualErrorShare * arm_.length_m(), arm_.point_count() - 1);
  const Eigen::MatrixXf weighted = offset_weights(length, share, 2).asDiagonal() * window.slope;
  known.precision += (weighted.transpose() * window.slope).cast<double>();
  known.pull += (weighted.transpose() * (window.slope * window.at - window.left_m)).cast<double>();
}

/// And what the windows say that are fitted.
LiveArmFit::Knowledge LiveArmFit::with_windows(Knowledge known) const {
  for (const Window& window : windows_) {
    if (window.is_fitted) {
      add(window, known);
    }
  }
  return known;
}

/// What was known before, where predictions are off by so many times the usual error.
void LiveArmFit::forget(double wrong) {
  if (wrong <= 1.0) {
    return;
  }
  const Eigen::VectorXd mean = before_.precision.ldlt().solve(before_.pull);
  const auto unknown = Eigen::MatrixXd::Identity(mean.size(), mean.size());
  before_.precision = unknown + (before_.precision - unknown) / (wrong * wrong);
  before_.pull = before_.precision * mean;
}

void LiveArmFit::solve() {
  model_.reset();
  const Knowledge known = with_windows(before_);
  const Eigen::LDLT<Eigen::MatrixXd> solver(known.precision);
  Eigen::VectorXf step = solver.solve(known.pull).cast<float>() - member_.e;
  step *= std::min(1.0F, kLongestStep / std::max(step.norm(), 1e-6F));
  member_.e += step;
  if (const double far = member_.distance(); far > FamilyMember::kFar) {
    member_.e *= float(FamilyMember::kFar / far);
  }
  const auto size = member_.e.size();
  member_.covariance = solver.solve(Eigen::MatrixXd::Identity(size, size)).cast<float>();
}

}  // namespace limber
