#pragma once

#include <string>
#include <vector>

#include "limber/network/compensation_model.hpp"

namespace limber {

/// What an arm's e tells of its physics, as in docs/families.md; of a family of real arms, nothing.
std::vector<TraitEstimate> physical_traits(const ArmFamily& family, const FamilyMember& member);

/// What motion alone tells of how far e has moved: a normal distribution's precision, and that by
/// its mean.
struct ToldOfE {
  Eigen::MatrixXd precision;
  Eigen::VectorXd pull;
};

/// What may have changed of an arm, the likeliest first, beside what was believed before: one trait
/// or, where none explains the motion, two. More than one: the motion does not tell which. Empty:
/// nothing has surely changed, or nothing that e tells of.
std::vector<ArmChange> explained_changes(const ArmFamily& family, const FamilyMember& before,
                                         const ToldOfE& told);

/// "load at the tip 52 ± 4 g (2), or friction on the table 0.33 ± 0.02 (0.25)"
std::string changes_text(const std::vector<ArmChange>& changes);

/// Each beside its reference: "load at the tip 52 ± 9 g (0)".
std::vector<std::string> trait_texts(const std::vector<TraitEstimate>& traits);

/// Those that differ, the surest first, with commas between; empty: none.
std::string differences_text(std::vector<TraitEstimate> traits);

/// A trait's name for people, and the unit that they know it by.
struct TraitWords {
  std::string text;
  std::string unit;     ///< " g"
  double per_si = 1.0;  ///< of that unit
};
TraitWords words_of_trait(const std::string& name);

/// The name of a trait that compares a segment's sides: its left side's strength less its right's,
/// as a share of their mean. @param segment  from 0
std::string sides_trait(int segment);

}  // namespace limber
