#pragma once
// For those who move an arm, real or virtual.

#include <vector>

#include "limber/arm/characterisation.hpp"

namespace limber {

/// The characterisation experiment (docs/model.md (9)) on the virtual arm. Segment `segment` lies
/// alone on a frictionless table, without braid hysteresis, with every actuator of nominal
/// strength. One side is pressurised from 0 to the segment's limit in `steps` equal steps, each
/// held until the segment stands still. So the strain includes the segment's own elasticity.
/// @param steps  ≥ 4, so that a quartic can be fitted; `steps` + 1 points come back.
/// @throws InputError if `segment` or `steps` is out of range, SystemFault if the simulation
/// blows up or does not come to rest.
std::vector<BenchPoint> bench_test(const ArmDescription& arm, int segment, int steps = 20);

/// `bench_test` of every segment, base first.
std::vector<std::vector<BenchPoint>> bench_test_all(const ArmDescription& arm, int steps = 20);

/// The same of a chamber of an arm in space: its segment alone, without gravity, and the others of
/// its chambers vented. The strain is the chamber's own, (25): what its place is strained by over
/// its share in (26); it is negated where the chamber extends, as polynomials hold its size.
/// @throws InputError for an arm in a plane, or if `channel` or `steps` is out of range;
/// SystemFault as above.
std::vector<BenchPoint> bench_test_of_chamber(const ArmDescription& arm, int channel,
                                              int steps = 20);

}  // namespace limber
