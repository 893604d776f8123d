#pragma once

#include <optional>
#include <string>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"

namespace limber {

/// Why a backbone is not a shape that the arm can start with.
struct StartFault {
  int row = 0;          ///< of the backbone, 0 the base
  std::string message;  ///< what was found, and what is allowed
};

/// A start is measured, so small deviations are allowed. What no tracked arm shows is not allowed:
/// a first plate that is not the base, gaps far shorter or longer than at rest, headings that jump,
/// or plates that do not lie where their headings lead. Numbers that are not finite are never
/// allowed.
std::optional<StartFault> find_start_fault(const Backbone& backbone, const ArmDescription& arm);

}  // namespace limber
