#pragma once

#include "limber/arm/characterisation.hpp"
#include "limber/plot/chart.hpp"

namespace limber {

/// Contraction over pressure: the bench points of every segment and the curve fitted to them, up to
/// the pressure limit. `bench` is what `result` was fitted to.
Chart bench_chart(const CharacterisedArm& result, const BenchData& bench);

}  // namespace limber
