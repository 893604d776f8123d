#pragma once

#include "limber/arm/arm_description.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/logs/import_mapping.hpp"

namespace limber {

/// Reads what a mapping for an arm in space says under `backbone` and `alignment`.
/// @throws InputError naming file, line and field.
void read_space_mapping(const YamlReader& root, const ArmDescription& arm, ImportMapping& mapping);

}  // namespace limber
