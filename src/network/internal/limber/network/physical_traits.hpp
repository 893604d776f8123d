#pragma once

#include <string>
#include <vector>

#include "limber/network/compensation_model.hpp"

namespace limber {

/// What an arm's e tells of its physics, as in docs/families.md; of a family of real arms, nothing.
std::vector<TraitEstimate> physical_traits(const ArmFamily& family, const FamilyMember& member);

/// The same of what the arm is now, in place of the arm's file beside what was believed before.
std::vector<TraitEstimate> physical_traits_since(const ArmFamily& family,
                                                 const FamilyMember& before,
                                                 const FamilyMember& now);

/// Those that differ, the surest first: "load at the tip 52 ± 9 g (0), …"; empty: none.
std::string differences_text(std::vector<TraitEstimate> traits);

/// A trait's name for people, and the unit that they know it by.
struct TraitWords {
  std::string text;
  std::string unit;     ///< " g"
  double per_si = 1.0;  ///< of that unit
};
TraitWords words_of_trait(const std::string& name);

/// A column per trait: how e of an arm changes whose trait is larger by 1, and whose other traits
/// stay. With more traits than numbers in e, as nearly as may be. k × traits
Eigen::MatrixXf trait_directions(const ArmFamily& family);

/// The name of a trait that compares a segment's sides: its left side's strength less its right's,
/// as a share of their mean. @param segment  from 0
std::string sides_trait(int segment);

}  // namespace limber
