#pragma once
// For those who train and evaluate models.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/valve_parameters.hpp"

namespace limber {

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
std::string to_text(const IdentifiedValves& valves, const std::string& unit = "kPa");

void write_valves(const std::filesystem::path& path, const IdentifiedValves& valves);
/// YAML, or JSON, which is YAML too. @throws InputError naming file, line and key.
IdentifiedValves read_valves(const std::filesystem::path& path);
IdentifiedValves read_valves(const YamlReader& root);

}  // namespace limber
