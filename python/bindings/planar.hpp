#pragma once

#include <utility>

#include "limber/arm/arm_description.hpp"

namespace limber::python {

/// `function`, which takes an arm first, for planar arms alone: it refuses others under `name`.
template <class Result, class... Arguments>
auto of_planar_arms(const char* name,
                    Result (*function)(const ArmDescription& arm, Arguments... arguments)) {
  return [name, function](const ArmDescription& arm, Arguments... arguments) -> Result {
    require_planar(arm, name);
    return function(arm, std::forward<Arguments>(arguments)...);
  };
}

/// The same of what takes a model, which has no name. @throws InputError naming what can.
void require_planar_model(Dimension dimension, const char* name);

}  // namespace limber::python
