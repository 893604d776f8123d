#pragma once
// For everyone.

#include <optional>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"

namespace limber {

/// What a model, plan, forest or recording keeps of the arm that it was made for, so that another
/// machine can tell whether an arm file is the same arm.
///
/// Hashes alone do not tell this: two CPUs fit strain polynomials that differ in the last digit,
/// and a length typed as 0.2350001 is not another arm. If the hashes differ, the keys are compared.
struct ArmIdentity {
  std::string name;
  std::string hash;         ///< ArmDescription::hash()
  std::string description;  ///< arm_keys_to_yaml(); empty in files of limber before it was kept
};

ArmIdentity identity_of(const ArmDescription& arm);

/// Numbers of arm files agree within this part of the larger one; counts and words exactly.
inline constexpr double kSameNumber = 1e-6;

/// Keys in which the arms differ with both values, "segments[0].length_m: 0.235 there, 0.24 here";
/// empty if they are the same arm. Names, virtual-arm parameters and the rate limit do not count:
/// how fast an arm may be asked to move changes nothing of what it does when asked. Strain
/// polynomials agree where their strains do, within kSameStrain over the pressure range.
std::vector<std::string> arm_differences(const ArmDescription& there, const ArmDescription& here);

/// The arm's rate limit when the file was made [kPa/s]; none where the file holds a hash alone.
/// @throws InputError if the file's description is not an arm.
std::optional<double> rate_limit_of(const ArmIdentity& made_for, const std::string& file);

/// `arm`, no faster than the arm that the file was made for: a plan that was asked to be slow is
/// checked and corrected as such. @throws InputError as rate_limit_of.
ArmDescription at_rate_of(const ArmIdentity& made_for, ArmDescription arm, const std::string& file);

/// Why `arm` is not the one that a file was made for, as the end of a sentence that names both;
/// empty if it is: equal hashes, or keys without a difference. A file that holds a hash alone is
/// of that arm only where the hashes are equal.
/// @param file  names the file in messages.
/// @throws InputError if the file's description is not an arm.
std::string why_another_arm(const ArmIdentity& made_for, const ArmDescription& arm,
                            const std::string& file);

}  // namespace limber
