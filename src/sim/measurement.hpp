#pragma once

#include <vector>

#include "limber/arm/backbone.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber {

/// @throws InputError if an option is out of its range.
void check_options(const VirtualArmOptions& options);

/// What sensors see of a simulated arm: pressures and the shape of its plates with the options'
/// noise and drops; always the same number of samples of the stream.
class Measurement {
 public:
  explicit Measurement(const VirtualArmOptions& options)
      : options_(options), random_(options.seed, options.stream) {}

  ArmState of(double time_s, const std::vector<double>& true_kpa, BackboneD plates);
  /// In space every plate's rotation is off by a small turn about each of its own axes.
  ArmState of(double time_s, const std::vector<double>& true_kpa, SpaceBackboneD plates);

  std::uint64_t position() const { return random_.position(); }
  void seek(std::uint64_t position) { random_.seek(position); }

 private:
  ArmState pressures(double time_s, const std::vector<double>& true_kpa);
  bool is_lost(double time_s);
  double noise(double deviation) { return deviation > 0.0 ? deviation * random_.normal() : 0.0; }

  VirtualArmOptions options_;
  RandomStream random_;
};

}  // namespace limber
