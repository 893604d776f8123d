#include "limber/data/recording_inspection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/arm/plate_distance.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/arm/valve_findings.hpp"
#include "limber/common/error.hpp"
#include "limber/data/simple_model.hpp"
#include "limber/data/space_fit.hpp"
#include "limber/data/valve_identification.hpp"
#include "suspicions.hpp"

namespace limber {

namespace {

constexpr double kGapPeriods = 1.5;            // a longer time between frames is a gap
constexpr double kFastestPlate_m_per_s = 4.0;  // three times what a full reversal does at 0.7 m
constexpr double kBaseMotion_m = 0.005;        // motion capture is better than that
constexpr double kOvershoot = 1.1;             // of the limit, measured
constexpr double kSetpointOvershoot = 1.001;
constexpr int kFrozenFrames = 10;      // exactly equal backbones, while …
constexpr double kFrozenChange = 0.1;  // … a pressure changes by this part of its limit

constexpr double kMeantTransitions = 0.01;  // of all: fewer were commanded by chance

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
        look_at_motion(t);
        look_for_frozen_backbones(t);
      }
    }
  }

 private:
  /// Of the side that the value is on; without a sign where both sides have the same.
  double limit_of(std::size_t segment, double kpa) const {
    const PressureLimits& limits = limits_kpa_[segment];
    return limits.is_symmetric() ? limits.upper_kpa : limits.side_kpa(kpa);
  }

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
      const auto column = static_cast<Eigen::Index>(s);
      const double pressure_kpa = episode_.pressure_kpa(t, column);
      const double setpoint_kpa = episode_.setpoint_kpa(t, column);
      const double limit_kpa = limits_kpa_[s].largest_kpa();
      if (limits_kpa_[s].size_kpa(setpoint_kpa) > kSetpointOvershoot * limit_kpa) {
        suspicions_.add(
            "a set point beyond the segment's limit", index_, t,
            fmt::format("{}: {:.1f} {}, limit {:.1f}", channel_name(recording_.dimension, s),
                        setpoint_kpa, recording_.command.unit, limit_of(s, setpoint_kpa)));
      }
      if (!episode_.setpoints_only &&
          limits_kpa_[s].size_kpa(pressure_kpa) > kOvershoot * limit_kpa) {
        suspicions_.add(
            "a measured " + recording_.command.name + " more than 10 % beyond the segment's limit",
            index_, t,
            fmt::format("{}: {:.1f} {}, limit {:.1f}", channel_name(recording_.dimension, s),
                        pressure_kpa, recording_.command.unit, limit_of(s, pressure_kpa)));
      }
    }
  }

  /// In space: rotations are quaternions of either sign, and the base says nothing of its start.
  void look_at_motion_in_space(int t) {
    const double step_s = episode_.time_s[t] - episode_.time_s[t - 1];
    for (int i = 0; i < recording_.point_count; ++i) {
      const double distance_m = (episode_.position_m(t, i) - episode_.position_m(t - 1, i)).norm();
      if (distance_m > kFastestPlate_m_per_s * step_s) {
        suspicions_.add("a plate that jumps", index_, t,
                        fmt::format("{}: {:.3f} m in {:.3f} s", plate_name(i), distance_m, step_s));
      }
    }
    const double base_m = (episode_.position_m(t, 0) - episode_.position_m(0, 0)).norm();
    if (base_m > kBaseMotion_m) {
      suspicions_.add("a base that has moved since the episode's start", index_, t,
                      fmt::format("{:.3f} m away", base_m));
    }
  }

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
      const double distance_m = moved_m[i];
      const double turn_rad = std::abs(now(i, 2) - before(i, 2));
      if (distance_m > kFastestPlate_m_per_s * step_s) {
        suspicions_.add("a plate that jumps", index_, t,
                        fmt::format("{}: {:.3f} m in {:.3f} s", plate_name(i), distance_m, step_s));
      }
      if (turn_rad > std::numbers::pi) {
        suspicions_.add("a heading that jumps by more than half a turn (wrapped?)", index_, t,
                        fmt::format("{}: {:.2f} rad in {:.3f} s", plate_name(i), turn_rad, step_s));
      }
      if (i == 0) {
        const auto first = episode_.backbone.row(0).head<2>();
        const double base_m = (now.row(0).head<2>() - first).norm();
        if (base_m > kBaseMotion_m) {
          suspicions_.add("a base that has moved since the episode's start", index_, t,
                          fmt::format("{:.3f} m away", base_m));
        }
      }
    }
  }

  /// A tracker that hangs repeats its last frame to the bit.
  void look_for_frozen_backbones(int t) {
    const bool same = episode_.backbone.row(t) == episode_.backbone.row(t - 1);
    equal_frames_ = same ? equal_frames_ + 1 : 0;
    if (equal_frames_ < kFrozenFrames) {
      return;
    }
    const Eigen::RowVectorXf change =
        episode_.pressure_kpa.row(t) - episode_.pressure_kpa.row(t - equal_frames_);
    for (std::size_t s = 0; s < limits_kpa_.size(); ++s) {
      const double own = std::abs(double(change[static_cast<Eigen::Index>(s)]));
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
  std::vector<PressureRange> ranges(static_cast<std::size_t>(recording.channel_count()));
  for (std::size_t s = 0; s < ranges.size(); ++s) {
    PressureRange& range = ranges[s];
    const auto column = static_cast<Eigen::Index>(s);
    bool first = true;
    for (const Episode& episode : recording.episodes) {
      const auto measured = episode.pressure_kpa.col(column);
      const auto commanded = episode.setpoint_kpa.col(column);
      const PressureRange own{measured.minCoeff(), measured.maxCoeff(), commanded.minCoeff(),
                              commanded.maxCoeff()};
      range = first ? own
                    : PressureRange{std::min(range.lowest_kpa, own.lowest_kpa),
                                    std::max(range.highest_kpa, own.highest_kpa),
                                    std::min(range.lowest_setpoint_kpa, own.lowest_setpoint_kpa),
                                    std::max(range.highest_setpoint_kpa, own.highest_setpoint_kpa)};
      first = false;
    }
  }
  return ranges;
}

std::vector<PressureLimits> limits_of(const ArmDescription* arm,
                                      const std::vector<PressureRange>& pressures) {
  std::vector<PressureLimits> limits_kpa;
  for (std::size_t s = 0; s < pressures.size(); ++s) {
    limits_kpa.push_back(
        arm != nullptr ? arm->limits_of_channel(static_cast<int>(s))
                       : PressureLimits(std::max(std::abs(pressures[s].lowest_setpoint_kpa),
                                                 std::abs(pressures[s].highest_setpoint_kpa))));
  }
  return limits_kpa;
}

std::string ranges_to_text(const Recording& recording, const std::vector<PressureRange>& ranges) {
  const bool measured = !recording.setpoints_only();
  const std::string& unit = recording.command.unit;
  std::string text =
      measured ? ""
               : fmt::format("  set points only: no {} was measured\n", recording.command.name);
  for (std::size_t s = 0; s < ranges.size(); ++s) {
    const PressureRange& range = ranges[s];
    text += fmt::format("  {}: {}set {:.1f} … {:.1f} {}\n",
                        channel_name(recording.dimension, Eigen::Index(s)),
                        measured ? fmt::format("measured {:.1f} … {:.1f} {}, ", range.lowest_kpa,
                                               range.highest_kpa, unit)
                                 : "",
                        range.lowest_setpoint_kpa, range.highest_setpoint_kpa, unit);
  }
  return text;
}

/// Empty for those who never meant to record transitions. Whether an end was reached is known only
/// where something was measured.
std::string transitions_to_text(const Recording& recording, const RecordingInspection& inspection) {
  const TransitionCoverage& transitions = inspection.transitions;
  if (double(transitions.attempted) < kMeantTransitions * transitions.possible) {
    return "";
  }
  const char* guessed = inspection.limits_known ? "" : "; limits guessed from the set points";
  return recording.setpoints_only()
             ? fmt::format("  {} of {:.0f} transitions commanded{}\n", transitions.attempted,
                           transitions.possible, guessed)
             : fmt::format(
                   "  {} of {:.0f} transitions covered (both ends reached), {} commanded{}\n",
                   transitions.covered, transitions.possible, transitions.attempted, guessed);
}

/// By the arm file, or by the arm that the recording describes.
std::optional<EpisodeErrors> errors_of(const Recording& recording, const ArmDescription* arm,
                                       const std::string& file) {
  const bool tracked = recording.dimension == Dimension::space
                           ? is_enough_for_space_fit(recording.episodes)
                           : recording.untracked_count() < recording.frame_count();
  if (!tracked || (arm == nullptr && recording.arm_description.empty())) {
    return std::nullopt;
  }
  if (arm != nullptr) {
    return errors_of_any(*arm, recording.episodes);
  }
  const ArmDescription own =
      read_arm_keys(recording.arm_description, file + ": attribute 'arm_description'");
  if (own.channel_count() != recording.channel_count() || own.dimension != recording.dimension ||
      own.point_count() != recording.point_count) {
    throw InputError(fmt::format(
        "{}: attribute 'arm_description' is of {} commands and {} points; the recording has {} "
        "and {}",
        file, own.channel_count(), own.point_count(), recording.channel_count(),
        recording.point_count));
  }
  return errors_of_any(own, recording.episodes);
}

}  // namespace

namespace {

/// What commands do to shapes: chambers on the wrong side, in another order, or without effect.
void look_at_chambers(const ArmDescription& arm, const std::vector<Episode>& episodes,
                      RecordingInspection& inspection) {
  for (const ChamberFinding& found : chamber_findings(arm, fit_space_model(arm, episodes))) {
    if (!found.suspicion.empty()) {
      inspection.suspicions.push_back({"a chamber that does not act as the arm file says", 1, 0, "",
                                       0, fmt::format("{} {}", found.name, found.suspicion)});
    }
  }
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
  look_at_whole(recording, arm, suspicions);
  for (std::size_t i = 0; i < recording.episodes.size(); ++i) {
    EpisodeInspector(recording, i, inspection.limits_kpa, suspicions).run();
  }
  inspection.suspicions = suspicions.take();
  for (Suspicion& suspicion : inspection.suspicions) {
    suspicion.log = recording.episodes[static_cast<std::size_t>(suspicion.episode)].log;
  }
  std::vector<double> largest_kpa;
  for (const PressureLimits& limits : inspection.limits_kpa) {
    largest_kpa.push_back(limits.largest_kpa());
  }
  inspection.valves = identify_valves(recording, std::move(largest_kpa));
  inspection.episode_errors = errors_of(recording, arm, file);
  if (arm != nullptr && arm->is_spatial() && is_enough_for_space_fit(recording.episodes)) {
    look_at_chambers(*arm, recording.episodes, inspection);
  }
  return inspection;
}

nlohmann::ordered_json to_json(const Recording& recording, const RecordingInspection& inspection) {
  nlohmann::ordered_json json;
  json["kind"] = "recording";
  json["arm"] = recording.arm_name;
  json["arm_hash"] = recording.arm_hash;
  json["source"] = recording.source;
  json["settings"] = recording.settings;
  json["seed"] = recording.seed;
  json["program_version"] = recording.program_version;
  json["rate_hz"] = recording.rate_hz;
  json["command"] = {{"name", recording.command.name}, {"unit", recording.command.unit}};
  json["commands_are"] = commands_are(recording.setpoints_only());
  json["dimension"] = position_size(recording.dimension);
  json["segments"] = recording.segment_count;
  if (recording.dimension == Dimension::space) {
    json["chambers"] = recording.chamber_count;
    json["rotations"] = recording.lifted() ? "lifted" : "measured";
  }
  json["points"] = recording.point_count;
  json["episodes"] = recording.episodes.size();
  json["frames"] = recording.frame_count();
  json["frames_dropped"] = recording.untracked_count();
  json["duration_s"] = recording.duration_s();
  if (std::any_of(recording.episodes.begin(), recording.episodes.end(),
                  [](const Episode& episode) { return !episode.physics.empty(); })) {
    for (const Episode& episode : recording.episodes) {
      json["physics"].push_back(episode.physics);
    }
  }
  // `command` is taken: it says what drives the arm.
  const char* const followed = recording.command.is_pressure_kpa() ? "pressure_kpa" : "commands";
  if (recording.setpoints_only()) {
    json[followed] = nullptr;
  }
  for (const PressureRange& range : inspection.pressures) {
    if (!recording.setpoints_only()) {
      json[followed].push_back({range.lowest_kpa, range.highest_kpa});
    }
    json[quantity_key(recording.command, "setpoint")].push_back(
        {range.lowest_setpoint_kpa, range.highest_setpoint_kpa});
  }
  for (const PressureLimits& limits : inspection.limits_kpa) {
    json[quantity_key(recording.command, "limits")].push_back(to_json(limits));
  }
  json["limits_known"] = inspection.limits_known;
  json["transitions"] = {{"possible", static_cast<std::int64_t>(inspection.transitions.possible)},
                         {"attempted", inspection.transitions.attempted},
                         {"covered", recording.setpoints_only()
                                         ? nlohmann::ordered_json()
                                         : nlohmann::ordered_json(inspection.transitions.covered)}};
  json["valves"] = to_json(inspection.valves);
  json["episode_errors"] =
      inspection.episode_errors ? to_json(*inspection.episode_errors) : nlohmann::ordered_json();
  json["suspicions"] = nlohmann::ordered_json::array();
  for (const Suspicion& suspicion : inspection.suspicions) {
    json["suspicions"].push_back({{"what", suspicion.what},
                                  {"count", suspicion.count},
                                  {"episode", suspicion.episode},
                                  {"log", suspicion.log},
                                  {"frame", suspicion.frame},
                                  {"first", suspicion.first}});
  }
  return json;
}

std::string to_text(const Recording& recording, const RecordingInspection& inspection) {
  std::string text = fmt::format(
      "recording of arm '{}' ({}), seed {}, limber {}\n"
      "  {}\n"
      "  {} episodes, {} frames at {} Hz ({:.1f} s), {} not tracked\n"
      "  {} segments, driven by {} [{}], {} backbone points [{}]\n",
      recording.arm_name, recording.source, recording.seed, recording.program_version,
      recording.settings.empty() ? "no settings stored" : recording.settings,
      recording.episodes.size(), recording.frame_count(), recording.rate_hz, recording.duration_s(),
      recording.untracked_count(), recording.segment_count, recording.command.name,
      recording.command.unit, recording.point_count,
      recording.dimension == Dimension::plane ? "m, m, rad"
      : recording.lifted()                    ? "in space, positions alone"
                                              : "in space, positions and rotations");
  text += ranges_to_text(recording, inspection.pressures);
  text += transitions_to_text(recording, inspection);
  text += "  " + to_text(inspection.valves, recording.command.unit) + "\n";
  for (const std::string& warning : inspection.valves.findings.warnings) {
    text += "    warning: " + warning + "\n";
  }
  std::string outliers;
  if (inspection.episode_errors) {
    const EpisodeErrors& errors = *inspection.episode_errors;
    text += fmt::format(
        "  the simple model (fitted gains, offsets, lengths, lag) is "
        "off by {:.2f} cm at the tip in the middle one of the episodes\n",
        errors.median_cm);
    outliers = to_text(errors);
    text += outliers.empty() ? "" : "  broken: " + outliers + "\n";
  }
  if (inspection.suspicions.empty() && outliers.empty()) {
    text += "  nothing suspicious";
    return text;
  }
  if (inspection.suspicions.empty()) {
    text.pop_back();
    return text;
  }
  text += "  suspicious:";
  for (const Suspicion& suspicion : inspection.suspicions) {
    text += fmt::format("\n    {}: {} times, first in {}, {}: {}", suspicion.what, suspicion.count,
                        episode_name(suspicion.episode, suspicion.log), frame_name(suspicion.frame),
                        suspicion.first);
  }
  return text;
}

}  // namespace limber
