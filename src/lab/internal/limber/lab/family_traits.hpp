#pragma once

#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// What e tells of the physics of a family's arms, by least squares over the virtual arms that it
/// learnt from: those quantities of which it tells most (docs/families.md, "What an arm is like").
/// Real arms and mirror images, of which no physics is noted, say nothing.
/// @param arm  whose physics they vary
/// @param physics  of each arm of `family.arms` (TrainingData::physics)
std::vector<PhysicalTrait> fit_traits(const ArmDescription& arm,
                                      const std::vector<std::string>& physics,
                                      const ArmFamily& family);

/// The same beside what the virtual arm really is, in place of what the family's arm file says.
std::vector<TraitEstimate> beside_truth(const ArmDescription& virtual_arm,
                                        std::vector<TraitEstimate> traits);

}  // namespace limber
