#include "limber/arm/characterisation.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/error.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/driver/wire_calibration.hpp"
#include "limber/lab/campaign.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/run/safety_settings.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "limber/world/environment.hpp"
#include "target.hpp"

namespace limber::fuzz {

namespace {

const ArmDescription& driven_by_motors() {
  static const ArmDescription arm = load_arm(LIMBER_SOURCE_DIR "/arms/motor_driven.yaml");
  return arm;
}

/// Everything that an arm's file is read for.
void read_arm_file(const Input& input) {
  const ArmDescription arm = load_arm(input.file);
  (void)load_safety(input.file);
  (void)virtual_arm_parameters(arm);
  const ArmDescription again = read_arm_keys(arm_keys_to_yaml(arm), input.file);
  require(again.hash() == arm.hash(), "an arm's keys are another arm's");
  (void)with_strain_polynomials(std::string(input.bytes), arm);  // where characterize writes it
  const NoLoadModel model(arm);
  Eigen::VectorXf poses(arm.point_count() * pose_size(arm.dimension));
  model.poses(Pressures::Zero(arm.channel_count()), poses);
  require(poses.allFinite(), "an arm at rest that is nowhere");
}

void read_environment_file(const Input& input) {
  const Environment environment = load_environment(input.file);
  const std::string yaml = environment_to_yaml(environment);
  require(environment_hash(read_environment(YamlReader::from_text(yaml, "again"))) ==
              environment_hash(environment),
          "an environment that is another one once written");
  (void)load_environment(input.file, three_segments());
}

void read_mapping_file(const Input& input) {
  const bool has_motors = input.bytes.find("commands:") != std::string_view::npos;
  (void)read_import_mapping(input.file, has_motors ? driven_by_motors() : three_segments());
}

void read_space_mapping_file(const Input& input) {
  (void)read_import_mapping(input.file, small_space_arm());
}

/// What a recording of a virtual arm, or a campaign's flags, say of its physics.
void read_physics(const Input& input) {
  for (const Dimension dimension : {Dimension::plane, Dimension::space}) {
    try {
      const VirtualArmParameters read =
          with_differences({}, std::string(input.bytes), dimension, "physics");
      const std::string again = physics_differences({}, read);
      require(physics_differences({}, with_differences({}, again, dimension, "again")) == again,
              "physics that is another once written");
    } catch (const InputError&) {
      if (dimension == Dimension::space) {
        throw;
      }
    }
  }
}

void read_valve_file(const Input& input) {
  const IdentifiedValves valves = read_valves(input.file);
  (void)to_text(valves);
  (void)why_unusable(valves.parameters, three_segments());
  (void)why_unusable(valves.parameters, small_space_arm());
}

void read_calibration_file(const Input& input) {
  const WireCalibration calibration = read_wire_calibration(input.file);
  (void)parse_wire_calibration(to_yaml(calibration), "again");
  (void)in_words(calibration);
  require_calibration_of(calibration, three_segments(), input.file);
}

void read_campaign_file(const Input& input) {
  const Campaign campaign = read_campaign(input.file);
  const std::size_t units = unit_count(campaign);
  require(units > 0, "a campaign of no unit");
  (void)campaign_unit(campaign, 0);
  (void)campaign_unit(campaign, units - 1);
}

std::vector<std::string> arm_seeds() {
  return {source_file("arms/three_segment.yaml"), source_file("arms/motor_driven.yaml"),
          source_file("arms/uneven_limits.yaml")};
}

std::vector<std::string> environment_seeds() {
  return {source_file("environments/03_gap_in_a_wall.yaml"),
          source_file("environments/06_overshoot.yaml")};
}

std::vector<std::string> valve_seeds() {
  IdentifiedValves valves;
  valves.parameters.segments.assign(2, {{0.1, 99.5}, {0.12, 80.0}, 0.0131, 0.2});
  IdentifiedValves none;
  none.findings.reason = "the set points never change";
  return {valves_to_yaml(valves), valves_to_yaml(none)};
}

std::vector<std::string> calibration_seeds() {
  WireCalibration plain = identity_calibration(three_segments());
  plain.clocks.driver = {0.1, 0.2, 0.3};
  WireCalibration seen = plain;
  seen.tracker.emplace();
  const auto plates = static_cast<std::size_t>(three_segments().point_count());
  seen.tracker->marker_offsets.resize(plates);
  seen.tracker->plane.emplace();
  seen.tracker->plane->body_rotations.assign(plates, Eigen::Quaterniond::Identity());
  return {to_yaml(plain), to_yaml(seen)};
}

}  // namespace

std::vector<Target> yaml_targets() {
  return {{"arm", "arm.yaml", read_arm_file, arm_seeds},
          {"environment", "environment.yaml", read_environment_file, environment_seeds},
          {"mapping", "mapping.yaml", read_mapping_file},
          {"space_mapping", "mapping.yaml", read_space_mapping_file},
          {"physics", "", read_physics},
          {"valves", "valves.yaml", read_valve_file, valve_seeds},
          {"calibration", "calibration.yaml", read_calibration_file, calibration_seeds},
          {"campaign", "campaign.yaml", read_campaign_file}};
}

}  // namespace limber::fuzz
