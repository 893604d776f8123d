#pragma once
// For those who write a controller.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/run/arm_driver.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// Where a start in motion is: what MotionState holds, as an environment says it.
ArmStart start_at(const MotionState& state);

class RestMiss;

/// What a model has missed since a motion began, as far as it was measured: measured beside
/// predicted from the frame before. Zero where nothing was measured.
struct ModelMiss {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();  ///< of the tip over all frames: x, y, theta
  double travelled_kpa = 0.0;                     ///< Σ|Δp| of the set points meanwhile
  /// Per plate, the most that a forecast of 0.5 s was off recently: it counts a tenth less with
  /// every frame. Empty before anything was compared. [m]
  Eigen::VectorXd plate_m;
};

/// A segment whose measured pressure falls short of what its valves would make of its set points.
struct PressureLoss {
  int segment = 0;         ///< in space, chamber
  double share = 0.0;      ///< of that pressure, missing
  double noticed_s = 0.0;  ///< since the run's start
};

/// "segment 1 lost 10 % of its pressure, noticed after 2.3 s: …"
std::string to_text(const PressureLoss& loss);

/// What an estimate predicts with.
struct EstimateModel {
  const MotionModel* model = nullptr;  ///< none: what is measured is all that is known; borrowed
  /// Where the arm starts, if measured shapes count as much as their noise allows beside predicted
  /// ones; none: shapes are taken as they are measured.
  std::optional<Backbone> filter_from;
};

/// The one place that knows where the arm is: what was measured and by how many frames that is
/// behind the set points, whether the arm is seen, whether it moves or rests and where, and, with a
/// model, the arm's state now and what the model misses.
///
/// With a model, the state is predicted from frame to frame and corrected by what is measured.
/// Pressures are measured in each frame; a frame without a backbone is bridged by prediction.
/// Behind ideal valves pressures are the set points, as plans for such a model have it. Where a
/// driver's states are behind its set points, as they say themselves or their pressures show, the
/// model says what these lead to.
///
/// Threads: one estimate, one thread. One query per frame, one for each frame that states are
/// behind, and one for each of the forecasts that are followed (0.5 s).
class ArmEstimate {
 public:
  /// After so long without a shape nobody knows where the arm is. [s]
  static constexpr double kUnknownAfterS = 0.25;

  /// @throws InputError for a model of another arm.
  explicit ArmEstimate(const ArmDescription& arm, const EstimateModel& with = {});
  ~ArmEstimate();
  ArmEstimate(const ArmEstimate&) = delete;
  ArmEstimate& operator=(const ArmEstimate&) = delete;

  /// Takes in a frame. The first call is the start, where the arm has long had these set points.
  void observe(const Pressures& setpoint_kpa, const ArmState& measured);

  /// Set points observed after the start.
  int frames() const;
  /// Set points of the frame observed last.
  const Pressures& setpoint_kpa() const;
  /// As the driver said it, `lag_frames` behind those set points.
  const ArmState& measured() const;
  /// Frames by which what is measured is behind what was commanded: said (ArmState::setpoint_kpa)
  /// or, with a model, shown by the pressures.
  int lag_frames() const;
  /// Frames since the arm was tracked last.
  int frames_unseen() const;

  /// The mean shape of an arm at rest: what was measured in the last 0.5 s, one frame after
  /// another, if no plate was farther than 3 mm from its mean, and the means of both halves differ
  /// by at most 1 mm. Else none.
  std::optional<Backbone> rest() const;

  /// Whether there is a model and the arm was tracked at least once; before that there is no state.
  bool has_state() const;
  /// After the set points that were observed last. @pre has_state()
  const MotionState& state() const;
  /// In the frame that `measured` shows, `lag_frames` earlier. @pre has_state()
  const MotionState& shown_state() const;
  /// Whether friction and valves still carry the arm on: it came by more than 0.3 % of its length
  /// in the frame observed last. Where it is now says little of where it ends.
  bool is_moving() const;

  /// In the order in which they were noticed; none without a model, or behind ideal valves.
  const std::vector<PressureLoss>& pressure_losses() const;

  /// Of the frames since the last `forget_miss`.
  const ModelMiss& miss() const;
  /// Where the tip is likely to be so many frames ahead, less where the model has it: what
  /// forecasts of 0.25 s have missed, low-passed, at most 5 cm, in proportion to how far ahead it
  /// is, twice as much at most. Without a network it is the same in the next frame. Zero without a
  /// model.
  Eigen::Vector2d missed_ahead_m(int frames) const;
  /// A motion begins: what was missed before it does not count any more, but for what is missed of
  /// an arm at rest.
  void forget_miss();
  /// Of an arm at rest, as those who plan from there have found it.
  const RestMiss& rest_miss() const;
  void take(const RestMiss& found);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace limber
