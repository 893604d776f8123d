#include "certified_frame.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "limber/run/arm_estimate.hpp"
#include "limber/run/replanner.hpp"
#include "plan_repair.hpp"

namespace limber {

namespace {

/// Of its plan, that an arm goes back where neither going on nor standing is certified. [s]
constexpr std::array kBackS = {1.0, 0.5, 0.25};
constexpr double kWholeArm = 3.0;  // of its length: a goal that the end of any motion is in

/// The set points that are wanted, then the rest of the plan, as far off it as these are.
std::vector<Pressures> with_rest_of(const PlanProgress& at, const CertifiedFrame::Wanted& wanted,
                                    const PressureBox& box, double step_limit_kpa) {
  std::vector<Pressures> to_kpa{wanted.kpa};
  const Pressures& has_kpa = at.setpoint_kpa(wanted.frame);
  const Pressures off_kpa = wanted.kpa - has_kpa;
  const std::vector<Pressures> rest =
      waypoints_after({at.plan, wanted.frame, has_kpa}, step_limit_kpa);
  for (std::size_t w = 1; w < rest.size(); ++w) {
    to_kpa.push_back(box.limited(rest[w] + off_kpa));
  }
  return to_kpa;
}

}  // namespace

CertifiedFrame::CertifiedFrame(const ArmDescription& arm, const MotionModel& model,
                               const Environment& environment, double clearance_m,
                               const std::vector<PressureLimits>& limits)
    : arm_(arm),
      model_(model),
      environment_(environment),
      clearance_m_(clearance_m),
      limits_(limits),
      check_(certificate_check(arm, model)) {
  environment_.goal = {};
  environment_.goal.position_tolerance_m = kWholeArm * arm.length_m();
}

CertifiedFrame::Sent CertifiedFrame::next(const MotionState& now, const PlanProgress& at,
                                          const std::vector<Wanted>& wanted) {
  const Plan& plan = at.plan;
  const PressureBox box = box_for(plan);
  for (const Wanted& one : wanted) {
    if (begin(now, with_rest_of(at, one, box, arm_.pressure_step_limit_kpa()), one.frame, &plan) ||
        begin(now, {one.kpa}, std::nullopt, &plan)) {
      return {last_->plan.frames[1].setpoint_kpa, one.frame};
    }
  }
  const PlanFrame* tried = nullptr;  // near its start, all of these are that
  for (const double back_s : kBackS) {
    const auto back = std::size_t(arm_.frames_in(back_s));
    const PlanFrame& to = plan.frames[at.frame - std::min(at.frame, back)];
    if (std::exchange(tried, &to) != &to && begin(now, {to.setpoint_kpa}, std::nullopt, &plan)) {
      return {last_->plan.frames[1].setpoint_kpa, std::nullopt};
    }
  }
  if (!last_ || last_->frame + 1 >= last_->plan.frames.size()) {
    return {now.setpoint_kpa(), std::nullopt, false};
  }
  const std::size_t frame = ++last_->frame;
  Sent sent{last_->plan.frames[frame].setpoint_kpa, std::nullopt, false};
  if (last_->first && last_->of == &plan) {
    sent.frame = std::min(*last_->first + frame - 1, plan.frames.size() - 1);
  }
  return sent;
}

bool CertifiedFrame::may_hold(const MotionState& now) {
  last_.reset();
  return begin(now, {now.setpoint_kpa()}, std::nullopt, nullptr);
}

bool CertifiedFrame::leads_on(const MotionState& now, const Plan& plan, std::size_t frame) const {
  const Pressures held_kpa = now.setpoint_kpa();
  const Wanted held{held_kpa, frame};
  return motion_from(now, with_rest_of({plan, frame, held_kpa}, held, box_for(plan),
                                       arm_.pressure_step_limit_kpa()))
      .has_value();
}

PressureBox CertifiedFrame::box_for(const Plan& plan) const {
  const std::vector<PressureLimits> limits = limits_after(plan, limits_);
  return limits.empty() ? pressure_box(arm_) : pressure_box(limits);
}

bool CertifiedFrame::begin(const MotionState& now, const std::vector<Pressures>& to_kpa,
                           std::optional<std::size_t> first, const Plan* of) {
  std::optional<Plan> found = motion_from(now, to_kpa);
  if (found) {
    last_ = Motion{*std::move(found), 1, first, of};
  }
  return found.has_value();
}

std::optional<Plan> CertifiedFrame::motion_from(const MotionState& now,
                                                const std::vector<Pressures>& to_kpa) const {
  Environment from_here = environment_;
  from_here.start = start_at(now);
  const Pose tip = tip_pose(now.backbone);
  from_here.goal.x_m = tip.x_m;
  from_here.goal.y_m = tip.y_m;
  std::vector<Pressures> waypoints_kpa{now.setpoint_kpa()};
  waypoints_kpa.insert(waypoints_kpa.end(), to_kpa.begin(), to_kpa.end());
  CheckedPlans plans(PlanningProblem{arm_, model_, from_here, clearance_m_}, check_);
  return plans.end_of(waypoints_kpa) ? plans.checked(waypoints_kpa, "certified frame", 0)
                                     : std::nullopt;
}

}  // namespace limber
