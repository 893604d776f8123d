#include "misassembled_wire.hpp"

#include <algorithm>
#include <chrono>

namespace limber {

namespace {

constexpr double kLongestSeenS = 1.0;  // more than any latency that is sampled
constexpr std::uint64_t kHeightStream = 0x3d;

}  // namespace

MisassembledWire::MisassembledWire(std::optional<Misassembly> misassembly, VirtualArm& arm,
                                   const VirtualArmOptions& options, bool real_time)
    : misassembly_(std::move(misassembly)),
      options_(options),
      chance_(options.seed, kHeightStream),
      real_time_(real_time) {
  if (misassembly_) {
    seen_.emplace_back(0.0, arm.true_backbone());
    arm.set_observer([this](double time_s, const BackboneD& backbone) {
      seen_.emplace_back(time_s, backbone);
      while (seen_.front().first < time_s - kLongestSeenS) {
        seen_.pop_front();
      }
    });
  }
}

Pressures MisassembledWire::from_wire(const Pressures& setpoint_kpa) const {
  return misassembly_ ? misassembly_->truth.from_wire(setpoint_kpa) : setpoint_kpa;
}

ArmState MisassembledWire::to_wire(ArmState state) const {
  if (!misassembly_) {
    return state;
  }
  if (state.backbone) {  // with the noise that it was measured with
    const double then_s = seen_.back().first - misassembly_->tracker_latency_s;
    const auto then = std::lower_bound(seen_.begin(), seen_.end(), then_s,
                                       [](const auto& one, double t) { return one.first < t; });
    *state.backbone += (then->second - seen_.back().second).cast<float>();
  }
  state = misassembly_->truth.to_wire(std::move(state));
  if (real_time_) {
    state.time_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  state.time_s += misassembly_->driver_ahead_s;
  if (state.backbone) {
    state.tracker_s =
        state.time_s - misassembly_->tracker_latency_s + misassembly_->tracker_ahead_s;
  }
  return state;
}

std::vector<PressureLimits> MisassembledWire::to_wire(
    std::vector<PressureLimits> limits_kpa) const {
  return misassembly_ ? misassembly_->truth.to_wire(limits_kpa) : limits_kpa;
}

std::optional<BodyPoses> MisassembledWire::bodies(const ArmState& on_wire) {
  if (!misassembly_ || !misassembly_->truth.tracker->plane || !on_wire.backbone) {
    return std::nullopt;
  }
  const TrackerCalibration& tracker = *misassembly_->truth.tracker;
  Eigen::VectorXd heights = misassembly_->body_heights;
  for (double& height : heights) {
    height += options_.noise_m / tracker.metres_per_unit * chance_.normal();
  }
  BodyPoses bodies = bodies_in_space(*tracker.plane, *on_wire.backbone, heights);
  for (Eigen::Index i = 0; i < bodies.rows(); ++i) {
    const Eigen::Vector3d tilt = options_.noise_rad * (chance_.normal() * tracker.plane->x_axis +
                                                       chance_.normal() * tracker.plane->y_axis);
    const Eigen::Quaterniond rotation =
        Eigen::Quaterniond(Eigen::AngleAxisd(tilt.norm(), tilt.stableNormalized())) *
        rotation_of(bodies, i);
    bodies.row(i).tail<4>() = rotation.coeffs().transpose();
  }
  return bodies;
}

}  // namespace limber
