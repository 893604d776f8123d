#pragma once
// For everyone.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/arm_identity.hpp"
#include "limber/arm/backbone.hpp"

namespace limber {

struct Environment;

/// One frame of a plan. The set points of frame k are commanded at time (k − 1)/rate and held for
/// one frame period; pressures and backbone are those predicted for its end, time k/rate.
struct PlanFrame {
  Pressures setpoint_kpa;  ///< size n
  Pressures pressure_kpa;  ///< size n, predicted; the set points where the plan knows no valves
  Backbone backbone;       ///< m×3, predicted
};

/// Figures of a plan's certificate (certificate/certificate.hpp), taken before it was written.
struct CertifiedFigures {
  double clearance_m = 0.0;      ///< +∞ without obstacles
  double max_deviation_m = 0.0;  ///< of a plate from where the plan has it
  /// Set by the reader: false if anything in the file has changed since.
  bool seal_is_intact = true;
};

/// Room that a plan keeps for the model's error, as its tube has it (docs/tube.md): the arm may be
/// that far from where it is predicted, in a share `level` of all runs.
struct PlanTube {
  double level = 0.0;                  ///< in (0, 1)
  std::vector<double> plate_radius_m;  ///< one per plate, ≥ 0: where it has its full width
  RoomGrowth growth;                   ///< of these, from where the plan starts
  double end_radius_m = 0.0;           ///< of the tip after the hold, ≥ 0
  double end_heading_rad = 0.0;        ///< ≥ 0
  /// Whether the plan's end lies so far inside the goal's tolerances. False where a goal is too
  /// small for that: then the tube holds for obstacles alone.
  bool goal_inside = false;
  bool operator==(const PlanTube&) const = default;
};

/// A motion in pressure space (docs/formats.md, schema limber/plan/2). Frames are part of it: the
/// arm's shape depends on how the pressures were reached, so frames are executed as they stand,
/// never resampled.
///
/// `frames[0]` is the start (time 0, nothing to command); the last `hold_frame_count` frames repeat
/// the final set point while the arm settles, after which the goal is judged.
struct Plan {
  std::string arm_name;
  std::string arm_hash;         ///< ArmDescription::hash()
  std::string arm_description;  ///< arm_keys_to_yaml(); empty in files of before it was kept
  Command command;              ///< the arm's: what "kpa" stands for in the names below
  std::string model;            ///< "no_load" or "network"
  std::string model_hash;       ///< content hash of the model file; empty for "no_load"
  /// e (FamilyMember) of the arm that it was certified with, where a closed loop has followed which
  /// arm of its family this is since; empty: as the model's file has it.
  Eigen::VectorXf arm_of_family;
  std::string valves_hash;  ///< ValveParameters::hash(); empty: planned without valves
  std::string environment_name;
  std::string environment_hash;  ///< environment_hash()
  std::string planner;
  std::uint64_t seed = 0;
  double margin_m = 0.0;         ///< clearance asked for; beside the tube, if there is one
  std::optional<PlanTube> tube;  ///< kept free of obstacles in all frames
  double frame_rate_hz = 0.0;
  /// That the plan was asked to stay within, one of each segment; empty: the arm's own.
  std::vector<PressureLimits> limits;

  std::vector<Pressures> waypoints_kpa;  ///< start first; frames run straight between them
  std::vector<PlanFrame> frames;
  int hold_frame_count = 0;

  double cost_kpa = 0.0;     ///< (2): Σ|Δp| over all segments and frames
  double clearance_m = 0.0;  ///< smallest predicted, of the tube if there is one; +∞: no obstacles
  double goal_distance_m = 0.0;       ///< predicted, after the hold
  double goal_orientation_rad = 0.0;  ///< the same; 0 if the goal asks for none
  std::string program_version;
  std::optional<CertifiedFigures> certified;  ///< none: not certified yet

  /// Whose arm this is (arm/arm_identity.hpp).
  ArmIdentity arm() const { return {arm_name, arm_hash, arm_description}; }
  int frame_count() const { return int(frames.size()); }
  /// Time of the last frame, hold included.
  double duration_s() const;
};

/// Writes the plan as JSON, atomically; every number survives the round trip exactly. A certified
/// plan is sealed with a hash of everything in the file.
void write_plan(const std::filesystem::path& path, const Plan& plan);

/// Reads and validates. Sizes agree, numbers are finite, the cost is Σ|Δp|, frames start and end at
/// the waypoints, the hold stands still, nothing was changed since it was certified.
/// @throws InputError naming file and field.
Plan read_plan(const std::filesystem::path& path);

/// Reads a plan for `certify` to judge: checks types and that numbers are finite, but not what they
/// say.
/// @throws InputError naming file and field.
Plan read_plan_unchecked(const std::filesystem::path& path);

/// @throws InputError if the plan was made for another arm (hashes and keys in the message), or
/// violates the arm's pressure limits, its own narrower ones, or the arm's rate.
void require_plan_of(const Plan& plan, const ArmDescription& arm, const std::string& file);

/// @throws InputError if the plan was made for another environment (names and hashes).
void require_plan_in(const Plan& plan, const Environment& environment, const std::string& file);

/// Set points for a valve controller, and the pressures predicted for the end of their frame:
/// `time_s,setpoint_0_kpa,…,pressure_0_kpa,…` (`setpoint_0,…,command_0,…` where the arm is driven
/// by anything else), one row per frame, time at which the frame's set points are to be commanded.
void write_setpoints_csv(const std::filesystem::path& path, const Plan& plan);

/// The same set points as the arm's own `commands` (limber/arm/arm_commands.hpp), `time_s` and a
/// column for each by its name. @param arm  the plan's.
void write_commands_csv(const std::filesystem::path& path, const Plan& plan,
                        const ArmDescription& arm);

/// Predicted shapes: `time_s,x_0_m,y_0_m,theta_0_rad,…`, one row per frame, its time the frame's
/// end.
void write_backbones_csv(const std::filesystem::path& path, const Plan& plan);

}  // namespace limber
