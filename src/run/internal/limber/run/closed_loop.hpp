#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "limber/forward/error_room.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/run/plan_controller.hpp"
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
  /// Of a model that `adapt` made from a family: which arm of it this is, is followed while it
  /// moves.
  bool adapts = true;
};

/// The whole closed loop (docs/planning.md, Closed loop): in each frame of a motion the state is
/// corrected by what is measured, the arm is led along its plan, and what is left of that is
/// replaced where it is no longer any good. Corrections from rest follow.
///
/// An arm that was never tracked runs open loop. Borrows model and environment. One run.
class ClosedLoop final : public PlanController {
 public:
  /// @throws InputError if the model is of another arm, or has no network: it errs as much after a
  /// correction as before.
  ClosedLoop(const ArmDescription& arm, const MotionModel& model, const Environment& environment,
             const ErrorRoom& room, const ClosedLoopSettings& settings, std::uint64_t seed);
  ~ClosedLoop() override;

  EstimateModel estimate_with() const override;
  void begin(const RunStart& start) override;
  void held() override;
  void obstacle_appeared(const Environment& now) override;
  std::string take_notice() override;
  void report(ExecutionResult& result) const override;

 private:
  void observe(const Moment& now) override;
  bool may_go_on(const Plan& plan, std::size_t seen, const ArmEstimate& arm) override;
  FrameSetpoint setpoint(const PlanProgress& at, std::size_t next, const ArmEstimate& arm) override;
  std::function<MotionAdvice()> advise(const PlanProgress& at, const ArmEstimate& arm) override;
  bool may_hold(const ArmEstimate& arm) override;
  NextPlan next(const PlanProgress& at, const ArmEstimate& arm) override;
  void take_next(ArmEstimate& arm) override;

  struct Motion;

  Pressures led_setpoint(const PlanProgress& at, std::size_t next, const ArmEstimate& arm);

  std::unique_ptr<Motion> motion_;
};

/// Queries of the model that a search makes in `seconds` on one thread, measured on this machine
/// now, in steps of 100, at least as many. Pass what it says on to later runs that are to be the
/// same.
std::uint64_t queries_within(double seconds, const ArmDescription& arm, const MotionModel& model);

/// Of a frame, for a search in mid-motion. [s]
inline constexpr double kMotionSearchS = 0.02;

}  // namespace limber
