#include "inspect_arm.hpp"

#include <cmath>

#include <fmt/ranges.h>

#include "limber/arm/arm_commands.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/arm/space_no_load.hpp"
#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

Finding inspect_arm_in_space(const ArmDescription& arm) {
  Finding finding;
  finding.json = {{"kind", "arm"},
                  {"name", arm.name},
                  {"hash", arm.hash()},
                  {"dimension", position_size(arm.dimension)},
                  {"command", {{"name", arm.command.name}, {"unit", arm.command.unit}}},
                  {"no_load", to_string(arm.no_load)},
                  {"segments", arm.segment_count()},
                  {"chambers", arm.channel_count()},
                  {"points", arm.point_count()},
                  {"length_m", arm.length_m()},
                  {"frame_rate_hz", arm.frame_rate_hz}};
  finding.text = fmt::format(
      "arm '{}' in space, hash {}\n  {} segments, {} chambers, {} plates, {:.3f} m long, {} Hz",
      arm.name, arm.hash(), arm.segment_count(), arm.channel_count(), arm.point_count(),
      arm.length_m(), arm.frame_rate_hz);
  const SpaceNoLoad no_load(arm);
  for (int i = 0; i < arm.channel_count(); ++i) {
    Eigen::VectorXd commands = Eigen::VectorXd::Zero(arm.channel_count());
    commands[i] = arm.limits_of_channel(i).largest_kpa();
    const Eigen::VectorXd strains = no_load.strains(commands);
    const auto bend_rad = sum_of<double>(arm.segment_count(), [&](int s) {
      return no_load.segment_shape(s, strains).rotation_rad.norm();
    });
    finding.json["full_bend_rad"].push_back(bend_rad);
    finding.json[quantity_key(arm.command, "limits")].push_back(to_json(arm.limits_of_channel(i)));
    finding.text += fmt::format("\n  {}: {} {} bend the arm by {:.2f} rad", channel_name(arm, i),
                                commands[i], arm.command.unit, bend_rad);
  }
  return finding;
}

}  // namespace

Finding inspect_arm(const YamlReader& root) {
  const ArmDescription arm = read_arm(root);
  const NoLoadModel model(arm);
  virtual_arm_parameters(arm);  // refuses what is wrong there
  if (arm.is_spatial()) {
    return inspect_arm_in_space(arm);
  }
  Finding finding;
  finding.json = {{"kind", "arm"},
                  {"name", arm.name},
                  {"hash", arm.hash()},
                  {"command", {{"name", arm.command.name}, {"unit", arm.command.unit}}},
                  {"no_load", to_string(arm.no_load)},
                  {"segments", arm.segment_count()},
                  {"points", arm.point_count()},
                  {"length_m", arm.length_m()},
                  {quantity_key(arm.command, "limits"), Json::array()},
                  {"frame_rate_hz", arm.frame_rate_hz},
                  {"pressure_rate_limit_kpa_per_s", arm.pressure_rate_limit_kpa_per_s}};
  finding.text = fmt::format(
      "arm '{}', hash {}\n  {} segments, {} plates, {:.3f} m long, {} Hz, at most {} {}/s",
      arm.name, arm.hash(), arm.segment_count(), arm.point_count(), arm.length_m(),
      arm.frame_rate_hz, arm.pressure_rate_limit_kpa_per_s, arm.command.unit);
  for (int i = 0; i < arm.segment_count(); ++i) {
    const Segment& segment = arm.segments[i];
    const SegmentShape full = model.segment_shape(i, segment.pressure_limit_kpa.largest_kpa());
    const double turn_rad = std::abs(full.curvature_per_m) * full.length_m;
    finding.json["full_bend_rad"].push_back(turn_rad);
    finding.json[quantity_key(arm.command, "limits")].push_back(
        to_json(segment.pressure_limit_kpa));
    finding.text += fmt::format(
        "\n  {}: {} m long, {} m wide, {} gaps, {} {} bends it by {}{:.2f} rad", segment_name(i),
        segment.length_m, segment.width_m, segment.gaps, to_string(segment.pressure_limit_kpa),
        arm.command.unit, segment.pressure_limit_kpa.is_symmetric() ? "" : "up to ", turn_rad);
  }
  if (!arm.commands.empty()) {
    for (const ArmCommand& command : arm.commands) {
      finding.json["commands"].push_back({{"name", command.name}, {"shares", command.shares}});
    }
    for (int i = 0; i < arm.segment_count(); ++i) {
      finding.text += fmt::format("\n  {} = {}", segment_name(i), command_sum(arm, i));
    }
  }
  return finding;
}

}  // namespace limber
