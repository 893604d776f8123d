#include "limber/sim/misassembly.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/sim/driver_server.hpp"

namespace limber {

namespace {

constexpr double kLongestSeenS = 1.0;  // more than any latency that is sampled
constexpr std::uint64_t kHeightStream = 0x3d;

constexpr double kMaxDrawnZeroKpa = 1.5;  // less than what a vented arm may read
constexpr double kMaxDrawnPositionM = 3.0;
constexpr double kMaxOffsetM = 0.008;
constexpr double kMaxHeightM = 0.03;  // of a body above its plate
constexpr double kMaxOffsetRad = 0.5;
constexpr double kMaxLatencyS = 0.15;
constexpr double kMaxDrawnClockS = 1000.0;

std::vector<WireChannel> drawn_channels(int count, RandomStream& stream) {
  auto channels = mapped<WireChannel>(count, [&](int s) {
    return WireChannel{s, stream.index(2) == 0 ? 1.0 : -1.0};
  });
  for (std::uint32_t s = std::uint32_t(count); s > 1; --s) {
    std::swap(channels[s - 1].channel, channels[stream.index(s)].channel);
  }
  return channels;
}

/// Every rotation is as likely as any other.
Eigen::Quaterniond drawn_rotation(RandomStream& stream) {
  Eigen::Vector4d q;
  for (double& number : q) {
    number = stream.normal();
  }
  return Eigen::Quaterniond(q).normalized();
}

// In the order of ServerFaultKind.
constexpr std::array kFaultNames = {"late", "repeat", "old",  "half",   "huge",  "nan",
                                    "size", "clock",  "die",  "hang",   "flood", "hello",
                                    "over", "stuck",  "jump", "sealed", "rise",  "release"};
static_assert(kFaultNames.size() == std::size_t(ServerFaultKind::release) + 1);

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
    const auto then =
        std::ranges::lower_bound(seen_, then_s, {}, [](const auto& one) { return one.first; });
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

Misassembly draw_misassembly(const ArmDescription& arm, std::uint64_t seed) {
  constexpr std::array<double, 3> kUnits = {1.0, 0.01, 0.001};
  RandomStream stream(seed, 0);
  Misassembly result;
  result.truth = identity_calibration(arm);
  result.truth.valves = drawn_channels(arm.channel_count(), stream);
  result.truth.sensors = drawn_channels(arm.channel_count(), stream);
  for (double& zero : result.truth.zero_kpa) {
    zero = stream.uniform(-kMaxDrawnZeroKpa, kMaxDrawnZeroKpa);
  }
  TrackerCalibration tracker;
  tracker.metres_per_unit = kUnits[stream.index(3)];
  tracker.radians_per_unit = stream.index(2) == 0 ? 1.0 : std::numbers::pi / 180.0;
  tracker.mirrored = stream.index(2) == 0;
  tracker.base = {stream.uniform(-kMaxDrawnPositionM, kMaxDrawnPositionM),
                  stream.uniform(-kMaxDrawnPositionM, kMaxDrawnPositionM),
                  stream.uniform(-std::numbers::pi, std::numbers::pi)};
  for (int i = 0; i < arm.point_count(); ++i) {
    tracker.marker_offsets.push_back({stream.uniform(-kMaxOffsetM, kMaxOffsetM),
                                      stream.uniform(-kMaxOffsetM, kMaxOffsetM),
                                      stream.uniform(-kMaxOffsetRad, kMaxOffsetRad)});
  }
  result.truth.tracker = tracker;
  result.tracker_latency_s = stream.uniform(0.0, kMaxLatencyS);
  result.truth.clocks.shape_delay =
      TimeInterval{result.tracker_latency_s, result.tracker_latency_s, result.tracker_latency_s};
  result.driver_ahead_s = stream.uniform(-kMaxDrawnClockS, kMaxDrawnClockS);
  result.tracker_ahead_s = stream.uniform(-kMaxDrawnClockS, kMaxDrawnClockS);
  result.truth.clocks.tracker =
      TimeInterval{-result.tracker_ahead_s, -result.tracker_ahead_s, -result.tracker_ahead_s};
  return result;
}

Misassembly draw_misassembly_in_3d(const ArmDescription& arm, std::uint64_t seed) {
  Misassembly result = draw_misassembly(arm, seed);
  TrackerCalibration& tracker = *result.truth.tracker;
  tracker.radians_per_unit = 1.0;  // quaternions have no unit
  RandomStream stream(seed, 1);
  TrackerPlane plane;
  const Eigen::Matrix3d axes = drawn_rotation(stream).toRotationMatrix();
  Eigen::Index largest = 0;
  axes.col(2).cwiseAbs().maxCoeff(&largest);
  plane.x_axis = axes.col(0);
  plane.y_axis = std::copysign(1.0, axes(largest, 2)) * axes.col(1);
  for (double& coordinate : plane.origin) {
    coordinate = stream.uniform(-kMaxDrawnPositionM, kMaxDrawnPositionM) / tracker.metres_per_unit;
  }
  result.body_heights.resize(arm.point_count());
  for (double& height : result.body_heights) {
    height = stream.uniform(0.0, kMaxHeightM) / tracker.metres_per_unit;
    plane.body_rotations.push_back(drawn_rotation(stream));
  }
  tracker.plane = plane;
  return result;
}

const char* to_string(ServerFaultKind kind) {
  return kFaultNames[std::size_t(kind)];
}

ServerFault parse_server_fault(const std::string& text) {
  constexpr double kMaxFrame = 1e6;
  const std::size_t at = text.find('@');
  const std::string name = text.substr(0, at);
  const auto* found = std::ranges::find(kFaultNames, name);
  double frame = -1.0;
  if (at == std::string::npos || found == kFaultNames.end() ||
      !parse_number(text.substr(at + 1), frame) || frame < 0.0 || frame > kMaxFrame ||
      frame != int(frame)) {
    throw InputError(
        fmt::format("--fault {}: expected KIND@FRAME, as in die@12; kinds: {}; frames count from 0",
                    text, fmt::join(kFaultNames, ", ")));
  }
  return {static_cast<ServerFaultKind>(found - kFaultNames.begin()), int(frame)};
}

}  // namespace limber
