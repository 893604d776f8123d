#pragma once

#include "limber/forward/forward_model.hpp"

namespace limber {

/// ForwardModel::checked_step of an arm in space: m×7 each.
SpaceBackbone checked_query(const ForwardModel& model, const Pressures& previous_kpa,
                            const Pressures& current_kpa, const SpaceBackbone& before,
                            const SpaceBackbone& previous);

}  // namespace limber
