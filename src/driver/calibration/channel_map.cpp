#include "channel_map.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/names.hpp"
#include "limber/common/mapped.hpp"
#include "limber/data/assignment.hpp"
#include "limber/driver/driver_check.hpp"

namespace limber {

namespace {

constexpr double kNoiseFactor = 6.0;  // standard deviations of a mean: more is motion
constexpr double kMinTurnRad = 0.002;
constexpr double kClearFactor = 1.25;  // what moves most moves so much more than the next
constexpr double kReadingMeanS = 0.5;

/// What one side of a channel moved: the segment that turned most, and to which side.
struct SideMoved {
  int segment = 0;
  double side = 1.0;  ///< 1: bent to the right, as positive pressures do
};

const char* side_name(double side) {
  return side > 0.0 ? "right" : "left";
}

/// Turn of each segment: of the heading at its end against that at its beginning.
std::vector<double> turns_of(const ArmDescription& arm, const PulsePoses& pulse) {
  const Eigen::VectorXd turned = (pulse.held.pose - pulse.before.pose).col(2);
  std::vector<double> turns;
  Eigen::Index plate = 0;
  for (const Segment& segment : arm.segments) {
    turns.push_back(turned[plate + segment.gaps] - turned[plate]);
    plate += segment.gaps;
  }
  return turns;
}

double magnitude(double value) {
  return std::abs(value);
}

/// Index of the largest |value|; −1 where another is about as large.
int clear_largest(const std::vector<double>& values) {
  const auto largest = std::ranges::max_element(values, {}, magnitude);
  for (auto it = values.begin(); it != values.end(); ++it) {
    if (it != largest && kClearFactor * std::abs(*it) > std::abs(*largest)) {
      return -1;
    }
  }
  return int(largest - values.begin());
}

/// Throws where a pulse turned no segment.
void require_motion(const CalibrationPulse& pulse, const PulsePoses& poses,
                    const std::vector<double>& turns, double noise_rad) {
  const double min_rad =
      std::max(kMinTurnRad, kNoiseFactor * noise_rad / std::sqrt(poses.held.count));
  const double largest = std::abs(*std::ranges::max_element(turns, {}, magnitude));
  if (largest < min_rad) {
    throw CalibrationRefused(fmt::format(
        "channel {} at {:.3g} kPa moved nothing: no segment turned by more than {:.4f} rad. Check "
        "supply, hose and valve",
        pulse.channel, pulse.setpoint_kpa, largest));
  }
}

/// What each pulse moved. Friction turns neighbours back, at times farther than the segment itself
/// turned: so each side is given to one pulse, such that all turns together are largest.
std::vector<SideMoved> sides_moved(const ArmDescription& arm, const CalibrationLog& log,
                                   const std::vector<PulsePoses>& pulses, double noise_rad) {
  constexpr double kFloorRad = 1e-4;  // a turn to the other side, or none
  const auto count = Eigen::Index(pulses.size());
  Eigen::MatrixXd gain(count, count);  // columns: right and left of each segment
  for (Eigen::Index k = 0; k < count; ++k) {
    const std::vector<double> turns = turns_of(arm, pulses[k]);
    require_motion(log.pulses[k], pulses[k], turns, noise_rad);
    for (int s = 0; s < arm.segment_count(); ++s) {
      const double turn = turns[s];
      gain(k, 2 * s) = std::log(std::max(kFloorRad, -turn));
      gain(k, 2 * s + 1) = std::log(std::max(kFloorRad, turn));
    }
  }
  const std::vector<Eigen::Index> columns = best_assignment(gain);
  if (assignment_margin(gain, columns) < std::log(kClearFactor)) {
    throw CalibrationRefused(
        "which channel moves which segment can't be told: two of them turn the same segments "
        "alike. Do they share air?");
  }
  std::vector<SideMoved> moved;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index column = columns[k];
    if (gain(k, column) <= std::log(kFloorRad)) {
      const CalibrationPulse& pulse = log.pulses[k];
      throw CalibrationRefused(fmt::format(
          "the {} of {} never moved, and channel {} at {:.3g} kPa moves what another channel does: "
          "two channels move the same side",
          side_name(column % 2 == 0 ? 1.0 : -1.0), segment_name(column / 2), pulse.channel,
          pulse.setpoint_kpa));
    }
    moved.push_back({int(column / 2), column % 2 == 0 ? 1.0 : -1.0});
  }
  return moved;
}

/// Every side that is on another channel than its other one, and where its hose is.
std::string hoses(const CalibrationLog& log, const std::vector<SideMoved>& moved) {
  auto parts = mapped<std::string>(moved.size(), [&](std::size_t k) {
    return fmt::format("the {} of {} is on channel {}'s {} side", side_name(moved[k].side),
                       segment_name(moved[k].segment), log.pulses[k].channel,
                       log.pulses[k].setpoint_kpa > 0.0 ? "positive" : "negative");
  });
  std::sort(parts.begin(), parts.end());
  return fmt::format("{}", fmt::join(parts, "; "));
}

void require_one_segment_per_channel(const CalibrationLog& log,
                                     const std::vector<SideMoved>& moved) {
  for (std::size_t k = 0; k + 1 < moved.size(); k += 2) {
    const SideMoved& up = moved[k];
    const SideMoved& down = moved[k + 1];
    const int channel = log.pulses[k].channel;
    if (up.segment != down.segment) {
      throw CalibrationRefused(fmt::format(
          "channel {} moves {} when positive and {} when negative: hoses are crossed between "
          "segments. As found, {}. Move hoses until both sides of each segment are on one channel",
          channel, segment_name(up.segment), segment_name(down.segment), hoses(log, moved)));
    }
  }
}

/// Channels by segment. @throws CalibrationRefused where two have the same.
std::vector<WireChannel> by_segment(const std::vector<int>& segments,
                                    const std::vector<double>& signs, const char* what) {
  std::vector<WireChannel> result(segments.size(), {-1, 1.0});
  for (std::size_t c = 0; c < segments.size(); ++c) {
    WireChannel& one = result[segments[c]];
    if (one.channel >= 0) {
      throw CalibrationRefused(
          fmt::format("{} {} and {} both belong to {}; none is left for another segment", what,
                      one.channel, c, segment_name(segments[c])));
    }
    one = {int(c), signs[c]};
  }
  return result;
}

/// Mean of each reading over frames `first` to `end` − 1.
Eigen::VectorXd mean_readings(const CalibrationLog& log, std::size_t first, std::size_t end) {
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(log.frames[first].state.pressure_kpa.size());
  for (std::size_t k = first; k < end; ++k) {
    mean += log.frames[k].state.pressure_kpa.cast<double>();
  }
  return mean / double(end - first);
}

}  // namespace

void take_rest_pressures(const CalibrationLog& log, WireCalibration& calibration) {
  const Eigen::VectorXd zero = mean_readings(log, 0, log.rest_end);
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(zero.size());
  for (std::size_t k = 0; k < log.rest_end; ++k) {
    squares += (log.frames[k].state.pressure_kpa.cast<double>() - zero).cwiseAbs2();
  }
  const Eigen::VectorXd noise = (squares / double(log.rest_end)).cwiseSqrt();
  calibration.zero_kpa.assign(zero.begin(), zero.end());
  calibration.noise_kpa.assign(noise.begin(), noise.end());
}

std::vector<WireChannel> valve_channels(const ArmDescription& arm, const CalibrationLog& log,
                                        const SeenPoses& poses) {
  const std::vector<PulsePoses> pulses = pulse_poses(poses, log, arm.frame_period_s());
  const PoseNoise noise = pose_noise(poses, 0, log.rest_end);
  const std::vector<SideMoved> moved = sides_moved(arm, log, pulses, noise.theta_rad);
  require_one_segment_per_channel(log, moved);
  std::vector<int> segments;
  std::vector<double> signs;
  for (std::size_t k = 0; k < moved.size(); k += 2) {
    segments.push_back(moved[k].segment);
    signs.push_back(log.pulses[k].setpoint_kpa > 0.0 ? moved[k].side : -moved[k].side);
  }
  return by_segment(segments, signs, "valve channels");
}

std::vector<WireChannel> sensor_channels(const ArmDescription& arm, const CalibrationLog& log,
                                         const std::vector<WireChannel>& valves,
                                         const std::vector<double>& zero_kpa) {
  const auto frames = std::size_t(std::lround(kReadingMeanS * arm.frame_rate_hz));
  const Eigen::Map<const Eigen::VectorXd> zero(zero_kpa.data(), std::ssize(zero_kpa));
  std::vector<int> segments(valves.size(), -1);
  std::vector<double> signs(valves.size(), 0.0);
  for (const CalibrationPulse& pulse : log.pulses) {
    const Eigen::VectorXd change =
        mean_readings(log, pulse.hold_end - frames, pulse.hold_end) - zero;
    const int reading = clear_largest({change.begin(), change.end()});
    if (reading < 0) {
      throw CalibrationRefused(
          fmt::format("channel {} at {:.3g} kPa changes several "
                      "readings alike, by {:.2f} kPa: check the sensors",
                      pulse.channel, pulse.setpoint_kpa, fmt::join(change, ", ")));
    }
    const int segment = segment_on(valves, pulse.channel);
    const double ratio = change[reading] / pulse.setpoint_kpa;
    const double direction = ratio < 0.0 ? -1.0 : 1.0;
    const std::string wrong =
        scale_complaint(segment_name(segment), pulse.setpoint_kpa, direction * change[reading]);
    if (!wrong.empty()) {
      throw CalibrationRefused(fmt::format("channel {}: {}", pulse.channel, wrong));
    }
    const double sign = valves[segment].sign * direction;
    if (segments[reading] >= 0 && (segments[reading] != segment || signs[reading] != sign)) {
      throw CalibrationRefused(fmt::format(
          "reading {} belongs to {} in one pulse and to {} in another, or turns its sign between "
          "its sides: the two sides of a channel have to be one reading, right less left",
          reading, segment_name(segments[reading]), segment_name(segment)));
    }
    segments[reading] = segment;
    signs[reading] = sign;
  }
  for (std::size_t r = 0; r < segments.size(); ++r) {
    if (segments[r] < 0) {
      throw CalibrationRefused(
          fmt::format("reading {} never changed: no channel's pressure is measured there", r));
    }
  }
  return by_segment(segments, signs, "readings");
}

}  // namespace limber
