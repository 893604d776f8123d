#pragma once
// For those who move an arm, real or virtual.

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/valve_findings.hpp"

namespace limber {

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
