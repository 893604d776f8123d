#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/driver/calibration_log.hpp"
#include "limber/driver/wire_calibration.hpp"

namespace limber {

/// What no log can tell. A mirrored tracker with all sides swapped reads the same: one of the first
/// two says which it is.
struct OperatorAnswer {
  std::optional<bool> mirrored;     ///< whether the tracker's y points to the right of its x
  std::optional<bool> bends_right;  ///< which way the arm bent in the timing step, seen from above
  /// Where the base's marker body sits in frame B as built; none: like the others, about there.
  std::optional<Eigen::Vector2d> base_marker_m;
};

/// What a calibration has to be known to, or it is refused: half widths of 95 % intervals.
struct CalibrationTolerance {
  double position_m = 0.005;
  double heading_rad = 0.01;
};

struct CalibrationEstimate {
  WireCalibration calibration;
  std::string refusal;  ///< why there is none, with what would fit; empty where there is one
};

/// A pure function of the log. @pre `answer` says which way.
CalibrationEstimate estimate_calibration(const ArmDescription& arm, const CalibrationLog& log,
                                         const OperatorAnswer& answer,
                                         const CalibrationTolerance& tolerance = {});

}  // namespace limber
