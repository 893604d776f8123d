#pragma once
// For those who check plans.

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// One thing that is wrong with a plan.
struct CertificateFailure {
  std::string check;  ///< "limits", "rate", "start", "waypoints", "cost", "hold", "valves",
                      ///< "model", "collision", "goal", "claims", "tube", "seal", "sizes" or
                      ///< "unfinished"
  int frame = -1;     ///< the first one that fails; −1 if no frame is to blame
  std::string message;
};

/// Result of an independent second check of a plan (docs/planning.md, Certificate).
struct Certificate {
  std::vector<CertificateFailure> failures;  ///< empty: certified
  /// Lower bound of the moving arm's distance from an obstacle, at most kClearanceToleranceM below
  /// the true distance; +∞ without obstacles.
  double clearance_m = std::numeric_limits<double>::quiet_NaN();
  int clearance_frame = -1;  ///< the frame that the motion there leads to, 0 the start; −1: none
  int clearance_gap = -1;    ///< between plates gap and gap + 1, from 0 at the base
  int clearance_obstacle = -1;   ///< index in the environment's list
  double max_deviation_m = 0.0;  ///< of a plate, own simulation against the stored backbone
  double max_heading_deviation_rad = 0.0;
  /// The same as max_deviation_m, but with each frame simulated from the stored one before it. If
  /// this is rounding and the other is not, the plan is not at fault: the model amplifies rounding
  /// along it, and nothing can be said about where the arm ends.
  double max_step_deviation_m = 0.0;
  /// Of a predicted pressure, own simulation of the valves against the stored one.
  double max_pressure_deviation_kpa = 0.0;
  double cost_kpa = 0.0;
  double max_step_kpa = 0.0;  ///< of a pressure in one frame
  double goal_distance_m =
      std::numeric_limits<double>::quiet_NaN();  ///< of the own simulation's last tip
  double goal_orientation_rad = 0.0;             ///< 0 if the goal asks for none
  int frames = 0;
  /// True if it was given up before everything was checked; then "unfinished" is the last of the
  /// failures. What was found until then is valid, and what was not checked has no figure.
  bool unfinished = false;

  bool certified() const { return failures.empty(); }

  static constexpr double kDeviationM = 1e-4;  ///< allowed at every plate of every frame
  static constexpr double kHeadingDeviationRad = 1e-3;
  static constexpr double kPressureDeviationShare = 1e-5;  ///< of the limit: of every pressure
  static constexpr double kSettledShare = 0.01;   ///< of the limit: what the hold has to settle to
  static constexpr double kMinClearanceM = 1e-4;  ///< even where no margin was asked for
  static constexpr double kClearanceToleranceM = 2e-5;
};

/// Certifies plans for one problem without any of the planner's code. It has its own valves and its
/// own forward model in double precision, run open loop from the environment's start through the
/// stored set points, and its own swept distance (branch and bound over time and arc length). It
/// checks limits, rate, frame rule, cost, hold and goal from their definitions, and judges
/// collision and goal on its own simulation.
///
/// Threads: constant after construction; share it freely.
class Certifier {
 public:
  /// Borrows all its arguments. Hashes, weights and obstacles are prepared here, so they must not
  /// change.
  /// @param network  the plans' model; null: the no-load model alone
  /// @param valves   the valves between set points and pressures, never taken from a plan; ideal
  ///                 ones for plans without valves
  Certifier(const ArmDescription& arm, const CompensationModel* network,
            const ValveParameters& valves, const Environment& environment);
  Certifier(Certifier&&) noexcept;
  Certifier& operator=(Certifier&&) noexcept;
  ~Certifier();

  /// @param give_up  called so often that the certificate ends within 5 ms after it turns true, in
  ///                 any environment; the result is then `unfinished`. Empty: never
  /// @throws InputError if the plan was made for another arm, other valves or another
  /// environment (hashes in the message), if the network or the valves are of another arm, or of an
  /// arm in space. Everything else is a failure in the result.
  /// @throws Interrupted if a signal comes while it looks for collisions.
  Certificate certify(const Plan& plan, const std::function<bool()>& give_up = {}) const;

  /// Hash of the environment, which plans have to state.
  const std::string& environment_hash() const;

 private:
  struct Problem;
  class Certification;

  void require_plan_of_problem(const Plan& plan) const;

  std::unique_ptr<const Problem> problem_;
};

/// Certifies one plan with a Certifier of its own, at the rate that the plan was asked to keep if
/// that is below the arm's (arm/arm_identity.hpp). @throws InputError as Certifier::certify.
Certificate certify(const Plan& plan, const ArmDescription& arm, const CompensationModel* network,
                    const ValveParameters& valves, const Environment& environment);

}  // namespace limber
