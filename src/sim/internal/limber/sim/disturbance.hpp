#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/run/appearing_obstacle.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// What may be different on the day a plan runs (docs/experiments.md, Disturbances).
enum class DisturbanceKind {
  tip_load,       ///< mass on the last plate [kg]
  friction,       ///< more dry friction, of table and braids, by this share
  weak_actuator,  ///< one side of one segment, sampled by seed, has lost this share of its strength
  noise,          ///< standard deviation of measured x and y [m], delivered 100 ms late
  lost_tracking,  ///< no backbone for so long [s], once, at a time sampled by seed
  obstacle,       ///< a circle of this radius [m] appears on the rest of the path
  sensor_noise,   ///< as `noise`, in time
  picked_up,      ///< as `tip_load`, but in mid-plan, at a time sampled by seed
  leak,           ///< in mid-plan a segment, both sampled by seed, comes to lose so much pressure
};

/// One of them. The model and the plan know nothing of it.
struct Disturbance {
  DisturbanceKind kind = DisturbanceKind::friction;
  double amount = 0.0;  ///< in the kind's unit
  bool operator==(const Disturbance&) const = default;
};

const char* to_string(DisturbanceKind kind);
/// "tip_load, friction, …", each with its unit and usual amount: for `--help` and messages.
std::string disturbance_kinds();

/// "friction", "tip_load=0.1,noise": what acts together; without an amount the usual one: 0.05 kg,
/// 0.3, 0.2, 0.5 mm, 0.5 s, 2 cm, 0.5 mm, 0.05 kg, 0.1. Empty: none.
/// @throws InputError naming what was found and what there is.
std::vector<Disturbance> parse_disturbances(const std::string& text);
/// As `parse_disturbances` reads it, amounts where they are not the usual ones.
std::string to_string(const std::vector<Disturbance>& disturbances);

/// A virtual arm as the disturbances have it, and what they do to the world.
struct DisturbedArm {
  ArmDescription arm;
  VirtualArmOptions options;
  std::optional<AppearingObstacle> obstacle;
};

/// The arm that a plan meets; with no disturbance, `arm` and `options` as they are, but for the
/// seed. What is random is sampled from `seed`, each kind from a stream of its own. Times count
/// from the arm's first frame.
DisturbedArm disturbed(const ArmDescription& arm, const Plan& plan,
                       const std::vector<Disturbance>& disturbances, std::uint64_t seed,
                       const VirtualArmOptions& options = {});

/// Whether one of them is of this kind.
bool has_kind(const std::vector<Disturbance>& disturbances, DisturbanceKind kind);

}  // namespace limber
