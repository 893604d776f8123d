#pragma once

#include <string>
#include <vector>

#include "limber/network/compensation_model.hpp"

namespace limber {

/// What an arm's e tells of its physics, as in docs/families.md; of a family of real arms, nothing.
std::vector<TraitEstimate> physical_traits(const ArmFamily& family, const FamilyMember& member);

/// What of an arm has changed, as its motion since tells: as few traits as may be, at most two.
/// Each beside what was believed before. Empty: nothing that it tells of, or nothing surely.
/// @param precision, pull  of e − before.e, by the motion since alone: e's likelihood is that of a
/// normal distribution with this precision, and this is precision · mean
std::vector<TraitEstimate> changed_traits(const ArmFamily& family, const FamilyMember& before,
                                          const Eigen::MatrixXd& precision,
                                          const Eigen::VectorXd& pull);

/// Those that differ, the surest first: "load at the tip 52 ± 9 g (0), …"; empty: none.
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
