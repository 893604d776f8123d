#pragma once

#include <array>
#include <optional>
#include <vector>

#include "exact_network.hpp"
#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// The forward model once more, written from docs/model.md alone: in double, with its own no-load
/// arcs, normalisation, layers and backbone layouts. The certificate checks the fast model against
/// it. Threads: constant after construction.
class ExactArm {
 public:
  using Shape = std::vector<Pose>;  // one per plate, base first

  /// @param network  null: the no-load model. Copied, while the arm is borrowed.
  ExactArm(const ArmDescription& arm, const CompensationModel* network);

  /// B̃ by (3), (4), or by (17) or (18).
  Shape no_load(const std::vector<double>& pressures_kpa) const;

  /// Two successive shapes: B_{t−2}, which the network may read, and B_{t−1}.
  struct Past {
    const Shape* before;
    const Shape* previous;
  };

  /// F(q_{t−1}, q_t, B_{t−1}), (5) or (16), kept within (20), of an arm that stood still.
  Shape next(const std::vector<double>& previous_kpa, const std::vector<double>& current_kpa,
             const Shape& previous) const;

  /// F(q_{t−1}, q_t, B_{t−2}, B_{t−1}) for two pasts that the same pressures move, in little more
  /// time than for one.
  std::array<Shape, 2> next_two(const std::vector<double>& previous_kpa,
                                const std::vector<double>& current_kpa,
                                const std::array<Past, 2>& past,
                                ExactNetwork::Workspace& workspace) const;

 private:
  const ArmDescription& arm_;
  BackboneLayout layout_ = BackboneLayout::gap_poses;
  OutputForm form_ = OutputForm::compensation;
  bool reads_velocity_ = false;
  std::optional<GapBounds> bounds_;
  std::optional<ExactNetwork> network_;  // none: no load
};

}  // namespace limber
