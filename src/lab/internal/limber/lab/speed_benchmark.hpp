#pragma once

#include <cstdint>

#include "limber/arm/arm_description.hpp"
#include "limber/common/progress.hpp"
#include "limber/forward/speed_report.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

struct SpeedSettings {
  std::int64_t queries = 1'000'000;  ///< of each measurement of single queries; batches as many
  int jobs = 0;                      ///< threads for the largest batches, 0: one per core
  std::uint64_t seed = 1;            ///< of inputs and of untrained weights
  bool optional_peers = true;        ///< also those of bench/speed_peers.hpp
  Progress::Mode progress = Progress::Mode::quiet;
};

/// Measures `arm`'s models. The paper's shape has the weights of `model` if that has this shape,
/// untrained ones otherwise: speed does not depend on what was learnt.
/// @param model  may be null.
SpeedReport measure_speed(const ArmDescription& arm, const CompensationModel* model,
                          const SpeedSettings& settings);

}  // namespace limber
