#include "limber/data/recording_inspection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/arm/plate_distance.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/log_units.hpp"
#include "limber/data/reach.hpp"
#include "limber/data/simple_model.hpp"
#include "limber/data/space_fit.hpp"
#include "limber/data/valve_identification.hpp"
#include "suspicions.hpp"

namespace limber {

namespace {

constexpr double kGapPeriods = 1.5;            // a longer time between frames is a gap
constexpr double kFastestPlate_m_per_s = 4.0;  // three times what a full reversal does at 0.7 m
constexpr double kOvershoot = 1.1;             // of the limit, measured
constexpr double kSetpointOvershoot = 1.001;
constexpr int kFrozenFrames = 10;      // exactly equal backbones, while …
constexpr double kFrozenChange = 0.1;  // … a pressure changes by this part of its limit

class EpisodeInspector {
 public:
  EpisodeInspector(const Recording& recording, std::size_t index,
                   const std::vector<PressureLimits>& limits_kpa, Suspicions& suspicions)
      : recording_(recording),
        episode_(recording.episodes[index]),
        index_(index),
        limits_kpa_(limits_kpa),
        suspicions_(suspicions) {}

  void run() {
    for (int t = 0; t < episode_.frame_count(); ++t) {
      look_at_pressures(t);
      if (t > 0) {
        look_at_time(t);
        if (episode_.was_tracked(t) && episode_.was_tracked(t - 1)) {
          look_at_motion(t);
          look_for_frozen_backbones(t);
        } else {
          equal_frames_ = 0;
        }
        if (episode_.was_tracked(t)) {
          look_at_base(t);
        }
      }
    }
  }

 private:
  void look_at_time(int t) {
    const double step_s = episode_.time_s[t] - episode_.time_s[t - 1];
    if (step_s > kGapPeriods / recording_.rate_hz) {
      suspicions_.add("a gap in time", index_, t,
                      fmt::format("{:.3f} s between frames, the rate gives {:.3f}", step_s,
                                  1.0 / recording_.rate_hz));
    }
  }

  void look_at_pressures(int t) {
    for (std::size_t s = 0; s < limits_kpa_.size(); ++s) {
      const auto column = Eigen::Index(s);
      const double pressure_kpa = episode_.pressure_kpa(t, column);
      const double setpoint_kpa = episode_.setpoint_kpa(t, column);
      const PressureLimits& limits = limits_kpa_[s];
      const double limit_kpa = limits.largest_kpa();
      if (limit_kpa <= 0.0) {
        continue;  // no arm is given, and nothing was commanded there
      }
      // The limit of the side that it is on; without a sign where both sides have the same.
      const auto beside_limit = [&](double kpa) {
        return fmt::format("{}: {:.1f} {}, limit {:.1f}", channel_name(recording_.dimension, s),
                           kpa, recording_.command.unit,
                           limits.is_symmetric() ? limits.upper_kpa : limits.side_kpa(kpa));
      };
      if (limits.size_kpa(setpoint_kpa) > kSetpointOvershoot * limit_kpa) {
        suspicions_.add("a set point beyond its limit", index_, t, beside_limit(setpoint_kpa));
      }
      if (!episode_.setpoints_only && limits.size_kpa(pressure_kpa) > kOvershoot * limit_kpa) {
        suspicions_.add(
            "a measured " + recording_.command.name + " more than 10 % beyond its limit", index_, t,
            beside_limit(pressure_kpa));
      }
    }
  }

  /// In space: rotations are quaternions of either sign.
  void look_at_motion_in_space(int t) {
    const double step_s = episode_.time_s[t] - episode_.time_s[t - 1];
    for (int i = 0; i < recording_.point_count; ++i) {
      look_at_step(t, i, (episode_.position_m(t, i) - episode_.position_m(t - 1, i)).norm(),
                   step_s);
    }
  }

  void look_at_step(int t, int plate, double distance_m, double step_s) {
    if (distance_m > kFastestPlate_m_per_s * step_s) {
      suspicions_.add(
          "a plate that jumps", index_, t,
          fmt::format("{}: {:.3f} m in {:.3f} s", plate_name(plate), distance_m, step_s));
    }
  }

  void look_at_base(int t) {
    const int first = episode_.next_tracked(0, t);
    const double base_m = (episode_.position_m(t, 0) - episode_.position_m(first, 0)).norm();
    if (base_m > kBaseStandsStill_m) {
      suspicions_.add("a base that has moved since the episode's start", index_, t,
                      fmt::format("{:.3f} m away", base_m));
    }
  }

  /// Between two tracked frames: those that were filled in are guesses.
  void look_at_motion(int t) {
    if (recording_.dimension == Dimension::space) {
      look_at_motion_in_space(t);
      return;
    }
    const double step_s = episode_.time_s[t] - episode_.time_s[t - 1];
    const auto now = backbone_at(episode_.backbone, t);
    const auto before = backbone_at(episode_.backbone, t - 1);
    const Eigen::VectorXd moved_m = plate_distances_m(now, before);
    for (int i = 0; i < recording_.point_count; ++i) {
      const double turn_rad = std::abs(now(i, 2) - before(i, 2));
      look_at_step(t, i, moved_m[i], step_s);
      if (turn_rad > std::numbers::pi) {
        suspicions_.add("a heading that jumps by more than half a turn (wrapped?)", index_, t,
                        fmt::format("{}: {:.2f} rad in {:.3f} s", plate_name(i), turn_rad, step_s));
      }
    }
  }

  /// A tracker that hangs repeats its last frame to the bit. So does what is filled in.
  void look_for_frozen_backbones(int t) {
    const bool same = episode_.backbone.row(t) == episode_.backbone.row(t - 1);
    equal_frames_ = same ? equal_frames_ + 1 : 0;
    if (equal_frames_ < kFrozenFrames) {
      return;
    }
    const Eigen::RowVectorXf change =
        episode_.pressure_kpa.row(t) - episode_.pressure_kpa.row(t - equal_frames_);
    for (std::size_t s = 0; s < limits_kpa_.size(); ++s) {
      const double own = std::abs(double(change[Eigen::Index(s)]));
      const double limit_kpa = limits_kpa_[s].largest_kpa();
      if (limit_kpa > 0.0 && own > kFrozenChange * limit_kpa) {
        suspicions_.add(
            "a backbone that stands still to the bit while " + recording_.command.name + "s change",
            index_, t,
            fmt::format("{} frames, the {} of {} changes by {:.1f} {}", equal_frames_,
                        recording_.command.name, channel_name(recording_.dimension, s), own,
                        recording_.command.unit));
        return;
      }
    }
  }

  const Recording& recording_;
  const Episode& episode_;
  std::size_t index_;
  const std::vector<PressureLimits>& limits_kpa_;
  Suspicions& suspicions_;
  int equal_frames_ = 0;
};

std::vector<PressureRange> pressure_ranges(const Recording& recording) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  std::vector<PressureRange> ranges;
  for (Eigen::Index column = 0; column < recording.channel_count(); ++column) {
    PressureRange range{kInfinite, -kInfinite, kInfinite, -kInfinite};
    const auto widen = [&](const auto& values, double& lowest, double& highest) {
      lowest = std::min(lowest, double(values.minCoeff()));
      highest = std::max(highest, double(values.maxCoeff()));
    };
    for (const Episode& episode : recording.episodes) {
      widen(episode.pressure_kpa.col(column), range.lowest_kpa, range.highest_kpa);
      widen(episode.setpoint_kpa.col(column), range.lowest_setpoint_kpa,
            range.highest_setpoint_kpa);
    }
    ranges.push_back(range);
  }
  return ranges;
}

std::vector<PressureLimits> limits_of(const ArmDescription* arm,
                                      const std::vector<PressureRange>& pressures) {
  return mapped<PressureLimits>(pressures.size(), [&](std::size_t s) {
    return arm != nullptr ? arm->limits_of_channel(int(s))
                          : PressureLimits(std::max(std::abs(pressures[s].lowest_setpoint_kpa),
                                                    std::abs(pressures[s].highest_setpoint_kpa)));
  });
}

/// The arm that the recording describes itself.
ArmDescription own_arm(const Recording& recording, const std::string& file) {
  ArmDescription own =
      read_arm_keys(recording.arm_description, file + ": attribute 'arm_description'",
                    PolynomialsOf::characterisation);
  refuse_if(own.channel_count() != recording.channel_count() ||
                own.dimension != recording.dimension || own.point_count() != recording.point_count,
            "{}: attribute 'arm_description' is of {} commands and {} points; the recording has {} "
            "and {}",
            file, own.channel_count(), own.point_count(), recording.channel_count(),
            recording.point_count);
  return own;
}

/// What commands do to shapes: chambers on the wrong side, in another order, or without effect.
void look_at_chambers(const ArmDescription& arm, const SpaceFit& fit,
                      RecordingInspection& inspection) {
  for (const ChamberFinding& found : chamber_findings(arm, fit)) {
    if (!found.suspicion.empty()) {
      inspection.suspicions.push_back({"a chamber that does not act as the arm file says", 1, 0, "",
                                       0, fmt::format("{} {}", found.name, found.suspicion)});
    }
  }
}

/// Arms are also recorded before their bench test.
bool is_characterised(const ArmDescription& arm) {
  return arm.no_load != NoLoadKind::strain_polynomial ||
         std::ranges::all_of(arm.segments, [](const Segment& segment) {
           return why_unusable(segment.strain_polynomial, segment.pressure_limit_kpa.largest_kpa())
               .empty();
         });
}

/// By the arm file, or by the arm that the recording describes.
void fit_simple_models(const Recording& recording, const ArmDescription* arm,
                       const std::string& file, RecordingInspection& inspection) {
  const bool in_space = recording.dimension == Dimension::space;
  const bool tracked = in_space ? is_enough_for_space_fit(recording.episodes)
                                : recording.untracked_count() < recording.frame_count();
  if (!tracked || (arm == nullptr && recording.arm_description.empty())) {
    return;
  }
  const ArmDescription used = arm != nullptr ? *arm : own_arm(recording, file);
  if (!is_characterised(used)) {
    return;
  }
  if (!in_space) {
    inspection.episode_errors = errors_of_any(used, recording.episodes);
    return;
  }
  try {
    const SpaceFit fit = fit_space_model(used, recording.episodes);
    inspection.episode_errors = episode_errors(fit, used, recording.episodes);
    if (arm != nullptr) {
      look_at_chambers(*arm, fit, inspection);
    }
  } catch (const InputError&) {  // nothing that a fit may use: what is odd is among the suspicions
  }
}

/// A configuration at the end of a motion.
struct Corner {
  std::vector<int> states;  ///< of each segment, as corner_kpa has them
  bool reached = false;
};

/// None if a set point is neither off nor full.
std::optional<int> state_at(double setpoint_kpa, const PressureLimits& limits) {
  for (const int state : {1, 2, 0}) {
    if (std::abs(setpoint_kpa - corner_kpa(limits, state)) <=
        kReachTolerance * limits.largest_kpa()) {
      return state;
    }
  }
  return std::nullopt;
}

/// None if a segment is at no state.
std::optional<Corner> corner_at(const Episode& episode, Eigen::Index frame,
                                const std::vector<PressureLimits>& limits_kpa) {
  Corner corner;
  corner.reached = true;
  for (std::size_t s = 0; s < limits_kpa.size(); ++s) {
    const auto column = Eigen::Index(s);
    const double setpoint_kpa = episode.setpoint_kpa(frame, column);
    const double tolerance_kpa = kReachTolerance * limits_kpa[s].largest_kpa();
    const std::optional<int> state = state_at(setpoint_kpa, limits_kpa[s]);
    if (!state) {
      return std::nullopt;
    }
    corner.states.push_back(*state);
    corner.reached &= std::abs(episode.pressure_kpa(frame, column) - setpoint_kpa) <= tolerance_kpa;
  }
  return corner;
}

}  // namespace

RecordingInspection inspect(const Recording& recording, const ArmDescription* arm,
                            const std::string& file) {
  validate(recording, file);
  if (arm != nullptr) {
    require_sizes_of(recording, *arm, file);
  }
  RecordingInspection inspection;
  inspection.limits_known = arm != nullptr;
  inspection.pressures = pressure_ranges(recording);
  inspection.limits_kpa = limits_of(arm, inspection.pressures);
  inspection.transitions = transition_coverage(recording, inspection.limits_kpa);
  Suspicions suspicions;
  look_at_whole(recording, arm, inspection.limits_kpa, suspicions);
  for (std::size_t i = 0; i < recording.episodes.size(); ++i) {
    EpisodeInspector(recording, i, inspection.limits_kpa, suspicions).run();
  }
  inspection.suspicions = suspicions.take();
  for (Suspicion& suspicion : inspection.suspicions) {
    suspicion.log = recording.episodes[suspicion.episode].log;
  }
  auto largest_kpa = mapped<double>(
      inspection.limits_kpa, [&](const PressureLimits& limits) { return limits.largest_kpa(); });
  inspection.valves = identify_valves(recording, std::move(largest_kpa));
  fit_simple_models(recording, arm, file, inspection);
  return inspection;
}

TransitionCoverage transition_coverage(const Recording& recording,
                                       const std::vector<PressureLimits>& limits_kpa) {
  using Transition = std::pair<std::vector<int>, std::vector<int>>;
  std::set<Transition> attempted;
  std::set<Transition> covered;
  for (const Episode& episode : recording.episodes) {
    // Frame 0 stands for the configuration that the first motion leaves.
    std::optional<Corner> from = corner_at(episode, 0, limits_kpa);
    for (int t = 1; t < episode.frame_count(); ++t) {
      const bool ends =
          t + 1 == episode.frame_count() || episode.motion_index[t + 1] != episode.motion_index[t];
      if (!ends) {
        continue;
      }
      std::optional<Corner> to = corner_at(episode, t, limits_kpa);
      if (from && to) {
        attempted.insert({from->states, to->states});
        if (from->reached && to->reached) {
          covered.insert({from->states, to->states});
        }
      }
      from = std::move(to);
    }
  }
  TransitionCoverage result;
  result.possible = std::pow(9.0, double(limits_kpa.size()));
  result.attempted = std::int64_t(attempted.size());
  result.covered = std::int64_t(covered.size());
  return result;
}

}  // namespace limber
