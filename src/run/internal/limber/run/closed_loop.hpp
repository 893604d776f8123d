#pragma once

#include <cstdint>
#include <memory>

#include "limber/forward/error_room.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/run/executor.hpp"
#include "limber/run/replanner.hpp"

namespace limber {

struct ClosedLoopSettings {
  /// Plans from rest, after a motion.
  ReplannerSettings corrections = {};
  /// Model queries of a search in mid-motion; its result is waited for during one frame: see
  /// queries_within. 0: the arm is neither led nor guided while it moves.
  std::uint64_t motion_queries = 2000;
  /// A moving arm that is not tracked for longer than that is stopped. [s], ≥ 0.
  double blind_s = 0.5;
};

/// The whole closed loop (docs/planning.md, Closed loop): in each frame of a motion the state is
/// corrected by what is measured, the arm is led along its plan, and what is left of that is
/// replaced where it is no longer any good; then the tip is led into the goal, and corrections from
/// rest follow.
///
/// An arm that was never tracked runs open loop. Borrows arm, model and environment.
class ClosedLoop final : public PlanSource {
 public:
  ClosedLoop(const ArmDescription& arm, const MotionModel& model, const Environment& environment,
             const ErrorRoom& room, const ClosedLoopSettings& settings, std::uint64_t seed);
  ~ClosedLoop() override;

  void observe(const Pressures& setpoint_kpa, const ArmState& state) override;
  FrameSetpoint setpoint(const Plan& plan, std::size_t frame, std::size_t next) override;
  bool may_hold() override;
  std::function<MotionAdvice()> advise(const Plan& plan, std::size_t next) override;
  bool may_go_on(const Plan& plan, std::size_t frame, const ArmState& state) override;
  std::optional<Plan> next(const Plan& plan, std::size_t frame, const ArmState& state) override;

  void obstacle_appeared(const Environment& now) override;

 private:
  struct Motion;

  Pressures led_setpoint(const Plan& plan, std::size_t frame, std::size_t next);

  std::unique_ptr<Motion> motion_;
};

/// Queries of the model that a search makes in `seconds` on one thread, measured on this machine
/// now, in steps of 100, at least as many. Pass what it says on to later runs that are to be the
/// same.
std::uint64_t queries_within(double seconds, const ArmDescription& arm, const MotionModel& model);

/// Of a frame, for a search in mid-motion. [s]
inline constexpr double kMotionSearchS = 0.02;

}  // namespace limber
