#include "run_message.hpp"

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/units.hpp"
#include "limber/network/physical_traits.hpp"
#include "limber/world/collision.hpp"

namespace limber {

namespace {

std::string collision_text(const Contact& contact, const Environment& environment) {
  return fmt::format("collided with {}, {}, after {:.2f} s",
                     obstacle_name(environment, contact.clearance.obstacle),
                     plates_of_gap(contact.clearance.gap), contact.time_s);
}

std::string unseen_text(const ExecutionResult& run) {
  return fmt::format("the arm was not seen {} ({} of {} frames without it): {} unknown",
                     run.frames_not_seen < run.frames ? "at the end" : "at all",
                     run.frames_not_seen, run.frames,
                     run.collided ? "whether it arrived is" : "arrival and collisions are");
}

/// "ended 3.2 cm from the goal (2.0 cm allowed)"
std::string miss_text(const PoseError& error, const PoseGoal& goal) {
  const bool is_off = error.position_m > goal.position_tolerance_m;
  const bool is_turned = goal.theta_rad && error.orientation_rad > goal.orientation_tolerance_rad;
  const std::string off = fmt::format("{:.1f} cm", kCmPerM * error.position_m);
  const std::string allowed = fmt::format("{:.1f} cm", kCmPerM * goal.position_tolerance_m);
  const std::string turned = fmt::format("{:.2f} rad", error.orientation_rad);
  const std::string turn_allowed = fmt::format("{:.2f} rad", goal.orientation_tolerance_rad);
  if (is_off && is_turned) {
    return fmt::format("ended {} and {} from the goal ({} and {} allowed)", off, turned, allowed,
                       turn_allowed);
  }
  return is_turned
             ? fmt::format("ended {} from the goal's heading ({} allowed)", turned, turn_allowed)
             : fmt::format("ended {} from the goal ({} allowed)", off, allowed);
}

/// " 1.2 cm from obstacle 3 (circle)"; empty: nothing stands there, or it is in it.
std::string nearest_text(const Backbone& shape, const ArmDescription& arm,
                         const Environment& environment) {
  if (environment.obstacles.empty()) {
    return "";
  }
  const Clearance nearest = CollisionChecker(arm, environment.obstacles).clearance(shape);
  return nearest.value_m > 0.0 ? fmt::format(" {:.1f} cm from {}", kCmPerM * nearest.value_m,
                                             obstacle_name(environment, nearest.obstacle))
                               : "";
}

std::string hint_of_miss(const ExecutionResult& run, const ArmDescription& arm,
                         const Environment& environment, const Plan& plan, Correction correction) {
  if (correction == Correction::feedback) {
    return "";
  }
  if (correction == Correction::none) {
    const bool was_predicted = plan.goal_distance_m > environment.goal.position_tolerance_m;
    return fmt::format(
        ": its plan has it {:.1f} cm from there{}", kCmPerM * plan.goal_distance_m,
        was_predicted ? "" : ", and is followed open loop; a closed loop (--replan) corrects it");
  }
  if (run.stopped_ahead) {
    return run.appeared
               ? fmt::format(": no plan leads past the obstacle that appeared after {:.2f} s",
                             run.appeared->time_s)
               : fmt::format(": it was halted on its way{}, and no plan leads on from there",
                             nearest_text(*run.final_backbone, arm, environment));
  }
  if (run.replans == 0) {
    return ": no plan from where it rests leads nearer";
  }
  const bool knows_why = !run.arm_changes.empty() || !run.pressure_losses.empty();
  return fmt::format(": {} {} from rest, none came into it{}", run.replans,
                     run.replans == 1 ? "plan" : "plans",
                     knows_why ? "" : "; friction or load may have changed");
}

}  // namespace

std::string why_not_arrived(const ExecutionResult& run, const Environment& environment) {
  std::string text;
  if (run.first_collision) {
    text = collision_text(*run.first_collision, environment);
  }
  const bool is_seen = run.final_backbone.has_value();
  if (!(is_seen && run.goal_reached)) {
    text += text.empty() ? "" : "; ";
    text += is_seen ? miss_text(run.goal_error, environment.goal) : unseen_text(run);
  }
  return text;
}

std::string hint_of(const ExecutionResult& run, const ArmDescription& arm,
                    const Environment& environment, const Plan& plan, Correction correction) {
  const bool misses =
      run.status == ExecutionStatus::done && run.final_backbone && !run.goal_reached;
  std::string text = misses ? hint_of_miss(run, arm, environment, plan, correction) : "";
  if (run.frames_not_certified > 0) {
    text += fmt::format("; in {} frames nothing was certified from where the arm was",
                        run.frames_not_certified);
  }
  if (!run.arm_changes.empty()) {
    text += "; what may have changed of the arm (in brackets, before): " +
            changes_text(run.arm_changes);
  }
  for (const PressureLoss& loss : run.pressure_losses) {
    text += "; " + to_text(loss);
  }
  return text;
}

}  // namespace limber
