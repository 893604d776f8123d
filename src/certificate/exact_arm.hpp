#pragma once

#include <array>
#include <optional>
#include <vector>

#include "exact_network.hpp"
#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// The valve model once more, written from docs/valves.md alone: in double precision and continuous
/// time, from one event to the next. It is slow on purpose; the certificate checks the fast model
/// against it.
class ExactValves {
 public:
  using Configurations = std::vector<std::vector<double>>;  ///< one per frame, n numbers

  /// Borrows both.
  ExactValves(const ArmDescription& arm, const ValveParameters& valves)
      : arm_(arm), valves_(valves) {}

  /// Pressures at the end of each frame. Frame 0 is the start; frame k's set points are commanded
  /// at its beginning, (k − 1)/rate.
  /// @param start_kpa   pressures at the end of frame 0: of an arm at rest its set points
  /// @param before_kpa  set points of the frames before frame 0, the newest first; the oldest of
  ///                    all that are given were in force for ever
  Configurations pressures_along(const Configurations& setpoints_kpa,
                                 const std::vector<double>& start_kpa,
                                 const Configurations& before_kpa) const;

  /// The same of an arm that has settled at its first set points.
  Configurations pressures_along(const Configurations& setpoints_kpa) const {
    return pressures_along(setpoints_kpa, setpoints_kpa.front(), {});
  }

 private:
  std::vector<double> segment_pressures(const SegmentValves& valves, double start_kpa,
                                        std::size_t before,
                                        const std::vector<double>& setpoints_kpa) const;

  const ArmDescription& arm_;
  const ValveParameters& valves_;
};

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

  /// F(q_{t−1}, q_t, B_{t−2}, B_{t−1}), (5) or (16), kept within (20), for two pasts that the same
  /// pressures move, in little more time than for one.
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
