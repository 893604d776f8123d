#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "checked_plans.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/run/plan_controller.hpp"

namespace limber {

/// Decides what an arm in closed loop is sent next: only set points that begin a motion
/// which comes to rest and is certified from where the arm is now. That motion is the rest of the
/// plan, moved by what the set points are off it, or a stop: the set points held until the arm
/// rests. An arm that would strike something all the same, as it moves faster than predicted, goes
/// back along its plan. Where nothing is certified, it keeps to the motion that was certified last.
///
/// Threads: what is constant may be called by any; the rest by one. All arguments are borrowed.
class CertifiedFrame {
 public:
  /// @param clearance_m  kept from obstacles, ≥ 0; most of what the arm has where that is less
  /// @param limits  of set points, one of each segment; empty: the arm's
  CertifiedFrame(const ArmDescription& arm, const MotionModel& model,
                 const Environment& environment, double clearance_m,
                 const std::vector<PressureLimits>& limits);

  /// From the next frame on. @param clearance_m  as above
  void keep(double clearance_m) { clearance_m_ = clearance_m; }

  /// Set points that are wanted, and the frame of the plan that they stand for.
  struct Wanted {
    Pressures kpa;
    std::size_t frame;
  };
  struct Sent {
    Pressures kpa;
    /// Of the plan; none: of the motion certified last, which is a stop or has ended.
    std::optional<std::size_t> frame;
    bool is_certified = true;
  };

  /// The first of these that is certified; or a frame on the way back; or the next frame of what
  /// was certified last, which the arm holds once that has ended.
  /// @param now   where the arm is, after all set points that were sent
  /// @param at    the plan that it follows, and the set points that it has
  Sent next(const MotionState& now, const PlanProgress& at, const std::vector<Wanted>& wanted);
  /// Whether the arm comes to rest free if it holds its set points from now on.
  bool may_stop(const MotionState& now) const {
    return motion_from(now, {now.setpoint_kpa()}).has_value();
  }
  /// The same for an arm that does so, whatever is said.
  bool may_hold(const MotionState& now);
  /// Whether it may follow the rest of a plan, whose frame `frame` it had last.
  bool leads_on(const MotionState& now, const Plan& plan, std::size_t frame) const;

 private:
  /// A certified motion and how far the arm is along it.
  struct Motion {
    Plan plan;
    std::size_t frame = 1;  ///< sent last
    /// Of the plan whose rest it is, in this one's frame 1; none: it is a stop.
    std::optional<std::size_t> first;
    const Plan* of;  ///< that one, none: no plan's; compared, never read
  };

  std::optional<Plan> motion_from(const MotionState& now,
                                  const std::vector<Pressures>& to_kpa) const;
  /// Whether that motion is certified; if so, it is the one that was certified last.
  bool begin(const MotionState& now, const std::vector<Pressures>& to_kpa,
             std::optional<std::size_t> first, const Plan* of);
  PressureBox box_for(const Plan& plan) const;

  const ArmDescription& arm_;
  MotionModel model_;
  Environment environment_;  // all motions start elsewhere, and end in the goal that each brings
  double clearance_m_;
  std::vector<PressureLimits> limits_;
  PlanCheck check_;
  std::optional<Motion> last_;
};

}  // namespace limber
