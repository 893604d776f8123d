#pragma once

#include <filesystem>
#include <string>

#include "limber/common/filesystem.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// Of all layers but the last.
Eigen::Index hidden_units(const std::vector<Layer>& layers);

/// @throws InputError beginning with `where` and naming the tensor, unless sizes fit each other and
/// the hidden ones of `layers`, and every number is finite.
void validate(const ArmFamily& family, const std::vector<Layer>& layers, const std::string& where);
void validate(const FamilyMember& member, const ArmFamily& family, const std::string& where);

/// Whether the model is a family's, not yet one arm's: `limber adapt` makes it so.
bool is_family(const CompensationModel& model);

/// The model of the arm e: an ordinary one of the same size, its hidden layers changed as e says,
/// in place of the arm which `model` was fitted to. What was measured on that arm
/// (error, tube) is left out. @pre model.family, and e has its size
CompensationModel model_of_arm(CompensationModel model, const FamilyMember& member);

/// The same of an arm that a run has followed, for the next one: its error stays what it was
/// measured to be, its tube is left out. @pre `before` is an arm's of a family
CompensationModel model_after_run(const CompensationModel& before, const FamilyMember& now);

/// `model_of_arm`, where a closed loop has followed which arm this is (Plan::arm_of_family).
/// @throws InputError if the model is no arm's of a family, or of one with another size of e
CompensationModel model_of_followed_arm(CompensationModel model, const Eigen::VectorXf& e);

/// The family again, without an arm. @pre model.family
CompensationModel family_of(CompensationModel model);

/// The tube of an arm that predictions are expected to be off by so many times as much.
Tube scaled(Tube tube, double times);

/// What a family's record says under a key that ends with _cm; NaN where it says nothing.
double noted_error_m(const CompensationModel& family, const std::string& key);

/// A family's tube is that of an arm whose fit expects the tip to be off by this much; the tubes of
/// other arms are in proportion. @return NaN for a family that does not say
double expected_error_of_tube_m(const CompensationModel& family);
void note_expected_error_of_tube(CompensationModel& family, double error_m);

/// @throws InputError, its message beginning with `where`, if the model is of no family.
void require_family(const CompensationModel& model, const std::string& where);

/// @throws InputError, its message beginning with `where`, if the model is a family's: it names the
/// command that makes it one arm's.
void require_one_arm(const CompensationModel& model, const std::string& where);

/// For whoever predicts, plans or moves: `read_model`, and `require_one_arm`.
CompensationModel read_model_of_one_arm(const fs::path& path);
/// The same, and `require_model_of` in the file's name.
CompensationModel read_model_of_one_arm(const fs::path& path, const ArmDescription& arm);

}  // namespace limber
