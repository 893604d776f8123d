#pragma once

#include <string>

#include "limber/arm/arm_description.hpp"

namespace limber {

class YamlReader;

/// `segments` and `gravity` of an arm in space (docs/space.md). @pre arm.command, arm.no_load are
/// read. @throws InputError naming file, line, field, what was found and what is allowed.
void read_space_segments(const YamlReader& root, PolynomialsOf polynomials, ArmDescription& arm);

/// One of them as YAML, on several lines. Numbers survive the round trip exactly.
std::string space_segment_to_yaml(const Segment& segment, const ArmDescription& arm);

}  // namespace limber
