// The columns of commands where no mapping names them.
#include <algorithm>

#include "limber/arm/names.hpp"
#include "limber/logs/import_mapping.hpp"

namespace limber {

namespace {

/// The names that limber gives the columns of segments' commands.
CommandColumns default_columns(const ArmDescription& arm, int first) {
  CommandColumns columns;
  columns.unit = arm.command.unit;
  for (int i = first; i < first + arm.channel_count(); ++i) {
    columns.columns.push_back(quantity_column(arm.command, followed_name(arm.command), i));
    columns.setpoint.push_back(quantity_column(arm.command, "setpoint", i));
  }
  columns.setpoint_optional = true;
  return columns;
}

/// Those of the arm file's `commands`, by their names.
CommandColumns summed_columns(const ArmDescription& arm) {
  CommandColumns columns;
  columns.unit = arm.command.unit;
  columns.summed = true;
  for (const ArmCommand& command : arm.commands) {
    columns.columns.push_back(command.name);
    columns.setpoint.push_back("setpoint_" + command.name);
  }
  columns.setpoint_optional = true;
  return columns;
}

}  // namespace

ImportMapping default_import_mapping(const ArmDescription& arm) {
  ImportMapping mapping;
  mapping.commands = arm.commands.empty() ? default_columns(arm, 0) : summed_columns(arm);
  return mapping;
}

CommandColumns as_counted_in(const std::vector<std::string>& names, CommandColumns commands,
                             const ArmDescription& arm) {
  if (!commands.setpoint_optional) {
    return commands;
  }
  const auto are_there = [&](const std::vector<std::string>& columns) {
    return std::ranges::all_of(columns, [&](const std::string& name) {
      return std::ranges::find(names, name) != names.end();
    });
  };
  const auto begin_there = [&](const CommandColumns& columns) {
    return are_there({columns.columns.front()}) || are_there({columns.setpoint.front()});
  };
  if (commands.summed && !begin_there(commands) && begin_there(default_columns(arm, 0))) {
    commands = default_columns(arm, 0);
  }
  const CommandColumns from_1 = default_columns(arm, 1);
  if (!begin_there(commands) && (are_there(from_1.columns) || are_there(from_1.setpoint))) {
    commands = from_1;
  }
  const bool has_setpoints = are_there(commands.setpoint);
  if (has_setpoints && !are_there({commands.columns.front()})) {
    commands.columns = commands.setpoint;
    commands.measured = false;
  } else if (!has_setpoints && !arm.command.is_pressure_kpa()) {
    commands.measured = false;  // commands alone are set points
  }
  if (!commands.measured) {
    commands.setpoint.clear();
    commands.setpoint_optional = false;
  }
  return commands;
}

}  // namespace limber
