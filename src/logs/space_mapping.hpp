#pragma once

#include <functional>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/logs/import_mapping.hpp"

namespace limber {

inline constexpr double kParallelAxes = 1e-3;  // sine of the least angle between two axes

// What mappings of arms in the plane and in space say in the same way.

/// How many `to` make one of the unit that is written here. @throws InputError for unknown ones.
double factor_to(const YamlReader& node, const std::string& to);

/// A column's name, or a tracked object's. @throws InputError where it is empty
std::string named_column(const YamlReader& node);

/// `headings: measured` or `tangent`.
bool read_headings_measured(const YamlReader& node);

/// What `read_point` makes of each of `elements`. @throws InputError where two have one source
std::vector<PointSource> read_sources(
    const std::vector<YamlReader>& elements,
    const std::function<PointSource(const YamlReader&)>& read_point);

/// Every point's plate: given, or counted where every plate has a point.
/// @param node      of all points; `elements`, its points, one for each of `points`
/// @param untracked_base  whether all plates but the base count as every plate, too
/// @throws InputError where plates do not rise or the last is not the arm's end
void number_plates(const YamlReader& node, const std::vector<YamlReader>& elements,
                   const ArmDescription& arm, bool untracked_base,
                   std::vector<PointSource>& points);

/// Reads what a mapping for an arm in space says under `backbone` and `alignment`.
/// @throws InputError naming file, line and field.
void read_space_mapping(const YamlReader& root, const ArmDescription& arm, ImportMapping& mapping);

}  // namespace limber
