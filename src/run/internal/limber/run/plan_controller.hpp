#pragma once

#include <chrono>
#include <list>
#include <memory>
#include <optional>
#include <string>

#include "limber/run/controller.hpp"
#include "limber/run/executor.hpp"

namespace limber {

/// How far a plan has been followed. What is sent may differ from the plan's own set points; the
/// plan stays as it was certified.
struct PlanProgress {
  const Plan& plan;
  std::size_t frame;          ///< of the plan, sent last or about to be
  const Pressures& sent_kpa;  ///< in that frame

  /// Of a frame: what was sent, or what the plan has.
  const Pressures& setpoint_kpa(std::size_t k) const {
    return k == frame ? sent_kpa : plan.frames[k].setpoint_kpa;
  }
};

/// A plan that followed another one, and what it was certified for: where the arm was, the
/// obstacles that were known, the goal that it was led to.
struct FollowedPlan {
  Plan plan;
  Environment environment;
};

/// What an arm in motion does after its next frame.
struct MotionAdvice {
  enum class Kind {
    go_on,  ///< follows the plan: its own, or another one
    wait,   ///< holds its set points for a frame
    stop    ///< holds them, and leaves the plan
  };
  Kind kind = Kind::go_on;
  /// To go on along, if not along its own: it starts at the set points of that next frame.
  std::optional<FollowedPlan> plan = std::nullopt;
  std::string reason = {};    ///< of a stop
  bool has_searched = false;  ///< for another plan, in vain or not
};

/// What is sent in a frame of a plan.
struct FrameSetpoint {
  Pressures kpa;
  /// Of the plan: the one that was asked for, a later one, or the one commanded last while the plan
  /// waits.
  std::size_t frame;
  /// Whether it begins a motion that is certified from where the arm is, as far as it is looked at.
  bool is_certified = true;
};

/// Controllers that follow plans: a plan's frames, then its hold, then the plan after it:
///
///   moving → holding → asking → moving …                                                the end
///      └→ halted, held 0.3 s → asking → held for all of the hold → asking once more ─────┘
///
/// The plan is followed as it stands: open loop. What derives from this says how it differs:
/// other set points, advice in motion, whether to go on, plans after the first. Where two of its
/// functions are asked in one frame, it is in the order of their declaration.
class PlanController : public Controller {
 public:
  /// @throws InputError the second time: its state is that of the first run.
  void begin(const RunStart& start) override;
  Decision step(const Moment& now) final;
  void held() override { is_late_ = advised_ != nullptr; }
  bool plans_again() const override { return true; }
  void report(ExecutionResult& result) const override;
  /// All after the first.
  const std::list<FollowedPlan>& further_plans() const { return plans_; }

 protected:
  /// What has been answered counts for nothing: it was for other obstacles. It is asked again.
  /// @return whether a plan to go on with was among it. @pre nothing is being worked out
  bool forget_answers() {
    PlanController::held();
    const bool had_plan = found_ && found_->has_value();
    found_ = nullptr;
    return had_plan;
  }
  /// Told of every frame, first of the start; and whether a question is being worked out.
  virtual void observe(const Moment& now) { (void)now; }
  /// Whether the rest of the plan may be followed; asked after each of its frames but the last.
  /// Where not, the arm holds where it is and `next` is asked.
  /// @param seen  frame of the plan that the arm's state shows
  virtual bool may_go_on(const Plan& /*plan*/, std::size_t /*seen*/, const ArmEstimate& /*arm*/) {
    return true;
  }
  /// Set points to send in frame `next` of the plan, within the limits and the frame rule. Asked
  /// for each frame of a plan, and while the arm waits in one, is halted or holds.
  /// @param next  the one after `at.frame`, or that one where the arm is to stay
  virtual FrameSetpoint setpoint(const PlanProgress& at, std::size_t next,
                                 const ArmEstimate& /*arm*/) {
    return {at.setpoint_kpa(next), next};
  }
  /// Asked before each frame of a motion, whose set points `at.sent_kpa` are then sent without
  /// waiting for the answer: it takes effect in the frame after that one, or never if it comes
  /// later. Empty: the arm goes on.
  virtual std::function<MotionAdvice()> advise(const PlanProgress& /*at*/,
                                               const ArmEstimate& /*arm*/) {
    return {};
  }
  /// Whether an arm that has to hold its set points, as a plan from there is being made, does
  /// something certified, as far as it is looked at. Asked for each such frame.
  virtual bool may_hold(const ArmEstimate& /*arm*/) { return true; }

  using NextPlan = std::function<std::optional<FollowedPlan>()>;
  /// The plan to follow from here on, for an arm that has held the set points of a frame for the
  /// hold, or 0.3 s where it was halted: the last frame, or the one after which it was not allowed
  /// to go on. It starts there. None ends the run; an empty question is one for none.
  virtual NextPlan next(const PlanProgress& /*at*/, const ArmEstimate& /*arm*/) { return {}; }
  /// `next` was answered; before that is followed.
  virtual void take_next(ArmEstimate& /*arm*/) {}

 private:
  enum class Phase { moving, holding, waiting_for_sight, asking };
  struct Advised {
    MotionAdvice advice;
    double took_s = 0.0;
  };

  bool is_at_end() const { return frame_ + 1 == plan_->frames.size(); }
  PlanProgress progress() const { return {*plan_, frame_, sent_kpa_}; }
  Decision sent(const Pressures& setpoint_kpa, bool is_certified);
  Decision move(const ArmEstimate& arm);
  void end_frame(const Moment& now);
  void drop_late_advice(bool is_thinking);
  MotionAdvice take_answer(bool is_timed);
  void take(MotionAdvice advice);
  Decision hold_frame(const ArmEstimate& arm);
  Decision hold_still(const ArmEstimate& arm);
  void begin_hold();
  Decision ask(const ArmEstimate& arm);
  std::optional<Decision> end_asking(const Moment& now);
  Decision end() const;
  void go_over_to(FollowedPlan next, const std::string& name);

  std::optional<RunStart> run_;
  std::list<FollowedPlan> plans_;  // those after the first
  const Plan* plan_ = nullptr;     // the one that is followed
  std::size_t frame_ = 0;          // the last one of it that was commanded
  Pressures sent_kpa_;             // in that frame

  Phase phase_ = Phase::moving;
  bool goes_on_ = true;         // along the plan
  bool waits_ = false;          // in the frame that is next
  bool is_in_frame_ = false;    // of a motion, which was sent
  std::size_t next_frame_ = 0;  // that one
  bool halted_ = false;
  int held_ = 0;               // frames of the hold that are over
  double hold_until_s_ = 0.0;  // since the hold began
  int after_end_ = 0;          // frames after the plan's end, in which its last ones are seen
  int blind_ = 0;              // frames waited for the arm to be tracked
  bool asks_again_ = false;
  bool begins_at_rest_ = false;
  int motion_ = 0;
  int first_motion_ = 0;     // of the plan that is followed
  std::string stop_reason_;  // of the plan that was left last

  std::shared_ptr<std::optional<Advised>> advised_;     // being worked out; none: nothing is
  bool is_late_ = false;                                // that one
  std::shared_ptr<std::optional<FollowedPlan>> found_;  // by `next`

  int replans_ = 0;
  int switches_ = 0;
  int waited_ = 0;
  int halts_ = 0;
  int frames_not_certified_ = 0;
  AdviceTimes times_;
};

/// A plan's frames as they stand, then its hold.
class OpenLoop final : public PlanController {
 public:
  bool plans_again() const override { return false; }
};

}  // namespace limber
