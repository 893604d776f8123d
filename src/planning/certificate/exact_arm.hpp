#pragma once

#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// The forward model once more, from docs/model.md and nothing else: plain loops in double, with
/// its own no-load arcs, normalisation, layers and backbone layouts. Slow on purpose; the
/// certificate holds the fast one to it. Threads: constant after construction.
class ExactArm {
 public:
  using Shape = std::vector<Pose>;  // one a plate, base first

  /// @param network  null: the no-load model. Borrowed, like the arm.
  ExactArm(const ArmDescription& arm, const CompensationModel* network)
      : arm_(arm), network_(network) {}

  /// B̃ by (3), (4), or by (17) or (18).
  Shape no_load(const std::vector<double>& pressures_kpa) const;

  /// F(q_{t−1}, q_t, B_{t−1}), (5) or (16).
  Shape next(const std::vector<double>& previous_kpa, const std::vector<double>& current_kpa,
             const Shape& previous) const;

 private:
  std::vector<double> network_output(const std::vector<double>& input) const;

  const ArmDescription& arm_;
  const CompensationModel* network_;
};

}  // namespace limber
