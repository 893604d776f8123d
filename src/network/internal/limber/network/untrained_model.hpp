#pragma once

#include <cstdint>
#include <vector>

#include "limber/network/compensation_model.hpp"

namespace limber {

/// A model of the right shape for `arm` with random weights (uniform, spread for ReLU layers) and
/// normalisations that fit the arm's ranges; its compensations are a few centimetres. For
/// benchmarks and tests: speed does not depend on what a network has learnt.
/// @param hidden  units of each hidden layer, all > 0; {100, 100, 100} is the paper's.
CompensationModel untrained_model(const ArmDescription& arm, BackboneLayout layout,
                                  const std::vector<int>& hidden, std::uint64_t seed,
                                  OutputForm form = OutputForm::compensation,
                                  bool reads_velocity = false,
                                  const std::vector<int>& past_commands = {});

}  // namespace limber
