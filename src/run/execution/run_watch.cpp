#include "run_watch.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "limber/arm/plate_distance.hpp"
#include "limber/world/hold.hpp"

namespace limber {

namespace {

constexpr double kRoundingS = 1e-6;

}  // namespace

const Environment* ObstacleAppearance::advance(int frame, double time_s,
                                               const std::optional<BackboneD>& shape) {
  if (obstacle_ == nullptr || frame != obstacle_->frame || !shape) {
    return nullptr;
  }
  const std::optional<Circle> circle = circle_ahead_of(arm_, *obstacle_, *shape);
  if (!circle) {
    return nullptr;
  }
  appeared_ = AppearedObstacle{time_s, *circle};
  Environment alone;
  alone.obstacles = {*circle};
  watch_.emplace(arm_, alone);
  observe(time_s, *shape);
  now_ = environment_;
  now_.obstacles.push_back(*circle);
  return &now_;
}

std::optional<Contact> ObstacleAppearance::of_this(std::optional<Contact> contact) const {
  if (contact) {
    contact->clearance.obstacle = int(environment_.obstacles.size());
  }
  return contact;
}

std::optional<Contact> ObstacleAppearance::nearer(const std::optional<Contact>& before) const {
  const std::optional<Contact> own = watch_ ? of_this(watch_->closest()) : std::nullopt;
  const bool is_nearer = own && (!before || own->clearance.value_m < before->clearance.value_m);
  return is_nearer ? own : before;
}

std::optional<Contact> ObstacleAppearance::earlier(const std::optional<Contact>& before) const {
  const std::optional<Contact> own = watch_ ? of_this(watch_->first_collision()) : std::nullopt;
  return own && (!before || own->time_s < before->time_s) ? own : before;
}

RunWatch::RunWatch(const ArmDescription& arm, const Environment& environment,
                   const ArmDriver& driver, const ArmEstimate& estimate, Look look,
                   const ExecutionSettings& settings)
    : environment_(environment),
      driver_(driver),
      estimate_(estimate),
      look_(std::move(look)),
      contacts_(arm, environment),
      appearance_(arm, environment, settings.obstacle),
      recorder_(arm),
      goal_time_(environment.goal) {}

void RunWatch::start(const Plan& plan) {
  started_ = true;
  start_time_s_ = driver_.state().time_s;
  see();
  if (shape_) {
    const BackboneD planned = plan.frames.front().backbone.cast<double>();
    start_error_m_ = largest_plate_distance_m(*shape_, planned);
  }
  recorder_.add(driver_.state(), plan.frames.front().setpoint_kpa, 0);
}

void RunWatch::observe(double time_s, const BackboneD& backbone) {
  if (started_) {
    contacts_.observe(time_s, backbone);
    appearance_.observe(time_s, backbone);
  }
}

const Environment* RunWatch::take_in(const Pressures& setpoint_kpa, int motion) {
  const ArmState& state = driver_.state();
  ++frames_;
  frames_not_seen_ += recorder_.add(state, setpoint_kpa, motion) ? 0 : 1;
  see();
  return appearance_.advance(frames_, state.time_s, shape_);
}

void RunWatch::see() {
  now_s_ = driver_.state().time_s;
  if (std::optional<BackboneD> seen = look_()) {
    observe(now_s_, *seen);
    shape_ = std::move(seen);
    shape_frame_ = shape_frame_ >= 0 && shape_time_s_ == now_s_ ? shape_frame_ : frames_;
    shape_time_s_ = now_s_;
    goal_time_.see(now_s_, tip_pose(*shape_));
  }
}

void RunWatch::compare(const Plan& plan, std::size_t frame) {
  const auto lag = std::size_t(estimate_.lag_frames());
  if (shape_ && shape_frame_ == frames_ && frame >= lag && frame - lag < plan.frames.size()) {
    prediction_.compare(plan, frame - lag, *shape_);
  }
}

bool RunWatch::rests_in_goal(double held_s) const {
  return held_s >= kHoldS && driver_.state().backbone && is_in_goal();
}

bool RunWatch::is_in_goal() const {
  return shape_ && is_within(environment_.goal, pose_error(environment_.goal, tip_pose(*shape_)));
}

bool RunWatch::is_seen() const {
  return shape_ && now_s_ - shape_time_s_ <= ArmEstimate::kUnknownAfterS + kRoundingS;
}

void RunWatch::judge(ExecutionResult& result) {
  result.frames = frames_;
  result.frames_not_seen = frames_not_seen_;
  result.lag_frames = estimate_.lag_frames();
  result.start_error_m = start_error_m_;
  result.pressure_losses = estimate_.pressure_losses();
  if (is_seen()) {
    result.final_backbone = shape_->cast<float>();
    result.goal_error = pose_error(environment_.goal, tip_pose(*shape_));
    result.goal_reached = result.status == ExecutionStatus::done && is_in_goal();
  }
  // A virtual arm knows its shape even if none was delivered.
  if (recorder_.tracked_count() > 0) {
    result.episode = recorder_.finish();
  }
  result.prediction = prediction_.error();
  if (result.prediction && !is_seen()) {
    result.prediction->final_m = std::numeric_limits<double>::quiet_NaN();
  }
  const auto since_start = [&](auto noted) {
    if (noted) {
      noted->time_s -= start_time_s_;
    }
    return noted;
  };
  if (const std::optional<double> since_s = goal_time_.inside_since_s(); since_s && is_seen()) {
    result.goal_time_s = std::max(0.0, *since_s - start_time_s_);
  }
  result.closest = since_start(appearance_.nearer(contacts_.closest()));
  result.first_collision = since_start(appearance_.earlier(contacts_.first_collision()));
  result.collided = result.first_collision.has_value();
  if (!is_seen() && !result.collided) {
    result.closest.reset();  // it may have come closer since
  }
  result.appeared = since_start(appearance_.appeared());
}

}  // namespace limber
