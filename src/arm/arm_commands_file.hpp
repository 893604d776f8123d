#pragma once

#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"

namespace limber {

class YamlReader;

/// The list `commands` of an arm file (docs/formats.md).
/// @param arm  with its segments
/// @throws InputError naming file and line for a command without a name or with another's, one that
/// acts on nothing or on a channel that the arm has not, and for a channel that can't be commanded
/// apart from those before it: of a segment, in space of a chamber.
std::vector<ArmCommand> read_arm_commands(const YamlReader& node, const ArmDescription& arm);

/// The same as YAML, a line for each; empty for none. Numbers survive the round trip exactly.
std::string arm_commands_to_yaml(const std::vector<ArmCommand>& commands);

}  // namespace limber
