#pragma once

#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"

namespace limber {

class YamlReader;

/// The list `commands` of an arm file (docs/formats.md).
/// @param segments  n, those of the arm.
/// @throws InputError naming file and line for a command without a name or with another's, one that
/// acts on nothing or on a segment that the arm has not, and for a segment that can't be commanded
/// apart from those before it.
std::vector<ArmCommand> read_arm_commands(const YamlReader& node, int segments);

/// The same as YAML, a line for each; empty for none. Numbers survive the round trip exactly.
std::string arm_commands_to_yaml(const std::vector<ArmCommand>& commands);

}  // namespace limber
