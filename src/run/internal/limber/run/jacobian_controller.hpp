#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "limber/arm/no_load_model.hpp"
#include "limber/run/controller.hpp"

namespace limber {

/// What tunes a JacobianController (docs/experiments.md, Controllers).
struct JacobianGains {
  double proportional = 0.0;    ///< share of the error's change that is taken back in each frame
  double integral_per_s = 0.0;  ///< of the error
  double damping_m_per_kpa = 1e-3;  ///< λ of the damped least squares, > 0
  bool operator==(const JacobianGains&) const = default;
};

/// "jacobian", and gains if they are not the defaults:
/// "jacobian,proportional=0.2,integral=1,damping=0.001".
/// @return none if `text` names another controller
/// @throws InputError naming the gain, what was found and what is allowed.
std::optional<JacobianGains> parse_jacobian(const std::string& text);

/// Follows a plan with feedback from the tip: the plan's set points, and in each frame a correction
///
///   Δq = Δq_plan + Jᵀ(J Jᵀ + λ² I)⁻¹ (K_p (Δr − Δy) + K_i e T),   e = r − y,
///
/// where y is the measured tip, r the tip that the plan predicts in the frame that y shows, and
/// after its end the goal. That is a PI controller in velocity form, so that limits do not wind it
/// up. J is the no-load model's Jacobian at the set points. The heading is a third row where the
/// goal asks for one, in metres by the goal's tolerances. It knows no obstacle. Frames without
/// tracking take the plan's set points alone.
///
/// Ends 10 s after the plan, or after 1 s within 1 mm of the goal.
class JacobianController final : public Controller {
 public:
  /// Borrows the plan.
  JacobianController(const ArmDescription& arm, const Plan& plan, const PoseGoal& goal,
                     const JacobianGains& gains);

  Decision step(const Moment& now) override;

 private:
  Eigen::VectorXd in_metres(const Pose& pose) const;
  Eigen::VectorXd predicted(std::size_t frame) const;
  Eigen::VectorXd reference(std::size_t frame) const;
  Eigen::MatrixXd no_load_jacobian() const;
  Eigen::VectorXd feedback(const Eigen::VectorXd& tip, std::size_t seen) const;
  bool has_ended(const std::optional<Eigen::VectorXd>& error);
  Eigen::VectorXd correction(const Eigen::VectorXd& velocity) const;

  ArmDescription arm_;
  NoLoadModel model_;
  const Plan& plan_;
  PoseGoal goal_;
  JacobianGains gains_;
  Eigen::Index rows_;
  std::size_t frame_ = 0;  // of the plan; beyond its end, frames since the start
  int settled_ = 0;        // frames within the tolerance, in a row
  Pressures setpoint_kpa_;
  std::optional<Eigen::VectorXd> tip_before_;  // in the frame before; none: it was not seen
};

}  // namespace limber
