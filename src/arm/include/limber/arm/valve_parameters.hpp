#pragma once
// For everyone.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/pose_size.hpp"

namespace limber {

struct ArmDescription;

/// How one segment's pressure moves in one direction.
struct ValveDirection {
  double time_constant_s = 0.0;       ///< ≥ 0; 0 follows at once
  double rate_limit_kpa_per_s = 0.0;  ///< > 0; +∞ where nothing limits it
  bool operator==(const ValveDirection&) const = default;
};

/// One segment's valves and their pressure controller (docs/valves.md).
struct SegmentValves {
  ValveDirection inflating;  ///< away from zero; rising where the command has no sides
  ValveDirection venting;    ///< toward zero; falling where the command has no sides
  double dead_time_s = 0.0;  ///< from a set point to the first effect, ≥ 0, not in whole frames
  double dead_band_kpa =
      0.0;  ///< ≥ 0; the valves stay closed within this distance of the set point
  bool operator==(const SegmentValves&) const = default;
};

/// Parameters of the valve model V of p_t = V(p_{t−1}, set points) as plain values: schema
/// limber/valves/1.
struct ValveParameters {
  /// A pressure has two sides, of which one vents before the other inflates; a curvature or an
  /// angle has none.
  bool has_sides = true;
  std::vector<SegmentValves> segments;  ///< empty: ideal valves, pressures are the set points

  bool is_ideal() const { return segments.empty(); }
  /// Hash of everything that a prediction depends on; empty for ideal valves.
  std::string hash() const;
  bool operator==(const ValveParameters&) const = default;
};

/// Longest dead time that a model accepts.
inline constexpr double kLongestDeadTimeS = 5.0;

/// Empty if a valve model of `arm` can use the parameters, else what is wrong with them:
/// "segment 1: dead_time_s = -1; expected …".
std::string why_unusable(const ValveParameters& parameters, const ArmDescription& arm);
/// The same without the arm: numbers out of range, or another number of segments.
std::string why_unusable(const ValveParameters& parameters, int segment_count);

/// |Modelled − measured| pressure over frames in which a set point has changed within the last
/// 0.5 s. In the unit of the arm's command.
struct ValveErrors {
  double mean_kpa = 0.0;
  double p95_kpa = 0.0;
  double max_kpa = 0.0;
  std::int64_t frames = 0;  ///< 0: not measured
};

/// How valves were identified, or why they were not. No part of the parameters' hash.
struct ValveFindings {
  std::string source;          ///< the recordings
  ValveErrors held_back;       ///< on motions that the fit has not seen
  ValveErrors from_setpoints;  ///< on the same motions, if set points were taken for pressures
  std::string reason;          ///< why there are no parameters; empty if there are
  std::vector<std::string> warnings;  ///< what is suspicious about the recordings
};

struct IdentifiedValves {
  ValveParameters parameters;  ///< ideal where there is a reason
  ValveFindings findings;
};

class YamlReader;

/// Keys as in the file (docs/formats.md, schema limber/valves/1).
nlohmann::ordered_json to_json(const IdentifiedValves& valves);
/// The file's text. Numbers survive the round trip exactly.
std::string valves_to_yaml(const IdentifiedValves& valves);
/// One line for people: parameters of each segment (once where all are alike) and errors.
std::string to_text(const IdentifiedValves& valves, const std::string& unit = "kPa",
                    Dimension dimension = Dimension::plane);

/// @throws InputError if no valve model can use the parameters.
void write_valves(const std::filesystem::path& path, const IdentifiedValves& valves);
/// YAML, or JSON, which is YAML too. @throws InputError naming file, line and key.
IdentifiedValves read_valves(const std::filesystem::path& path);
IdentifiedValves read_valves(const YamlReader& root);

}  // namespace limber
