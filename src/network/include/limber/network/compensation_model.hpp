#pragma once
// For those who ask a model where the arm goes.

#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/arm_identity.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/network/learnt_region.hpp"
#include "limber/network/prediction_error.hpp"

namespace limber {

/// How backbones enter and leave the network; sizes and order in network/backbone_layout.hpp.
enum class BackboneLayout {
  base_poses,  ///< the paper's: 3m numbers, poses about the arm's base; 102-…-48 for n = 3, m = 16
  gap_poses,   ///< each plate's pose about the plate before it: 3(m − 1) numbers; the default
};

/// "base_poses" or "gap_poses", as model files have it.
const char* to_string(BackboneLayout layout);

/// What the network's outputs mean, in the coordinates of the layout.
enum class OutputForm {
  compensation,  ///< the paper's (5): what is added to B̃_t, one number for each of the backbone's
  gated_change,  ///< (16): what is added to B_{t−1}, then a gate for each number, twice as many
};

/// "compensation" or "gated_change", as model files have it.
const char* to_string(OutputForm form);

/// Affine map of each number, x ↦ (x − offset)·scale, so that training data lie in [0, 1] (or have
/// unit spread). A number that never changes in the data (the base plate's pose) has no range: its
/// scale is 1.
struct Normalisation {
  Eigen::VectorXf offset;
  Eigen::VectorXf scale;  ///< finite, not 0
};

/// One layer, y = W x + b, with ReLU behind every layer but the last.
struct Layer {
  Eigen::MatrixXf weight;  ///< out × in
  Eigen::VectorXf bias;    ///< out
};

/// What (20) keeps every gap's shape within: one number for each of the m − 1 gaps. A gap's length
/// is that of the straight line between its plates. In space a turn is a twist, and the bend has a
/// bound of its own.
struct GapBounds {
  Eigen::VectorXf min_length_m;  ///< > 0
  Eigen::VectorXf max_length_m;  ///< ≥ min_length_m
  Eigen::VectorXf min_turn_rad;
  Eigen::VectorXf max_turn_rad;    ///< ≥ min_turn_rad
  Eigen::VectorXf max_bend_rad{};  ///< > 0, in space; else empty
};

/// A quantity of an arm's physics that e tells of: about middle + slope · e, in its name's unit
/// (docs/families.md, "What an arm is like").
struct PhysicalTrait {
  std::string name;       ///< "tip_load_kg"
  float of_file = 0.0F;   ///< what the arm's file says
  float middle = 0.0F;    ///< of the family's middle
  float left = 0.0F;      ///< standard deviation of what e does not tell
  Eigen::VectorXf slope;  ///< k
  Eigen::VectorXf along;  ///< k: how e changes with it, when nothing else of the arm does
};

/// What is believed of one.
struct TraitEstimate {
  std::string name;
  double value = 0.0;
  double deviation = 0.0;  ///< standard, of value − reference
  double reference = 0.0;  ///< what the arm's file says, or what was believed before
  /// Beyond what may well be chance.
  bool differs() const { return std::abs(value - reference) > 2.0 * deviation; }
};

/// Traits that have changed together.
using ArmChange = std::vector<TraitEstimate>;

/// What makes a network one for a family of arms: k numbers e say which arm it is. A hidden layer,
/// max(W x + b, 0) at e = 0, is (γ(g + G e) / γ(g)) ∘ max(W x + b + C e, 0) of arm e
/// (docs/families.md; γ in network/arm_gain.hpp). e is in the family's own scale: over the arms
/// that it learnt from, e has mean 0 and unit covariance, so that the origin is the family's
/// middle, and an arm of it is about √k away. Plain values.
struct ArmFamily {
  static constexpr int kMaxSize = 64;  ///< of k

  Eigen::MatrixXf shifts;             ///< C, U × k: of the units of all hidden layers, in order
  Eigen::MatrixXf log_gains;          ///< g and G, U × (1 + k)
  Eigen::MatrixXf arms;               ///< k × N, e of the arms that it learnt from
  std::vector<PhysicalTrait> traits;  ///< of virtual arms, whose physics is known

  int size() const { return int(shifts.cols()); }
};

/// Which arm of a family a model is of, as far as its recordings told.
struct FamilyMember {
  static constexpr double kFar = 2.0;  ///< from the family's middle: no arm of it

  std::string family_hash;     ///< of the family's file; empty: not from a file
  Eigen::VectorXf e;           ///< k; the layers are those of this arm
  Eigen::MatrixXf covariance;  ///< k × k, of e: several arms fit what was recorded

  /// Of each number of e.
  Eigen::VectorXf deviation() const { return covariance.diagonal().cwiseMax(0.0F).cwiseSqrt(); }
  /// |e| / √k, about 1 for an arm of the family.
  double distance() const { return double(e.norm()) / std::sqrt(double(e.size())); }
};

/// The network Φ of (5), (16) or (22) with everything needed to use it. Its inputs (q_{t−1}, q_t,
/// B_{t−1}, B̃_t, and B_{t−1} − B_{t−2} where it reads velocities) are normalised by `input`. Its
/// result is in the coordinates of `layout`: the compensation B_t − B̃_t normalised by `output`; or
/// a change normalised by `output` (which scales but never shifts it, so that no change stays no
/// change) and the gates' arguments, not normalised. Plain values.
struct CompensationModel {
  BackboneLayout layout = BackboneLayout::gap_poses;
  OutputForm form = OutputForm::compensation;
  /// (22): it reads how the backbone changed in the frame before, B_{t−1} − B_{t−2} in the
  /// coordinates of `layout`. Whether an arm moves can't be told from one backbone.
  bool reads_velocity = false;
  /// Frames ago, ascending, of the commands that it reads beside q_{t−1} and beside q_t; of arms in
  /// space alone.
  std::vector<int> past_commands;
  std::vector<Layer> layers;
  /// An ensemble's other networks, of the same shape and normalisation, in the order of their
  /// validation errors: `layers` is the best. For a single prediction, `layers` is enough.
  std::vector<std::vector<Layer>> more_members;
  Normalisation input;
  Normalisation output;
  std::string arm_name;
  std::string arm_hash;         ///< ArmDescription::hash()
  std::string arm_description;  ///< arm_keys_to_yaml(); empty in files of before it was kept
  Dimension dimension = Dimension::plane;
  int segment_count = 0;
  int chamber_count = 0;  ///< of an arm in space: a command each; else 0
  int point_count = 0;
  std::string preset;  ///< "paper" or "best"
  /// Record of the training: data files and hashes, seed, epochs, losses, seconds.
  std::map<std::string, std::string> training;
  /// What it learnt from and has to be asked with: false, measured pressures; true, set points, for
  /// nothing was measured. It then knows the valves along with the arm, and no valve model belongs
  /// before it. Of files of before there were two kinds: false.
  bool learnt_from_setpoints = false;
  /// The valves between set points and pressures of the recordings (docs/valves.md); none if the
  /// recordings did not show them, for the reason that the findings give.
  std::optional<ValveParameters> valves;
  ValveFindings valve_findings;
  /// Error of `layers` on motions used neither for its training nor for its choice; none if no such
  /// motions were left.
  std::optional<PredictionError> prediction_error;
  /// Where the arm may be beside its predictions; none before `limber calibrate`.
  std::optional<Tube> tube;
  /// What the training recordings held; none in files of before it was kept.
  std::optional<LearntRegion> learnt;
  /// What its predictions stay within, by (20); none in files of before it was kept.
  std::optional<GapBounds> bounds;

  /// Where it is a family's, or was made from one; and the arm that it is then a model of.
  std::optional<ArmFamily> family;
  std::optional<FamilyMember> member_of_family;

  /// Numbers of q_t.
  int channel_count() const {
    return dimension == Dimension::space ? chamber_count : segment_count;
  }
  /// Numbers of q_t with those of `past_commands` below it, as ForwardModel::step_batch is told.
  int command_size() const { return channel_count() * (1 + int(past_commands.size())); }
  int member_count() const { return 1 + int(more_members.size()); }
  /// Member `index` as a model of its own, without the training record. @pre index < member_count()
  CompensationModel member(int index) const;

  IdentifiedValves identified_valves() const;
  /// @throws InputError as `require_no_valves_before`.
  void set_valves(const IdentifiedValves& identified);
  /// Whose arm this is (arm/arm_identity.hpp).
  ArmIdentity arm() const { return {arm_name, arm_hash, arm_description}; }
  void set_arm(const ArmDescription& arm);

  /// "102-100-100-100-48".
  std::string shape() const;
};

/// @throws InputError, its message beginning with `where`, unless the layers chain, fit the
/// layout's sizes and the normalisations, all members have one shape, and every number is finite.
void validate(const CompensationModel& model, const std::string& where);

/// @throws InputError, its message beginning with `where`, unless the model was trained for `arm`
/// (why_another_arm; both names and hashes in the message, and the keys that differ).
void require_model_of(const CompensationModel& model, const ArmDescription& arm,
                      const std::string& where);

/// @throws InputError, its message beginning with `where`, if `valves` are to stand before a model
/// that learnt from set points: their lag would count twice.
void require_no_valves_before(const CompensationModel& model, const ValveParameters& valves,
                              const std::string& where);

/// Writes safetensors (docs/formats.md), atomically, after `validate`.
/// @throws InputError as `validate`; SystemFault if the disk refuses.
void write_model(const std::filesystem::path& path, const CompensationModel& model);

/// Reads and validates. @throws InputError naming file and tensor or metadata key.
CompensationModel read_model(const std::filesystem::path& path);

}  // namespace limber
