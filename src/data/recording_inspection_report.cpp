// What an inspection found, as JSON and as text.
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/json.hpp"
#include "limber/data/recording_inspection.hpp"

namespace limber {

namespace {

constexpr double kMeantTransitions = 0.01;  // of all: fewer were commanded by chance

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

/// Whole numbers as such; 10^19 and more are none of JSON's.
Json possible_to_json(double transitions) {
  constexpr double kMaxWhole = 9e18;
  return transitions < kMaxWhole ? Json(std::int64_t(transitions)) : Json(transitions);
}

}  // namespace

Json to_json(const Recording& recording, const RecordingInspection& inspection) {
  Json json;
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
  json["transitions"] = {
      {"possible", possible_to_json(inspection.transitions.possible)},
      {"attempted", inspection.transitions.attempted},
      {"covered", recording.setpoints_only() ? Json() : Json(inspection.transitions.covered)}};
  json["valves"] = to_json(inspection.valves);
  json["episode_errors"] = inspection.episode_errors ? to_json(*inspection.episode_errors) : Json();
  json["suspicions"] = Json::array();
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
  text += "  " + to_text(inspection.valves, recording.command.unit, recording.dimension) + "\n";
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
