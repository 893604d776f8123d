#pragma once

#include <cmath>
#include <deque>
#include <vector>

#include "limber/common/random_stream.hpp"
#include "limber/driver/calibration_log.hpp"
#include "limber/driver/wire_calibration.hpp"
#include "limber/sim/misassembly.hpp"

namespace limber {

/// Two to four segments of random lengths, widths and gaps.
inline ArmDescription arm_of(std::uint64_t seed) {
  ArmDescription arm;
  arm.name = "random";
  arm.frame_rate_hz = 20.0;
  arm.pressure_rate_limit_kpa_per_s = 100.0;
  arm.actuator_radius_m = 0.006;
  RandomStream chance(seed, 7);
  const auto segments = 2 + chance.index(3);
  for (std::uint32_t s = 0; s < segments; ++s) {
    Segment segment;
    segment.length_m = chance.uniform(0.15, 0.3);
    segment.width_m = chance.uniform(0.017, 0.05);
    segment.gaps = 3 + static_cast<int>(chance.index(4));
    segment.pressure_limit_kpa = PressureLimits(100.0);
    arm.segments.push_back(segment);
  }
  return arm;
}

/// What no calibration can put right.
enum class Flaw {
  none,
  crossed_hoses,    ///< the negative sides of channels 0 and 1 are changed over
  dead_channel,     ///< channel 1 moves nothing
  millibar,         ///< readings are ten times too large
  bodies_reversed,  ///< tip first
  bodies_swapped,   ///< two of them
  other_arm,        ///< a third longer
  untracked,
  no_supply,  ///< no channel moves anything
  // Of bodies in 3D:
  lifted,        ///< what bends lifts off the table
  twisted_body,  ///< the last body turns about another axis
  wrong_order,   ///< quaternions with qw first
};

/// An arm of its own kind, with nothing of the virtual arm's: valves of first order, turns that
/// follow pressures with play (friction) and drag the neighbours along, sides that contract unlike.
/// It is put together wrongly, and measured with noise and late.
class SimulatedRig {
 public:
  SimulatedRig(const ArmDescription& arm, const Misassembly& wrong, Flaw flaw, std::uint64_t seed)
      : arm_(arm), wrong_(wrong), flaw_(flaw), chance_(seed, 1), along_m_(rest_positions_m(arm)) {
    const auto n = arm.segments.size();
    pressure_kpa_.assign(n, 0.0);
    setpoint_kpa_.assign(n, 0.0);
    play_rad_.assign(n, 0.0);
    for (std::size_t s = 0; s < n; ++s) {
      gain_.push_back(1.5e-4 / arm.segments[s].width_m * chance_.uniform(0.8, 1.2));
      asymmetry_.push_back(chance_.uniform(-kAsymmetry, kAsymmetry));
    }
    remember();
  }

  CalibrationRig rig() {
    return {[this](const Pressures& setpoint_kpa) { return frame(setpoint_kpa); },
            [this] { settle(); }, [](const std::string&) {}};
  }

  CalibrationFrame frame(const Pressures& on_wire) {
    set(on_wire);
    CalibrationFrame frame;
    frame.setpoint_kpa = on_wire;
    frame.sent_s = time_s_ + chance_.uniform(0.0, 5e-4);
    const double sampled_s = frame.sent_s + chance_.uniform(1e-4, 1e-3);
    frame.received_s = sampled_s + chance_.uniform(2e-4, 2e-3);
    while (time_s_ < sampled_s - 0.5 * kStepS) {
      advance();
    }
    frame.state = seen();
    frame.state.time_s = sampled_s + wrong_.driver_ahead_s;
    if (frame.state.backbone && wrong_.truth.tracker->plane) {
      frame.bodies = bodies(*frame.state.backbone);
      frame.state.backbone.reset();
    }
    if (frame.state.backbone || frame.bodies) {
      frame.state.tracker_s =
          frame.state.time_s - wrong_.tracker_latency_s + wrong_.tracker_ahead_s;
    }
    const double end_s = std::round(frame_end_s_ * 1e3 + 50.0) * 1e-3;
    while (time_s_ < end_s - 0.5 * kStepS) {
      advance();
    }
    frame_end_s_ = end_s;
    return frame;
  }

  /// Shapes of the arm as they are now, without noise and latency; and what the wire says of them.
  Backbone true_backbone() const { return backbone_of(history_.back()); }
  ArmState on_wire(const Backbone& backbone) const {
    ArmState state;
    state.pressure_kpa = Pressures::Zero(arm_.segment_count());
    state.backbone = backbone;
    return wrong_.truth.to_wire(state);
  }

 private:
  static constexpr double kStepS = 0.001;
  static constexpr double kValveS = 0.08;
  static constexpr double kPlayRad = 0.004;
  static constexpr double kDrag = -0.25;
  static constexpr double kContraction = 0.015;  // m per rad of a turn, over the width
  static constexpr double kAsymmetry = 0.05;     // of it, between the sides of a segment
  static constexpr double kNoiseM = 1e-4;
  static constexpr double kNoiseRad = 3e-4;
  static constexpr double kNoiseKpa = 0.02;

  struct Moment {
    double time_s = 0.0;
    std::vector<double> turn_rad;
    std::vector<double> shorter_m;
  };

  void set(const Pressures& on_wire) {
    Pressures wire = on_wire;
    if (flaw_ == Flaw::dead_channel) {
      wire[1] = 0.0F;
    }
    if (flaw_ == Flaw::no_supply) {
      wire.setZero();
    }
    if (flaw_ == Flaw::crossed_hoses) {
      const float a = std::min(wire[0], 0.0F);
      const float b = std::min(wire[1], 0.0F);
      wire[0] += b - a;
      wire[1] += a - b;
    }
    const Pressures kpa = wrong_.truth.from_wire(wire);
    for (std::size_t s = 0; s < setpoint_kpa_.size(); ++s) {
      setpoint_kpa_[s] = kpa[static_cast<Eigen::Index>(s)];
    }
  }

  void advance() {
    for (std::size_t s = 0; s < pressure_kpa_.size(); ++s) {
      pressure_kpa_[s] += (setpoint_kpa_[s] - pressure_kpa_[s]) * kStepS / kValveS;
      const double wanted = -gain_[s] * arm_.segments[s].length_m * 10.0 * pressure_kpa_[s];
      play_rad_[s] = std::clamp(play_rad_[s], wanted - kPlayRad, wanted + kPlayRad);
    }
    time_s_ += kStepS;
    remember();
  }

  void settle() {
    setpoint_kpa_.assign(setpoint_kpa_.size(), 0.0);
    for (int k = 0; k < 500; ++k) {
      advance();
    }
    frame_end_s_ = time_s_;
  }

  void remember() {
    Moment now{time_s_, {}, {}};
    for (std::size_t s = 0; s < play_rad_.size(); ++s) {
      double turn = play_rad_[s];
      if (s > 0) {
        turn += kDrag * play_rad_[s - 1];
      }
      now.turn_rad.push_back(turn);
      const double side = pressure_kpa_[s] > 0.0 ? 1.0 + asymmetry_[s] : 1.0 - asymmetry_[s];
      now.shorter_m.push_back(kContraction * gain_[s] * std::abs(pressure_kpa_[s]) * side);
    }
    history_.push_back(now);
    if (history_.size() > 700) {
      history_.pop_front();
    }
  }

  Backbone backbone_of(const Moment& moment) const {
    Backbone backbone(arm_.point_count(), 3);
    backbone.row(0).setZero();
    double x = 0.0;
    double y = 0.0;
    double theta = 0.0;
    for (int gap = 0; gap + 1 < arm_.point_count(); ++gap) {
      const auto g = static_cast<std::size_t>(gap);
      const auto s = static_cast<std::size_t>(arm_.segment_of_gap(gap));
      const double half =
          0.5 * (along_m_[g + 1] - along_m_[g] - moment.shorter_m[s] / arm_.segments[s].gaps);
      x += half * std::cos(theta);
      y += half * std::sin(theta);
      theta += moment.turn_rad[s] / arm_.segments[s].gaps;
      x += half * std::cos(theta);
      y += half * std::sin(theta);
      backbone.row(gap + 1) << static_cast<float>(x), static_cast<float>(y),
          static_cast<float>(theta);
    }
    return flaw_ == Flaw::other_arm
               ? Backbone(backbone * Eigen::Vector3f(1.33F, 1.33F, 1.0F).asDiagonal())
               : backbone;
  }

  ArmState seen() {
    ArmState state;
    state.pressure_kpa.resize(arm_.segment_count());
    for (int s = 0; s < arm_.segment_count(); ++s) {
      state.pressure_kpa[s] = static_cast<float>(pressure_kpa_[static_cast<std::size_t>(s)] +
                                                 kNoiseKpa * chance_.normal());
    }
    const auto late = static_cast<std::size_t>(std::lround(wrong_.tracker_latency_s / kStepS));
    const std::size_t newest = history_.size() - 1;
    Backbone backbone = backbone_of(history_[newest - std::min(newest, late)]);
    for (Eigen::Index i = 0; i < backbone.rows(); ++i) {
      backbone(i, 0) += static_cast<float>(kNoiseM * chance_.normal());
      backbone(i, 1) += static_cast<float>(kNoiseM * chance_.normal());
      backbone(i, 2) += static_cast<float>(kNoiseRad * chance_.normal());
    }
    state.backbone = backbone;
    state = wrong_.truth.to_wire(state);
    spoil(state);
    return state;
  }

  /// What a tracker in 3D sees of poses in its plane, with noise across the plane too.
  BodyPoses bodies(const Backbone& in_plane) {
    const TrackerCalibration& tracker = *wrong_.truth.tracker;
    const TrackerPlane& plane = *tracker.plane;
    Eigen::VectorXd heights = wrong_.body_heights;
    for (Eigen::Index i = 0; i < heights.size(); ++i) {
      heights[i] += kNoiseM / tracker.metres_per_unit * chance_.normal();
      if (flaw_ == Flaw::lifted) {  // 20 mm at the arm's far end
        heights[i] += 0.02 / tracker.metres_per_unit * std::abs(pressure_kpa_.front()) / 10.0 *
                      double(i) / double(heights.size());
      }
    }
    BodyPoses bodies = bodies_in_space(plane, in_plane, heights);
    const Eigen::Index last = bodies.rows() - 1;
    for (Eigen::Index i = 0; i <= last; ++i) {
      Eigen::Quaterniond rotation = rotation_of(bodies, i);
      for (const Eigen::Vector3d& axis : {plane.x_axis, plane.y_axis}) {
        rotation = Eigen::AngleAxisd(kNoiseRad * chance_.normal(), axis) * rotation;
      }
      if (flaw_ == Flaw::twisted_body && i == last) {
        const double tilt_rad = 0.01 * pressure_kpa_.back();
        rotation = Eigen::AngleAxisd(tilt_rad, plane.x_axis) * rotation;
      }
      bodies.row(i).tail<4>() = rotation.coeffs().transpose();
      if (flaw_ == Flaw::wrong_order) {
        bodies.row(i).tail<4>() << rotation.w(), rotation.x(), rotation.y(), rotation.z();
      }
    }
    return bodies;
  }

  void spoil(ArmState& state) const {
    switch (flaw_) {
      case Flaw::millibar:
        state.pressure_kpa *= 10.0F;
        break;
      case Flaw::bodies_reversed:
        state.backbone = Backbone(state.backbone->colwise().reverse());
        break;
      case Flaw::bodies_swapped:
        state.backbone->row(1).swap(state.backbone->row(state.backbone->rows() - 2));
        break;
      case Flaw::untracked:
        state.backbone.reset();
        break;
      default:
        break;
    }
  }

  ArmDescription arm_;
  Misassembly wrong_;
  Flaw flaw_;
  RandomStream chance_;
  std::vector<double> along_m_;
  std::vector<double> gain_;
  std::vector<double> asymmetry_;
  std::vector<double> pressure_kpa_;
  std::vector<double> setpoint_kpa_;
  std::vector<double> play_rad_;
  std::deque<Moment> history_;
  double time_s_ = 0.0;
  double frame_end_s_ = 0.0;
};

}  // namespace limber
